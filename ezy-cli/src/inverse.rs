//! The command `inverse`. Without the feature `analysis`, how to get it.

use super::Models;
use super::failure::Failure;
use super::inverse_arguments::InverseArguments;

#[cfg(not(feature = "analysis"))]
pub(super) fn inverse(_: Models<'_>, _: &InverseArguments) -> Result<(), Failure> {
    Err(super::linearize::without_analysis())
}

#[cfg(feature = "analysis")]
pub(super) use with_analysis::inverse;

#[cfg(feature = "analysis")]
mod with_analysis {
    use super::super::animate::write;
    use super::super::drawing;
    use super::super::failure::print;
    use super::super::interruption::Interruption;
    use super::super::inverse_text::Found;
    use super::super::inverse_values::{Values, Wanted};
    use super::super::json::print_json;
    use super::super::motion::{end, method, refused, simulation};
    use super::super::names::{check_assignments, check_input, scene_entry, scene_with};
    use super::super::out_path::check_ending;
    use super::super::progress::Progress;
    use super::super::selection::path;
    use super::{Failure, InverseArguments, Models};
    use ezy_core::analysis::InverseDynamics;
    use ezy_core::dynamics::System;
    use ezy_core::linalg::Backend;
    use ezy_core::model::{Name, Scene, SceneInfo};
    use ezy_core::record::{find_name, input_index};
    use ezy_core::simulate::{Outcome, Run, SetupError};

    /// Samples of a run, besides the first, between which powers are integrated.
    const N_SAMPLES: f64 = 1000.0;

    pub(in super::super) fn inverse(models: Models<'_>, arguments: &InverseArguments) -> Result<(), Failure> {
        let InverseArguments { by, motion, out, plot, .. } = arguments;
        let (model, entry) = scene_entry(models, &arguments.path)?;
        check_assignments(model, entry, &motion.start, &motion.input)?;
        by.iter().try_for_each(|name| check_input(model, entry, name))?;
        if let Some(out) = out {
            check_ending(out, "values", &["csv"])?;
        }
        if let Some(plot) = plot {
            drawing::check()?;
            drawing::check_name(plot)?;
        }
        if let Some(every_s) = arguments.every.filter(|every_s| *every_s <= 0.0) {
            return Err(Failure::wrong_use(SetupError::Every { every_s }));
        }
        let scene = scene_with(model, entry, &motion.set)?;
        let rows = rows(&scene.info(), &path(model, entry), &arguments.drive)?;
        let mut system = System::new(scene.as_ref(), Backend::Auto).map_err(Failure::wrong_use)?;
        let mut wanted = wanted(&system, rows, by)?;
        let interruption = Interruption::listen();
        let (run, n_between) = run(arguments, scene.as_ref(), interruption)?;
        let (values, error) = Values::of(&run, &mut system, &mut wanted, interruption);
        let stopped = match &run.outcome {
            outcome if outcome.reached_end() => None,
            outcome => Some(format!("the run {outcome}")),
        };
        let stopped = error.map(|error| error.to_string()).or(stopped);
        if values.times.is_empty() {
            return Err(Failure::stopped(stopped.unwrap_or_else(|| "interrupted before the first value".to_owned())));
        }
        let found = Found { path: path(model, entry), info: run.info(), values: &values, n_between };
        if let Some(out) = out {
            write(out, found.csv()?)?;
        }
        if let Some(plot) = plot {
            found.draw(plot)?;
        }
        if arguments.json {
            print_json(&found.json(stopped.as_deref()))?;
        } else {
            let files: String = [out, plot].into_iter().flatten().map(|file| format!("\n{}", file.display())).collect();
            print(&format!("{}{files}{}", found.text(), if files.is_empty() { "" } else { "\n" }))?;
        }
        match stopped {
            _ if interruption.is_asked() || matches!(run.outcome, Outcome::Interrupted { .. }) => {
                Err(interruption.failure(stopped.unwrap_or_else(|| "interrupted".to_owned())))
            }
            None => Ok(()),
            Some(why) => Err(Failure::stopped(why)),
        }
    }

    /// The rows of the drives, or of what is named.
    fn rows(info: &SceneInfo, path: &str, drives: &[String]) -> Result<Vec<usize>, Failure> {
        let all = info.rows.iter().enumerate();
        if drives.is_empty() {
            let rows: Vec<usize> = all.filter(|(_, row)| row.kind == "drive").map(|(i, _)| i).collect();
            return match rows.is_empty() {
                false => Ok(rows),
                true => Err(Failure::wrong_use(format!(
                    "{path} has no drive that prescribes its motion; write one in the model, such as `drive motor: crank.phi = 2 rad/s * t;` \
                     (docs/language.md#drive), or name another constraint with --drive"
                ))),
            };
        }
        let mut rows = Vec::new();
        for name in drives {
            // a constraint of two rows has one name, and each row one behind a dot
            let is_of =
                |row: &Name| &**row == name || row.strip_prefix(&**name).is_some_and(|rest| rest.starts_with('.'));
            let here: Vec<usize> =
                info.rows.iter().enumerate().filter(|(_, row)| is_of(&row.name)).map(|(i, _)| i).collect();
            if here.is_empty() {
                find_name("constraint", name, info.rows.iter().map(|row| &*row.name))?;
            }
            rows.extend(here.into_iter().filter(|row| !rows.contains(row)).collect::<Vec<_>>());
        }
        Ok(rows)
    }

    /// What is asked for: the multipliers of the rows, or inputs in their place.
    fn wanted<'s>(system: &System<&'s dyn Scene>, rows: Vec<usize>, by: &[String]) -> Result<Wanted<'s>, Failure> {
        if by.is_empty() {
            return Ok(Wanted::Rows(rows));
        }
        let info = system.info();
        if !info.switches.is_empty() {
            return Err(Failure::wrong_use(format!(
                "scene `{}` has rows that come and go (stick-slip friction, stops): inputs are not found in place of its drives; without --by their \
                 multipliers are",
                info.name
            )));
        }
        let names: Vec<&str> = rows.iter().map(|&row| &*info.rows[row].name).collect();
        let inputs = by.iter().map(|name| input_index(info, name)).collect::<Result<Vec<_>, _>>()?;
        let inverse = InverseDynamics::new(system, &names, &by.iter().map(String::as_str).collect::<Vec<_>>());
        let inverse =
            inverse.map_err(|error| Failure::wrong_use(format!("{error}; the rows: {}", names.join(", "))))?;
        Ok(Wanted::Inputs(inputs, Box::new(inverse)))
    }

    /// The run, and how many samples there are for each row of `--out`.
    fn run(
        arguments: &InverseArguments,
        scene: &dyn Scene,
        interruption: Interruption,
    ) -> Result<(Run, usize), Failure> {
        let until_s = end(&arguments.motion, &scene.info());
        let progress = Progress::new();
        let mut simulation = simulation(&arguments.motion, scene, method(&arguments.motion)?)?
            .interrupted_by(interruption.flag())
            .on_progress(|fraction| progress.tell(fraction));
        let mut n_between = 1;
        if until_s > 0.0 {
            let every_s = arguments.every.unwrap_or(until_s / N_SAMPLES);
            // rows that are far apart have samples between them
            n_between = (every_s.min(until_s) * N_SAMPLES / until_s).ceil().max(1.0) as usize;
            simulation = simulation.every(every_s / n_between as f64);
        }
        Ok((simulation.run().map_err(refused)?, n_between))
    }
}
