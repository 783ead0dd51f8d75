//! Methods with a fixed step: how they end at discontinuities, and sums of states.

use super::discontinuities::{Cut, Discontinuities};
use super::hermite::{Node, interpolate};
use super::{Integrator, compensated};
use crate::archive::Archive;
use crate::dynamics::{Dynamics, MotionError, State};
use crate::scalar::Scalar;

/// The stages of an explicit method.
pub(super) trait Stages<T: Scalar>: Send {
    /// One step of length `h` from `from`; writes `to`, not yet projected. `t_next` is the time that `to` gets, so that
    /// the clock can say it without rounding. `from` is the (projected) result of the step before. Works are integrated
    /// as far as the states hold them.
    ///
    /// # Errors
    /// [`MotionError`] of a stage; `to` is then unspecified.
    fn go<D: Dynamics<T> + ?Sized>(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        h: f64,
        t_next: f64,
        to: &mut State<T>,
    ) -> Result<(), MotionError>;

    /// The state of the last stage; works are left out.
    fn last_stage(&self) -> &State<T>;

    /// What rounding cut off the last step.
    fn rest(&mut self) -> &mut State<T>;
}

/// Steps of a length that the clock gives, shorter where they end at a discontinuity.
pub(super) struct FixedSteps<S>(pub S);

impl<S> FixedSteps<S> {
    fn forget_rest<T: Scalar>(&mut self)
    where
        S: Stages<T>,
    {
        let State { q, v, z, work, .. } = self.0.rest();
        [q, v, z, work].into_iter().for_each(|rest| rest.fill(T::from_f64(0.0)));
    }
}

impl<D: Dynamics<T>, T: Scalar, S: Stages<T>> Integrator<D, T> for FixedSteps<S> {
    fn restart(&mut self) {
        self.forget_rest();
    }

    fn step(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        h: f64,
        t_next: f64,
        discontinuities: &mut dyn Discontinuities<D, T>,
        to: &mut State<T>,
    ) -> Result<(), MotionError> {
        self.0.go(system, from, h, t_next, to)?;
        let mut cut = discontinuities.cut(system, from, &[to, self.0.last_stage()], h);
        while let Some(Cut::Before(length) | Cut::Over(length)) = cut {
            self.forget_rest();
            self.0.go(system, from, length, from.state.t + length, to)?;
            let is_before = matches!(cut, Some(Cut::Before(_)));
            let is_over = is_before && discontinuities.are_crossed(system, from.state, &[to, self.0.last_stage()]);
            cut = is_over.then(|| Cut::nearer(from.state.t, length));
        }
        if to.t >= t_next {
            discontinuities.rest();
        }
        Ok(())
    }

    fn between(
        &mut self,
        _system: &mut D,
        from: Node<'_, T>,
        to: Node<'_, T>,
        t: f64,
        out: &mut State<T>,
    ) -> Result<(), MotionError> {
        interpolate(from, to, t, out);
        Ok(())
    }

    fn remember(&mut self, _system: &mut D, archive: &mut Archive<T>) {
        self.0.rest().remember(archive);
    }

    fn given_step(
        &mut self,
        system: &mut D,
        from: Node<'_, T>,
        h: f64,
        to: &mut State<T>,
    ) -> Result<bool, MotionError> {
        self.0.go(system, from, h, from.state.t + h, to)?;
        Ok(true)
    }
}

/// `to = from + h slope`, with what rounding cuts off in `rest`. The time is left alone.
pub(super) fn add<T: Scalar>(to: &mut State<T>, from: &State<T>, h: f64, slope: &State<T>, rest: &mut State<T>) {
    let h = T::from_f64(h);
    let add = |to: &mut [T], from: &[T], slope: &[T], rest: &mut [T]| {
        for (((to, from), slope), rest) in to.iter_mut().zip(from).zip(slope).zip(rest) {
            *to = compensated::add(*from, h * *slope, rest);
        }
    };
    add(&mut to.q, &from.q, &slope.q, &mut rest.q);
    add(&mut to.v, &from.v, &slope.v, &mut rest.v);
    if !slope.z.is_empty() {
        add(&mut to.z, &from.z, &slope.z, &mut rest.z);
    }
    add(&mut to.work, &from.work, &slope.work, &mut rest.work);
}

/// `to = from + h rates`. The time is left alone.
pub(super) fn advance<T: Scalar>(to: &mut State<T>, from: Node<'_, T>, h: f64) {
    let (Node { state, q_rate, a, rate, power, .. }, h) = (from, T::from_f64(h));
    let each = |to: &mut [T], from: &[T], rates: &[T]| {
        to.iter_mut().zip(from).zip(rates).for_each(|((to, from), rate)| *to = *from + h * *rate);
    };
    each(&mut to.q, &state.q, q_rate);
    each(&mut to.v, &state.v, a);
    each(&mut to.z, &state.z, rate);
    each(&mut to.work, &state.work, power);
}
