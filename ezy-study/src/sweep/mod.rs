//! Many runs of a scene: which cases, what is kept of each, on all cores, into files that survive.

mod builder;
mod case;
mod error;
mod finished;
mod format;
mod group;
mod kept;
mod manifest;
mod parquet;
mod part;
mod plan;
mod results;
mod row;
mod samples;
#[cfg(test)]
mod tests;
mod trajectories;
mod workers;

pub use builder::{Progress, RanAlone, Sweep, Table, Written};
pub use case::{Case, Refused};
pub use error::SweepError;
pub use finished::{Ended, Finished};
pub use format::Format;
pub use kept::Kept;
pub use plan::{Plan, PlanError, Value};
pub use results::{Results, ResultsError};
pub use row::{Cell, Column, Kind, Row};
pub use samples::{Design, Samples};
