//! Runs a scene: step, project, record. Knows no formula.

mod build;
mod checked;
mod checkpoint;
mod error;
mod error_estimate;
mod events;
mod inputs;
mod modes;
mod monitor;
mod outcome;
mod recording;
mod run_loop;
mod several;
mod simulation;
mod stepper;
mod stepping;
mod tolerances;

pub use checkpoint::{Checkpoint, CheckpointError};
pub use error::SetupError;
pub use error_estimate::{ErrorEstimate, NoErrorEstimate, QuantityError};
pub use events::Occurrence;
pub use inputs::input_file::{InputFileError, read_inputs};
pub use inputs::input_table::{InputTable, TableError};
pub use inputs::inputs_guard::InputsGuard;
pub use inputs::now::{Inputs, Now};
pub(crate) use monitor::processor_time::{IS_KNOWN as PROCESSOR_TIME_IS_KNOWN, processor_time};
pub use monitor::rank_watch::{RankDeficientInterval, RankRecord};
pub use monitor::{ConditionPeak, EnergyError, ExceededLimit, LeastPivot, Monitors, Peak, SoftestImpact};
pub use outcome::{Cost, Outcome, Run, StopReason};
pub use several::eight_steppers::{EightSteppers, NotTogether};
pub use several::ensemble::Ensemble;
pub use several::sensitivity::{Sensitivities, Tangent};
#[cfg(feature = "sweep")]
pub(crate) use several::together::{Alone, End, Waiting, run_together};
pub use simulation::Simulation;
pub use stepper::Stepper;
pub use stepping::singularity_crossing::SingularityCrossed;
