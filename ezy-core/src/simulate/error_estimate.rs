//! The error that a run has reached.

use crate::integrate::Method;

/// The error of a run.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ErrorEstimate {
    /// Of positions, velocities, multipliers and first-order states, each in its units; then of the time of the end, if an event ended the run.
    pub errors: Vec<QuantityError>,
    /// How much larger a small change of the start becomes, each number of its size over the run; unknown where the run from a moved start
    /// did not come to its end.
    pub amplification: Option<f64>,
    /// By which method and tolerance the second run was made.
    pub second: Method,
}

/// The error of all positions, velocities, multipliers or first-order states with one unit.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct QuantityError {
    /// `positions`, `velocities`, `multipliers`, `states` or `end`.
    pub quantity: &'static str,
    /// Their unit: `m`, `rad`, `m/s`, `N`, …
    pub unit: String,
    /// The largest error of any of them in the last sample.
    pub at_end: f64,
    /// The largest error of any of them in any sample.
    pub largest: f64,
    /// Time of that sample, s.
    pub t: f64,
}

/// Why the error of a run is not known.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct NoErrorEstimate(pub(super) String);
