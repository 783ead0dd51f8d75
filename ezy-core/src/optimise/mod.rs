//! Parameters from measurements, and the best parameters: least squares and searches over runs.
//!
//! | | |
//! |---|---|
//! | [`Fit`] | free quantities from [`Measured`] columns, with confidence intervals and what the data do not determine |
//! | [`Search`] | free quantities that make a number of a run largest or smallest |
//!
//! What is free is named by [`Free`], with bounds; how a run is made with its values is a closure of the caller. The methods are those
//! of the crate `basin`: Levenberg-Marquardt, differential evolution, Nelder-Mead. Knows nothing of how a run is made.

mod error;
mod fit;
mod free;
mod least_squares;
mod measured;
mod model;
mod search;
mod sensitivity;
mod statistics;
mod student;
#[cfg(test)]
mod tests;

pub use error::OptimiseError;
pub use fit::{Estimate, Fit, Fitted};
pub use free::Free;
pub use least_squares::FitEnd;
pub use measured::Measured;
pub use search::{Optimum, Search};
pub use sensitivity::sensitivities_at;
