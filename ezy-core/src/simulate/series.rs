//! Taylor's method with its step control.

use super::step_limit::{StepLimit, is_too_short, limited_step};
use super::tolerances::steps::{DEFECT_OF_ROUNDING, LARGEST_DEFECT};
use crate::dynamics::{MotionError, State, System};
use crate::integrate::{Node, Taylor, Tolerance};
use crate::model::Scene;

/// Steps along series, of lengths that their coefficients choose.
pub(super) struct AlongSeries<'s> {
    pub taylor: Taylor<'s>,
    tolerance: Tolerance,
    /// Longest step after one that was taken again, s; infinite once coefficients choose shorter ones.
    at_most_s: f64,
    rejected: u64,
}

impl<'s> AlongSeries<'s> {
    pub(super) fn new(taylor: Taylor<'s>, tolerance: Tolerance) -> Self {
        Self { taylor, tolerance, at_most_s: f64::INFINITY, rejected: 0 }
    }

    /// Forgets the steps taken so far.
    pub(super) fn restart(&mut self) {
        self.taylor.restart();
        self.at_most_s = f64::INFINITY;
    }

    /// Steps taken again.
    pub(super) fn n_rejected(&self) -> u64 {
        self.rejected
    }

    /// A step from `from` towards `end`, of a length that keeps to the tolerance; not yet projected.
    pub(super) fn step<S: Scene + ?Sized>(
        &mut self,
        system: &System<'_, S>,
        from: Node<'_>,
        end: f64,
        to: &mut State,
    ) -> Result<(), MotionError> {
        let (t, mut length) = (from.state.t, self.taylor.longest_step(self.tolerance));
        if is_too_short(t, length) && length < end - t {
            return Err(MotionError::StepCollapsed { t, step_s: length });
        }
        if length > self.at_most_s {
            length = self.at_most_s;
        } else {
            self.at_most_s = f64::INFINITY;
        }
        let StepLimit { step_s, t_next } = limited_step(t, end, length);
        self.taylor.advance(system, from.state, step_s, to);
        to.t = t_next;
        Ok(())
    }

    /// Whether the step from `from` to `to`, both evaluated, is to be taken again, half as long: its series is not the motion.
    pub(super) fn shortens(&mut self, from: Node<'_>, to: Node<'_>) -> bool {
        let (t, h) = (from.state.t, to.state.t - from.state.t);
        let shortens = !is_too_short(t, 0.5 * h) && !self.taylor.follows(h, to.a, LARGEST_DEFECT, DEFECT_OF_ROUNDING);
        if shortens {
            self.at_most_s = 0.5 * h;
            self.rejected += 1;
        } else {
            self.at_most_s *= 2.0;
        }
        shortens
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    crate::model! {
        /// A stone that falls.
        pub model Stone {
            body stone { mass: 2, inertia: 1 }
            gravity (0, -10);
            start high { stone at (0, 5) angle 0; at rest; }
            scene falls { start high; until 1 s; }
        }
    }

    /// Accelerations at the end that are no numbers are not those of a series. A step is halved for them as long as half of it changes the time.
    #[test]
    fn analytic_steps_are_halved_as_long_as_halves_change_the_time() {
        let scene = stone::Falls::default();
        for (h, is_halved) in [(1e-3, true), (2.1e-14, true), (1.9e-14, false)] {
            let taylor = Taylor::new(&scene, 8, 0).unwrap();
            let mut series = AlongSeries::new(taylor, Tolerance::new(1e-9, 1e-9));
            let (from, mut to) = (State::zero(3, 0), State::zero(3, 0));
            to.t = h;
            let node = |state| Node { state, a: &[f64::NAN; 3], power: &[] };
            assert_eq!(series.shortens(node(&from), node(&to)), is_halved, "{h:e}");
            assert_eq!(
                (series.at_most_s, series.n_rejected()),
                if is_halved { (0.5 * h, 1) } else { (f64::INFINITY, 0) }
            );
        }
    }
}
