//! The classical Runge–Kutta method of order 4.

use super::{Knot, compensated};
use crate::dynamics::{MotionError, State, System};
use crate::model::Scene;

/// Stages of the method for q' = v, v' = a(t, q, v), w' = power of each effect.
///
/// The steps of one run are summed with compensation: what rounding cuts off a sum is added to the next one. Without
/// it a body that rolls straight for 1e5 steps is 1e-10 m off, since each step is rounded the same way.
///
/// # Source
/// W. Kutta, Z. Math. Phys. 46 (1901) 435–453.
#[derive(Debug)]
pub struct Rk4 {
    stage: State,
    slope: State,
    sum: State,
    /// What rounding cut off the last step.
    rest: State,
    lambda: Vec<f64>,
}

impl Rk4 {
    /// Storage for a scene with these sizes.
    pub fn new(n_coordinates: usize, n_rows: usize, n_effects: usize) -> Self {
        let zero = State::zero(n_coordinates, n_effects);
        Self { stage: zero.clone(), slope: zero.clone(), sum: zero.clone(), rest: zero, lambda: vec![0.0; n_rows] }
    }

    /// Forgets what rounding cut off, before another run.
    pub fn restart(&mut self) {
        [&mut self.rest.q, &mut self.rest.v, &mut self.rest.work].into_iter().for_each(|rest| rest.fill(0.0));
    }

    /// One step of length `h` from `from`; writes `to`, not yet projected. `t_next` is the time that `to` gets, so that
    /// the clock can say it without rounding. `from` is the (projected) result of the step before. Works are integrated
    /// as far as the states hold them.
    ///
    /// # Errors
    /// [`MotionError`] of a stage; `to` is then unspecified.
    /// # Cost
    /// Three evaluations of the accelerations; no allocation.
    pub fn step<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Knot<'_>,
        h: f64,
        t_next: f64,
        to: &mut State,
    ) -> Result<(), MotionError> {
        let Knot { state: from, a, power } = from;
        self.slope.q.copy_from_slice(&from.v);
        self.slope.v.copy_from_slice(a);
        self.slope.work.copy_from_slice(power);
        self.sum.copy_from(&self.slope);
        for (t, c, b) in [(from.t + 0.5 * h, 0.5 * h, 2.0), (from.t + 0.5 * h, 0.5 * h, 2.0), (t_next, h, 1.0)] {
            advance(&mut self.stage, from, c, &self.slope);
            self.slope.q.copy_from_slice(&self.stage.v);
            system.accelerations(t, &self.stage.q, &self.stage.v, &mut self.slope.v, &mut self.lambda)?;
            system.power(t, &self.stage.q, &self.stage.v, &self.lambda, &mut self.slope.work);
            accumulate(&mut self.sum, b, &self.slope);
        }
        add(&mut to.q, &from.q, h / 6.0, &self.sum.q, &mut self.rest.q);
        add(&mut to.v, &from.v, h / 6.0, &self.sum.v, &mut self.rest.v);
        add(&mut to.work, &from.work, h / 6.0, &self.sum.work, &mut self.rest.work);
        to.t = t_next;
        Ok(())
    }
}

/// `to = from + h slope`, with what rounding cuts off in `rest`.
fn add(to: &mut [f64], from: &[f64], h: f64, slope: &[f64], rest: &mut [f64]) {
    for (((to, from), slope), rest) in to.iter_mut().zip(from).zip(slope).zip(rest) {
        *to = compensated::add(*from, h * slope, rest);
    }
}

/// `to = from + h slope`.
fn advance(to: &mut State, from: &State, h: f64, slope: &State) {
    let line = |to: &mut [f64], from: &[f64], slope: &[f64]| {
        to.iter_mut().zip(from).zip(slope).for_each(|((to, from), slope)| *to = from + h * slope);
    };
    line(&mut to.q, &from.q, &slope.q);
    line(&mut to.v, &from.v, &slope.v);
    line(&mut to.work, &from.work, &slope.work);
}

/// `sum += b slope`.
fn accumulate(sum: &mut State, b: f64, slope: &State) {
    let add = |sum: &mut [f64], slope: &[f64]| sum.iter_mut().zip(slope).for_each(|(s, x)| *s += b * x);
    add(&mut sum.q, &slope.q);
    add(&mut sum.v, &slope.v);
    add(&mut sum.work, &slope.work);
}
