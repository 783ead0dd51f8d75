//! The EzyRoller by hand. Body 1 is the seat, body 2 the bar; rows: hinge x, hinge y, rear wheel, front wheel.

use super::{Scene, answer};
use crate::right_side::{ByHand, Equations, N_Q, State};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

/// Rear wheel, hinge, front wheel: distances from the centres of mass, m.
const A: f64 = 0.2;
const B: f64 = 0.6;
const C: f64 = 0.1;
const D: f64 = 0.1;
/// Torque, N·m, and its angular frequency, rad/s.
const M0: f64 = 2.0;
const OMEGA: f64 = PI;
const MASS: [f64; N_Q] = [46.0, 46.0, 10.0, 1.0, 1.0, 0.005];

/// From rest, folded, driven by a torque in the hinge.
pub fn driven() -> Result<Scene<4>, Box<dyn Error>> {
    let start = state([0.0, 0.0, 0.0, B - D, 0.0, PI], [0.0; N_Q]);
    let right_side = ByHand { mass: MASS, equations: |t, q, v| equations(M0 * (OMEGA * t).cos(), q, v) };
    Ok(Scene { name: "ezyroller/driven", start, until_s: 60.0, right_side, end: end("ezyroller_driven")? })
}

/// Rolling freely at 1 m/s with the bar across.
pub fn coast() -> Result<Scene<4>, Box<dyn Error>> {
    // the front wheel does not slip: the bar turns with the rate at which its hinge moves across it
    let turn = 1.0 / (C + D);
    let start = state([A, 0.0, 0.0, A + B, D, FRAC_PI_2], [1.0, 0.0, 0.0, 1.0 - D * turn, 0.0, turn]);
    let right_side = ByHand { mass: MASS, equations: |_, q, v| equations(0.0, q, v) };
    Ok(Scene { name: "ezyroller/coast", start, until_s: 1.0, right_side, end: end("ezyroller_coast")? })
}

fn state(q: [f64; N_Q], v: [f64; N_Q]) -> State {
    std::array::from_fn(|i| if i < N_Q { q[i] } else { v[i - N_Q] })
}

fn equations(torque: f64, q: &[f64; N_Q], v: &[f64; N_Q]) -> Equations<4> {
    let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
    let (w1, w2) = (v[2], v[5]);
    Equations {
        jacobian: [
            [1.0, 0.0, -B * s1, -1.0, 0.0, -D * s2],
            [0.0, 1.0, B * c1, 0.0, -1.0, D * c2],
            [-s1, c1, -A, 0.0, 0.0, 0.0],
            [0.0, 0.0, 0.0, -s2, c2, C],
        ],
        force: [0.0, 0.0, torque, 0.0, 0.0, -torque],
        convective: [
            -B * c1 * w1 * w1 - D * c2 * w2 * w2,
            -B * s1 * w1 * w1 - D * s2 * w2 * w2,
            -(v[0] * c1 + v[1] * s1) * w1,
            -(v[3] * c2 + v[4] * s2) * w2,
        ],
    }
}

/// The last sample of a reference: 256-bit arithmetic, two derivations.
fn end(name: &str) -> Result<[f64; N_Q], Box<dyn Error>> {
    let file = answer(name)?;
    let last = file["samples"].as_array().and_then(|samples| samples.last()).ok_or("no samples")?;
    let mut q = [0.0; N_Q];
    for (i, q) in q.iter_mut().enumerate() {
        *q = last["q"][i].as_str().ok_or("no coordinate")?.parse()?;
    }
    Ok(q)
}
