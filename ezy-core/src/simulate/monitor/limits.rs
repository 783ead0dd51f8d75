//! Limits of a run.

use crate::model::Name;
use crate::simulate::SetupError;
use crate::simulate::tolerances::monitors::MAX_CHOSEN_STEPS;

/// Limits as set; infinite where none was.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::simulate) struct Limits {
    /// Largest residual of a row, m or rad, m/s or rad/s.
    pub drift: f64,
    /// Largest energy balance over the energy turned over.
    pub energy_error: f64,
    /// Steps, rejected ones included.
    pub steps: Option<u64>,
}

impl Default for Limits {
    fn default() -> Self {
        Self { drift: f64::INFINITY, energy_error: f64::INFINITY, steps: None }
    }
}

impl Limits {
    /// Limits that can be kept, or [`SetupError::Limit`].
    pub(crate) fn checked(self) -> Result<Self, SetupError> {
        for (name, value) in [("max-drift", self.drift), ("max-energy-error", self.energy_error)] {
            if value.is_nan() || value < 0.0 {
                return Err(SetupError::Limit { name, value });
            }
        }
        Ok(self)
    }

    /// Whether a run is watched by more than it is by itself.
    pub(crate) fn are_given(&self) -> bool {
        *self != Self::default()
    }

    /// Largest number of steps of a run.
    pub(crate) fn most_steps(&self, chooses_steps: bool) -> u64 {
        self.steps.unwrap_or(if chooses_steps { MAX_CHOSEN_STEPS } else { u64::MAX })
    }
}

/// Whether a value is within a limit; NaN is not.
pub(super) fn keeps(value: f64, limit: f64) -> bool {
    value <= limit || limit == f64::INFINITY
}

/// A limit would be exceeded by the next state; the last one within it is the end of the run.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ExceededLimit {
    /// A row is not met.
    #[error(
        "at t = {t} s the {level} residual of constraint `{row}` is {value:.3e}, above the limit of {limit:e} (max-drift); \
         project positions and velocities, or take a smaller step or tolerance", t = crate::scalar::legible_time(*.t)
    )]
    Drift {
        /// Time of the state that exceeds it, s.
        t: f64,
        /// `position` or `velocity`.
        level: &'static str,
        /// Name of the row.
        row: Name,
        /// Its residual, m or rad, m/s or rad/s.
        value: f64,
        /// The limit.
        limit: f64,
    },
    /// Energy and work do not fit.
    #[error(
        "at t = {t} s energy and work differ by {joules:.3e} J, {relative:.3e} of the energy turned over, above the limit of \
         {limit:e} (max-energy-error); take a smaller step or tolerance, or look at the forces at that time", t = crate::scalar::legible_time(*.t)
    )]
    EnergyError {
        /// Time of the state that exceeds it, s.
        t: f64,
        /// The balance, J.
        joules: f64,
        /// The same over the energy turned over.
        relative: f64,
        /// The limit.
        limit: f64,
    },
    /// The end is out of reach.
    #[error(
        "the attempted steps reach the limit of {limit} (max-steps), the last good one {step_s:.1e} s long; allow more \
         steps or larger errors, end earlier, or look at the speeds and forces at that time"
    )]
    Steps {
        /// The limit.
        limit: u64,
        /// Length of the last good step, s; zero without one.
        step_s: f64,
    },
    /// The end is out of reach at the pace of the last steps. Not where a limit of steps was set.
    #[error(
        "after {attempts} attempted steps it advances by {pace_s:.1e} s a step; at this pace the end needs {needed:.0e} more, above the \
         limit of {limit}; take a larger tolerance or another method, look at the speeds and forces at that time, or set a limit \
         yourself (max-steps)"
    )]
    Pace {
        /// Attempted steps so far.
        attempts: u64,
        /// Time for each of the last attempted steps, s.
        pace_s: f64,
        /// Steps that the rest needs at this pace.
        needed: f64,
        /// The limit.
        limit: u64,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn regress_chosen_steps_end_at_ten_million_as_the_manual_says() {
        assert_eq!(Limits::default().most_steps(true), 10_000_000);
        assert_eq!(Limits::default().most_steps(false), u64::MAX);
        assert_eq!(Limits { steps: Some(7), ..Limits::default() }.most_steps(true), 7);
    }
}
