//! Energy balance of a short run.

use super::{Check, CheckError};
use crate::integrate::Method;
use crate::model::Scene;
use crate::simulate::{Run, Simulation};

/// Longest run, s.
const HORIZON: f64 = 1.0;

/// Steps of the coarser of two runs.
const N_STEPS: f64 = 1000.0;

/// What extrapolation over one halving leaves of an error of 1e-8 at the coarse step.
const TOLERANCE: f64 = 1e-9;

/// Kinetic and potential energy less work, less its value at the start, over a short run, relative to the largest
/// kinetic energy or work. The balance goes with the fourth power of the step; two runs extrapolate it to step zero.
pub fn balance<S: Scene + ?Sized>(scene: &S, start_s: f64) -> Result<Check, CheckError> {
    let horizon = HORIZON.min(scene.info().until_s - start_s).max(0.0);
    let step = horizon / N_STEPS;
    let run = |step_s: f64| {
        let order = Simulation::new(scene).method(Method::rk4(step_s)).until(start_s + horizon);
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
        largest_error,
        tolerance: TOLERANCE,
        reason: "RK4 at two steps, extrapolated to step zero",
    })
}

/// Largest extrapolated balance, relative; NaN when a run stopped early.
fn extrapolated(coarse: &Run, fine: &Run) -> f64 {
    if !(coarse.outcome.reached_end() && fine.outcome.reached_end()) {
        return f64::NAN;
    }
    let energies = fine.samples().flat_map(|s| [s.energy.kinetic, s.energy.work.abs()]);
    let size = energies.fold(f64::MIN_POSITIVE, f64::max);
    let balances = coarse.samples().zip(fine.samples()).map(|(c, f)| (c.energy.balance, f.energy.balance));
    balances.map(|(c, f)| (f + (f - c) / 15.0).abs() / size).fold(0.0, f64::max)
}
