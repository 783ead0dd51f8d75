//! Methods that advance a state: a file or folder each, and a line of the table in `method.rs`. Knows no files and no constraints but through
//! [`System`](crate::dynamics::System).

mod compensated;
mod discontinuities;
mod dop853;
mod family;
mod fixed_steps;
mod gauss;
mod hermite;
mod integrator;
mod method;
mod midpoint;
mod radau;
mod reduced;
mod rk4;
mod root;
mod step_control;
mod step_limit;
mod taylor;
mod tolerances;

pub(crate) use discontinuities::{EventDiscontinuities, Smooth};
pub(crate) use dop853::{Dop853, ERROR_ORDER as DOP853_ERROR_ORDER, InQuasiVelocities};
pub(crate) use family::Sizes;
pub use family::{MethodInfo, Needs};
pub(crate) use hermite::Node;
pub(crate) use integrator::Integrator;
pub use method::{Method, MethodKind};
pub(crate) use root::{resolution_at, root, side_of};
pub use step_control::Tolerance;
pub(crate) use step_control::{Clock, StepControl};
pub(crate) use taylor::{AlongSeries, Taylor};
pub use taylor::{PreciseError, PreciseMotion};
pub(crate) use tolerances::second_run;
pub(crate) use tolerances::steps::QUARTERED;
