//! The command `check`.

use ezy_core::testing::{CheckError, check_scene};

use super::Models;
use super::arguments::CheckArguments;
use super::failure::{Failure, print};
use super::selection::find;

pub(super) fn check(models: Models<'_>, arguments: &CheckArguments) -> Result<(), Failure> {
    let selection = find(models, &arguments.path)?;
    let mut failed = Vec::new();
    for entry in selection.model.scenes {
        if selection.scene.is_some_and(|chosen| chosen.name != entry.name) {
            continue;
        }
        match check_scene((entry.new)().as_ref()) {
            Ok(report) => print(&report.to_string())?,
            Err(CheckError::Failed(report)) => {
                print(&report.to_string())?;
                failed.push(format!("{}/{}", selection.model.name, entry.name));
            }
            Err(error) => {
                let (model, scene) = (selection.model.name, entry.name);
                return Err(Failure::stopped(format!("{model}/{scene} could not be checked: {error}")));
            }
        }
    }
    if failed.is_empty() { Ok(()) } else { Err(Failure::stopped(format!("checks failed in {}", failed.join(", ")))) }
}
