//! The command `run`.

use std::fs::File;

use crate::integrate::{Method, Tolerance};
use crate::model::{Scene, SceneInfo};
use crate::simulate::{InputTable, Outcome, Run, SetupError, Simulation, read_inputs};

use super::Models;
use super::arguments::{MethodName, MotionArguments, RunArguments};
use super::failure::{Failure, print, print_error};
use super::interruption::Interruption;
use super::json::print_json;
use super::names::{check_assignments, scene_entry, scene_with};
use super::out_file::OutFile;
use super::progress::Progress;
use super::run_end::{remarks, run_json, run_text};

/// Rows of `--out` when `--every` is not given, besides the first.
const N_ROWS: f64 = 1000.0;

/// Times at which runs are compared where there are no rows.
const N_COMPARED: f64 = 200.0;

pub(super) fn run(models: Models<'_>, arguments: &RunArguments) -> Result<(), Failure> {
    let motion = &arguments.motion;
    let (model, entry) = scene_entry(models, &motion.path)?;
    check_assignments(model, entry, &motion.start, &motion.input)?;
    if let Some(every_s) = arguments.every.filter(|every_s| *every_s <= 0.0) {
        return Err(Failure::wrong_use(SetupError::Every { every_s }));
    }
    if arguments.every.is_some() && arguments.out.is_none() {
        return Err(Failure::wrong_use(
            "--every is the time between the rows of --out; add --out FILE.csv, or leave --every",
        ));
    }
    let scene = scene_with(model, entry, &motion.set)?;
    let method = method(motion)?;
    let interruption = Interruption::listen();
    let done = simulate(arguments, scene.as_ref(), method, interruption);
    if let (Err(Failure::Stopped(outcome)), true) = (&done, arguments.json) {
        print_json(&run_json(&scene.info(), method, None, outcome))?;
    }
    let (run, written) = done?;
    // it chooses its steps, which a table may not let it
    let radau_runs = motion.inputs.is_none() && has_jacobians(scene.as_ref());
    if arguments.json {
        print_json(&run_json(&scene.info(), method, Some(&run), &run.outcome.to_string()))?;
        print_error(&remarks(&run, method, radau_runs));
    } else {
        print(&run_text(&run, method, radau_runs))?;
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

/// Whether a scene and its modes have the Jacobians of their equations.
fn has_jacobians(scene: &dyn Scene) -> bool {
    scene.jacobian_places().is_some() && scene.modes().iter().all(|mode| mode.jacobian_places().is_some())
}

/// Step of a method with a fixed step, s, when none is given.
const STEP_S: f64 = 1e-3;
/// Relative tolerance of a method that chooses its steps, when none is given.
const RELATIVE_TOLERANCE: f64 = 1e-9;

pub(super) fn method(arguments: &MotionArguments) -> Result<Method, Failure> {
    let MotionArguments { method, step, rtol, atol, .. } = arguments;
    match method {
        MethodName::Rk4 => match rtol.or(*atol) {
            Some(_) => Err(Failure::wrong_use(
                "rk4 has a fixed step: give `--step`, or a method with a tolerance, such as `--method dop853`",
            )),
            None => Ok(Method::rk4(step.unwrap_or(STEP_S))),
        },
        MethodName::Dop853 => Ok(Method::Dop853(tolerance("dop853", arguments)?)),
        MethodName::Taylor => Ok(Method::Taylor(tolerance("taylor", arguments)?)),
        MethodName::Radau => Ok(Method::Radau(tolerance("radau", arguments)?)),
    }
}

/// Tolerance of a method that chooses its steps.
fn tolerance(method: &str, arguments: &MotionArguments) -> Result<Tolerance, Failure> {
    if arguments.step.is_some() {
        return Err(Failure::wrong_use(format!(
            "{method} chooses the length of its steps: give `--rtol` in place of `--step`"
        )));
    }
    let relative = arguments.rtol.unwrap_or(RELATIVE_TOLERANCE);
    Ok(Tolerance { relative, absolute: arguments.atol.unwrap_or(relative) })
}

/// Inputs of the file, then those of the command line, which win.
fn inputs(arguments: &MotionArguments, info: &SceneInfo) -> Result<Vec<(String, InputTable)>, Failure> {
    let mut all = Vec::new();
    if let Some(path) = &arguments.inputs {
        let of_file = |what: &dyn std::fmt::Display| Failure::wrong_use(format!("`{}`: {what}", path.display()));
        let file = File::open(path).map_err(|error| of_file(&error))?;
        all = read_inputs(file, info).map_err(|error| of_file(&error))?;
    }
    all.extend(arguments.input.iter().map(|a| (a.name.clone(), InputTable::from(a.value))));
    Ok(all)
}

/// The run, and whether its file is complete.
type Simulated = (Run, Result<(), String>);

fn simulate(
    arguments: &RunArguments,
    scene: &dyn Scene,
    method: Method,
    interruption: Interruption,
) -> Result<Simulated, Failure> {
    let mut out = arguments.out.as_deref().map(|path| OutFile::open(path, arguments.estimate_error)).transpose()?;
    let progress = Progress::new();
    let mut simulation = simulation(&arguments.motion, scene, method, interruption, &progress)?;
    let until_s = end(&arguments.motion, &scene.info());
    if arguments.estimate_error {
        simulation = simulation.estimate_error();
        if until_s > 0.0 && out.is_none() {
            simulation = simulation.every(until_s / N_COMPARED);
        }
    }
    if let Some(out) = &mut out {
        let default_every = || (until_s > 0.0).then_some(until_s / N_ROWS);
        if let Some(every) = arguments.every.or_else(default_every) {
            simulation = simulation.every(every);
        }
        simulation = simulation.stream_to(out);
    }
    let run = simulation.run().map_err(not_run)?;
    let written = out.map_or(Ok(()), |out| out.complete(run.error_estimate.as_ref()));
    Ok((run, written))
}

/// Why there is no run.
pub(super) fn not_run(error: SetupError) -> Failure {
    match error {
        SetupError::Motion(_) | SetupError::Record(_) => Failure::stopped(error),
        _ => Failure::wrong_use(error),
    }
}

/// End of the run, s.
pub(super) fn end(arguments: &MotionArguments, info: &SceneInfo) -> f64 {
    arguments.until.unwrap_or(info.until_s)
}

/// The run that is asked for, but for what is recorded.
pub(super) fn simulation<'s>(
    arguments: &MotionArguments,
    scene: &'s dyn Scene,
    method: Method,
    interruption: Interruption,
    progress: &'s Progress,
) -> Result<Simulation<'s, dyn Scene + 's>, Failure> {
    let info = scene.info();
    let mut simulation = Simulation::new(scene)
        .method(method)
        .until(end(arguments, &info))
        .project(arguments.project)
        .metric(arguments.metric)
        .work()
        .interrupted_by(interruption.flag())
        .on_progress(|fraction| progress.tell(fraction));
    if info.n_outputs() > 0 {
        simulation = simulation.outputs();
    }
    for (name, table) in inputs(arguments, &info)? {
        simulation = simulation.input(name, table);
    }
    if let Some(residual) = arguments.max_drift {
        simulation = simulation.max_drift(residual);
    }
    if let Some(relative) = arguments.max_energy_error {
        simulation = simulation.max_energy_error(relative);
    }
    if let Some(steps) = arguments.max_steps {
        simulation = simulation.max_steps(steps);
    }
    for assignment in &arguments.start {
        simulation = simulation.give(&assignment.name, assignment.value);
    }
    if arguments.project_start {
        simulation = simulation.project_start();
    }
    Ok(simulation)
}
