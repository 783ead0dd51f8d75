//! The explicit midpoint method of order 2.

use super::Integrator;
use super::family::{Family, MethodInfo, Needs, Sizes};
use super::fixed_steps::{FixedSteps, Stages, add, advance};
use super::hermite::Node;
use super::step_control::Tolerance;
use super::tolerances::second_run::{ROUNDING, TIGHTER};
use crate::dynamics::{Dynamics, MotionError, State};
use crate::scalar::Scalar;

/// Stages of the method for q' = N(q) v, v' = a(t, q, v, z), z' = rates of first-order states, w' = power of each effect: the slope in the middle of the step, which half a step of
/// Euler's method finds, carries the whole step.
///
/// # Source
/// C. Runge, Math. Ann. 46 (1895) 167–178.
pub(super) struct Midpoint<T = f64> {
    stage: State<T>,
    slope: State<T>,
    /// What rounding cut off the last step.
    rest: State<T>,
    lambda: Vec<T>,
}

impl Family for Midpoint {
    const INFO: MethodInfo = MethodInfo {
        name: "midpoint",
        summary: "Explicit midpoint method of order 2 with a fixed step, to compare with",
        order: Some(2),
        chooses_steps: false,
        is_implicit: false,
        needs: Needs::Nothing,
        takes_any_body: true,
        takes_states: true,
        tighter: TIGHTER,
        rounding: ROUNDING,
    };

    fn in_any_number<D: Dynamics<T>, T: Scalar>(
        Sizes { n_q, n_v, n_c, n_z, n_works }: Sizes,
        _tolerance: Tolerance,
    ) -> Option<Box<dyn Integrator<D, T>>> {
        let zero = State::zeros([n_q, n_v], n_z, n_works);
        let lambda = vec![T::from_f64(0.0); n_c];
        Some(Box::new(FixedSteps(Midpoint { stage: zero.clone(), slope: zero.clone(), rest: zero, lambda })))
    }
}

impl<T: Scalar> Stages<T> for Midpoint<T> {
    /// # Cost
    /// One evaluation of the accelerations; no allocation.
    fn go<D: Dynamics<T> + ?Sized>(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        h: f64,
        t_next: f64,
        to: &mut State<T>,
    ) -> Result<(), MotionError> {
        let Self { stage, slope, rest, lambda } = self;
        advance(stage, from, 0.5 * h);
        stage.t = from.state.t + 0.5 * h;
        system.position_rates(&stage.q, &stage.v, &mut slope.q);
        system.place_states(&stage.z);
        system.accelerations(stage.t, &stage.q, &stage.v, &mut slope.v, lambda)?;
        system.state_rates(stage.t, &stage.q, &stage.v, &mut slope.z);
        system.power(stage.t, &stage.q, &stage.v, lambda, &mut slope.work);
        add(to, from.state, h, slope, rest);
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
