//! The lengths of steps of collocation.

use super::{Collocated, tableau::N};
use crate::archive::Archive;
use crate::integrate::tolerances::gauss::{AIM, BEST_STEEPNESS, DIVERGED, GROW, SHRINK};

/// The error at the end of a step goes with this power of its length.
const ERROR_ORDER: f64 = 2.0 * N as f64 + 1.0;

/// The error within a step goes with this power of its length.
const DENSE_ERROR_ORDER: f64 = N as f64 + 1.0;

/// What the next step is to the last one.
#[derive(Debug, Clone, Default)]
pub(crate) struct GaussControl {
    /// The step under way was tried before, and failed.
    has_failed: bool,
    /// Steepness of the last accepted step over its length, 1/s.
    last_rate: f64,
    /// The length that the last accepted step should have had by its error, s; none after a start, or where it had no error.
    last_length_s: Option<f64>,
}

impl GaussControl {
    /// Factor for the step after one of the length `h` with this error over the tolerance and this steepness of the equations; it is accepted where the error is
    /// at most one. A step whose sweeps have little to do says less of how steep the equations are than the one before, so the larger of both counts.
    ///
    /// Errors of neighbouring steps differ by chance. So the next length is √(h √(L K)), where the last two errors ask for the lengths L and K. Behind a start,
    /// and behind a step that failed, it is the length that the last error asks for.
    ///
    /// # Source
    /// H211b with b = 4: Söderlind, Digital filters in adaptive time-stepping, ACM Transactions on Mathematical Software 29 (2003).
    pub(crate) fn factor(&mut self, h: f64, error: f64, steepness: f64) -> f64 {
        let rate = steepness / h;
        let steepness = h * rate.max(self.last_rate);
        let most = if self.has_failed { 1.0 } else { GROW };
        let mut by_error = (AIM / error).powf(1.0 / ERROR_ORDER);
        if error <= 1.0 {
            let length = h * by_error;
            if let Some(last) = self.last_length_s.filter(|_| !self.has_failed) {
                by_error = ((length * last).sqrt() / h).sqrt();
            }
            (self.last_rate, self.last_length_s) = (rate, Some(length).filter(|length| length.is_finite()));
        }
        self.has_failed = error > 1.0 || error.is_nan();
        if by_error.is_nan() { SHRINK } else { by_error.min(BEST_STEEPNESS / steepness).min(most).max(SHRINK) }
    }

    /// Writes it, or reads another one over it.
    pub(super) fn remember(&mut self, archive: &mut Archive) {
        archive.flag(&mut self.has_failed);
        archive.number(&mut self.last_rate);
        archive.option(&mut self.last_length_s);
    }

    /// Factor for the next try after one that did not converge, or that could not be evaluated.
    pub(crate) fn failed(&mut self) -> f64 {
        self.has_failed = true;
        DIVERGED
    }
}

impl Collocated {
    /// In how many parts a step is divided, so that the error within each is within the tolerance.
    pub(crate) fn n_parts(dense_error: f64) -> usize {
        dense_error.powf(1.0 / DENSE_ERROR_ORDER).ceil().max(1.0) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of a power.
    const ROUNDING: f64 = 1e-13;

    /// Errors go with the power 17 of the length: a hundredth of the tolerance keeps the length, and 2^17 times that halves it.
    #[test]
    fn analytic_errors_change_lengths_by_their_seventeenth_root() {
        let factor = |error: f64, steepness: f64| GaussControl::default().factor(1.0, error, steepness);
        for (error, expected) in [(0.01, 1.0), (0.01 * 2.0_f64.powi(17), 0.5), (0.01 * 2.0_f64.powi(-17), 2.0)] {
            assert!((factor(error, 0.01) / expected - 1.0).abs() <= ROUNDING, "{error}");
        }
        assert_eq!([factor(0.0, 0.01), factor(1e30, 0.01), factor(f64::NAN, 0.01)], [4.0, 0.2, 0.2]);
    }

    /// Errors that ask for 4 s and 1 s over steps of 1 s: the next one has √(1 · √(4 · 1)) s. Without an error, and behind a failure, it has what the last error
    /// asks for.
    #[test]
    fn analytic_lengths_follow_the_errors_of_two_steps() {
        let of = |length: f64| 0.01 * length.powi(-17);
        for (lengths, expected) in
            [([4.0, 1.0], 2.0_f64.sqrt()), ([0.8, 0.8], 0.8_f64.sqrt()), ([1.0, 1.0], 1.0), ([f64::INFINITY, 0.9], 0.9)]
        {
            let mut control = GaussControl::default();
            let [_, factor] = lengths.map(|length| control.factor(1.0, of(length), 0.01));
            assert!((factor / expected - 1.0).abs() <= ROUNDING, "{lengths:?}: {factor}");
        }
        let mut control = GaussControl::default();
        control.factor(1.0, of(4.0), 0.01);
        assert!(control.factor(1.0, of(0.5), 0.01) < 1.0);
        let factor = control.factor(0.5, of(0.9), 0.01);
        assert!((factor / 0.9 - 1.0).abs() <= ROUNDING, "{factor}");
    }

    /// A steepness of twice the best asks for half the length, whatever the error.
    #[test]
    fn analytic_steep_equations_shorten_steps() {
        let factors = [12.0, 24.0, 3.0].map(|steepness| GaussControl::default().factor(1.0, 1e-30, steepness));
        assert_eq!(factors, [0.5, 0.25, 2.0]);
    }

    /// For their length: 3 over 0.5 s are as much as 6 over 1 s. A step that is taken again says nothing of the next one.
    #[test]
    fn analytic_the_larger_steepness_of_two_steps_counts() {
        let mut control = GaussControl::default();
        let steps = [(0.5, 1e-30, 3.0), (1.0, 1e-30, 1.5), (1.0, 1e-30, 2.0), (1.0, 2.0, 1e3), (1.0, 1e-30, 2.0)];
        let [first, after_steep, later, again, after_failed] =
            steps.map(|(h, error, steepness)| control.factor(h, error, steepness));
        assert_eq!([first, after_steep, later, after_failed], [2.0, 1.0, 3.0, 1.0]);
        assert!(again < 1.0);
    }

    #[test]
    fn invariant_steps_do_not_grow_after_one_that_failed() {
        let mut control = GaussControl::default();
        assert_eq!(control.failed(), 0.5);
        assert_eq!([control.factor(1.0, 1e-30, 0.01), control.factor(1.0, 1e-30, 0.01)], [1.0, 4.0]);
        assert!(control.factor(1.0, 2.0, 0.01) < 1.0);
        assert_eq!(control.factor(1.0, 1e-30, 0.01), 1.0);
    }

    /// Halves have 2^-9 of the error.
    #[test]
    fn analytic_parts_by_the_ninth_root() {
        assert_eq!([0.0, 1.0, 500.0, 513.0, 19_000.0].map(Collocated::n_parts), [1, 1, 2, 3, 3]);
    }
}
