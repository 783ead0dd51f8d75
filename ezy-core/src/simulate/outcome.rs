//! What a run leaves.

use crate::dynamics::MotionError;
use crate::model::SceneInfo;
use crate::record::{Record, RecordError, Sample, UnknownName};

/// A finished run: all that was computed, also when it stopped early.
#[derive(Debug)]
pub struct Run {
    /// How it ended.
    pub outcome: Outcome,
    /// What it took.
    pub cost: Cost,
    pub(super) info: &'static SceneInfo,
    /// Holds the start at least.
    pub(super) record: Record,
}

impl Run {
    /// Names and sizes.
    pub fn info(&self) -> &'static SceneInfo {
        self.info
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
pub enum Outcome {
    /// At the end that was asked for.
    ReachedEnd,
    /// Before; everything up to the last good state is in the run.
    Stopped {
        /// Time of the last good state, s.
        t: f64,
        /// Why.
        reason: StopReason,
    },
}

impl Outcome {
    /// Whether the run is complete.
    pub fn reached_end(&self) -> bool {
        matches!(self, Self::ReachedEnd)
    }
}

impl std::fmt::Display for Outcome {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::ReachedEnd => f.write_str("reached the end"),
            Self::Stopped { t, reason } => write!(f, "stopped at t = {t} s: {reason}"),
        }
    }
}

/// Why a run stopped early.
#[derive(Debug, thiserror::Error)]
pub enum StopReason {
    /// The motion cannot be continued.
    #[error(transparent)]
    Motion(#[from] MotionError),
    /// A sample could not be written.
    #[error(transparent)]
    Record(#[from] RecordError),
}

/// What a run took.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Cost {
    /// Accepted steps.
    pub steps: u64,
    /// Steps that were tried and taken back.
    pub rejected: u64,
    /// Evaluations of the accelerations.
    pub evaluations: u64,
    /// Factorisations of K, or runs of a generated elimination, projections included.
    pub factorizations: u64,
    /// Wall time of the loop, recording included, s.
    pub seconds: f64,
}
