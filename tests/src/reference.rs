//! Reference trajectories of `answers/`: two independent derivations in 256-bit arithmetic that agree to 3e-41,
//! printed with 36 digits.

use crate::garage;
use ezy_core::scalar::DoubleDouble;
use serde_json::Value;

/// One sample of a reference trajectory.
#[derive(Debug, Clone, PartialEq)]
pub struct ReferenceSample {
    /// Time, s.
    pub t: f64,
    /// Coordinates.
    pub q: Vec<f64>,
    /// Velocities.
    pub v: Vec<f64>,
    /// Accelerations.
    pub a: Vec<f64>,
    /// Multipliers in the order B.x, B.y, rear, front.
    pub lambda: Vec<f64>,
    /// Kinetic energy, J.
    pub kinetic: f64,
    /// Work of the drive since the start, J.
    pub work: f64,
    /// Wheel A.
    pub point_a: Vec<f64>,
    /// Wheel C.
    pub point_c: Vec<f64>,
}

/// One sample with all digits that double-double holds.
#[derive(Debug, Clone, PartialEq)]
pub struct PreciseSample {
    /// Time, s.
    pub t: f64,
    /// Coordinates.
    pub q: Vec<DoubleDouble>,
    /// Velocities.
    pub v: Vec<DoubleDouble>,
    /// Multipliers in the order B.x, B.y, rear, front.
    pub lambda: Vec<DoubleDouble>,
}

/// Reads `answers/<name>.json`.
///
/// # Panics
/// When the file is not there or not as described: the test that asks for it fails.
pub fn load(name: &str) -> Vec<ReferenceSample> {
    samples(name).iter().map(sample).collect()
}

/// As [`load`], with all digits.
///
/// # Panics
/// As [`load`].
pub fn load_precise(name: &str) -> Vec<PreciseSample> {
    let numbers = |v: &Value| v.as_array().expect("a list of numbers").iter().map(digits).collect();
    let sample = |v: &Value| PreciseSample {
        t: number(&v["t"]),
        q: numbers(&v["q"]),
        v: numbers(&v["qd"]),
        lambda: numbers(&v["lambda"]),
    };
    samples(name).iter().map(sample).collect()
}

fn samples(name: &str) -> Vec<Value> {
    garage::load(name)["samples"].as_array().expect("samples").clone()
}

fn sample(v: &Value) -> ReferenceSample {
    ReferenceSample {
        t: number(&v["t"]),
        q: numbers(&v["q"]),
        v: numbers(&v["qd"]),
        a: numbers(&v["qdd"]),
        lambda: numbers(&v["lambda"]),
        kinetic: number(&v["KE"]),
        work: number(&v["W"]),
        point_a: numbers(&v["A"]),
        point_c: numbers(&v["C"]),
    }
}

fn numbers(v: &Value) -> Vec<f64> {
    v.as_array().expect("a list of numbers").iter().map(number).collect()
}

fn number(v: &Value) -> f64 {
    v.as_str().expect("a decimal in quotes").parse().expect("a decimal number")
}

fn digits(v: &Value) -> DoubleDouble {
    decimal(v.as_str().expect("a decimal in quotes"))
}

/// A decimal number with all its digits.
///
/// # Panics
/// When it is none.
pub fn decimal(text: &str) -> DoubleDouble {
    let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = whole.trim_start_matches('-').chars().chain(fraction.chars());
    let digit = |c: char| DoubleDouble::from(f64::from(c.to_digit(10).expect("a digit")));
    let ten = DoubleDouble::from(10.0);
    let number = digits.map(digit).fold(DoubleDouble::from(0.0), |sum, digit| sum * ten + digit);
    let exponent = exponent.parse::<i32>().expect("an exponent") - fraction.len() as i32;
    let power = (0..exponent.abs()).fold(DoubleDouble::from(1.0), |power, _| power * ten);
    let size = if exponent < 0 { number / power } else { number * power };
    if text.starts_with('-') { -size } else { size }
}
