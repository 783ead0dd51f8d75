//! Step control.

use super::convergence::MAX_PASSES;
use crate::integrate::Tolerance;

/// The length of the next step from the errors of the last two and the passes that the iteration took.
///
/// # Source
/// Gustafsson, ACM Trans. Math. Software 20 (1994); Hairer, Wanner, Solving Ordinary Differential Equations II (1996), IV.8,
/// (8.21), (8.25) and the constants of the program RADAU5 there.
#[derive(Debug, Clone, Default)]
pub(crate) struct RadauControl {
    /// Length, s, and error of the last accepted step.
    last: Option<(f64, f64)>,
    just_rejected: bool,
}

/// Power of the step with which the estimate goes.
const ESTIMATE_ORDER: f64 = 4.0;
/// Steps are aimed at this part of the largest allowed error, less where the iteration is slow.
const SAFETY: f64 = 0.9;
/// A step changes at most by these factors.
const SHRINK: f64 = 0.2;
const GROW: f64 = 8.0;
/// A step that would grow by less keeps its length and its factors.
const KEEP: f64 = 1.2;
/// Smallest error that is used for prediction.
const LEAST_ERROR: f64 = 1e-2;
/// The first step is a guess: what remains of it after a rejection.
const FIRST_REJECTED: f64 = 0.1;

/// Largest estimate for which values between steps are within a tolerance: the estimate is of order 4 in the step, their error
/// of order 5.
pub(crate) fn tolerance_of_estimate(tolerance: Tolerance) -> Tolerance {
    let relative = tolerance.relative.powf(0.8);
    Tolerance { relative, absolute: tolerance.absolute * (relative / tolerance.relative) }
}

/// What an error over the tolerance of estimates is over that of values between steps.
pub(super) fn values_over_estimate(of_estimate: Tolerance) -> f64 {
    of_estimate.relative.powf(-0.25)
}

impl RadauControl {
    /// Length of the step after one of length `h` with an error of at most 1; `keeps` says that an equal length would keep the
    /// factors.
    pub(crate) fn accept(&mut self, h: f64, error: f64, n_passes: u32, keeps: bool) -> f64 {
        let mut factor = wanted(error, n_passes);
        if let Some((last_h, last_error)) = self.last {
            let trend = SAFETY * (h / last_h) * (last_error / (error * error)).powf(1.0 / ESTIMATE_ORDER);
            factor = factor.min(trend.clamp(SHRINK, GROW));
        }
        if std::mem::take(&mut self.just_rejected) {
            factor = factor.min(1.0);
        }
        self.last = Some((h, error.max(LEAST_ERROR)));
        if keeps && (1.0..=KEEP).contains(&factor) { h } else { h * factor }
    }

    /// Length of the next try after a step of length `h` with an error above 1.
    pub(crate) fn reject(&mut self, h: f64, error: f64, n_passes: u32) -> f64 {
        self.just_rejected = true;
        let factor = if self.last.is_none() { FIRST_REJECTED } else { wanted(error, n_passes).min(SAFETY) };
        h * factor
    }

    /// Length of the next try after an iteration that did not converge.
    pub(crate) fn diverge(&mut self, h: f64, factor: f64) -> f64 {
        self.just_rejected = true;
        h * factor
    }
}

/// Factor for the step by this error alone.
fn wanted(error: f64, n_passes: u32) -> f64 {
    let (n_passes, most) = (f64::from(n_passes), f64::from(MAX_PASSES));
    let safety = SAFETY.min(SAFETY * (1.0 + 2.0 * most) / (n_passes + 2.0 * most));
    // not a number becomes the smallest
    (safety / error.max(f64::MIN_POSITIVE).powf(1.0 / ESTIMATE_ORDER)).clamp(SHRINK, GROW).max(SHRINK)
}
