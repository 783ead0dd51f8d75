//! `ezy study`.

use ezy_models::study::{StudyError, study as run_study};

use super::arguments::StudyArguments;
use super::failure::Failure;
use super::output::print;
use super::progress::Progress;

pub fn study(arguments: &StudyArguments) -> Result<(), Failure> {
    let progress = Progress::new();
    let done = run_study(&arguments.out, |fraction, part| {
        progress.tell(fraction);
        progress.tell_part(part);
    });
    drop(progress);
    match done {
        Ok(study) => print(&format!("{}\nThe page: {}\n", study.summary, study.page.display())),
        Err(error @ StudyError::Write { .. }) => Err(Failure::wrong_use(error)),
        Err(error) => Err(Failure::stopped(error)),
    }
}
