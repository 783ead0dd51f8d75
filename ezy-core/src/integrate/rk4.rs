//! The classical Runge–Kutta method of order 4.

use super::Integrator;
use super::family::{Family, MethodInfo, Needs, Sizes};
use super::fixed_steps::{FixedSteps, Stages, add, advance};
use super::hermite::Node;
use super::step_control::Tolerance;
use super::tolerances::second_run::{ROUNDING, TIGHTER};
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
    slope: State<T>,
    sum: State<T>,
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
        Self {
            stage: zero.clone(),
            slope: zero.clone(),
            sum: zero.clone(),
            rest: zero,
            lambda: vec![T::from_f64(0.0); n_c],
        }
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
                _ => advance(&mut self.stage, start, c, &self.slope),
            }
            self.stage.t = t;
            system.position_rates(&self.stage.q, &self.stage.v, &mut self.slope.q);
            if has_states {
                system.place_states(&self.stage.z);
            }
            system.accelerations(t, &self.stage.q, &self.stage.v, &mut self.slope.v, &mut self.lambda)?;
            if has_states {
                system.state_rates(t, &self.stage.q, &self.stage.v, &mut self.slope.z);
            }
            system.power(t, &self.stage.q, &self.stage.v, &self.lambda, &mut self.slope.work);
            match stage {
                0 => advance(&mut self.sum, from, b, &self.slope),
                _ => accumulate(&mut self.sum, b, &self.slope),
            }
        }
        add(to, start, h / 6.0, &self.sum, &mut self.rest);
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

/// `sum += b slope`.
fn accumulate<T: Scalar>(sum: &mut State<T>, b: f64, slope: &State<T>) {
    let b = T::from_f64(b);
    let add = |sum: &mut [T], slope: &[T]| sum.iter_mut().zip(slope).for_each(|(s, x)| *s = *s + b * *x);
    add(&mut sum.q, &slope.q);
    add(&mut sum.v, &slope.v);
    if !slope.z.is_empty() {
        add(&mut sum.z, &slope.z);
    }
    add(&mut sum.work, &slope.work);
}
