//! The command `animate`.

mod data;
mod page;

use std::path::{Path, PathBuf};

use crate::model::{Scene, SceneInfo};
use crate::output;
use crate::simulate::{Outcome, Run, SetupError};

use super::Models;
use super::arguments::AnimateArguments;
use super::failure::{Failure, print};
use super::interruption::Interruption;
use super::motion::{end, method, refused, simulation};
use super::motion_arguments::MotionArguments;
use super::names::{check_assignments, scene_entry, scene_with};
use super::progress::Progress;
use super::selection::typed;
use data::Animation;

/// Frames of a page, where it holds them.
const N_FRAMES: f64 = 1000.0;
/// Numbers of all frames together: some seven bytes each.
const N_NUMBERS: f64 = 200_000.0;
const FEWEST_FRAMES: f64 = 50.0;
/// Frames of a picture that moves, and of a directory of pictures.
const N_PICTURES: f64 = 120.0;
/// A picture that moves takes real time between these, s.
const SHORTEST_S: f64 = 3.0;
const LONGEST_S: f64 = 20.0;

pub(super) fn animate(models: Models<'_>, arguments: &AnimateArguments) -> Result<(), Failure> {
    let motion = &arguments.motion;
    let (model, entry) = scene_entry(models, &arguments.path)?;
    check_assignments(model, entry, &motion.start, &motion.input)?;
    if let Some(every_s) = arguments.every.filter(|every_s| *every_s <= 0.0) {
        return Err(Failure::wrong_use(SetupError::Every { every_s }));
    }
    let scene = scene_with(model, entry, &motion.set)?;
    let default = || PathBuf::from(format!("out/animation-{}-{}.html", typed(model.name), entry.name));
    let path = arguments.out.clone().unwrap_or_else(default);
    let is_picture = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("svg"));
    let info = scene.info();
    let n_frames = if is_picture || arguments.frames.is_some() { N_PICTURES } else { n_frames(&info) };
    let every_s = arguments.every.unwrap_or_else(|| end(motion, &info) / n_frames);
    let interruption = Interruption::listen();
    let run = record(motion, scene.as_ref(), every_s, interruption)?;
    let animation = Animation::new(scene.as_ref(), &run, method(motion)?);
    let film = animation.film();
    let (what, text) = match is_picture {
        true => ("picture", film.moving(run.last().t.clamp(SHORTEST_S, LONGEST_S))),
        false => ("page", page::page(&animation)),
    };
    write(&path, &text)?;
    print(&format!("{}/{} {}\nThe {what}: {}\n", info.model, info.name, run.outcome, path.display()))?;
    if let Some(directory) = &arguments.frames {
        for (i, frame) in film.frames().enumerate() {
            write(&directory.join(format!("frame-{i:04}.svg")), &frame)?;
        }
        print(&format!("The first frame: {}\n", directory.join("frame-0000.svg").display()))?;
    }
    match run.outcome {
        _ if run.outcome.reached_end() => Ok(()),
        Outcome::Interrupted { .. } => Err(interruption.failure(format!("the run {}", run.outcome))),
        _ => Err(Failure::stopped(format!("the run {}", run.outcome))),
    }
}

/// The run with a sample for each frame.
fn record(
    motion: &MotionArguments,
    scene: &dyn Scene,
    every_s: f64,
    interruption: Interruption,
) -> Result<Run, Failure> {
    let progress = Progress::new();
    let mut simulation = simulation(motion, scene, method(motion)?)?
        .work()
        .interrupted_by(interruption.flag())
        .on_progress(|fraction| progress.tell(fraction));
    if every_s > 0.0 {
        simulation = simulation.every(every_s);
    }
    simulation.run().map_err(refused)
}

/// The page of a run, and the run.
pub(super) fn page_of(
    motion: &MotionArguments,
    scene: &dyn Scene,
    interruption: Interruption,
) -> Result<(String, Run), Failure> {
    let info = scene.info();
    let run = record(motion, scene, end(motion, &info) / n_frames(&info), interruption)?;
    let page = page::page(&Animation::new(scene, &run, method(motion)?));
    Ok((page, run))
}

/// As many as a page of a usual size holds.
fn n_frames(info: &SceneInfo) -> f64 {
    let n_numbers = 3 * info.bodies.len() + info.n_outputs() + 2 * info.n_rows().min(2 * data::MOST_ARROWS) + 4;
    (N_NUMBERS / n_numbers as f64).clamp(FEWEST_FRAMES, N_FRAMES).floor()
}

/// Writes a file, and makes its folder.
pub(super) fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    let made = folder.map_or(Ok(()), std::fs::create_dir_all);
    made.and_then(|()| output::write(path, text)).map_err(|cause| {
        let path = path.display();
        Failure::wrong_use(format!("`{path}` cannot be written: {cause}; give --out a file that may be written"))
    })
}
