//! Errors of a measurement.

use ezy_core::simulate::SetupError;

/// Accuracy cannot be measured.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AccuracyError {
    /// The runs cannot start.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The end is not after the start.
    #[error("the run starts and ends at {until_s} s; give an end after the start")]
    NoTime {
        /// Start and end, s.
        until_s: f64,
    },
    /// The budget is not positive, or too long.
    #[error("the budget is {budget_s:?} s; give a positive number of seconds up to {longest_s:e}")]
    Budget {
        /// The budget, s.
        budget_s: f64,
        /// The longest, s.
        longest_s: f64,
    },
    /// The reference does not reach the end.
    #[error("there is no reference: {method} {outcome}")]
    NoReference {
        /// The method that was to give it.
        method: String,
        /// How its run ended.
        outcome: String,
    },
    /// It was asked to end before the reference was there.
    #[error("the measurement was interrupted before it had a reference; nothing was measured")]
    Interrupted,
    /// Even the runs with the smallest tolerances differ from the start.
    #[error(
        "there is no reference: runs at the two tightest tolerances differ by {difference:.1e} of the size of the motion from \
         its first moments; no digit of the motion is known"
    )]
    NothingKnown {
        /// Largest scaled difference of positions.
        difference: f64,
    },
    /// A figure could not be made.
    #[cfg(feature = "figures")]
    #[error(transparent)]
    Figure(#[from] crate::report::figure::FigureError),
    /// A file or directory could not be written.
    #[error("{} cannot be written: {cause}; choose another directory", path.display())]
    Write {
        /// The file or directory.
        path: std::path::PathBuf,
        /// What the system said.
        cause: std::io::Error,
    },
}
