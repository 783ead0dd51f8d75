//! The command `plot`.

use super::Models;
use super::arguments::PlotArguments;
use super::drawing;
#[cfg(feature = "figures")]
use super::drawing_of_columns::Picture;
#[cfg(feature = "figures")]
use super::failure::print;
use super::failure::{Failure, print_error};
use super::interruption::Interruption;
use super::motion::{method, refused, simulation};
use super::motion_arguments::MotionArguments;
use super::motion_table::MotionTable;
use super::names::{check_assignments, path, scene_entry, scene_with};
use super::progress::Progress;
use super::vary::{Variation, varied};

/// Intervals of a run between the points of its curves.
const N_INTERVALS: f64 = 2000.0;

#[cfg(not(feature = "figures"))]
pub(super) fn plot(_: Models<'_>, _: &PlotArguments) -> Result<(), Failure> {
    drawing::check()
}

#[cfg(feature = "figures")]
pub(super) fn plot(models: Models<'_>, arguments: &PlotArguments) -> Result<(), Failure> {
    let (scenes, patterns): (Vec<&String>, Vec<&String>) = arguments.what.iter().partition(|word| word.contains('/'));
    let Some(first) = scenes.first() else {
        let word = patterns.first().map_or("", |word| word.as_str());
        return Err(Failure::wrong_use(format!("`{word}` names no scene; write MODEL/SCENE before the columns")));
    };
    let (model, entry) = scene_entry(models, first)?;
    let out = arguments.out.clone().unwrap_or_else(|| format!("{}.svg", path(model, entry).replace('/', "-")).into());
    drawing::check_name(&out)?;
    let runs = Runs { variations: &arguments.vary, every: arguments.every, n_scenes: scenes.len() };
    let mut motions = Vec::new();
    let mut stopped = None;
    for scene in &scenes {
        stopped = stopped.or(runs.motions(models, scene, &arguments.motion, &mut motions)?);
    }
    if patterns.is_empty() {
        let known: Vec<&str> = motions[0].columns[1..].iter().map(|column| column.name.as_str()).collect();
        return Err(Failure::wrong_use(format!("give one column or several; {first} has: {}", known.join(", "))));
    }
    let names: Vec<String> = scenes.iter().map(|scene| scene.to_lowercase()).collect();
    let title = names.join(", ");
    let against = arguments.against.as_deref();
    Picture { title: &title, motions: &motions, patterns: &patterns, against }.write(&out)?;
    print(&format!("{}\n", out.display()))?;
    stopped.map_or(Ok(()), Err)
}

/// How scenes are run to be drawn or compared.
pub(super) struct Runs<'a> {
    pub variations: &'a [Variation],
    pub every: Option<f64>,
    pub n_scenes: usize,
}

impl Runs<'_> {
    /// Runs a scene with every value, adds the motions, and returns why one of them stopped before its end.
    pub(super) fn motions(
        &self,
        models: Models<'_>,
        scene: &str,
        arguments: &MotionArguments,
        motions: &mut Vec<MotionTable>,
    ) -> Result<Option<Failure>, Failure> {
        let (model, entry) = scene_entry(models, scene)?;
        let scene_path = path(model, entry);
        let interruption = Interruption::listen();
        let mut stopped = None;
        for (label, arguments) in varied(arguments, self.variations, &(entry.info)())? {
            check_assignments(model, entry, &arguments.start, &arguments.input)?;
            let scene = scene_with(model, entry, &arguments.set)?;
            let method = method(&arguments)?;
            let until_s = arguments.until.unwrap_or(scene.info().until_s);
            let progress = Progress::new();
            let mut simulation = simulation(&arguments, scene.as_ref(), method)?
                .work()
                .interrupted_by(interruption.flag())
                .on_progress(|fraction| progress.tell(fraction));
            if let Some(every_s) = self.every.or((until_s > 0.0).then_some(until_s / N_INTERVALS)) {
                simulation = simulation.every(every_s);
            }
            let run = simulation.run().map_err(refused)?;
            let name = match (self.n_scenes, label.is_empty()) {
                (1, true) => scene_path.clone(),
                (1, false) => label,
                (_, true) => scene_path.clone(),
                (_, false) => format!("{scene_path}, {label}"),
            };
            if !run.outcome.reached_end() {
                let why = format!("the run of {name} {}", run.outcome);
                if matches!(run.outcome, crate::simulate::Outcome::Interrupted { .. }) {
                    return Err(interruption.failure(why));
                }
                print_error(&format!("remark: {why}\n"));
                stopped = Some(Failure::stopped(why));
            }
            motions.push(MotionTable::of_run(name, scene.as_ref(), &run)?);
        }
        Ok(stopped)
    }
}
