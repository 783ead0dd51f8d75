//! Runs of scenes whose columns are drawn or compared.

use super::Models;
use super::failure::{Failure, print_error};
use super::interruption::Interruption;
use super::motion::{method, refused, simulation};
use super::motion_arguments::MotionArguments;
use super::motion_table::MotionTable;
use super::names::{check_assignments, scene_entry, scene_with};
use super::progress::Progress;
use super::selection::path;
use super::vary::{Variation, varied};
use ezy_core::simulate::Outcome;

/// Intervals of a run between the points of its curves.
const N_INTERVALS: f64 = 2000.0;

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
                if matches!(run.outcome, Outcome::Interrupted { .. }) {
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
