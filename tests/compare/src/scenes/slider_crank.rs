//! The slider-crank by hand: a closed loop with a spring and a damper; rows: bearing x, bearing y, pin x, pin y, guide.
//!
//! The crank's centre of mass is its bearing, the rod's is the slider.

use super::{Scene, answer};
use crate::right_side::{ByHand, Equations, N_Q};
use std::error::Error;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6};

/// Crank and rod, m.
const R: f64 = 0.5;
const L: f64 = 1.0;
/// Spring with damper between their middles: N/m, m, N·s/m.
const STIFFNESS: f64 = 1.0;
const LENGTH: f64 = 1.0;
const DAMPING: f64 = 1.0;
/// Force along the guide on the rod's tip, N, and the tip beyond the slider, m.
const PUSH: f64 = 1.0;
const TIP: f64 = 1.0;
const MASS: [f64; N_Q] = [1.0, 1.0, 1.0, 1.0, 1.0, 2.0];

/// From rest, with the crank upright.
pub fn slider_crank() -> Result<Scene<5>, Box<dyn Error>> {
    let start = [0.0, 0.0, FRAC_PI_2, L * FRAC_PI_6.cos(), 0.0, -FRAC_PI_6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let right_side = ByHand { mass: MASS, equations };
    Ok(Scene { name: "slidercrank/pushed", start, until_s: 10.0, right_side, end: end()? })
}

fn equations(_t: f64, q: &[f64; N_Q], v: &[f64; N_Q]) -> Equations<5> {
    let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
    let (w1, w2) = (v[2], v[5]);
    // arms of the spring's ends about the centres of mass
    let (h1, h2) = (0.5 * R, -0.5 * L);
    let d = [q[3] + h2 * c2 - q[0] - h1 * c1, q[4] + h2 * s2 - q[1] - h1 * s1];
    let rate = [v[3] - h2 * s2 * w2 - v[0] + h1 * s1 * w1, v[4] + h2 * c2 * w2 - v[1] - h1 * c1 * w1];
    let length = d[0].hypot(d[1]);
    let tension = STIFFNESS * (length - LENGTH) + DAMPING * (d[0] * rate[0] + d[1] * rate[1]) / length;
    let f = [tension * d[0] / length, tension * d[1] / length];
    Equations {
        jacobian: [
            [-1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
            [0.0, -1.0, 0.0, 0.0, 0.0, 0.0],
            [1.0, 0.0, -R * s1, -1.0, 0.0, -L * s2],
            [0.0, 1.0, R * c1, 0.0, -1.0, L * c2],
            [0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        ],
        force: [
            f[0],
            f[1],
            h1 * (c1 * f[1] - s1 * f[0]),
            -f[0] + PUSH,
            -f[1],
            -h2 * (c2 * f[1] - s2 * f[0]) - TIP * s2 * PUSH,
        ],
        convective: [0.0, 0.0, -R * c1 * w1 * w1 - L * c2 * w2 * w2, -R * s1 * w1 * w1 - L * s2 * w2 * w2, 0.0],
    }
}

/// The last row of a reference: 113-bit arithmetic, two formulations.
fn end() -> Result<[f64; N_Q], Box<dyn Error>> {
    let file = answer("slider_crank_ida")?;
    let last = file["rows"].as_array().and_then(|rows| rows.last()).ok_or("no rows")?;
    let number = |i: usize| last[i].as_f64().ok_or("no number");
    Ok([0.0, 0.0, number(1)?, number(2)?, 0.0, number(3)?])
}
