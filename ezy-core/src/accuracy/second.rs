//! The reference by another method.

use std::time::Instant;

use super::errors::{Comparison, Scales, compare};
use super::runs::{NoRun, Runs};
use super::trajectory::Trajectory;
use super::variant::Variant;
use crate::integrate::Method;
use crate::simulate::Cost;

/// A second route to the reference.
#[derive(Debug, Clone)]
pub struct Second {
    /// How it was made.
    pub by: String,
    /// Difference from the reference.
    pub difference: Comparison,
    /// Difference of its own last two approximations.
    pub own: Comparison,
}

/// A second method may differ from the reference by this factor of the difference of its own last two runs. At the level of
/// rounding both vary by chance.
const CONFIRMED: f64 = 100.0;

/// Relative differences up to this are rounding of a long run.
const ROUNDING: f64 = 1e-12;

/// RK4 steps for each step of the reference: extrapolated RK4 then comes near to rounding.
const STEPS_PER_STEP: u64 = 16;

impl Second {
    /// Whether it agrees with the reference within its own accuracy.
    pub fn confirms(&self) -> bool {
        let [difference, own] = [&self.difference, &self.own].map(|of| of.grid.position.scaled);
        difference <= (CONFIRMED * own).max(ROUNDING)
    }

    /// RK4 with two steps, extrapolated to the step zero.
    pub(super) fn by_rk4(
        runs: &Runs<'_>,
        cost: Cost,
        reference: &Trajectory,
        scales: &Scales,
        until: Instant,
    ) -> Result<Self, String> {
        let step_s = (runs.until_s - runs.start_s) / (STEPS_PER_STEP * cost.steps.max(1)) as f64;
        let motion = |step_s: f64| {
            let run = runs.on_grid(Method::rk4(step_s), Variant::default(), until);
            run.map(|run| Trajectory::of(&run)).map_err(|why| refused(&why))
        };
        let (coarse, fine) = (motion(step_s)?, motion(0.5 * step_s)?);
        let compared = |one: &Trajectory, other: &Trajectory| {
            compare(one, other, scales).ok_or_else(|| "rk4 has samples at other times".to_owned())
        };
        let own = compared(&fine, &coarse)?;
        let difference = compared(&fine.extrapolated(&coarse, 1.0 / 15.0), reference)?;
        let by = format!("rk4 with steps of {step_s:.2e} s and half of it, extrapolated to the step zero");
        Ok(Self { by, difference, own })
    }
}

fn refused(why: &NoRun) -> String {
    format!("rk4 {why}")
}
