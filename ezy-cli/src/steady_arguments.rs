//! The arguments of `equilibrium` and `linearize`.

use std::path::PathBuf;

use clap::Args;

use super::value::{Assignment, parse_assignment, parse_number};
use super::vary::{Variation, parse_variation};

/// Finds a steady motion of a scene, and prints the eigenvalues of small deviations from it
///
/// Looks for rest, or for a motion that is constant seen from a frame that travels and turns evenly, near the start of the scene: straight
/// at one speed, or on a circle. Then linearizes about it: x' = A x + B u, y = C x + D u, with x in the tangent space of the constraints.
/// With --vary: the root locus, and the critical values at which stability changes. With --response: the transfer function from an input to an
/// output, its poles, zeros and margins, and a Bode plot. With --mode: an animation of one mode.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "analysis"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct LinearizeArguments {
    #[command(flatten)]
    pub steady: SteadyArguments,
    /// Print the eigenvalues for each of these values: of a parameter, count, input or start value, which is held. 1:10:0.5 stands for
    /// 1,1.5,2,…,10
    #[arg(long, value_name = "NAME=START:END:STEP|A,B,…", value_parser = parse_variation)]
    pub vary: Option<Variation>,
    /// Print poles, zeros, static gain, margins and resonance of the response of an output to an input, or of several
    #[arg(long, value_name = "INPUT:OUTPUT,…", value_delimiter = ',', value_parser = parse_pair)]
    pub response: Vec<Pair>,
    /// Frequencies of the files of --response, rad/s: by default from below all poles and zeros to above
    #[arg(long, value_name = "FIRST:LAST", value_parser = parse_frequencies, requires = "response")]
    pub frequencies: Option<[f64; 2]>,
    /// Draw the mechanism swinging in this mode of the table, counted from 1, without growth or decay; give --animate with it
    #[arg(long, value_name = "N", requires = "animate", conflicts_with_all = ["vary", "response"])]
    pub mode: Option<usize>,
    /// The file of --mode: a page, .html, or a picture that moves, .gif or .svg
    #[arg(long, value_name = "FILE", requires = "mode")]
    pub animate: Option<PathBuf>,
    /// How far what moves most deviates in the animation, m or rad [default: largest angle 0.2 rad, or largest displacement a tenth of the mechanism]
    #[arg(long, value_name = "A", value_parser = parse_number, requires = "animate", allow_negative_numbers = true)]
    pub amplitude: Option<f64>,
    /// Write as CSV a row for each value of --vary and each eigenvalue, or for each frequency of --response
    #[arg(long, value_name = "FILE.csv")]
    pub out: Option<PathBuf>,
    /// Draw real and imaginary parts over the value of --vary, or the Bode plot of --response; .svg, .png or .html
    #[arg(long, value_name = "FILE")]
    pub plot: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// An input and an output.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(not(feature = "analysis"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct Pair {
    pub input: String,
    pub output: String,
}

/// Reads `INPUT:OUTPUT`.
fn parse_pair(text: &str) -> Result<Pair, String> {
    match text.split(':').map(str::trim).collect::<Vec<_>>()[..] {
        [input, output] if !input.is_empty() && !output.is_empty() => {
            Ok(Pair { input: input.to_owned(), output: output.to_owned() })
        }
        _ => Err("it is no pair of names; write INPUT:OUTPUT, such as steer:yaw_rate".to_owned()),
    }
}

/// Reads `FIRST:LAST`.
fn parse_frequencies(text: &str) -> Result<[f64; 2], String> {
    let ends = text.split(':').map(parse_number).collect::<Result<Vec<f64>, String>>()?;
    match ends[..] {
        [first, last] if 0.0 < first && first < last => Ok([first, last]),
        _ => {
            Err("these are no ascending frequencies above zero; write FIRST:LAST in rad/s, such as 0.01:100".to_owned())
        }
    }
}

/// Finds where a scene rests, or runs steadily, and whether it stays there
///
/// Newton's method, with exact derivatives, begins at the start of the scene. Without velocities there, rest is looked for; else a motion that is
/// constant seen from a frame that travels and turns evenly: straight on, or on a circle. What the equations leave free stays near the start.
/// Stability is that of small deviations. With --vary: the bifurcation diagram, with every branch that leaves that of the start, and folds,
/// branch points and changes of stability by their values. Exit status 1 where no such motion is found: the message says which force or row is left.
#[derive(Debug, Args)]
#[cfg_attr(not(feature = "analysis"), allow(dead_code, reason = "told how to get the command"))]
pub(super) struct EquilibriumArguments {
    #[command(flatten)]
    pub steady: SteadyArguments,
    /// Look for every rest, from 128 starts that are spread over full turns of all angles and both ways of assembly
    #[arg(long)]
    pub all: bool,
    /// Follow the motion while a parameter, input or start value goes from the least to the largest of these values, around folds and into
    /// branches, in steps of at most STEP
    #[arg(long, value_name = "NAME=START:END:STEP", value_parser = parse_variation, conflicts_with = "all")]
    pub vary: Option<Variation>,
    /// What the diagram shows over the value of --vary, in figure and table: a coordinate, velocity or first-order state; without it the
    /// angle that changes most, or, where none does, the turn rate
    #[arg(long, value_name = "COLUMN", requires = "vary")]
    pub of: Option<String>,
    /// Write a row for each point of each branch, as CSV
    #[arg(long, value_name = "FILE.csv", requires = "vary")]
    pub out: Option<PathBuf>,
    /// Draw the diagram; .svg, .png or .html
    #[arg(long, value_name = "FILE", requires = "vary")]
    pub plot: Option<PathBuf>,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_what_is_no_pair_and_no_span_is_refused() {
        let pair = parse_pair("steer: yaw_rate").unwrap();
        assert_eq!((&*pair.input, &*pair.output), ("steer", "yaw_rate"));
        assert!(["steer", "a:b:c", ":b", "a:", ""].into_iter().all(|text| parse_pair(text).is_err()));
        assert_eq!(parse_frequencies("0.01:1e2"), Ok([0.01, 100.0]));
        assert!(
            ["0:1", "2:1", "1:1", "-1:1", "1", "1:2:3", "a:b"].into_iter().all(|text| parse_frequencies(text).is_err())
        );
    }
}
