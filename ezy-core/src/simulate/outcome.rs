//! The result of a run.

use super::{EnergyError, ErrorEstimate, ExceededLimit, Monitors, NoErrorEstimate, Occurrence, RankRecord};
use crate::dynamics::{MotionError, MovedValue, Strain};
use crate::model::SceneInfo;
use crate::record::{Record, RecordError, Sample, UnknownName};
use crate::scalar::{legible_time, rounded};
use std::fmt;
use std::sync::Arc;

/// A finished run: all that was computed, also when it stopped early. `{:?}` prints how it ended, and how much there is.
pub struct Run {
    /// How it ended.
    pub outcome: Outcome,
    /// What it took.
    pub cost: Cost,
    /// What was watched on the way.
    pub monitors: Monitors,
    /// Time since which stability and not accuracy limited the steps of dop853, s. An implicit method, such as radau, takes longer
    /// steps then. Other methods do not detect it.
    pub stiff_since_s: Option<f64>,
    /// Where constraints depended on each other.
    pub rank: RankRecord,
    /// Start values that were near, or let give way ([`Simulation::project_start`](super::Simulation::project_start)), and changed by more
    /// than their last digits.
    pub moved: Vec<MovedValue>,
    /// Its error, when [`Simulation::estimate_error`](super::Simulation::estimate_error) asked for it.
    pub error_estimate: Option<Result<ErrorEstimate, NoErrorEstimate>>,
    pub(super) info: Arc<SceneInfo>,
    pub(super) events: Vec<Occurrence>,
    /// Holds the start at least.
    pub(super) record: Record,
}

impl fmt::Debug for Run {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Run")
            .field("scene", &self.info.name)
            .field("outcome", &self.outcome)
            .field("cost", &self.cost)
            .field("n_samples", &self.samples().len())
            .field("n_events", &self.events.len())
            .field("n_moved", &self.moved.len())
            .finish_non_exhaustive()
    }
}

impl Run {
    /// Names and sizes.
    pub fn info(&self) -> &Arc<SceneInfo> {
        &self.info
    }

    /// The events that took place, in time; what ended the run is the last one.
    pub fn events(&self) -> &[Occurrence] {
        &self.events
    }

    /// The samples: the start, one every recording interval, and the end or the last good state.
    pub fn samples(&self) -> impl DoubleEndedIterator<Item = Sample<'_>> + ExactSizeIterator {
        self.record.samples()
    }

    /// The first sample: the consistent start.
    pub fn first(&self) -> Sample<'_> {
        self.record.at(0)
    }

    /// The last sample: the end, or the last good state when the run stopped early.
    pub fn last(&self) -> Sample<'_> {
        self.record.at(self.record.len() - 1)
    }

    /// Sample `i`, `None` past the last.
    pub fn sample(&self, i: usize) -> Option<Sample<'_>> {
        self.record.get(i)
    }

    /// One column of every sample, by the names of [`crate::record::columns`].
    ///
    /// # Errors
    /// [`UnknownName`] with the nearest column.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, UnknownName> {
        self.record.column(name)
    }
}

/// How a run ended.
#[derive(Debug)]
#[non_exhaustive]
pub enum Outcome {
    /// At the time that was asked for.
    ReachedEnd,
    /// At an event that ends the run.
    ReachedEvent {
        /// Time of the event, s.
        t: f64,
        /// Its name.
        name: &'static str,
    },
    /// At the time that was asked for, or at an event that ends the run, but with fixed steps too long for the motion: energy and
    /// work differ by more than [`EnergyError::LARGEST_OF_FIXED_STEPS`], and the result is not to be trusted. Not where a limit
    /// was set by [`Simulation::max_energy_error`](super::Simulation::max_energy_error).
    Untrusted {
        /// Time of the end, s.
        t: f64,
        /// Length of the steps, s.
        step_s: f64,
        /// The energy balance.
        energy: EnergyError,
    },
    /// Before, because it was asked to end ([`Simulation::interrupted_by`](super::Simulation::interrupted_by)); everything up to
    /// there is in the run.
    Interrupted {
        /// Time of the last state, s.
        t: f64,
    },
    /// Before; everything up to the last good state is in the run.
    Stopped {
        /// Time of the last good state, s.
        t: f64,
        /// Why.
        reason: StopReason,
        /// Largest acceleration then and its cause, when the motion became too fast.
        strain: Option<Strain>,
    },
}

impl Outcome {
    /// Whether the run is complete, at its time or at an event that ends it, and nothing speaks against its result.
    pub fn reached_end(&self) -> bool {
        matches!(self, Self::ReachedEnd | Self::ReachedEvent { .. })
    }

    /// Whether it came to the time that was asked for or to an event that ends it, whatever the result is worth.
    pub(crate) fn is_complete(&self) -> bool {
        self.reached_end() || matches!(self, Self::Untrusted { .. })
    }
}

impl std::fmt::Display for Outcome {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::ReachedEnd => f.write_str("reached the end"),
            Self::ReachedEvent { t, name } => write!(f, "reached `{name}` at t = {} s", legible_time(*t)),
            Self::Untrusted { t, step_s, energy: EnergyError { joules, relative, t: at } } => write!(
                f,
                "reached t = {} s, but is not to be trusted: at t = {} s energy and work differ by {joules:.3e} J, {relative:.1e} of the \
                 energy turned over (limit {:e}); the fixed step of {} s is too long for this motion; take a tenth of it, or a \
                 method with a tolerance (dop853, taylor, gauss, radau)",
                legible_time(*t),
                rounded(*at, 4),
                EnergyError::LARGEST_OF_FIXED_STEPS,
                rounded(*step_s, 4)
            ),
            Self::Interrupted { t } => write!(f, "was interrupted at t = {} s", legible_time(*t)),
            Self::Stopped { t, reason, strain } => {
                write!(f, "stopped at t = {} s: {reason}", legible_time(*t))?;
                strain.as_ref().map_or(Ok(()), |strain| write!(f, "; {strain}"))
            }
        }
    }
}

/// Why a run stopped early.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StopReason {
    /// The motion cannot be continued.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A limit would be exceeded.
    #[error(transparent)]
    Limit(#[from] ExceededLimit),
    /// A sample could not be written.
    #[error(transparent)]
    Record(#[from] RecordError),
    /// The last sample has a value that is not finite, though positions and velocities are: an energy that overflows, or an output.
    #[error(
        "`{column}` is {value} there; the run has no result: its magnitudes leave the range of numbers, or an output is undefined"
    )]
    NoNumber {
        /// Name of the column.
        column: String,
        /// NaN or an infinity.
        value: f64,
    },
}

impl StopReason {
    /// Whether the largest acceleration at the last good state explains the failure.
    pub(super) fn asks_for_strain(&self) -> bool {
        use MotionError::{NotFinite, ProjectionStalled, StepCollapsed};
        match self {
            Self::Motion(error) => matches!(error, NotFinite { .. } | ProjectionStalled { .. } | StepCollapsed { .. }),
            Self::Limit(limit) => !matches!(limit, ExceededLimit::Drift { .. }),
            Self::Record(_) | Self::NoNumber { .. } => false,
        }
    }
}

/// What a run took.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Cost {
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Evaluations of the accelerations.
    pub evaluations: u64,
    /// Factorisations of K, or runs of a generated elimination, projections included.
    pub factorizations: u64,
    /// Wall time of the loop, recording included, s.
    pub seconds: f64,
    /// Time that a processor worked for the loop, s; where the system does not tell it, as on Windows, the wall time.
    pub processor_seconds: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest acceleration explains a motion that became too fast: steps that collapse, numbers that overflow, a limit of steps or energy. It
    /// says nothing about constraints that drift, or a file that cannot be written.
    #[test]
    fn invariant_only_what_speed_can_explain_asks_for_the_largest_acceleration() {
        let drift = ExceededLimit::Drift { t: 0.0, level: "position", row: "pin.x".into(), value: 1.0, limit: 0.1 };
        for (reason, asks) in [
            (StopReason::Motion(MotionError::StepCollapsed { t: 0.0, step_s: 1e-15 }), true),
            (StopReason::Motion(MotionError::NotFinite { t: 0.0, quantity: "x".into() }), true),
            (StopReason::Motion(MotionError::EuclideanTooLarge { n: 4000, limit: 3000 }), false),
            (StopReason::Limit(ExceededLimit::Steps { limit: 3, step_s: 0.1 }), true),
            (StopReason::Limit(drift), false),
            (StopReason::NoNumber { column: "x".into(), value: f64::NAN }, false),
        ] {
            assert_eq!(reason.asks_for_strain(), asks, "{reason}");
        }
    }
}
