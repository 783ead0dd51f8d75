//! The arguments of `periodic`.

use std::path::PathBuf;

use clap::{ArgGroup, Args};

use super::steady_arguments::SteadyArguments;
use super::value::parse_number;

/// Finds a motion that repeats itself, such as a gait, and whether it is stable
///
/// Newton's method on what does not return after a period, with exact derivatives, begins at the start of the scene. Where nothing depends on place
/// or heading, the motion may come back at another place and heading, as a gait does. Prints the period in s, how far the motion goes, its start,
/// and the Floquet multipliers: the factors of small deviations over a period. Runs are by dop853. Exit status 1 where no such motion is found: the
/// message says what does not return.
#[derive(Debug, Args)]
#[command(group(ArgGroup::new("of_period").required(true).args(["period", "period_near"])))]
#[cfg_attr(not(feature = "analysis"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct PeriodicArguments {
    #[command(flatten)]
    pub steady: SteadyArguments,
    /// The period, s: that of the force or drive that depends on time, or a multiple of it
    #[arg(long, value_name = "S", value_parser = parse_number)]
    pub period: Option<f64>,
    /// Find the period, too, near this one, s, of a scene that does not depend on time
    #[arg(long, value_name = "S", value_parser = parse_number)]
    pub period_near: Option<f64>,
    /// Run the scene for so many periods first, and begin the search where it then is
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub after: u32,
    /// Relative tolerance of the runs
    #[arg(long, value_name = "TOL", value_parser = parse_number, default_value = "1e-12")]
    pub rtol: f64,
    /// Write the motion over the period, as CSV
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Draw the multipliers with the unit circle, inside of which deviations fade; .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}
