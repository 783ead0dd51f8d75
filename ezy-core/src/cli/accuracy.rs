//! The command `accuracy`.

use std::path::PathBuf;

use crate::accuracy::{Accuracy, AccuracyError, WorkPrecision};
use crate::simulate::SetupError;

use super::Models;
use super::accuracy_json::accuracy_json;
use super::arguments::AccuracyArguments;
use super::failure::{Failure, print};
use super::names::{check_assignments, scene_entry, scene_with};
use super::progress::Progress;
use super::selection::typed;

/// What is named when it is written.
const WRITTEN: &str = if cfg!(feature = "figures") { "page" } else { "numbers" };

pub(super) fn accuracy(models: Models<'_>, arguments: &AccuracyArguments) -> Result<(), Failure> {
    let (model, entry) = scene_entry(models, &arguments.path)?;
    check_assignments(model, entry, &arguments.start, &arguments.input)?;
    let scene = scene_with(model, entry, &arguments.set)?;
    let mut order = Accuracy::new(scene.as_ref()).budget(arguments.budget);
    if let Some(until_s) = arguments.until {
        order = order.until(until_s);
    }
    order = arguments.start.iter().fold(order, |order, start| order.give(&start.name, start.value));
    order = arguments.input.iter().fold(order, |order, input| order.input(&input.name, input.value));
    let directory = arguments
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("out/accuracy-{}-{}", typed(model.name), entry.name)));
    // a directory that cannot be written is found before the work, not after it
    std::fs::create_dir_all(&directory).map_err(|cause| AccuracyError::Write { path: directory.clone(), cause })?;
    let progress = Progress::new();
    let measured = order.measure(|fraction, part| {
        progress.tell(fraction);
        progress.tell_part(part);
    });
    drop(progress);
    let measured = measured?;
    let written = measured.save(&directory)?;
    match arguments.json {
        true => print(&format!("{}\n", accuracy_json(&measured)))?,
        false => print(&format!("{}\nThe {WRITTEN}: {}\n", text(&measured), written.display()))?,
    }
    if measured.is_empty() {
        let budget_s = measured.budget_s;
        return Err(Failure::stopped(format!("nothing was measured within {budget_s} s; give more with --budget")));
    }
    Ok(())
}

impl From<AccuracyError> for Failure {
    fn from(error: AccuracyError) -> Self {
        match error {
            AccuracyError::Setup(SetupError::Motion(_) | SetupError::Record(_))
            | AccuracyError::NoReference { .. }
            | AccuracyError::NothingKnown { .. } => Self::stopped(error),
            #[cfg(feature = "figures")]
            AccuracyError::Figure(_) => Self::stopped(error),
            AccuracyError::Write { .. } => Self::wrong_use(format!("{error} with --out")),
            AccuracyError::Budget { .. } => Self::wrong_use(format!("{error} with --budget")),
            AccuracyError::Setup(_) | AccuracyError::NoTime { .. } => Self::wrong_use(error),
        }
    }
}

fn text(measured: &WorkPrecision) -> String {
    let mut text = format!("{}/{} to t = {} s\n\n", measured.info.model, measured.info.name, measured.until_s);
    measured.advice().iter().for_each(|advice| text += &format!("{advice}\n"));
    text += &format!("\n{}\n", measured.table());
    measured.reference_text().iter().for_each(|line| text += &format!("{line}\n"));
    let missing = measured.missing_text();
    if !missing.is_empty() {
        text += "\nNot measured:\n";
        missing.iter().for_each(|line| text += &format!("  {line}\n"));
    }
    text + &format!("\n{}.\n", measured.machine)
}
