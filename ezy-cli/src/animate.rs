//! The command `animate`.

mod data;
mod page;
mod pixels;

use std::path::{Path, PathBuf};

use ezy_core::integrate::Method;
use ezy_core::model::coordinate::N_OF_BODY;
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::simulate::{Outcome, Run, SetupError};
use ezy_study::output;

use super::Models;
use super::arguments::{AnimateArguments, FrameFormat};
use super::failure::{Failure, print};
use super::interruption::Interruption;
use super::motion::{end, method, refused, simulation};
use super::motion_arguments::MotionArguments;
use super::names::{check_assignments, scene_entry, scene_with};
use super::out_path::{ending, make_folder_of};
use super::progress::Progress;
use super::selection::typed;
pub(super) use data::Animation;
#[cfg(feature = "analysis")]
pub(super) use data::{Plot, Told};

/// Frames of a page, where it holds them.
const N_FRAMES: f64 = 1000.0;
/// Numbers of all frames together: some seven bytes each.
const N_NUMBERS: f64 = 200_000.0;
const FEWEST_FRAMES: f64 = 50.0;
/// Frames of a picture that moves, and of a directory of pictures.
pub(super) const N_PICTURES: f64 = 120.0;
/// Frames of a GIF at most, and the time of one at least, hundredths of a second.
const MOST_OF_GIF: f64 = 200.0;
const SHORTEST_OF_GIF: f64 = 4.0;
/// The time of a frame that viewers of a GIF still show, s.
const LEAST_OF_GIF_S: f64 = 0.02;
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
    let kind = Kind::of(&path, "--out")?;
    let has_pixels = kind == Kind::Gif || (arguments.frames.is_some() && arguments.format == FrameFormat::Png);
    match (has_pixels, arguments.width) {
        (true, _) => super::drawing::check()?,
        (false, Some(_)) => {
            return Err(Failure::wrong_use(
                "--width is that of pixels; give --out FILE.gif or --frames DIR --format png with it",
            ));
        }
        (false, None) => {}
    }
    let info = scene.info();
    let end_s = end(motion, &info);
    let n_frames = match kind {
        Kind::Gif => n_of_gif(seconds(end_s)),
        Kind::Page if arguments.frames.is_none() => n_frames(&info),
        _ => N_PICTURES,
    };
    let every_s = arguments.every.unwrap_or(end_s / n_frames);
    let shortest_s = LEAST_OF_GIF_S * end_s / seconds(end_s);
    if kind == Kind::Gif && every_s < shortest_s {
        return Err(Failure::wrong_use(format!(
            "--every {every_s}: a GIF shows at most 50 frames a second, here one each {shortest_s} s; give that or more, or --out FILE.svg"
        )));
    }
    let interruption = Interruption::listen();
    let run = record(motion, scene.as_ref(), every_s, interruption)?;
    let animation = Animation::new(scene.as_ref(), &run, method(motion)?);
    let film = animation.film();
    let width = arguments.width.unwrap_or_else(|| film.width());
    write(&path, kind.bytes(&animation, seconds(run.last().t), width)?)?;
    let what = kind.name();
    print(&format!("{}/{} {}\nThe {what}: {}\n", info.model, info.name, run.outcome, path.display()))?;
    if let Some(directory) = &arguments.frames {
        let name = |i: usize, ending: &str| directory.join(format!("frame-{i:04}.{ending}"));
        match arguments.format {
            FrameFormat::Svg => film.frames().enumerate().try_for_each(|(i, frame)| write(&name(i, "svg"), frame))?,
            FrameFormat::Png => {
                (0..run.samples().len()).try_for_each(|i| write(&name(i, "png"), pixels::png(&film, i, width)?))?;
            }
        }
        let ending = if arguments.format == FrameFormat::Svg { "svg" } else { "png" };
        print(&format!("The first frame: {}\n", name(0, ending).display()))?;
    }
    match run.outcome {
        _ if run.outcome.reached_end() => Ok(()),
        Outcome::Interrupted { .. } => Err(interruption.failure(format!("the run {}", run.outcome))),
        _ => Err(Failure::stopped(format!("the run {}", run.outcome))),
    }
}

/// What is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Page,
    Svg,
    Gif,
}

impl Kind {
    /// By the ending of its name, which `option` gives; a device has none.
    pub(super) fn of(path: &Path, option: &str) -> Result<Self, Failure> {
        match ending(path).as_deref() {
            None | Some("html" | "htm") => Ok(Self::Page),
            Some("svg") => Ok(Self::Svg),
            Some("gif") => Ok(Self::Gif),
            Some(_) => Err(Failure::wrong_use(format!(
                "`{}`: animations are written as .html, .svg or .gif; give {option} such a file",
                path.display()
            ))),
        }
    }

    /// What the file is called.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Page => "page",
            Self::Svg | Self::Gif => "picture",
        }
    }

    /// The file. As a picture it moves for so many seconds; `width` is that of a GIF, pixels.
    pub(super) fn bytes(self, animation: &Animation, seconds: f64, width: u32) -> Result<Vec<u8>, Failure> {
        match self {
            Self::Svg => Ok(animation.film().moving(seconds).into_bytes()),
            Self::Gif => pixels::gif(&animation.film(), seconds, width),
            Self::Page => Ok(page::page(animation).into_bytes()),
        }
    }
}

/// How long a picture moves.
pub(super) fn seconds(end_s: f64) -> f64 {
    end_s.clamp(SHORTEST_S, LONGEST_S)
}

/// Frames of a GIF, whose times are whole hundredths of a second.
pub(super) fn n_of_gif(seconds: f64) -> f64 {
    let hundredths = (100.0 * seconds / MOST_OF_GIF).ceil().max(SHORTEST_OF_GIF);
    (100.0 * seconds / hundredths).round()
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

/// The page of an animation of a run of `scene` by `method`, with a frame for each sample: what the command `animate` writes.
pub fn animation_page(scene: &dyn Scene, run: &Run, method: Method) -> String {
    page::page(&Animation::new(scene, run, method))
}

/// The page of a run, and the run.
pub(super) fn page_of(
    motion: &MotionArguments,
    scene: &dyn Scene,
    interruption: Interruption,
) -> Result<(String, Run), Failure> {
    let info = scene.info();
    let run = record(motion, scene, end(motion, &info) / n_frames(&info), interruption)?;
    let page = animation_page(scene, &run, method(motion)?);
    Ok((page, run))
}

/// As many as a page of a usual size holds.
fn n_frames(info: &SceneInfo) -> f64 {
    let n_numbers = N_OF_BODY * info.bodies.len() + info.n_outputs() + 2 * info.n_rows().min(2 * data::MOST_ARROWS) + 4;
    (N_NUMBERS / n_numbers as f64).clamp(FEWEST_FRAMES, N_FRAMES).floor()
}

/// Writes a file, and makes its folder.
pub(super) fn write(path: &Path, bytes: impl AsRef<[u8]>) -> Result<(), Failure> {
    make_folder_of(path).and_then(|()| output::write(path, bytes)).map_err(|cause| {
        let path = path.display();
        Failure::wrong_use(format!("`{path}` cannot be written: {cause}; give --out a file that may be written"))
    })
}
