//! Step control.

use crate::archive::Archive;
use crate::integrate::Tolerance;
use crate::integrate::tolerances::radau::{FIRST_REJECTED, GROW, KEEP, LEAST_ERROR, MAX_PASSES, SAFETY, SHRINK};

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
/// Largest estimate for which values between steps are within a tolerance: the estimate is of order 4 in the step, their error
/// of order 5.
pub(crate) fn tolerance_of_estimate(tolerance: Tolerance) -> Tolerance {
    tolerance.with_relative(tolerance.relative.powf(0.8))
}

/// What an error over the tolerance of estimates is over that of values between steps.
pub(super) fn values_over_estimate(of_estimate: Tolerance) -> f64 {
    of_estimate.relative.powf(-0.25)
}

impl RadauControl {
    /// Writes it, or reads another one over it.
    pub(super) fn remember(&mut self, archive: &mut Archive) {
        let (mut h, mut error) = (self.last.map(|(h, _)| h), self.last.map(|(_, error)| error));
        archive.option(&mut h);
        archive.option(&mut error);
        self.last = h.zip(error);
        archive.flag(&mut self.just_rejected);
    }

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
    (safety / error.powf(1.0 / ESTIMATE_ORDER)).clamp(SHRINK, GROW).max(SHRINK)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of a power.
    const ROUNDING: f64 = 1e-14;

    fn close(x: f64, y: f64) {
        assert!((x - y).abs() <= ROUNDING * y.abs(), "{x} {y}");
    }

    /// An error of ε asks for ε^(−1/4) of the step, of which 0.9 are taken after one pass, and 0.9 · 15/(n + 14) after n; within 1/5 and 8.
    #[test]
    fn analytic_next_step_is_the_fourth_root_of_the_error() {
        for (error, n_passes, factor) in [
            (1.0 / 16.0, 1, 1.8),
            (1.0 / 16.0, 4, 1.8 * 15.0 / 18.0),
            (1.0, 7, 0.9 * 15.0 / 21.0),
            (1e-8, 1, 8.0),
            (0.0, 1, 8.0),
        ] {
            close(RadauControl::default().accept(0.5, error, n_passes, false), 0.5 * factor);
        }
    }

    /// Steps of 1 s and 2 s with errors of 1/16 and 1/4: 0.9 · 2 · ((1/16)/(1/4)²)^(1/4) by their trend, 0.9 (1/4)^(−1/4) by the last one alone. The
    /// smaller one counts, and an error below 1e-2 counts as 1e-2.
    #[test]
    fn analytic_trend_of_errors_shortens_the_next_step() {
        let after = |first: [f64; 2], second: [f64; 2]| {
            let mut control = RadauControl::default();
            control.accept(first[0], first[1], 1, false);
            control.accept(second[0], second[1], 1, false) / second[0]
        };
        close(after([1.0, 0.0625], [2.0, 0.25]), 0.9 * 4.0_f64.powf(0.25));
        close(after([1.0, 0.0625], [1.0, 0.25]), 0.9);
        close(after([2.0, 0.0625], [1.0, 0.25]), 0.45);
        close(after([1.0, 1e-5], [1.0, 0.1]), 0.9);
        close(after([10.0, 1.0], [1.0, 1.0]), 0.2);
    }

    /// A step that would grow by at most 1.2 keeps its length where that keeps its factors.
    #[test]
    fn invariant_nearly_equal_steps_keep_their_factors() {
        // 0.9 ε^(−1/4) is 1.1, 1.3 and 0.95
        for (wanted, kept) in [(1.1_f64, 1.0), (1.3, 1.3), (0.95, 0.95)] {
            let error = (0.9 / wanted).powi(4);
            close(RadauControl::default().accept(2.0, error, 1, true), 2.0 * kept);
            close(RadauControl::default().accept(2.0, error, 1, false), 2.0 * wanted);
        }
    }

    /// A tenth remains of a first step; of a later one what its error asks for, 0.9 at most; the next one after that does not grow.
    #[test]
    fn analytic_rejected_steps_become_shorter_and_do_not_grow_at_once() {
        let mut control = RadauControl::default();
        close(control.reject(1.0, 16.0, 1), 0.1);
        close(control.accept(0.1, 1e-8, 1, false), 0.1);
        close(control.reject(1.0, 16.0, 1), 0.45);
        close(control.reject(1.0, 1e-3, 1), 0.9);
        close(control.reject(1.0, f64::NAN, 1), 0.2);
        close(control.diverge(1.0, 0.3), 0.3);
        close(control.accept(0.3, 1e-2, 1, false), 0.3);
        assert!(control.accept(0.3, 1e-2, 1, false) > 0.5);
    }

    /// The estimate is of order 4, values between steps are of order 5: a tolerance of 1e-10 is 1e-8 of the estimate.
    #[test]
    fn analytic_tolerance_of_the_estimate_is_that_of_an_order_less() {
        let of_estimate = tolerance_of_estimate(Tolerance::new(1e-10, 1e-7));
        let close = |x: f64, y: f64| assert!((x / y - 1.0).abs() <= 1e-12, "{x} {y}");
        close(of_estimate.relative, 1e-8);
        close(of_estimate.absolute, 1e-5);
        // an error of 1e-10 is one tolerance of values, and 1e-2 of estimates
        close(values_over_estimate(of_estimate), 1e2);
    }
}
