//! A simulation as the arguments of a command ask for it.

use std::fs::File;

use ezy_core::integrate::{Method, MethodKind, Tolerance};
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::scalar::legible_time;
use ezy_core::simulate::{InputTable, SetupError, Simulation, read_inputs};

use super::failure::Failure;
use super::motion_arguments::MotionArguments;

/// Step of a method with a fixed step, s, when none is given.
const STEP_S: f64 = 1e-3;
/// Time at which scenes start, s.
const START_S: f64 = 0.0;

/// The method that is asked for; a step alone asks for rk4.
pub(super) fn method(arguments: &MotionArguments) -> Result<Method, Failure> {
    let MotionArguments { method, step, .. } = arguments;
    let by_step = if step.is_some() { MethodKind::Rk4 } else { Method::default().kind() };
    let kind = method.map_or(by_step, |word| word.0);
    let name = kind.name();
    match (kind.with_step(step.unwrap_or(STEP_S)), tolerance(arguments)) {
        (Some(method), None) => Ok(method),
        (Some(_), Some(_)) => Err(Failure::wrong_use(format!(
            "{name} has a fixed step and no tolerance: give `--step` alone, or a method with a tolerance, such as `--method dop853`"
        ))),
        (None, _) if step.is_some() => Err(Failure::wrong_use(format!(
            "{name} chooses the length of its steps: give `--rtol` in place of `--step`"
        ))),
        (None, tolerance) => {
            let tolerance = tolerance.unwrap_or(Tolerance::new(Tolerance::DEFAULT, Tolerance::DEFAULT));
            Ok(kind.with_tolerance(tolerance).unwrap_or_default())
        }
    }
}

/// The tolerance, where a part of it is given.
fn tolerance(arguments: &MotionArguments) -> Option<Tolerance> {
    let MotionArguments { rtol, atol, angle_tol, .. } = arguments;
    rtol.or(*atol).or(*angle_tol)?;
    let relative = rtol.unwrap_or(Tolerance::DEFAULT);
    Some(Tolerance { angle: *angle_tol, ..Tolerance::new(relative, atol.unwrap_or(relative)) })
}

/// Inputs of the file, then those of the command line, which win.
pub(super) fn inputs(arguments: &MotionArguments, info: &SceneInfo) -> Result<Vec<(String, InputTable)>, Failure> {
    let mut all = Vec::new();
    if let Some(path) = &arguments.inputs {
        let of_file = |what: &dyn std::fmt::Display| Failure::wrong_use(format!("`{}`: {what}", path.display()));
        let file = File::open(path).map_err(|error| of_file(&error))?;
        all = read_inputs(file, info).map_err(|error| of_file(&error))?;
        if let Some((name, table)) = all.iter().find(|(_, table)| table.begin() > START_S) {
            return Err(of_file(&format!(
                "the first value of `{name}` is at t = {} s, after the start of the run at {START_S} s; add a row for the start",
                legible_time(table.begin())
            )));
        }
    }
    all.extend(arguments.input.iter().map(|a| (a.name.clone(), InputTable::from(a.value))));
    Ok(all)
}

/// End of the run, s.
pub(super) fn end(arguments: &MotionArguments, info: &SceneInfo) -> f64 {
    arguments.until.unwrap_or(info.until_s)
}

/// The run of a scene that the arguments ask for, with its outputs.
pub(super) fn simulation<'s>(
    arguments: &MotionArguments,
    scene: &'s (dyn Scene + 's),
    method: Method,
) -> Result<Simulation<'s, &'s (dyn Scene + 's)>, Failure> {
    Ok(simulation_with(arguments, scene, method, inputs(arguments, &scene.info())?))
}

/// As [`simulation`], with inputs that were read before.
pub(super) fn simulation_with<'s>(
    arguments: &MotionArguments,
    scene: &'s (dyn Scene + 's),
    method: Method,
    inputs: impl IntoIterator<Item = (String, InputTable)>,
) -> Simulation<'s, &'s (dyn Scene + 's)> {
    let info = scene.info();
    let mut simulation = Simulation::new(scene)
        .method(method)
        .until(end(arguments, &info))
        .project(arguments.project.0)
        .metric(arguments.metric.0);
    if info.n_outputs() > 0 {
        simulation = simulation.outputs();
    }
    for (name, table) in inputs {
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
        simulation = simulation.start(&assignment.name, assignment.value);
    }
    if arguments.project_start {
        simulation = simulation.project_start();
    }
    simulation
}

/// Why a run was refused, by exit status.
pub(super) fn refused(error: SetupError) -> Failure {
    match error {
        SetupError::Motion(_) | SetupError::Record(_) => Failure::stopped(error),
        _ => Failure::wrong_use(error),
    }
}
