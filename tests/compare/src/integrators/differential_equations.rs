//! `differential-equations`: DOP853, and Verner's pair of orders 9 and 8. States are arrays.

use super::{Arrival, MAX_STEPS, Task, coordinates};
use crate::right_side::{RightSide, State};
use differential_equations::prelude::*;

pub fn dop853<R: RightSide>(right_side: &R, task: Task, tolerance: f64) -> Result<Arrival, String> {
    let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(MAX_STEPS as usize);
    let slope = |t: f64, y: &State, slope: &mut State| right_side.slope(t, y, slope);
    let solution = IVP::ode_from_fn(slope, 0.0, task.until_s, task.start).method(method).solve();
    arrival(solution)
}

pub fn rkv98<R: RightSide>(right_side: &R, task: Task, tolerance: f64) -> Result<Arrival, String> {
    let method = ExplicitRungeKutta::rkv988e().rtol(tolerance).atol(tolerance).max_steps(MAX_STEPS as usize);
    let slope = |t: f64, y: &State, slope: &mut State| right_side.slope(t, y, slope);
    let solution = IVP::ode_from_fn(slope, 0.0, task.until_s, task.start).method(method).solve();
    arrival(solution)
}

fn arrival(solution: Result<Solution<f64, State>, Error<f64, State>>) -> Result<Arrival, String> {
    let solution = solution.map_err(|error| format!("{error:?}"))?;
    let last = solution.y.last().ok_or("an empty solution")?;
    let (steps, rejected) = (solution.steps.accepted as u64, Some(solution.steps.rejected as u64));
    Ok(Arrival { q: coordinates(last), steps, rejected })
}
