//! The arguments of `sweep`.

use std::convert::Infallible;
use std::path::PathBuf;

use clap::Args;

use super::motion_arguments::MotionArguments;
use super::value::{parse_count, parse_number};
use super::vary::{Variation, parse_axis};
use super::word::Word;
use ezy_study::sweep::{Design, Format, Kept};

/// Runs a scene for many values, on all cores, and writes a table with a row for each run
///
/// Every value of --vary is run with every one of the others, with every sample and with every row of --list. The table is a folder:
/// sweep.json says what it is of, part-000000.csv and so on have the rows. A run that fails is a row with its outcome. Ctrl-C ends
/// the sweep and keeps what was computed; the same command with --resume goes on.
#[derive(Debug, Args)]
pub(super) struct SweepArguments {
    /// Its name; case and underscores do not matter
    #[arg(value_name = "MODEL/SCENE")]
    pub path: String,
    /// Run with each of these values: of a parameter, count, input or start value, or of method, step, rtol, atol, angle-tol, project,
    /// metric; may be repeated. 40:60:5 stands for 40,45,50,55,60
    #[arg(long, value_name = "NAME=A,B,…|START:END:STEP", value_parser = parse_axis)]
    pub vary: Vec<Variation>,
    /// Spread samples over this range of a parameter, input or start value; may be repeated; needs --samples
    #[arg(long, value_name = "NAME=LOW:HIGH", value_parser = parse_range, requires = "samples")]
    pub sample: Vec<SampledRange>,
    /// Number of samples
    #[arg(long, value_name = "N", value_parser = parse_count, requires = "sample")]
    pub samples: Option<u64>,
    /// How samples are spread
    #[arg(long, value_enum, ignore_case = true, default_value_t, requires = "samples")]
    pub design: Word<Design>,
    /// Seed of the samples: the same seed gives the same ones
    #[arg(long, value_name = "N", value_parser = parse_count, default_value = "0", requires = "samples")]
    pub seed: u64,
    /// Run with each row of a CSV file, whose columns are named as in --vary
    #[arg(long, value_name = "FILE.csv")]
    pub list: Option<PathBuf>,
    /// What to keep of each run: a column of `run --out` or a point at the end (seat.vx, A.x), max:COLUMN, min:COLUMN, the time of an
    /// event (event:NAME), how often it takes place (count:NAME), error, samples (all of them, a file each run); may be repeated [default: coordinates, velocities and outputs at the end]
    #[arg(long, value_name = "WHAT,…", value_parser = parse_kept, value_delimiter = ',')]
    pub keep: Vec<Kept>,
    /// Seconds between the samples of a run that are kept, and from which max: and min: are taken [default: a thousandth of the run]
    #[arg(long, value_name = "DT", value_parser = parse_number, allow_negative_numbers = true)]
    pub every: Option<f64>,
    /// Folder of the table; made if it does not exist [default: out/sweep-MODEL-SCENE]
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Go on with what is in the folder; each case is computed once
    #[arg(long)]
    pub resume: bool,
    /// Compute the I-th of N shares, from 1 to N: other machines compute the others, into the same folder or other ones
    #[arg(long, value_name = "I/N", value_parser = parse_shard)]
    pub shard: Option<[u64; 2]>,
    /// Write a script for Slurm that computes the sweep as a job array of N tasks, in place of computing it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..), conflicts_with = "shard")]
    pub slurm: Option<u64>,
    /// How the files are written
    #[arg(long, value_enum, ignore_case = true, default_value_t)]
    pub format: Word<Format>,
    /// Draw what is kept over one or two values of --vary: curves or maps, and a page
    #[arg(long, conflicts_with_all = ["shard", "slurm"])]
    pub plot: bool,
    /// Let eight neighbouring cases step together by dop853, three to six times as fast; only ends can be kept
    #[arg(long)]
    pub lanes: bool,
    /// Cases of each file [default: 1000, or more beyond a million cases]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub part: Option<u64>,
    /// Number of threads [default: as many as the machine runs at once]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub threads: Option<u64>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
    #[command(flatten)]
    pub motion: MotionArguments,
}

/// A name and the range that samples are spread over.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SampledRange {
    pub name: String,
    pub low: f64,
    pub high: f64,
}

fn parse_range(text: &str) -> Result<SampledRange, String> {
    let example = "write NAME=LOW:HIGH, such as l=0.4:0.6";
    let (name, range) = text.split_once('=').ok_or_else(|| format!("it has no `=`; {example}"))?;
    let (low, high) = range.split_once(':').ok_or_else(|| format!("`{range}` has no `:`; {example}"))?;
    if name.trim().is_empty() {
        return Err(format!("it has no name before `=`; {example}"));
    }
    Ok(SampledRange { name: name.trim().to_owned(), low: parse_number(low)?, high: parse_number(high)? })
}

fn parse_shard(text: &str) -> Result<[u64; 2], String> {
    let share = text.split_once('/').and_then(|(i, n)| Some([parse_count(i).ok()?, parse_count(n).ok()?]));
    share
        .filter(|[i, n]| (1..=*n).contains(i))
        .ok_or_else(|| format!("`{text}` is no share; write I/N with I from 1 to N, such as 3/100"))
}

fn parse_kept(text: &str) -> Result<Kept, Infallible> {
    Ok(Kept::from(text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_ranges_and_shares_are_read() {
        assert_eq!(
            parse_range("l = -1:pi"),
            Ok(SampledRange { name: "l".into(), low: -1.0, high: std::f64::consts::PI })
        );
        assert_eq!((parse_shard("3/100"), parse_shard("1/1")), (Ok([3, 100]), Ok([1, 1])));
        assert!(["l", "l=1", "=1:2", "l=a:b"].iter().all(|text| parse_range(text).is_err()));
        assert!(["0/3", "4/3", "1", "1/0", "a/b", "-1/2"].iter().all(|text| parse_shard(text).is_err()));
    }
}
