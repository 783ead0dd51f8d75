//! Runs a scene: step, project, record. Knows no formula.

mod control;
mod error;
mod input_file;
mod input_table;
mod instantaneous;
mod integrator;
mod keeper;
mod launch;
mod motion;
mod outcome;
mod pace;
mod reach;
mod run_loop;
mod simulation;
mod stepper;

pub use error::SetupError;
pub use input_file::{InputFileError, read_inputs};
pub use input_table::{InputTable, TableError};
pub use outcome::{Cost, Outcome, Run, StopReason};
pub use simulation::Simulation;
pub use stepper::Stepper;
