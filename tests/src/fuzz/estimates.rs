//! Estimates of errors beside the true errors of random motions, many of which take one to three steps.

use ezy_core::prelude::*;

use super::draw::Draw;
use super::methods::Case;
use super::parameters::Scenes;
use crate::estimates::{Judged, Question, Reference};

/// Share of a scene's time that is run, as powers of ten: the shortest are one step.
const SHARES: [f64; 2] = [-4.0, 0.0];

/// Tolerances of the runs, and steps of RK4 over a run, as powers of ten.
const TOLERANCES: [f64; 2] = [-12.0, -3.0];
const RK4_STEPS: [f64; 2] = [0.0, 3.0];

/// An estimate is at least this part of the error.
pub const SMALLEST: f64 = 0.2;

/// Estimates above this many times the error are few.
pub const LARGEST: f64 = 100.0;

/// Steps after which a run is ended.
const MOST_STEPS: u64 = 20_000;

/// What came of one random run.
pub enum Estimated {
    /// The motion has no reference: it is refused, stops or takes too many steps.
    NoReference,
    /// The method does not apply, or the run has no estimate and says so.
    NoEstimate,
    /// Estimates and true errors.
    Judged {
        /// The command line of the run.
        command: String,
        /// Each error that is above rounding.
        judged: Vec<Judged>,
    },
}

/// Run `i` of a seed.
pub fn estimated(scenes: &Scenes, seed: u64, i: u64) -> Estimated {
    let mut draw = Draw::new(seed, i);
    let case = Case::new(scenes, seed, i);
    let scene = case.scene();
    let until_s = scene.info().until_s * draw.decades(SHARES[0], SHARES[1]);
    let case = case.over(until_s);
    let tolerance = draw.decades(TOLERANCES[0], TOLERANCES[1]);
    let method = match draw.below(5) {
        0 => Method::dop853(tolerance),
        1 => Method::taylor(tolerance),
        2 => Method::gauss(tolerance),
        3 => Method::radau(tolerance),
        _ => Method::rk4(until_s / draw.decades(RK4_STEPS[0], RK4_STEPS[1]).round()),
    };
    let given = &case.given;
    let question = Question { scene: &*scene, given, until_s, most_steps: MOST_STEPS, counts_rounding: false };
    let Some(reference) = Reference::of(&question) else { return Estimated::NoReference };
    match reference.judge(&question, method) {
        Ok((judged, _)) => Estimated::Judged { command: case.command(method) + " --estimate-error", judged },
        Err(_) => Estimated::NoEstimate,
    }
}
