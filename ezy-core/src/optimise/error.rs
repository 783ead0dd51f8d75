//! Why there is nothing to fit or to optimise.

use crate::record::UnknownName;
use crate::scalar::legible;

/// A fit or a search cannot be made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OptimiseError {
    /// The measurement cannot be read.
    #[error("{0}")]
    Data(String),
    /// Nothing is free.
    #[error("nothing is free: name at least one parameter, start value or input")]
    NothingFree,
    /// Fewer values than free quantities.
    #[error(
        "{n_values} measured values cannot determine {n_free} free quantities and their errors; measure more, or free fewer"
    )]
    TooFewValues {
        /// Measured values.
        n_values: usize,
        /// Free quantities.
        n_free: usize,
    },
    /// The bounds leave nothing free, or the start is outside.
    #[error(
        "`{name}` starts at {} between the bounds {} and {}; give a lower bound below the upper one, and a start between them",
        legible(*.start), legible(*.lower), legible(*.upper)
    )]
    Bounds {
        /// Name of the free quantity.
        name: String,
        /// Its start.
        start: f64,
        /// Its lower bound.
        lower: f64,
        /// Its upper bound.
        upper: f64,
    },
    /// A search is made within bounds.
    #[error("`{name}` has no bounds, and a search needs both; give them: `Free::between(\"{name}\", lower, upper)`")]
    Unbounded {
        /// Name of the free quantity.
        name: String,
    },
    /// A weight is not positive.
    #[error("the standard deviation of `{column}` is {}; give a positive one", legible(*.sigma))]
    Sigma {
        /// Name of the column.
        column: String,
        /// What was given.
        sigma: f64,
    },
    /// A measured or wanted column is none of the run.
    #[error(transparent)]
    Column(#[from] UnknownName),
    /// The run recorded nothing at a measured time.
    #[error(
        "the run has no sample at t = {} s, where `{column}` was measured; call `.at(data.times().to_vec())` on the simulation, and let it last until then",
        legible(*.t)
    )]
    NoSample {
        /// Time of the measurement, s.
        t: f64,
        /// Name of the column.
        column: String,
    },
    /// The run with the start values fails.
    #[error("the run with the start values fails: {reason}; start with values that a run can be made with")]
    Start {
        /// How it ended.
        reason: String,
    },
    /// No run within the bounds came to its end.
    #[error("none of {n_runs} runs within the bounds came to its end; the last one: {reason}")]
    NoRun {
        /// Runs that were tried.
        n_runs: usize,
        /// How the last one ended.
        reason: String,
    },
}
