//! `russell_ode`: DOP853, there DoPri8.

use super::{Arrival, MAX_STEPS, Task, coordinates};
use crate::right_side::RightSide;
use russell_lab::Vector;
use russell_ode::prelude::*;

pub fn dopri8<R: RightSide>(right_side: &R, task: Task, tolerance: f64) -> Result<Arrival, String> {
    let mut y = Vector::from(&task.start);
    let system = System::new(y.dim(), |slope: &mut Vector, t: f64, y: &Vector, _: &mut NoArgs| {
        right_side.slope(t, y.as_data(), slope.as_mut_data());
        Ok(())
    });
    let mut params = Params::new(Method::DoPri8);
    params.set_tolerances(tolerance, tolerance, None)?;
    params.step.n_step_max = MAX_STEPS as usize;
    let mut solver = OdeSolver::new(params, system)?;
    solver.solve(&mut y, 0.0, task.until_s, None, &mut 0, None)?;
    let counts = solver.stats();
    let (steps, rejected) = (counts.n_accepted as u64, Some(counts.n_rejected as u64));
    Ok(Arrival { q: coordinates(y.as_data()), steps, rejected })
}
