//! The classical Runge–Kutta method of order 4.

use super::{Node, compensated};
use crate::dynamics::{Dynamics, MotionError, State};
use crate::scalar::Scalar;

/// Stages of the method for q' = v, v' = a(t, q, v), w' = power of each effect.
///
/// The steps of one run are summed with compensation: what rounding cuts off a sum is added to the next one. Without
/// it a body that rolls straight for 1e5 steps is 1e-10 m off, since each step is rounded the same way.
///
/// # Source
/// W. Kutta, Z. Math. Phys. 46 (1901) 435–453.
#[derive(Debug)]
pub(crate) struct Rk4<T = f64> {
    stage: State<T>,
    slope: State<T>,
    sum: State<T>,
    /// What rounding cut off the last step.
    rest: State<T>,
    lambda: Vec<T>,
}

impl<T: Scalar> Rk4<T> {
    /// Storage for a scene with these sizes.
    pub(crate) fn new(n_coordinates: usize, n_rows: usize, n_effects: usize) -> Self {
        let zero = State::zeros(n_coordinates, n_effects);
        Self {
            stage: zero.clone(),
            slope: zero.clone(),
            sum: zero.clone(),
            rest: zero,
            lambda: vec![T::from_f64(0.0); n_rows],
        }
    }

    /// Forgets the rounding errors of the sums, before another run.
    pub(crate) fn restart(&mut self) {
        [&mut self.rest.q, &mut self.rest.v, &mut self.rest.work]
            .into_iter()
            .for_each(|rest| rest.fill(T::from_f64(0.0)));
    }

    /// One step of length `h` from `from`; writes `to`, not yet projected. `t_next` is the time that `to` gets, so that
    /// the clock can say it without rounding. `from` is the (projected) result of the step before. Works are integrated
    /// as far as the states hold them.
    ///
    /// # Errors
    /// [`MotionError`] of a stage; `to` is then unspecified.
    /// # Cost
    /// Three evaluations of the accelerations; no allocation.
    pub(crate) fn step(
        &mut self,
        system: &mut impl Dynamics<T>,
        from: Node<'_, T>,
        h: f64,
        t_next: f64,
        to: &mut State<T>,
    ) -> Result<(), MotionError> {
        let Node { state: from, a, power } = from;
        self.slope.q.copy_from_slice(&from.v);
        self.slope.v.copy_from_slice(a);
        self.slope.work.copy_from_slice(power);
        self.sum.copy_from(&self.slope);
        for (t, c, b) in [(from.t + 0.5 * h, 0.5 * h, 2.0), (from.t + 0.5 * h, 0.5 * h, 2.0), (t_next, h, 1.0)] {
            advance(&mut self.stage, from, c, &self.slope);
            self.stage.t = t;
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

    /// The state of the last stage, near the end of the step; works are left out.
    pub(crate) fn last_stage(&self) -> &State<T> {
        &self.stage
    }
}

/// `to = from + h slope`, with what rounding cuts off in `rest`.
fn add<T: Scalar>(to: &mut [T], from: &[T], h: f64, slope: &[T], rest: &mut [T]) {
    let h = T::from_f64(h);
    for (((to, from), slope), rest) in to.iter_mut().zip(from).zip(slope).zip(rest) {
        *to = compensated::add(*from, h * *slope, rest);
    }
}

/// `to = from + h slope`.
fn advance<T: Scalar>(to: &mut State<T>, from: &State<T>, h: f64, slope: &State<T>) {
    let h = T::from_f64(h);
    let line = |to: &mut [T], from: &[T], slope: &[T]| {
        to.iter_mut().zip(from).zip(slope).for_each(|((to, from), slope)| *to = *from + h * *slope);
    };
    line(&mut to.q, &from.q, &slope.q);
    line(&mut to.v, &from.v, &slope.v);
    line(&mut to.work, &from.work, &slope.work);
}

/// `sum += b slope`.
fn accumulate<T: Scalar>(sum: &mut State<T>, b: f64, slope: &State<T>) {
    let b = T::from_f64(b);
    let add = |sum: &mut [T], slope: &[T]| sum.iter_mut().zip(slope).for_each(|(s, x)| *s = *s + b * *x);
    add(&mut sum.q, &slope.q);
    add(&mut sum.v, &slope.v);
    add(&mut sum.work, &slope.work);
}
