//! A steady motion and its modes, as text and as JSON.

use serde_json::{Value, json};

use super::steady_text::{heading, motion_json, state_text, verdict, verdict_text, zeros_text};
use ezy_core::analysis::{Linearization, Mode, Spectrum, SteadyMotion};
use ezy_core::model::SceneInfo;
use ezy_core::scalar::rounded;
use ezy_study::report::table::{Table, fixed};
use nalgebra::{Complex, DMatrix};

/// Digits of eigenvalues in tables.
const DIGITS: usize = 6;
/// Names of what moves most in a mode.
const MOST_NAMES: usize = 3;

/// What was found.
pub(super) struct Linearized<'a> {
    pub motion: &'a SteadyMotion,
    pub linear: &'a Linearization,
    pub spectrum: &'a Spectrum,
    pub modes: &'a [Mode],
}

pub(super) fn text_of(found: &Linearized<'_>) -> String {
    let Linearized { motion, linear, spectrum, modes } = found;
    let info = linear.info();
    let mut text = heading(info, motion) + &state_text(info, motion);
    if !modes.is_empty() {
        let names = names_of_rows(info);
        let head =
            ["mode", "real [1/s]", "imag [1/s]", "damping ratio", "frequency [Hz]", "doubles in [s]", "halves in [s]"];
        let mut table = Table::new(head.into_iter().chain(["moves most"]));
        for (mode, number) in modes.iter().zip(1..) {
            let s = mode.eigenvalue;
            let [doubles, halves] = [1.0, -1.0].map(|sign| time(sign * mode.doubling_time_s()));
            let most: Vec<&str> = mode.largest.iter().take(MOST_NAMES).map(|i| names[*i]).collect();
            let numbers = [s.re, s.im, mode.damping_ratio(), mode.frequency_hz()].map(|x| fixed(x, DIGITS));
            let number = usize::to_string(&number);
            table.push([number].into_iter().chain(numbers).chain([doubles, halves, most.join(", ")]));
        }
        text += &format!("\n{table}");
    }
    text + &format!("\n{}\n{}\n", verdict_text(motion, spectrum), zeros_text(motion, spectrum))
}

/// A time; nothing where it is negative or endless.
fn time(t: f64) -> String {
    if t > 0.0 && t.is_finite() && t < ENDLESS_S { rounded(t, 4) } else { String::new() }
}

/// From here on it is rounding that a deviation grows by, s.
const ENDLESS_S: f64 = 1e9;

/// Names of the rows of the basis.
pub(super) fn names_of_rows(info: &SceneInfo) -> Vec<&str> {
    let states = info.states.iter().map(|state| state.name);
    info.coordinates.iter().chain(&*info.velocities).map(|c| &*c.name).chain(states).collect()
}

pub(super) fn json_of(found: &Linearized<'_>) -> Value {
    let Linearized { motion, linear, spectrum, modes } = found;
    let info = linear.info();
    let names = names_of_rows(info);
    let modes: Vec<Value> = modes.iter().map(|mode| mode_json(mode, &names)).collect();
    json!({
        "model": info.model,
        "scene": info.name,
        "steady": motion_json(info, motion),
        "names": names,
        "inputs": linear.inputs,
        "outputs": info.outputs.iter().map(|output| &*output.name).collect::<Vec<_>>(),
        "a": rows(&linear.a),
        "b": rows(&linear.b),
        "c": rows(&linear.c),
        "d": rows(&linear.d),
        "basis": rows(&linear.basis),
        "eigenvalues": modes,
        "zeros": { "count": spectrum.n_zero, "jordan_blocks": spectrum.zero_blocks },
        "unstable": spectrum.n_unstable(),
        "neutral": spectrum.n_neutral(),
        "verdict": verdict(motion, spectrum),
    })
}

fn mode_json(mode: &Mode, names: &[&str]) -> Value {
    let time = mode.doubling_time_s();
    let part = |of: fn(&Complex<f64>) -> f64, vector: &nalgebra::DVector<Complex<f64>>| vector.iter().map(of).collect();
    let parts = |vector| -> [Vec<f64>; 2] { [part(|x| x.re, vector), part(|x| x.im, vector)] };
    let [[x_real, x_imaginary], [real, imaginary]] = [parts(&mode.vector), parts(&mode.deviation)];
    json!({
        "real": mode.eigenvalue.re,
        "imaginary": mode.eigenvalue.im,
        "damping_ratio": mode.damping_ratio(),
        "frequency_hz": mode.frequency_hz(),
        "doubling_time": Some(time).filter(|t| *t > 0.0),
        "halving_time": Some(-time).filter(|t| *t > 0.0),
        "largest": mode.largest.iter().map(|i| names[*i]).collect::<Vec<_>>(),
        "vector": { "real": x_real, "imaginary": x_imaginary },
        "deviation": { "real": real, "imaginary": imaginary },
    })
}

pub(super) fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}
