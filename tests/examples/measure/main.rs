//! What the pages of EZY measure, and comparisons of random runs.
//!
//! `cargo run --release --example measure -- --help` lists it all; what takes `--write` puts its tables and figures into `docs`.

mod cranks;
mod estimates;
mod hard_cases;
mod instructions;
mod job_array;
mod long_runs;
mod methods;
mod parameters;

use std::error::Error;
use std::process::ExitCode;

use clap::{Args, Parser};

type Outcome = Result<(), Box<dyn Error>>;

// what is measured is said at its arguments
/// Measures what the pages of EZY tell, and compares random runs
#[derive(Debug, Parser)]
#[command(name = "measure")]
enum Asked {
    HardCases(hard_cases::Asked),
    Cranks(cranks::Asked),
    Methods(methods::Asked),
    Estimates(estimates::Asked),
    Instructions(instructions::Asked),
    LongRuns(long_runs::Asked),
    /// Simulates a job array on nodes that fail: the tables of docs/many-runs.md
    JobArray,
    /// Runs scenes with random parameters, and demands a result or a refusal that says why
    RandomParameters(Random),
    /// Runs random motions by every method, judged by a reference and by their own amplification
    RandomMethods(Random),
    /// Compares estimates of the errors of random runs, many of one to three steps, with the true errors
    ///
    /// Prints those below a fifth of the error, or above a hundred times it.
    RandomEstimates(Random),
    #[command(hide = true)]
    CountScene(instructions::Counted),
    #[command(hide = true)]
    CountChain(instructions::Counted),
    #[command(hide = true)]
    CountRun(long_runs::Counted),
}

/// Which random cases.
#[derive(Debug, Args)]
struct Random {
    /// How many
    n: u64,
    /// Number they are drawn from
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// The first of them
    #[arg(long, default_value_t = 0)]
    first: u64,
}

impl Random {
    fn cases(&self) -> std::ops::Range<u64> {
        self.first..self.first.saturating_add(self.n)
    }
}

/// Faults are printed where they are found.
fn outcome(n_faults: usize) -> Outcome {
    if n_faults == 0 { Ok(()) } else { Err(format!("{n_faults} faults").into()) }
}

fn main() -> ExitCode {
    let outcome = match Asked::parse() {
        Asked::HardCases(asked) => hard_cases::run(&asked),
        Asked::Cranks(asked) => {
            cranks::run(&asked);
            Ok(())
        }
        Asked::Methods(asked) => methods::run(&asked),
        Asked::Estimates(asked) => estimates::run(&asked),
        Asked::Instructions(asked) => instructions::run(&asked),
        Asked::LongRuns(asked) => long_runs::run(&asked),
        Asked::JobArray => {
            job_array::run();
            Ok(())
        }
        Asked::RandomParameters(random) => parameters::run(&random),
        Asked::RandomMethods(random) => methods::random(&random),
        Asked::RandomEstimates(random) => estimates::random(&random),
        Asked::CountScene(counted) => instructions::repeat_scene(&counted),
        Asked::CountChain(counted) => instructions::repeat_chain(&counted),
        Asked::CountRun(counted) => long_runs::repeat(&counted),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}
