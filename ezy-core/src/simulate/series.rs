//! Taylor's method with its step control.

use super::step_limit::{StepLimit, is_too_short, limited_step};
use crate::dynamics::{MotionError, State, System};
use crate::integrate::{Node, Taylor, Tolerance};
use crate::model::Scene;

/// Steps along series, of lengths that their coefficients choose.
pub(super) struct AlongSeries<'s> {
    pub taylor: Taylor<'s>,
    tolerance: Tolerance,
}

impl<'s> AlongSeries<'s> {
    pub(super) fn new(taylor: Taylor<'s>, tolerance: Tolerance) -> Self {
        Self { taylor, tolerance }
    }

    /// A step from `from` towards `end`, of a length that keeps to the tolerance; not yet projected.
    pub(super) fn step<S: Scene + ?Sized>(
        &mut self,
        system: &System<'_, S>,
        from: Node<'_>,
        end: f64,
        to: &mut State,
    ) -> Result<(), MotionError> {
        let (t, length) = (from.state.t, self.taylor.longest_step(self.tolerance));
        if is_too_short(t, length) && length < end - t {
            return Err(MotionError::StepCollapsed { t, step_s: length });
        }
        let StepLimit { step_s, t_next } = limited_step(t, end, length);
        self.taylor.advance(system, from.state, step_s, to);
        to.t = t_next;
        Ok(())
    }
}
