//! The double pendulum by hand: two uniform rods of 1 m and 1 kg; rows: pin x, pin y, elbow x, elbow y.

use super::{Scene, answer};
use crate::right_side::{ByHand, Equations, N_Q};
use std::error::Error;

/// Half a rod, m.
const R: f64 = 0.5;
/// Weight of a rod, N.
const WEIGHT: f64 = 9.81;
const MASS: [f64; N_Q] = [1.0, 1.0, 1.0 / 12.0, 1.0, 1.0, 1.0 / 12.0];

/// Released level and straight.
pub fn double_pendulum() -> Result<Scene<4>, Box<dyn Error>> {
    let start = [R, 0.0, 0.0, 3.0 * R, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let right_side = ByHand { mass: MASS, equations };
    Ok(Scene { name: "doublependulum/swing", start, until_s: 10.0, right_side, end: end()? })
}

fn equations(_t: f64, q: &[f64; N_Q], v: &[f64; N_Q]) -> Equations<4> {
    let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
    let (ww1, ww2) = (v[2] * v[2], v[5] * v[5]);
    Equations {
        jacobian: [
            [-1.0, 0.0, -R * s1, 0.0, 0.0, 0.0],
            [0.0, -1.0, R * c1, 0.0, 0.0, 0.0],
            [1.0, 0.0, -R * s1, -1.0, 0.0, -R * s2],
            [0.0, 1.0, R * c1, 0.0, -1.0, R * c2],
        ],
        force: [0.0, -WEIGHT, 0.0, 0.0, -WEIGHT, 0.0],
        convective: [-R * c1 * ww1, -R * s1 * ww1, -R * c1 * ww1 - R * c2 * ww2, -R * s1 * ww1 - R * s2 * ww2],
    }
}

/// From the angles of a reference: 113-bit arithmetic, two formulations.
fn end() -> Result<[f64; N_Q], Box<dyn Error>> {
    let file = answer("chain_pendulum")?;
    let case = file["cases"].as_array().and_then(|cases| cases.iter().find(|case| case["name"] == "double_1m"));
    let last = case.and_then(|case| case["states"].as_array()?.last()).ok_or("no states")?;
    let angle = |i: usize| last["angles"][i].as_f64().ok_or("no angle");
    let (upper, lower) = (angle(0)?, angle(1)?);
    let ((s1, c1), (s2, c2)) = (upper.sin_cos(), lower.sin_cos());
    Ok([R * c1, R * s1, upper, 2.0 * R * c1 + R * c2, 2.0 * R * s1 + R * s2, lower])
}
