//! The arguments of `workspace`.

use std::path::PathBuf;

use clap::Args;

use super::steady_arguments::SteadyArguments;
use super::vary::{Variation, parse_axis};

/// Finds which values of one or two coordinates a mechanism reaches, and where it is singular
///
/// Holds the coordinates of --over at the values of a grid and assembles the mechanism there, from neighbour to neighbour, near the start of the scene.
/// Over one coordinate follows the positions around dead centres into the other way of assembly, and finds singular positions to ten digits. At
/// each place: the smallest singular value of the position rows by all other coordinates, which is zero in a singular position, and the transmission,
/// the largest move of the others for a move of one of the held coordinates. Both count angles in rad and lengths in lengths of the mechanism; values
/// are in m and rad.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "analysis"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct WorkspaceArguments {
    #[command(flatten)]
    pub steady: SteadyArguments,
    /// The coordinate and its values, in m or rad; given twice: a map over both
    #[arg(long, value_name = "COORDINATE=START:END:STEP", value_parser = parse_axis, required = true)]
    pub over: Vec<Variation>,
    /// Leave these drives out, which prescribe what should take other values
    #[arg(long, value_name = "DRIVE,…", value_delimiter = ',')]
    pub without: Vec<String>,
    /// What the figure over one coordinate shows besides the singular value; without it the angle that changes most, or the coordinate
    #[arg(long, value_name = "COORDINATE")]
    pub of: Option<String>,
    /// Write a row for each place, as CSV
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Draw the smallest singular value over the values; .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}
