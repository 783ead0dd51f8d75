//! When the simplified Newton iteration has converged.

use crate::integrate::Tolerance;
use crate::integrate::tolerances::radau::{AT_ONCE, FORGET, MAX_PASSES, PART, ROUNDING, SHORTEN, SLOWEST, TRUSTED};

/// Follows the changes of the passes of one iteration.
///
/// # Source
/// Hairer, Wanner, Solving Ordinary Differential Equations II (1996), IV.8, (8.10) and (8.11).
pub(super) struct Convergence {
    goal: f64,
    n_passes: u32,
    /// Error after a pass over its change.
    share: f64,
    last_change: f64,
    last_unsolved: f64,
    last_ratio: f64,
    rate: f64,
}

/// Decision after an iteration.
pub(super) enum Verdict {
    GoOn,
    Converged,
    /// The iteration diverges; this factor for the step may help.
    Diverged {
        factor: f64,
    },
}

impl Convergence {
    /// `share` is the rate of convergence of the previous step.
    pub(super) fn new(tolerance: Tolerance, share: f64) -> Self {
        let goal = (ROUNDING / tolerance.relative).max(PART.min(tolerance.relative.sqrt()));
        let share = share.max(f64::EPSILON).powf(FORGET);
        Self { goal, n_passes: 0, share, last_change: 0.0, last_unsolved: 0.0, last_ratio: 0.0, rate: AT_ONCE }
    }

    /// Judges a pass that changed the stages by `change` tolerances, from residuals that alone would change velocities by `unsolved`
    /// tolerances.
    pub(super) fn judge(&mut self, change: f64, unsolved: f64) -> Verdict {
        self.n_passes += 1;
        if !change.is_finite() {
            return Verdict::Diverged { factor: SHORTEN };
        }
        if self.n_passes > 1 {
            let ratio = change / self.last_change;
            self.rate = if self.n_passes == 2 { ratio } else { (ratio * self.last_ratio).sqrt() };
            self.last_ratio = ratio;
            if change == 0.0 && unsolved <= self.goal {
                return Verdict::Converged;
            }
            if self.rate >= SLOWEST {
                return Verdict::Diverged { factor: SHORTEN };
            }
            // a geometric series of changes; the first one may be large by a poor guess, and the ratio small by that
            let share = self.rate / (1.0 - self.rate);
            self.share = if self.n_passes == 2 { share.max(self.share) } else { share };
        }
        self.last_change = change.max(f64::MIN_POSITIVE);
        let left = self.share * change;
        let is_solved = unsolved <= self.goal || (self.n_passes > 1 && unsolved <= TRUSTED * self.last_unsolved);
        self.last_unsolved = unsolved;
        if left <= self.goal && is_solved {
            return Verdict::Converged;
        }
        if self.n_passes == 1 {
            return Verdict::GoOn;
        }
        let Some(n_left) = (MAX_PASSES - 1).checked_sub(self.n_passes) else {
            return Verdict::Diverged { factor: SHORTEN };
        };
        let expected = left * self.rate.powi(n_left as i32) / self.goal;
        if expected < 1.0 {
            return Verdict::GoOn;
        }
        let power = -1.0 / f64::from(5 + n_left);
        Verdict::Diverged { factor: 0.8 * expected.min(20.0).powf(power) }
    }

    /// Rate of convergence: error after a pass over error before.
    pub(super) fn rate(&self) -> f64 {
        self.rate
    }

    /// Error after a pass over the change of that pass.
    pub(super) fn share(&self) -> f64 {
        self.share
    }

    pub(super) fn n_passes(&self) -> u32 {
        self.n_passes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLERANCE: Tolerance = Tolerance::new(1e-6, 1e-6);

    /// Rounding of some powers.
    const ROUNDING: f64 = 1e-12;

    fn close(x: f64, y: f64) {
        assert!((x - y).abs() <= ROUNDING * y.abs(), "{x} {y}");
    }

    /// Changes 1, 1/10, 1/100 … of which 1/9 of the last one is left: below the goal of 1e-3 from 1e-3 on.
    #[test]
    fn analytic_geometric_series_of_changes_ends_at_what_is_left_of_it() {
        let mut convergence = Convergence::new(TOLERANCE, 1.0);
        for change in [1.0, 0.1, 0.01] {
            assert!(matches!(convergence.judge(change, change), Verdict::GoOn), "{change}");
        }
        close(convergence.rate(), 0.1);
        close(convergence.share(), 1.0 / 9.0);
        assert!(matches!(convergence.judge(1e-3, 1e-3), Verdict::Converged));
        assert_eq!(convergence.n_passes(), 4);
    }

    /// A residual that is gone does not end the iteration while stages still change.
    #[test]
    fn invariant_changes_count_where_nothing_is_left_of_the_residual() {
        let mut convergence = Convergence::new(TOLERANCE, 1.0);
        for change in [1.0, 0.1, 0.01] {
            assert!(matches!(convergence.judge(change, 0.0), Verdict::GoOn), "{change}");
        }
    }

    /// From the third pass on the rate is the geometric mean of the last two: √(0.1 · 0.001).
    #[test]
    fn analytic_rate_is_the_mean_of_two_passes() {
        let mut convergence = Convergence::new(TOLERANCE, 1.0);
        convergence.judge(1.0, 1.0);
        convergence.judge(0.1, 1.0);
        close(convergence.rate(), 0.1);
        convergence.judge(1e-4, 1.0);
        close(convergence.rate(), 1e-2);
        close(convergence.share(), 1e-2 / 0.99);
    }

    /// The goal is the root of the tolerance, at most 3 % and at least ten roundings over the tolerance: a first pass ends the iteration when
    /// it is met with the share of the step before, to the power 0.8.
    #[test]
    fn analytic_goal_is_the_root_of_the_tolerance_within_bounds() {
        for (relative, goal) in [(1e-6, 1e-3), (1e-2, 0.03), (1e-14, 10.0 * f64::EPSILON / 1e-14)] {
            for share in [1.0, 1e-2] {
                let ends = |change: f64| {
                    let mut convergence = Convergence::new(Tolerance::new(relative, 1.0), share);
                    matches!(convergence.judge(change, 0.0), Verdict::Converged)
                };
                let largest = goal / share.powf(0.8);
                assert!(ends(0.999 * largest) && !ends(1.001 * largest), "{relative:e} {share}");
            }
        }
    }

    /// At the rate θ the second pass leaves θ/(1 − θ) of its change θ, and four more passes θ⁴ of that. Where this is more than the goal of 1e-3,
    /// at most 20 times as much, the step is shortened by a root of it.
    #[test]
    fn analytic_slow_iterations_ask_for_a_shorter_step() {
        let after_two = |rate: f64| {
            let mut convergence = Convergence::new(TOLERANCE, 1e-16);
            assert!(matches!(convergence.judge(1.0, 1.0), Verdict::GoOn));
            convergence.judge(rate, 1.0)
        };
        for (rate, expected) in [(0.7_f64, 20.0), (0.4, 0.4_f64.powi(6) / 0.6 / 1e-3)] {
            let Verdict::Diverged { factor } = after_two(rate) else { panic!("{rate}") };
            close(factor, 0.8 * expected.powf(-1.0 / 9.0));
        }
        // 0.29⁶/0.71 is 8e-4
        assert!(matches!(after_two(0.29), Verdict::GoOn));
        for rate in [0.99, 1.5, f64::NAN] {
            let Verdict::Diverged { factor } = after_two(rate) else { panic!("{rate}") };
            assert_eq!(factor, 0.5, "{rate}");
        }
    }

    /// Small changes of stages whose residuals are still there are no solution: after the first pass they have to be within the goal, later a
    /// tenth of those before.
    #[test]
    fn invariant_small_changes_that_leave_residuals_do_not_end_the_iteration() {
        let goes_on = |[first, second]: [f64; 2]| {
            let mut convergence = Convergence::new(TOLERANCE, 1e-16);
            assert!(matches!(convergence.judge(1e-5, first), Verdict::GoOn));
            matches!(convergence.judge(1e-7, second), Verdict::GoOn)
        };
        assert!(goes_on([100.0, 10.1]) && !goes_on([100.0, 9.9]));
        assert!(goes_on([5e-3, 1.1e-3]) && !goes_on([5e-3, 0.9e-3]));
    }

    /// Nothing changes: solved when the residual is within the goal, else without hope.
    #[test]
    fn invariant_a_pass_without_changes_is_the_last() {
        let after = |unsolved: f64| {
            let mut convergence = Convergence::new(TOLERANCE, 1.0);
            convergence.judge(1.0, 1.0);
            convergence.judge(0.0, unsolved)
        };
        assert!(matches!(after(0.9e-3), Verdict::Converged));
        assert!(matches!(after(2.0), Verdict::GoOn));
    }

    /// The seventh pass is the last one.
    #[test]
    fn regress_iterations_end_after_seven_passes() {
        let mut convergence = Convergence::new(TOLERANCE, 1.0);
        let mut n = 0;
        // changes so small that only the residual keeps it going
        while matches!(convergence.judge(1e-6 * 0.1_f64.powi(n), 1.0), Verdict::GoOn) {
            n += 1;
        }
        assert_eq!((n, convergence.n_passes()), (6, 7));
    }
}
