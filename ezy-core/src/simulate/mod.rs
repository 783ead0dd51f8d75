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
pub use monitor::processor_time::{IS_KNOWN as PROCESSOR_TIME_IS_KNOWN, processor_time};
pub use monitor::rank_watch::{RankDeficientInterval, RankRecord};
pub use monitor::{ConditionPeak, EnergyError, ExceededLimit, LeastPivot, Monitors, Peak, SoftestImpact};
pub use outcome::{Cost, Outcome, Run, StopReason};
pub use several::eight_steppers::{EightSteppers, NotTogether};
pub use several::ensemble::Ensemble;
pub use several::sensitivity::{Sensitivities, Tangent};
#[doc(hidden)]
pub use several::together::{Alone, EndOfRun, WaitingRun, run_together};
pub use simulation::Simulation;
#[cfg(test)]
pub(crate) use simulation::simulation;
pub use stepper::Stepper;
pub use stepping::singularity_crossing::SingularityCrossed;

/// The version of this crate.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

/// The level at which this crate was optimised, from `0` to `3`: that of its profile, which a debug build may raise.
pub const OPT_LEVEL: &str = env!("EZY_OPT_LEVEL");
