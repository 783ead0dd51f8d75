//! The work that a system did.

use crate::model::Pivots;

/// Work done since construction, and the least pivot that was met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Counters {
    /// Evaluations of the accelerations.
    pub evaluations: u64,
    /// Factorisations of K, or runs of a generated elimination, for accelerations and corrections; and those that a method makes by itself.
    pub factorizations: u64,
    /// The least [`Solved::smallest_pivot`](super::Solved) since someone asked: at ends and stages of steps, also of those that were taken back.
    pub least_pivot: f64,
}

impl Counters {
    /// Nothing yet.
    pub(super) fn new() -> Self {
        Self { evaluations: 0, factorizations: 0, least_pivot: 1.0 }
    }

    /// Takes note of an elimination: its smallest pivot; none where one vanished.
    #[inline]
    pub(super) fn eliminated(&mut self, pivots: Pivots) -> Option<f64> {
        self.factorizations += 1;
        let smallest = pivots.smallest();
        self.least_pivot = self.least_pivot.min(smallest);
        pivots.all_keep().then_some(smallest)
    }

    /// The least pivot since this was asked before.
    pub(crate) fn take_least_pivot(&mut self) -> f64 {
        std::mem::replace(&mut self.least_pivot, 1.0)
    }
}
