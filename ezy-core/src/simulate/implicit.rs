//! Radau IIA with its step control.

use super::discontinuities::{Cut, Discontinuities};
use super::step_limit::{StepLimit, is_too_short, limited_step};
use crate::dynamics::{MotionError, State, System};
use crate::integrate::{Attempt, Node, Radau, RadauControl, Tolerance, tolerance_of_estimate};
use crate::model::Scene;

/// Radau IIA with the length of its next step.
pub(super) struct Implicit {
    method: Radau,
    control: RadauControl,
    /// Of the error estimate.
    tolerance: Tolerance,
    /// Length of the next step, s; none before the first.
    step_s: Option<f64>,
    rejected: u64,
}

impl Implicit {
    pub(super) fn new(method: Radau, tolerance: Tolerance) -> Self {
        let tolerance = tolerance_of_estimate(tolerance);
        Self { method, control: RadauControl::default(), tolerance, step_s: None, rejected: 0 }
    }

    /// Forgets the steps taken so far.
    pub(super) fn restart(&mut self) {
        self.method.restart();
        self.control = RadauControl::default();
        self.step_s = None;
    }

    /// Forgets the steps taken so far, and begins with this step length, s.
    pub(super) fn restart_with(&mut self, step_s: f64) {
        self.restart();
        self.step_s = Some(step_s);
    }

    /// Rejected steps.
    pub(super) fn n_rejected(&self) -> u64 {
        self.rejected
    }

    /// The state at `t` between the ends of the last step, not projected; its time is left alone.
    pub(super) fn between(&self, from: &State, to: &State, t: f64, out: &mut State) {
        self.method.dense_at(from, to, (t - from.t) / (to.t - from.t), out);
    }

    /// A step from `from` towards `end` whose error is within the tolerance; not yet projected. It ends at a discontinuity.
    pub(super) fn step<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Node<'_>,
        end: f64,
        discontinuities: &mut Discontinuities,
        to: &mut State,
    ) -> Result<(), MotionError> {
        let t = from.state.t;
        let left = end - t;
        let mut length = self.step_s.unwrap_or_else(|| self.method.first_step(from, left, self.tolerance));
        // the step length before a discontinuity, to continue with behind it
        let (mut whole, mut cut) = (None, None);
        loop {
            let StepLimit { step_s: h, t_next } = limited_step(t, end, length);
            if is_too_short(t, h) && h < left {
                return Err(MotionError::StepCollapsed { t, step_s: h });
            }
            let attempt = self.method.attempt(system, from, h, self.tolerance, to)?;
            if matches!(attempt, Attempt::Solved { .. }) {
                to.t = t_next;
                let next_cut = match cut {
                    None => discontinuities.cut(system, from, &[to], h),
                    Some(Cut::Before(_)) if discontinuities.are_crossed(system, from.state, &[to]) => {
                        Some(Cut::nearer(t, h))
                    }
                    Some(_) => None,
                };
                if let Some(Cut::Before(shorter) | Cut::Over(shorter)) = next_cut {
                    whole.get_or_insert(h);
                    (cut, length) = (next_cut, shorter);
                    self.rejected += 1;
                    continue;
                }
            }
            match attempt {
                Attempt::Solved { error, n_passes } if error <= 1.0 => {
                    self.step_s = Some(match whole {
                        Some(whole) => whole,
                        None => {
                            discontinuities.restart();
                            self.control.accept(h, error, n_passes, self.method.keeps_factors())
                        }
                    });
                    self.method.accept(h);
                    if cut.is_some() {
                        self.method.turn();
                    }
                    return Ok(());
                }
                Attempt::Solved { error, n_passes } => length = self.control.reject(h, error, n_passes),
                Attempt::Diverged { factor } => length = self.control.diverge(h, factor),
            }
            self.rejected += 1;
        }
    }
}
