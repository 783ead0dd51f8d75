//! Reference trajectories of `answers/`: two independent derivations in 256-bit arithmetic that agree to 3e-41,
//! printed with 36 digits.

use serde_json::Value;
use std::path::Path;

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

/// Reads `answers/<name>.json`.
///
/// # Panics
/// When the file is not there or not as described: the test that asks for it fails.
pub fn load(name: &str) -> Vec<ReferenceSample> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("answers").join(format!("{name}.json"));
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let file: Value = serde_json::from_str(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let samples = file["samples"].as_array().expect("samples");
    samples.iter().map(sample).collect()
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
