//! Taylor's method, with another one for the neighbourhood of singular positions.

use super::adaptive::Adaptive;
use super::reach::{Reach, is_too_short, reach};
use super::usual;
use crate::dynamics::{MotionError, State, System};
use crate::integrate::{Knot, Taylor, Tolerance};
use crate::model::Scene;

/// Steps along series, and stages instead next to rank loss: there, what rounding does to a coefficient grows with its order.
pub(super) struct TaylorWithDetour<'s> {
    pub taylor: Taylor<'s>,
    tolerance: Tolerance,
    /// A usual length of a step, s.
    usual_s: f64,
    detour: Adaptive,
    /// Whether the last step was a detour.
    is_on_detour: bool,
}

/// Steps that shorten to this part of the usual raise the question of rank.
const SHORT: f64 = 0.2;

impl<'s> TaylorWithDetour<'s> {
    pub(super) fn new(taylor: Taylor<'s>, tolerance: Tolerance, detour: Adaptive) -> Self {
        Self { taylor, tolerance, usual_s: 0.0, detour, is_on_detour: false }
    }

    /// Forgets the steps taken so far.
    pub(super) fn restart(&mut self) {
        self.taylor.restart();
        self.detour.restart();
        self.usual_s = 0.0;
    }

    /// Steps that were tried and not taken.
    pub(super) fn n_rejected(&self) -> u64 {
        self.detour.n_rejected()
    }

    /// The state at `t` between the ends of the last step, not projected.
    pub(super) fn between<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Knot<'_>,
        to: Knot<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<(), MotionError> {
        if self.is_on_detour {
            return self.detour.between(system, from, to, t, out);
        }
        self.taylor.dense_at(system, from.state, t - from.state.t, out);
        Ok(())
    }

    /// A step from `from` towards `end`, of a length that keeps to the tolerance; not yet projected.
    pub(super) fn step<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Knot<'_>,
        end: f64,
        to: &mut State,
    ) -> Result<(), MotionError> {
        let (t, length) = (from.state.t, self.taylor.longest_step(self.tolerance));
        let is_short = length < SHORT * self.usual_s;
        self.usual_s = usual::follow(self.usual_s, length, length.min(end - t));
        let was_on_detour = std::mem::replace(
            &mut self.is_on_detour,
            is_short && length < end - t && system.is_near_rank_loss(t, &from.state.q),
        );
        if self.is_on_detour {
            if !was_on_detour {
                self.detour.take_over(self.usual_s);
            }
            // laws that have series have no kinks
            return self.detour.step(system, from, end, to, |_, _| None);
        }
        if is_too_short(t, length) && length < end - t {
            return Err(MotionError::StepCollapsed { t, step_s: length });
        }
        let Reach { step_s, t_next } = reach(t, end, length);
        self.taylor.advance(system, from.state, step_s, to);
        to.t = t_next;
        Ok(())
    }
}
