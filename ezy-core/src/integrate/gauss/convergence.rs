//! When sweeps have converged, and when they will not.

use crate::integrate::tolerances::gauss::{GROWING, MAX_SWEEPS, OF_SWEEPS, ROUNDING, STALLED};

/// How sweeps converged.
pub(super) struct Convergence {
    /// By how much the equations change slopes over the step, at most: sweep n has the rate z/n where they are linear.
    pub steepness: f64,
}

impl Convergence {
    /// In so many sweeps, of which the last one changed slopes by this part of the first one.
    fn new(n_sweeps: u32, last: f64) -> Self {
        let n_sweeps = f64::from(n_sweeps);
        let rate =
            if n_sweeps > 1.0 { last.max(f64::EPSILON * f64::EPSILON).powf(1.0 / (n_sweeps - 1.0)) } else { 0.0 };
        Self { steepness: n_sweeps * rate }
    }
}

/// The changes that sweeps made so far.
#[derive(Debug)]
pub(super) struct Sweeps {
    n: u32,
    first: f64,
    last_change: f64,
    last_rate: f64,
}

impl Default for Sweeps {
    fn default() -> Self {
        Self { n: 0, first: 0.0, last_change: 0.0, last_rate: 1.0 }
    }
}

impl Sweeps {
    /// How many there were.
    pub(super) fn n(&self) -> u32 {
        self.n
    }

    /// What one more sweep, which changed slopes by this over the tolerance, says: `None` where another one is to follow, and no convergence where
    /// they do not converge. `size` gives what the slopes themselves are over the tolerance.
    pub(super) fn see(&mut self, change: f64, size: impl FnOnce() -> f64) -> Option<Option<Convergence>> {
        self.n += 1;
        if !change.is_finite() {
            return Some(None);
        }
        // the first change tells no rate
        let rate = if self.n == 1 {
            self.first = change;
            1.0
        } else {
            change / self.last_change
        };
        let converged = || Some(Convergence::new(self.n, change / self.first));
        // two rates: one may be small by chance, the first one because the first guess lacks high degrees, which hardly move anything
        if change * rate.max(self.last_rate).min(1.0) <= OF_SWEEPS {
            return Some(converged());
        }
        if rate.min(self.last_rate) >= STALLED && self.n > GROWING {
            let is_rounding = change <= ROUNDING * size();
            return Some(if is_rounding { converged() } else { None });
        }
        (self.last_change, self.last_rate) = (change, rate);
        (self.n == MAX_SWEEPS).then_some(None)
    }
}
