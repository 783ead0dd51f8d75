//! Taylor's method with DOP853 as its fallback next to singular positions.

use super::adaptive::Adaptive;
use super::reach::{Reach, is_too_short, reach};
use super::usual;
use crate::dynamics::{MotionError, State, System};
use crate::integrate::{Knot, Taylor, Tolerance};
use crate::model::Scene;

/// Taylor's method, and DOP853 next to rank loss, where the rounding error of a coefficient grows with its order.
pub(super) struct TaylorWithDetour<'s> {
    pub taylor: Taylor<'s>,
    tolerance: Tolerance,
    /// Usual step length, s.
    usual_s: f64,
    detour: Adaptive,
    /// Whether the last step was one of the fallback.
    is_on_detour: bool,
}

/// The rank is checked when a step is shorter than this part of the usual one.
const SHORT: f64 = 0.2;

impl<'s> TaylorWithDetour<'s> {
    pub fn new(taylor: Taylor<'s>, tolerance: Tolerance, detour: Adaptive) -> Self {
        Self { taylor, tolerance, usual_s: 0.0, detour, is_on_detour: false }
    }

    /// Forgets the steps taken so far.
    pub fn restart(&mut self) {
        self.taylor.restart();
        self.detour.restart();
        self.usual_s = 0.0;
    }

    /// Rejected steps.
    pub fn n_rejected(&self) -> u64 {
        self.detour.n_rejected()
    }

    /// The state at `t` between the ends of the last step, not projected.
    pub fn between<S: Scene + ?Sized>(
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

    /// A step from `from` towards `end` whose error is within the tolerance; not yet projected.
    pub fn step<S: Scene + ?Sized>(
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
            // laws with a series are smooth
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
