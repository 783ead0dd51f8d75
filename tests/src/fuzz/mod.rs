//! Random parameters, starts and inputs, most of them reasonable and some of them not: every scene either computes what
//! an independent solution in 31 digits confirms, or refuses. `methods`: the same motion by every method that has a tolerance.

mod accelerations;
pub mod draw;
pub mod estimates;
pub mod methods;
mod motion;
mod oracle;
mod parameters;
mod reference;
mod tally;

pub use accelerations::exact_equations;
pub use oracle::Oracle;
pub use parameters::{Scenes, compare, trial};
pub use tally::{Tally, Verdict};
