//! The command `run`.

use ezy_core::integrate::Method;
use ezy_core::model::{Name, Scene};
use ezy_core::scalar::{legible, rounded};
use ezy_core::simulate::{Outcome, Run, SetupError};

use super::Models;
use super::arguments::RunArguments;
use super::failure::{Failure, print, print_error};
use super::interruption::Interruption;
use super::json::print_json;
use super::motion::{end, method, refused, simulation};
use super::names::{check_assignments, scene_entry, scene_with};
use super::out_file::OutFile;
use super::out_path::check_ending;
use super::progress::Progress;
use super::run_end::{remarks, run_json, run_text};

/// Rows of `--out` when `--every` is not given, besides the first.
const N_ROWS: f64 = 1000.0;

/// Rows that are written at most: tens of gigabytes, even of a small scene.
const MOST_ROWS: f64 = 1e8;

/// Times at which runs are compared where there are no rows.
const N_COMPARED: f64 = 200.0;

pub(super) fn run(models: Models<'_>, arguments: &RunArguments) -> Result<(), Failure> {
    let (model, entry) = scene_entry(models, &arguments.path)?;
    check_assignments(model, entry, &arguments.motion.start, &arguments.motion.input)?;
    if let Some(every_s) = arguments.every.filter(|every_s| *every_s <= 0.0) {
        return Err(Failure::wrong_use(SetupError::Every { every_s }));
    }
    if arguments.every.is_some() && arguments.out.is_none() {
        return Err(Failure::wrong_use(
            "--every is the time between the rows of --out; add --out FILE.csv, or leave --every",
        ));
    }
    let n_rows = arguments.every.map_or(0.0, |every_s| end(&arguments.motion, &(entry.info)()) / every_s);
    if n_rows > MOST_ROWS {
        let least_s = rounded(end(&arguments.motion, &(entry.info)()) / MOST_ROWS, 3);
        return Err(Failure::wrong_use(format!(
            "--every {} makes {n_rows:.1e} rows, more than a disk holds; at most {MOST_ROWS:.0e} are written: give --every {least_s} or more",
            legible(arguments.every.unwrap_or_default()),
        )));
    }
    if !arguments.at.is_empty() && arguments.out.is_none() {
        return Err(Failure::wrong_use("--at gives the times of the rows of --out; add --out FILE.csv, or leave --at"));
    }
    if let Some(out) = &arguments.out {
        check_ending(out, "motions", &["csv"])?;
    }
    let scene = scene_with(model, entry, &arguments.motion.set)?;
    let method = method(&arguments.motion)?;
    let interruption = Interruption::listen();
    let done = simulate(arguments, scene.as_ref(), method, interruption);
    if let (Err(Failure::Stopped(outcome)), true) = (&done, arguments.json) {
        print_json(&run_json(&scene.info(), method, None, &[], outcome))?;
    }
    let (run, free, written) = done?;
    // it chooses its steps, which a table may not let it
    let radau_runs = arguments.motion.inputs.is_none() && scene.jacobian_places().is_some();
    if arguments.json {
        print_json(&run_json(&scene.info(), method, Some(&run), &free, &run.outcome.to_string()))?;
        print_error(&remarks(&run, method, radau_runs));
    } else {
        print(&run_text(&run, &free, method, radau_runs))?;
    }
    let stopped = (!run.outcome.reached_end()).then(|| format!("the run {}", run.outcome));
    match (stopped, written) {
        (None, Ok(())) => Ok(()),
        (Some(why), file) if matches!(run.outcome, Outcome::Interrupted { .. }) => {
            Err(interruption.failure(file.map_or_else(|file| format!("{why}; {file}"), |()| why.clone())))
        }
        (Some(why), Ok(())) | (None, Err(why)) => Err(Failure::stopped(why)),
        (Some(why), Err(file)) => Err(Failure::stopped(format!("{why}; {file}"))),
    }
}

/// The run, the start values that were free, and whether its file is complete.
type Simulated = (Run, Vec<Name>, Result<(), String>);

fn simulate(
    arguments: &RunArguments,
    scene: &dyn Scene,
    method: Method,
    interruption: Interruption,
) -> Result<Simulated, Failure> {
    let info = scene.info();
    let until_s = end(&arguments.motion, &info);
    let mut out = arguments.out.as_deref().map(|path| OutFile::open(path, arguments.estimate_error)).transpose()?;
    let progress = Progress::new();
    let mut simulation = simulation(&arguments.motion, scene, method)?
        .work()
        .interrupted_by(interruption.flag())
        .on_progress(|fraction| progress.tell(fraction));
    if arguments.estimate_error {
        simulation = simulation.estimate_error();
        if until_s > 0.0 && out.is_none() {
            simulation = simulation.every(until_s / N_COMPARED);
        }
    }
    if let Some(out) = &mut out {
        let default_every = || (until_s > 0.0).then_some(until_s / N_ROWS);
        if !arguments.at.is_empty() {
            simulation = simulation.at(arguments.at.iter().copied());
        } else if let Some(every) = arguments.every.or_else(default_every) {
            simulation = simulation.every(every);
        }
        simulation = simulation.stream_to(out);
    }
    // a start that cannot be assembled is refused by the run
    let free = simulation.free_start_values().unwrap_or_default();
    let run = simulation.run().map_err(refused)?;
    let written = out.map_or(Ok(()), |out| out.complete(run.error_estimate.as_ref()));
    Ok((run, free, written))
}
