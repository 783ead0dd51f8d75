//! Which samples a run keeps, and their times.

use crate::record::Wanted;
use crate::simulate::SetupError;

/// Which samples of a run are kept.
#[derive(Debug, Clone, Default)]
pub(in crate::simulate) struct Sampling {
    pub times: SampleTimes,
    pub wanted: Wanted,
    /// Whether all but the first and the last go to a recorder alone.
    pub streamed: bool,
}

/// When samples are kept, besides the start and the end.
#[derive(Debug, Clone, Default)]
pub(in crate::simulate) enum SampleTimes {
    #[default]
    Never,
    /// At equal intervals, s.
    Every(f64),
    /// At these times, s.
    At(Vec<f64>),
}

impl SampleTimes {
    /// Those of a run from `start_s` to `until_s`, in order.
    ///
    /// # Errors
    /// [`SetupError::Every`], [`SetupError::SampleTime`].
    pub(in crate::simulate) fn of_run(&self, start_s: f64, until_s: f64) -> Result<Self, SetupError> {
        match self {
            Self::Every(every_s) if every_s.is_nan() || *every_s <= 0.0 => Err(SetupError::Every { every_s: *every_s }),
            Self::At(times) => {
                if let Some(&t) = times.iter().find(|t| !(start_s..=until_s).contains(*t)) {
                    return Err(SetupError::SampleTime { t, start_s, until_s });
                }
                let mut times: Vec<f64> = times.iter().copied().filter(|t| *t > start_s && *t < until_s).collect();
                times.sort_by(f64::total_cmp);
                times.dedup();
                Ok(Self::At(times))
            }
            _ => Ok(self.clone()),
        }
    }

    /// Time of the next sample after the start and `n_kept - 1` others, s; infinite where there is none.
    pub(in crate::simulate) fn next(&self, start_s: f64, n_kept: usize) -> f64 {
        match self {
            Self::Never => f64::INFINITY,
            Self::Every(every_s) => start_s + n_kept as f64 * every_s,
            Self::At(times) => times.get(n_kept - 1).copied().unwrap_or(f64::INFINITY),
        }
    }
}
