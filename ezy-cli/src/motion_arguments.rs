//! What every command that runs a scene takes: method, limits, parameters, start values, inputs.

use std::path::PathBuf;

use clap::Args;

use super::value::{Assignment, parse_assignment, parse_count, parse_number};
use super::word::Word;
use ezy_core::dynamics::{Metric, Projection};
use ezy_core::integrate::MethodKind;

// its documentation would take the place of that of the command
#[derive(Debug, Clone, Default, Args)]
pub(super) struct MotionArguments {
    /// End of the run in seconds [default: what the scene says]
    #[arg(long, value_name = "S", value_parser = parse_number, allow_negative_numbers = true)]
    pub until: Option<f64>,
    /// Integration method [default: dop853, or rk4 with --step]
    #[arg(long, value_enum, ignore_case = true)]
    pub method: Option<Word<MethodKind>>,
    /// Step in seconds, of a method with a fixed step [default: 1e-3]
    #[arg(long, value_name = "H", value_parser = parse_number, allow_negative_numbers = true)]
    pub step: Option<f64>,
    /// Relative tolerance, of a method that chooses its steps [default: 1e-9]
    #[arg(long, value_name = "R", value_parser = parse_number, allow_negative_numbers = true)]
    pub rtol: Option<f64>,
    /// Absolute tolerance in m, rad, m/s, rad/s [default: that of --rtol]
    #[arg(long, value_name = "A", value_parser = parse_number, allow_negative_numbers = true)]
    pub atol: Option<f64>,
    /// Tolerance of angles in rad, in place of --rtol and --atol, for rotors whose angles grow
    #[arg(long, value_name = "A", value_parser = parse_number, allow_negative_numbers = true)]
    pub angle_tol: Option<f64>,
    /// What is projected onto the constraints after each step
    #[arg(long, value_enum, ignore_case = true, default_value_t)]
    pub project: Word<Projection>,
    /// Metric in which the projection is smallest
    #[arg(long, value_enum, ignore_case = true, default_value_t)]
    pub metric: Word<Metric>,
    /// Stop before the residual of a constraint exceeds R: m or rad in positions, m/s or rad/s in velocities
    #[arg(long, value_name = "R", value_parser = parse_number, allow_negative_numbers = true)]
    pub max_drift: Option<f64>,
    /// Stop before the error of the energy balance exceeds R, relative to the energy exchanged so far
    #[arg(long, value_name = "R", value_parser = parse_number, allow_negative_numbers = true)]
    pub max_energy_error: Option<f64>,
    /// Stop after N steps, rejected ones included [default: when the method chooses them, ten million, or as soon as these cannot suffice]
    #[arg(long, value_name = "N", value_parser = parse_count, allow_negative_numbers = true)]
    pub max_steps: Option<u64>,
    /// Change a parameter or a count; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub set: Vec<Assignment>,
    /// Hold a start value: seat.x, seat.y, seat.phi, seat.vx, seat.vy, seat.omega, …; may be repeated
    ///
    /// A given value replaces that of the scene and is held. Values that neither gives follow from the constraints.
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub start: Vec<Assignment>,
    /// Project a start that contradicts the constraints onto them instead of refusing it
    ///
    /// All values then change as little as possible in the mass metric: positions first, then velocities.
    #[arg(long)]
    pub project_start: bool,
    /// Set an input, in its unit; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub input: Vec<Assignment>,
    /// Read inputs from a CSV file with a column t and one for each input
    ///
    /// Straight lines join the rows; two rows at one time are a jump. They are read in fixed steps, so give --step. Columns
    /// may carry their unit: `torque [N*m]`. Of a file that --out wrote, each value holds until the next row.
    #[arg(long, value_name = "FILE.csv")]
    pub inputs: Option<PathBuf>,
}
