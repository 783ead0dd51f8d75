//! Gauss–Legendre collocation with its step control.

use super::discontinuities::Passage;
use super::step_limit::{StepLimit, is_too_short, limited_step};
use super::tolerances::steps::{APPROACH, LEFT, MAX_DISCONTINUITIES};
use crate::dynamics::{MotionError, State, System};
use crate::integrate::{Collocated, Gauss, GaussControl, Node, Tolerance};
use crate::model::SceneRef;

/// Collocation with the length of its next step.
pub(super) struct Collocation {
    method: Gauss,
    control: GaussControl,
    tolerance: Tolerance,
    /// Length of the next step, s; none before the first.
    step_s: Option<f64>,
    rejected: u64,
    /// Error of the polynomial of the last step, over the tolerance.
    dense_error: f64,
}

impl Collocation {
    pub(super) fn new(method: Gauss, tolerance: Tolerance) -> Self {
        Self { method, control: GaussControl::default(), tolerance, step_s: None, rejected: 0, dense_error: 0.0 }
    }

    /// Forgets the steps taken so far.
    pub(super) fn restart(&mut self) {
        self.method.restart();
        self.control = GaussControl::default();
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

    /// The smallest pivot within the last step; infinite where accelerations were not eliminated.
    pub(super) fn smallest_pivot(&self) -> f64 {
        self.method.smallest_pivot()
    }

    /// The next step starts at the end of the last one.
    pub(super) fn accept(&mut self) {
        self.method.accept();
    }

    /// The state at `t` between the ends of the last step, not projected; its time is left alone.
    ///
    /// # Errors
    /// [`MotionError`] at a node.
    /// # Cost
    /// Where the polynomial of the step is not good enough, some sweeps for each of its parts, once a step.
    pub(super) fn between<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        to: &State,
        t: f64,
        out: &mut State,
    ) -> Result<(), MotionError> {
        let share = (t - from.state.t) / (to.t - from.state.t);
        if self.dense_error <= 1.0 {
            self.method.dense_at(from.state, share, out);
            return Ok(());
        }
        let n_parts = Collocated::n_parts(self.dense_error);
        self.method.dense_in_parts(system, from.state, n_parts, self.tolerance, share, out)
    }

    /// A step from `from` towards `end` whose error is within the tolerance; not yet projected. `passage` says what a step to a
    /// state passes.
    ///
    /// In a layer a force changes by nearly all of itself, and the step is not short beside that: the order of its end is not reached, and
    /// the error of its polynomial counts.
    pub(super) fn step<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        end: f64,
        to: &mut State,
        mut passage: impl FnMut(&mut System<P>, &State) -> Passage,
    ) -> Result<(), MotionError> {
        let t = from.state.t;
        let left = end - t;
        let mut length = self.step_s.unwrap_or_else(|| self.method.first_step(from, left));
        // the step length before a discontinuity, to continue with behind it
        let (mut whole, mut n_discontinuities) = (None, 0);
        loop {
            let StepLimit { step_s: h, t_next } = limited_step(t, end, length);
            if is_too_short(t, h) && h < left {
                return Err(MotionError::StepCollapsed { t, step_s: h });
            }
            match self.method.attempt(system, from, h, self.tolerance, to) {
                Ok(Collocated::Solved { mut error, dense_error, rate }) => {
                    let passage = passage(system, to);
                    if passage == Passage::Layer {
                        error = error.max(dense_error);
                    }
                    if let Passage::Ends(shorter) = passage
                        && n_discontinuities < MAX_DISCONTINUITIES
                    {
                        n_discontinuities += 1;
                        let whole = *whole.get_or_insert(h);
                        length = if shorter > LEFT * whole { APPROACH * shorter } else { shorter };
                    } else {
                        let factor = self.control.factor(error, rate);
                        if error <= 1.0 {
                            to.t = t_next;
                            self.dense_error = dense_error;
                            // one that was cut short says little of the next
                            let shortest = if h < length { length } else { 0.0 };
                            self.step_s = Some(whole.unwrap_or((h * factor).max(shortest)));
                            return Ok(());
                        }
                        length = h * factor;
                    }
                }
                Ok(Collocated::Diverged) => length = h * self.control.failed(),
                // a node may have left the region where the equations are defined; a shorter step may not
                Err(error) => {
                    length = h * self.control.failed();
                    if is_too_short(t, length) {
                        return Err(error);
                    }
                }
            }
            self.rejected += 1;
        }
    }
}
