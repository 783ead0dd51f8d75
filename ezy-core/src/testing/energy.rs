//! Energy balance of a short run.

use super::{Check, CheckError};
use crate::dynamics::max_abs;
use crate::integrate::Method;
use crate::model::Scene;
use crate::simulate::{Outcome, Run, Simulation};

/// Longest run, s.
const HORIZON: f64 = 1.0;

/// Steps of the coarser of two runs.
const N_STEPS: f64 = 1000.0;

/// Error after extrapolation over one halving, from 1e-8 at the coarse step.
const TOLERANCE: f64 = 1e-9;

/// A body that cannot move drifts by rounding, 1e-15 m in a short run. This way times the tolerance is as much, so that
/// the work of its reactions is within what is accepted, m.
const ROUNDED_WAY: f64 = 1e-6;

/// Kinetic and potential energy less work, less its value at the start, over a short run, relative to the largest
/// kinetic energy or work, or to what the largest reaction does on a rounded way. The balance goes with the fourth power of the step; two runs extrapolate it to step zero.
pub(super) fn balance<S: Scene + ?Sized>(scene: &S, start_s: f64) -> Result<Check, CheckError> {
    let horizon = HORIZON.min(scene.info().until_s - start_s).max(0.0);
    let step = horizon / N_STEPS;
    let run = |step_s: f64| {
        let order = Simulation::new(scene).method(Method::rk4(step_s)).until(start_s + horizon).without_events();
        order.every(horizon / 10.0).work().run()
    };
    let (largest_error, n_compared) = if horizon > 0.0 {
        let (coarse, fine) = (run(step)?, run(0.5 * step)?);
        (extrapolated(&coarse, &fine), coarse.samples().len())
    } else {
        (0.0, 0)
    };
    Ok(Check {
        name: "energy balance of a short run",
        n_compared,
        n_left_out: 0,
        largest_error,
        tolerance: TOLERANCE,
        reason: "RK4 at two steps, extrapolated to step zero",
    })
}

/// Largest extrapolated balance, relative; NaN when a run stopped early.
fn extrapolated(coarse: &Run, fine: &Run) -> f64 {
    // what a step leaves of the energy is extrapolated, however large it is
    if [coarse, fine].iter().any(|run| matches!(run.outcome, Outcome::Stopped { .. })) {
        return f64::NAN;
    }
    let reaction = |multipliers: &[f64]| max_abs(multipliers) * ROUNDED_WAY;
    let energies = fine.samples().flat_map(|s| [s.energy.kinetic, s.energy.work.abs(), reaction(s.multipliers)]);
    let size = energies.fold(f64::MIN_POSITIVE, f64::max);
    let balances = coarse.samples().zip(fine.samples()).map(|(c, f)| (c.energy.balance, f.energy.balance));
    balances.map(|(c, f)| (f + (f - c) / 15.0).abs() / size).fold(0.0, f64::max)
}
