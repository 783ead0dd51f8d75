//! `ode_solvers`: DOP853. States are vectors of the `nalgebra` that it brings along.
//!
//! The time is one of the states: version 0.6.2 has 0 where the last two nodes of the method are 1, so it is wrong where
//! the time occurs in the equations (its pull request 42).

use super::{Arrival, Task, coordinates};
use crate::right_side::RightSide;
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, SVector, System};

const N: usize = 12;

type Vector = SVector<f64, { N + 1 }>;

struct Slope<'r, R>(&'r R);

impl<R: RightSide> System<f64, Vector> for Slope<'_, R> {
    fn system(&self, _t: f64, y: &Vector, slope: &mut Vector) {
        self.0.slope(y[N], y.as_slice(), slope.as_mut_slice());
        slope[N] = 1.0;
    }
}

pub fn dop853<R: RightSide>(right_side: &R, task: Task, tolerance: f64) -> Result<Arrival, String> {
    let start = Vector::from_fn(|i, _| if i < N { task.start[i] } else { 0.0 });
    let slope = Slope(right_side);
    let mut solver = Dop853::new(slope, 0.0, task.until_s, task.until_s, start, tolerance, tolerance);
    solver.set_output(OutputType::Sparse);
    let counts = solver.integrate().map_err(|error| error.to_string())?;
    let last = solver.y_out().last().ok_or("an empty solution")?;
    let (steps, rejected) = (counts.accepted_steps.into(), Some(counts.rejected_steps.into()));
    Ok(Arrival { q: coordinates(last.as_slice()), steps, rejected })
}
