//! The command `animate`.

mod data;
mod page;

use std::path::{Path, PathBuf};

use crate::model::SceneInfo;
use crate::output;
use crate::simulate::{Outcome, SetupError};

use super::Models;
use super::arguments::AnimateArguments;
use super::failure::{Failure, print};
use super::interruption::Interruption;
use super::names::{check_assignments, scene_entry, scene_with};
use super::progress::Progress;
use super::run::{end, method, not_run, simulation};
use super::selection::typed;
use data::Animation;

/// Frames of an animation, where a page holds them.
const N_FRAMES: f64 = 1000.0;
/// Numbers of all frames together: some seven bytes each.
const N_NUMBERS: f64 = 200_000.0;
const FEWEST_FRAMES: f64 = 50.0;

pub(super) fn animate(models: Models<'_>, arguments: &AnimateArguments) -> Result<(), Failure> {
    let motion = &arguments.motion;
    let (model, entry) = scene_entry(models, &motion.path)?;
    check_assignments(model, entry, &motion.start, &motion.input)?;
    if let Some(every_s) = arguments.every.filter(|every_s| *every_s <= 0.0) {
        return Err(Failure::wrong_use(SetupError::Every { every_s }));
    }
    let scene = scene_with(model, entry, &motion.set)?;
    let method = method(motion)?;
    let interruption = Interruption::listen();
    let progress = Progress::new();
    let info = scene.info();
    let mut simulation = simulation(motion, scene.as_ref(), method, interruption, &progress)?;
    let until_s = end(motion, &info);
    if until_s > 0.0 {
        simulation = simulation.every(arguments.every.unwrap_or_else(|| until_s / n_frames(&info)));
    }
    let run = simulation.run().map_err(not_run)?;
    drop(progress);
    let path = arguments
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("out/animation-{}-{}.html", typed(model.name), entry.name)));
    let animation = Animation::new(scene.as_ref(), &run, method);
    write(&path, &page::page(&animation))?;
    print(&format!("{}/{} {}\nThe page: {}\n", info.model, info.name, run.outcome, path.display()))?;
    match run.outcome {
        _ if run.outcome.reached_end() => Ok(()),
        Outcome::Interrupted { .. } => Err(interruption.failure(format!("the run {}", run.outcome))),
        _ => Err(Failure::stopped(format!("the run {}", run.outcome))),
    }
}

/// As many as a page of a usual size holds.
fn n_frames(info: &SceneInfo) -> f64 {
    let n_numbers = 3 * info.bodies.len() + info.n_outputs() + 2 * info.n_rows().min(2 * data::MOST_ARROWS) + 4;
    (N_NUMBERS / n_numbers as f64).clamp(FEWEST_FRAMES, N_FRAMES).floor()
}

/// Writes a file, and the folder where the default is.
pub(super) fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let made = folder.map_or(Ok(()), std::fs::create_dir_all);
    made.and_then(|()| output::write(path, text)).map_err(|cause| {
        Failure::wrong_use(format!(
            "`{}` cannot be written: {cause}; give --out a file that may be written",
            path.display()
        ))
    })
}
