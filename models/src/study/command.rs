//! The command `study` of `ezy`.

use std::path::PathBuf;

use ezy_cli::clap::{Arg, ArgMatches, Command, value_parser};
use ezy_cli::{Failure, Interruption, Progress, print};

use super::StudyError;

/// The command and its help.
pub fn command() -> Command {
    let out = Arg::new("out")
        .long("out")
        .value_name("DIR")
        .default_value("out/ezyroller")
        .value_parser(value_parser!(PathBuf))
        .help("Directory to write into; made if it does not exist");
    Command::new("study")
        .about("Does the EzyRoller study: equations, figures, numbers and a page")
        .long_about(
            "Does the EzyRoller study: equations, figures, numbers and a page\n\n\
             Writes index.html, which needs nothing else, each figure as SVG and PNG, and the numbers behind it as CSV. \
             Every number that the page states is measured in this run. Ctrl-C ends the study with the parts that are done.",
        )
        .arg(out)
}

/// Does the study and prints its key numbers.
///
/// # Errors
/// [`Failure::Use`] when a file cannot be written, [`Failure::Stopped`] when a run stops, [`Failure::Interrupted`] after
/// a signal.
pub fn run(arguments: &ArgMatches) -> Result<(), Failure> {
    let directory: &PathBuf = arguments.get_one("out").ok_or_else(|| Failure::wrong_use("give --out a directory"))?;
    let progress = Progress::new();
    let interruption = Interruption::listen();
    let done = super::study(directory, interruption.flag(), |fraction, part| {
        progress.tell(fraction);
        progress.tell_part(part);
    });
    drop(progress);
    match done {
        Ok(study) => print(&format!("{}\nThe page: {}\n", study.summary, study.page.display())),
        Err(error @ StudyError::Interrupted { .. }) => Err(interruption.failure(error)),
        Err(error @ StudyError::Write { .. }) => Err(Failure::wrong_use(error)),
        Err(error) => Err(Failure::stopped(error)),
    }
}
