//! `diffsol`: the explicit method of Tsitouras, of order 5. Its others are for stiff equations.

use super::{Arrival, Task, coordinates};
use crate::right_side::RightSide;
use diffsol::{NalgebraMat, OdeBuilder, OdeSolverMethod, OdeSolverStopReason};

pub fn tsit45<R: RightSide>(right_side: &R, task: Task, tolerance: f64) -> Result<Arrival, String> {
    let n = task.start.len();
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(tolerance)
        .atol([tolerance])
        .rhs(|y: &[f64], _p: &[f64], t: f64, slope: &mut [f64]| right_side.slope(t, y, slope))
        .init(|_p: &[f64], _t: f64, y: &mut [f64]| y.copy_from_slice(&task.start), n)
        .build()
        .map_err(|error| error.to_string())?;
    let mut solver = problem.tsit45().map_err(|error| error.to_string())?;
    solver.set_stop_time(task.until_s).map_err(|error| error.to_string())?;
    loop {
        match solver.step() {
            Ok(OdeSolverStopReason::TstopReached) => break,
            Ok(_) => {}
            Err(error) => return Err(error.to_string()),
        }
    }
    let end: Vec<f64> = (0..n).map(|i| solver.state().y[i]).collect();
    let counts = solver.get_statistics();
    let rejected = counts.number_of_error_test_failures as u64;
    Ok(Arrival { q: coordinates(&end), steps: counts.number_of_steps as u64, rejected: Some(rejected) })
}
