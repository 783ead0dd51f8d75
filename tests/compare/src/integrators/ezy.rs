//! EZY, as a program runs a scene.

use super::{Arrival, coordinates};
use ezy_core::integrate::Method;
use ezy_core::model::Scene;
use ezy_core::simulate::Simulation;

/// A whole order, its start assembled and both projections after each step; and the number of evaluations.
pub fn ezy<S: Scene>(scene: &S, method: Method, until_s: f64) -> Result<(Arrival, u64), String> {
    let run = Simulation::new(scene).method(method).until(until_s).run().map_err(|error| error.to_string())?;
    if !run.outcome.reached_end() {
        return Err(run.outcome.to_string());
    }
    let q = coordinates(run.last().coordinates);
    Ok((Arrival { q, steps: run.cost.steps, rejected: Some(run.cost.rejected) }, run.cost.evaluations))
}
