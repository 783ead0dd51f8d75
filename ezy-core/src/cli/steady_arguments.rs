//! The arguments of `equilibrium` and `linearize`.

use std::path::PathBuf;

use clap::Args;

use super::value::{Assignment, parse_assignment};
use super::vary::{Variation, parse_variation};

/// Finds a steady motion of a scene, and prints the eigenvalues of small deviations from it
///
/// Looks for rest, or for a motion that is constant seen from a frame that travels and turns evenly, near the start of the scene: straight
/// at one speed, or on a circle. Then linearizes about it: x' = A x + B u, y = C x + D u, with x in the tangent space of the constraints.
/// With --vary: the root locus, and the critical values at which stability changes.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "analysis"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct LinearizeArguments {
    #[command(flatten)]
    pub steady: SteadyArguments,
    /// Print the eigenvalues for each of these values: of a parameter, count, input or start value, which is held. 1:10:0.5 stands for
    /// 1,1.5,2,…,10
    #[arg(long, value_name = "NAME=START:END:STEP|A,B,…", value_parser = parse_variation)]
    pub vary: Option<Variation>,
    /// Write a row for each value of --vary and each eigenvalue, as CSV
    #[arg(long, value_name = "FILE.csv", requires = "vary")]
    pub out: Option<PathBuf>,
    /// Draw real and imaginary parts over the value of --vary; .svg, .png or .html
    #[arg(long, value_name = "FILE", requires = "vary")]
    pub plot: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Finds where a scene rests, or runs steadily, and whether it stays there
///
/// Newton's method, with exact derivatives, begins at the start of the scene. Without velocities there, rest is looked for; else a motion that is
/// constant seen from a frame that travels and turns evenly: straight on, or on a circle. What the equations leave free stays near the start.
/// Stability is that of small deviations. Exit status 1 where no such motion is found: the message says which force or row is left.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "analysis"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct EquilibriumArguments {
    #[command(flatten)]
    pub steady: SteadyArguments,
    /// Look for every rest, from 128 starts that are spread over full turns of all angles and both ways of assembly
    #[arg(long)]
    pub all: bool,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

// its documentation would take the place of that of the command
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "analysis"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct SteadyArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL/SCENE")]
    pub path: String,
    /// Change a parameter or a count; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub set: Vec<Assignment>,
    /// Begin the search from this start value, as in `run`; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub start: Vec<Assignment>,
    /// Set an input, in its unit; may be repeated
    #[arg(long, value_name = "NAME=VALUE", value_parser = parse_assignment)]
    pub input: Vec<Assignment>,
    /// Coordinates, velocities and first-order states that keep their start value in the search: a speed, a place; may be repeated
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub hold: Vec<String>,
}
