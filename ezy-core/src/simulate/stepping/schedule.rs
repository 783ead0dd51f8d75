//! The times at which steps of a run end.

use crate::integrate::Clock;

/// The steps of a clock, or the end alone when the method chooses its steps.
#[derive(Debug, Clone, Copy)]
pub(in crate::simulate) enum Schedule {
    Clock(Clock),
    Free { start: f64, end: f64 },
}

impl Schedule {
    /// Length and end of step `n`, which starts at `t`, s; a method that chooses its steps may stop before.
    pub(in crate::simulate) fn step(&self, n: u64, t: f64) -> (f64, f64) {
        match self {
            Self::Clock(clock) => (clock.step(n), clock.time(n + 1)),
            Self::Free { end, .. } => (end - t, *end),
        }
    }

    /// s
    pub(in crate::simulate) fn start(&self) -> f64 {
        match self {
            Self::Clock(clock) => clock.time(0),
            Self::Free { start, .. } => *start,
        }
    }

    /// s
    pub(in crate::simulate) fn end(&self) -> f64 {
        match self {
            Self::Clock(clock) => clock.time(clock.n_steps()),
            Self::Free { end, .. } => *end,
        }
    }
}
