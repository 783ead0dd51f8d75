//! The classical Runge–Kutta method of order 4.

use super::family::{Family, MethodInfo, Needs, Sizes};
use super::fixed_steps::{FixedSteps, Stages};
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

    /// The stage at `from + h rates` of its start; `sum` are these rates. Times are left alone.
    fn begin(&mut self, sum: &mut State<T>, from: Node<'_, T>, h: f64) {
        let Self { stage, .. } = self;
        let (Node { state, q_rate, a, rate, power, .. }, h) = (from, T::from_f64(h));
        let each = |sum: &mut [T], stage: &mut [T], from: &[T], rates: &[T]| {
            for (((sum, stage), from), rate) in sum.iter_mut().zip(stage).zip(from).zip(rates) {
                (*sum, *stage) = (*rate, *from + h * *rate);
            }
        };
        each(&mut sum.q, &mut stage.q, &state.q, q_rate);
        each(&mut sum.v, &mut stage.v, &state.v, a);
        each(&mut sum.z, &mut stage.z, &state.z, rate);
        each(&mut sum.work, &mut stage.work, &state.work, power);
    }

    /// Adds the slope of a stage in the middle to `sum`, twice; the next stage is at `from + h slope`.
    fn go_on(&mut self, sum: &mut State<T>, from: &State<T>, h: f64) {
        let (Self { stage, slope, .. }, h, twice) = (self, T::from_f64(h), T::from_f64(2.0));
        let each = |sum: &mut [T], stage: &mut [T], from: &[T], slope: &[T]| {
            for (((sum, stage), from), slope) in sum.iter_mut().zip(stage).zip(from).zip(slope) {
                (*sum, *stage) = (*sum + twice * *slope, *from + h * *slope);
            }
        };
        // coordinates come first: the velocities that are their rates are those of the stage before
        each(&mut sum.q, &mut stage.q, &from.q, if slope.q.is_empty() { &stage.v } else { &slope.q });
        each(&mut sum.v, &mut stage.v, &from.v, &slope.v);
        each(&mut sum.z, &mut stage.z, &from.z, &slope.z);
        each(&mut sum.work, &mut stage.work, &from.work, &slope.work);
    }

    /// `to = from + h (to + slope)`, with what rounding cuts off in `rest`.
    fn finish(&mut self, to: &mut State<T>, from: &State<T>, h: f64) {
        let (Self { stage, slope, rest, .. }, h) = (self, T::from_f64(h));
        let each = |to: &mut [T], from: &[T], slope: &[T], rest: &mut [T]| {
            for (((to, from), slope), rest) in to.iter_mut().zip(from).zip(slope).zip(rest) {
                *to = compensated::add(*from, h * (*to + *slope), rest);
            }
        };
        each(&mut to.q, &from.q, if slope.q.is_empty() { &stage.v } else { &slope.q }, &mut rest.q);
        each(&mut to.v, &from.v, &slope.v, &mut rest.v);
        each(&mut to.z, &from.z, &slope.z, &mut rest.z);
        each(&mut to.work, &from.work, &slope.work, &mut rest.work);
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
        // the end holds the sum of the slopes until they are all there
        self.begin(to, from, half);
        for (t, next) in [(start.t + half, Some(half)), (start.t + half, Some(h)), (t_next, None)] {
            let Self { stage, slope, lambda, .. } = self;
            stage.t = t;
            if !slope.q.is_empty() {
                system.position_rates(&stage.q, &stage.v, &mut slope.q);
            }
            if has_states {
                system.place_states(&stage.z);
            }
            system.accelerations(t, &stage.q, &stage.v, &mut slope.v, lambda)?;
            if has_states {
                system.state_rates(t, &stage.q, &stage.v, &mut slope.z);
            }
            system.power(t, &stage.q, &stage.v, lambda, &mut slope.work);
            match next {
                Some(h) => self.go_on(to, start, h),
                None => self.finish(to, start, h / 6.0),
            }
        }
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
