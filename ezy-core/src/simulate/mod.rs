//! Runs a scene: step, project, record. Knows no formula.

mod error;
mod instantaneous;
mod keeper;
mod outcome;
mod run_loop;
mod simulation;

pub use error::SetupError;
pub use outcome::{Cost, Outcome, Run, StopReason};
pub use simulation::Simulation;
