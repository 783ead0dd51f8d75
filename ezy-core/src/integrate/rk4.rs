//! The classical Runge–Kutta method of order 4.

use super::family::{Family, MethodInfo, Needs, Sizes};
use super::fixed_steps::{FixedSteps, Numbers, Stages, advance, line};
use super::hermite::Node;
use super::step_control::Tolerance;
use super::tolerances::second_run::{ROUNDING, TIGHTER};
use super::{Integrator, compensated};
use crate::dynamics::{Dynamics, MotionError, State};
use crate::scalar::Scalar;

/// Stages of the method for q' = N(q) v, v' = a(t, q, v, z), z' = rates of first-order states, w' = power of each effect.
///
/// The steps of one run are summed with compensation: what rounding cuts off a sum is added to the next one. Without
/// it a body that rolls straight for 1e5 steps is 1e-10 m off, since each step is rounded the same way.
///
/// # Source
/// W. Kutta, Z. Math. Phys. 46 (1901) 435–453.
pub(super) struct Rk4<T = f64> {
    stage: State<T>,
    /// Rates of the stage; of coordinates none where they are its velocities.
    slope: State<T>,
    /// What rounding cut off the last step.
    rest: State<T>,
    lambda: Vec<T>,
}

impl Family for Rk4 {
    const INFO: MethodInfo = MethodInfo {
        name: "rk4",
        summary: "Classical Runge-Kutta method of order 4 with a fixed step",
        order: Some(4),
        chooses_steps: false,
        is_implicit: false,
        needs: Needs::Nothing,
        takes_any_body: true,
        takes_states: true,
        tighter: TIGHTER,
        rounding: ROUNDING,
    };

    fn in_any_number<D: Dynamics<T>, T: Scalar>(
        sizes: Sizes,
        _tolerance: Tolerance,
    ) -> Option<Box<dyn Integrator<D, T>>> {
        Some(Box::new(FixedSteps(Rk4::new(sizes))))
    }
}

impl<T: Scalar> Rk4<T> {
    fn new(Sizes { n_q, n_v, n_c, n_z, n_works }: Sizes) -> Self {
        let zero = State::zeros([n_q, n_v], n_z, n_works);
        let n_rates = if n_q == n_v { 0 } else { n_q };
        let slope = State::zeros([n_rates, n_v], n_z, n_works);
        Self { stage: zero.clone(), slope, rest: zero, lambda: vec![T::from_f64(0.0); n_c] }
    }

    fn slope(&self) -> Numbers<'_, T> {
        let numbers = Numbers::from(&self.slope);
        if numbers.q.is_empty() { Numbers { q: &self.stage.v, ..numbers } } else { numbers }
    }

    /// The stage at `from + h slope`. The time is left alone.
    fn advance_stage(&mut self, from: &State<T>, h: f64) {
        let (Self { stage, slope, .. }, h) = (self, T::from_f64(h));
        // coordinates come first: the velocities that are their rates are those of the stage before
        line(&mut stage.q, &from.q, h, if slope.q.is_empty() { &stage.v } else { &slope.q });
        line(&mut stage.v, &from.v, h, &slope.v);
        line(&mut stage.z, &from.z, h, &slope.z);
        line(&mut stage.work, &from.work, h, &slope.work);
    }
}

impl<T: Scalar> Stages<T> for Rk4<T> {
    /// # Cost
    /// Three evaluations of the accelerations; no allocation.
    fn go<D: Dynamics<T> + ?Sized>(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        h: f64,
        t_next: f64,
        to: &mut State<T>,
    ) -> Result<(), MotionError> {
        let (start, half) = (from.state, 0.5 * h);
        let has_states = !from.rate.is_empty();
        for (stage, (t, c, b)) in
            [(start.t + half, half, 2.0), (start.t + half, half, 2.0), (t_next, h, 1.0)].into_iter().enumerate()
        {
            match stage {
                0 => advance(&mut self.stage, start, c, from),
                _ => self.advance_stage(start, c),
            }
            self.stage.t = t;
            if !self.slope.q.is_empty() {
                system.position_rates(&self.stage.q, &self.stage.v, &mut self.slope.q);
            }
            if has_states {
                system.place_states(&self.stage.z);
            }
            system.accelerations(t, &self.stage.q, &self.stage.v, &mut self.slope.v, &mut self.lambda)?;
            if has_states {
                system.state_rates(t, &self.stage.q, &self.stage.v, &mut self.slope.z);
            }
            system.power(t, &self.stage.q, &self.stage.v, &self.lambda, &mut self.slope.work);
            match stage {
                // the end holds the sum of the slopes until they are all there
                0 => advance(to, from, b, self.slope()),
                _ => accumulate(to, b, self.slope()),
            }
        }
        finish(to, start, h / 6.0, &mut self.rest);
        to.t = t_next;
        Ok(())
    }

    fn last_stage(&self) -> &State<T> {
        &self.stage
    }

    fn rest(&mut self) -> &mut State<T> {
        &mut self.rest
    }
}

/// `to = from + h to`, with what rounding cuts off in `rest`.
fn finish<T: Scalar>(to: &mut State<T>, from: &State<T>, h: f64, rest: &mut State<T>) {
    let h = T::from_f64(h);
    let add = |to: &mut [T], from: &[T], rest: &mut [T]| {
        for ((to, from), rest) in to.iter_mut().zip(from).zip(rest) {
            *to = compensated::add(*from, h * *to, rest);
        }
    };
    add(&mut to.q, &from.q, &mut rest.q);
    add(&mut to.v, &from.v, &mut rest.v);
    if !from.z.is_empty() {
        add(&mut to.z, &from.z, &mut rest.z);
    }
    add(&mut to.work, &from.work, &mut rest.work);
}

/// `sum += b slope`.
fn accumulate<T: Scalar>(sum: &mut State<T>, b: f64, slope: Numbers<'_, T>) {
    let b = T::from_f64(b);
    let add = |sum: &mut [T], slope: &[T]| sum.iter_mut().zip(slope).for_each(|(s, x)| *s = *s + b * *x);
    add(&mut sum.q, slope.q);
    add(&mut sum.v, slope.v);
    if !slope.z.is_empty() {
        add(&mut sum.z, slope.z);
    }
    add(&mut sum.work, slope.work);
}
