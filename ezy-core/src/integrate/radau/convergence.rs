//! When the simplified Newton iteration has converged.

use crate::integrate::Tolerance;

/// Largest number of Newton iterations of a step.
pub(super) const MAX_PASSES: u32 = 7;
/// The iteration ends when its error is below this part of the tolerance, or below the root of the tolerance.
const PART: f64 = 0.03;
/// Rounding of sums of some terms, in parts of the largest: changes and residuals below it are zero.
pub(super) const ROUNDING: f64 = 10.0 * f64::EPSILON;
/// Factor for the step after an iteration that diverges.
pub(super) const SHORTEN: f64 = 0.5;
/// Largest rate of convergence.
const SLOWEST: f64 = 0.99;
/// Exponent of the previous rate in the estimate for the first iteration.
const FORGET: f64 = 0.8;
/// The stages are also taken as solved when a pass has left at most this part of the residual. A stiff force that levels off makes
/// passes with small changes that leave nearly all of it.
const TRUSTED: f64 = 0.1;
/// Rate of convergence that is assumed when one iteration sufficed.
const AT_ONCE: f64 = 1e-3;

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
