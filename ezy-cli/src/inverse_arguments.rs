//! The arguments of `inverse`.

use std::path::PathBuf;

use clap::Args;

use super::motion_arguments::MotionArguments;
use super::value::parse_number;

/// Finds the torques and forces that a prescribed motion takes
///
/// Runs the scene, whose drives prescribe the motion. Without --by the values are the multipliers of the drives, in N or N*m; docs/notation.md has
/// their signs. With --by inputs take the place of the drives: the values are those that leave nothing for the drives to push, each in the unit of
/// its input. Power is in W, work in J. Exit status 1 where the run or the search of values stops, as in a singular position: what was
/// found until then is printed and written.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "analysis"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct InverseArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL/SCENE")]
    pub path: String,
    /// Drives, or other constraints, whose forces are asked for [default: every drive of the scene]
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub drive: Vec<String>,
    /// Inputs that take the place of the drives: one for each row, in any order
    #[arg(long, value_name = "INPUT,…", value_delimiter = ',')]
    pub by: Vec<String>,
    /// Seconds between the rows of --out [default: a thousandth of the run]
    #[arg(long, value_name = "DT", value_parser = parse_number, allow_negative_numbers = true)]
    pub every: Option<f64>,
    /// Write time and values as CSV
    ///
    /// With --by the file can be read by a later run: 'run MODEL/SCENE --inputs FILE.csv --step H', of a scene without the drives from the same
    /// start, follows the motion. Straight lines join the rows.
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Draw values and powers over time; .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub motion: MotionArguments,
}
