//! The command line: one command a file. Everything it does is done through the public parts of `ezy-core`.

mod accuracy;
mod accuracy_json;
mod arguments;
mod check;
mod failure;
mod json;
mod list;
mod names;
mod out_file;
mod output;
mod progress;
mod run;
mod run_end;
mod run_monitors;
mod show;
mod study;
mod value;

use std::process::ExitCode;

use arguments::{Arguments, Command};
use clap::Parser as _;

/// Reads the arguments, does what they ask, and turns a failure into a message and an exit status.
pub fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let done = match &arguments.command {
        None => study::study(&arguments::StudyArguments::default()),
        Some(Command::List(arguments)) => list::list(arguments),
        Some(Command::Show(arguments)) => show::show(arguments),
        Some(Command::Run(arguments)) => run::run(arguments),
        Some(Command::Check(arguments)) => check::check(arguments),
        Some(Command::Accuracy(arguments)) => accuracy::accuracy(arguments),
        Some(Command::Study(arguments)) => study::study(arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
