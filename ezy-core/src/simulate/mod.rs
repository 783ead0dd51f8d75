//! Runs a scene: step, project, record. Knows no formula.

mod adaptive;
mod control;
mod course;
mod detour;
mod ensemble;
mod error;
mod events;
mod implicit;
mod input_file;
mod input_table;
mod instantaneous;
mod integrator;
mod keeper;
mod launch;
mod modes;
mod monitor;
mod motion;
mod outcome;
mod pace;
mod rank_watch;
mod reach;
mod run_loop;
mod sensitivity;
mod simulation;
mod stepper;

pub use ensemble::Ensemble;
pub use error::SetupError;
pub use events::Occurrence;
pub use input_file::{InputFileError, read_inputs};
pub use input_table::{InputTable, TableError};
pub use monitor::{ConditionPeak, EnergyError, ExceededLimit, LeastPivot, Monitors, Peak};
pub use outcome::{Cost, Outcome, Run, StopReason};
pub use rank_watch::{RankRecord, RankSpell};
pub use sensitivity::{Sensitivities, Tangent};
pub use simulation::Simulation;
pub use stepper::Stepper;
