//! Runs a scene: step, project, record. Knows no formula.

mod build;
mod checkpoint;
mod control;
mod ensemble;
mod error;
mod error_estimate;
mod estimated_run;
mod events;
mod given;
mod input_file;
mod input_table;
mod inputs_guard;
mod modes;
mod monitor;
mod now;
mod outcome;
mod processor_time;
mod rank_watch;
mod run_loop;
mod sample_times;
mod sampler;
mod schedule;
mod sensitivity;
mod simulation;
mod singular;
mod singularity_crossing;
mod snapshot;
mod stepper;
mod stepper_state;
#[cfg(feature = "sweep")]
mod together;
mod tolerances;
mod trajectory;

pub use checkpoint::{Checkpoint, CheckpointError};
pub use ensemble::Ensemble;
pub use error::SetupError;
pub use error_estimate::{ErrorEstimate, NoErrorEstimate, QuantityError};
pub use events::Occurrence;
pub use input_file::{InputFileError, read_inputs};
pub use input_table::{InputTable, TableError};
pub use inputs_guard::InputsGuard;
pub use monitor::{ConditionPeak, EnergyError, ExceededLimit, LeastPivot, Monitors, Peak};
pub use now::{Inputs, Now};
pub use outcome::{Cost, Outcome, Run, StopReason};
pub(crate) use processor_time::{IS_KNOWN as PROCESSOR_TIME_IS_KNOWN, processor_time};
pub use rank_watch::{RankDeficientInterval, RankRecord};
pub use sensitivity::{Sensitivities, Tangent};
pub use simulation::Simulation;
pub use singularity_crossing::SingularityCrossed;
pub use stepper::Stepper;
#[cfg(feature = "sweep")]
pub(crate) use together::{Alone, End, Waiting, run_together};
