//! `ezy run`.

use std::fs::File;

use ezy_core::integrate::Method;
use ezy_core::model::{Scene, SceneEntry};
use ezy_core::record::{CsvWriter, Sample, find_name};
use ezy_core::report::table::{Table, fixed};
use ezy_core::simulate::{Outcome, Run, SetupError, Simulation};
use ezy_models::registry::{find, typed};

use super::arguments::{MethodName, RunArguments};
use super::failure::Failure;
use super::json::Json;
use super::output::print;
use super::progress::Progress;

/// Rows of `--out` when `--every` is not given, besides the first.
const N_ROWS: f64 = 1000.0;

pub fn run(arguments: &RunArguments) -> Result<(), Failure> {
    let entry = scene_entry(&arguments.path)?;
    let mut scene = (entry.new)();
    for assignment in &arguments.set {
        let names = entry.info.parameters.iter().map(|parameter| parameter.name);
        scene.set_parameter(find_name("parameter", &assignment.name, names)?, assignment.value);
    }
    let method = match arguments.method {
        MethodName::Rk4 => Method::rk4(arguments.step),
    };
    match simulate(arguments, scene.as_ref(), method) {
        Ok(run) => {
            if arguments.json {
                print(&format!("{}\n", run_json(&run, method)))?;
            } else {
                print(&run_text(&run))?;
            }
            match run.outcome {
                Outcome::ReachedEnd => Ok(()),
                Outcome::Stopped { .. } => Err(Failure::stopped(format!("the run {}", run.outcome))),
            }
        }
        Err(failure) => {
            if let (Failure::Stopped(outcome), true) = (&failure, arguments.json) {
                let [model, scene, method] = [entry.info.model, entry.info.name, method.name()].map(Json::text);
                let outcome = Json::text(outcome.as_str());
                println!(
                    "{}",
                    Json::object([("model", model), ("scene", scene), ("method", method), ("outcome", outcome)])
                );
            }
            Err(failure)
        }
    }
}

fn scene_entry(path: &str) -> Result<&'static SceneEntry, Failure> {
    let selection = find(path)?;
    selection.scene.ok_or_else(|| {
        let model = typed(selection.model.name);
        let scenes = selection.model.scenes.iter().map(|entry| format!("{model}/{}", entry.info.name));
        Failure::wrong_use(format!("`{path}` names no scene; run one of: {}", scenes.collect::<Vec<_>>().join(", ")))
    })
}

fn simulate(arguments: &RunArguments, scene: &dyn Scene, method: Method) -> Result<Run, Failure> {
    let info = scene.info();
    let until_s = arguments.until.unwrap_or(info.until_s);
    let mut writer = match &arguments.out {
        None => None,
        Some(path) => {
            let refused = |cause: std::io::Error| {
                let remedy = "give --out a file in a directory that exists and may be written to";
                Failure::wrong_use(format!("`{}` cannot be written: {cause}; {remedy}", path.display()))
            };
            Some(CsvWriter::new(File::create(path).map_err(refused)?, info).map_err(refused)?)
        }
    };
    let progress = Progress::new();
    let mut simulation = Simulation::new(scene)
        .method(method)
        .until(until_s)
        .project(arguments.project.into())
        .metric(arguments.metric.into())
        .on_progress(|fraction| progress.tell(fraction));
    for assignment in &arguments.start {
        simulation = simulation.give(&assignment.name, assignment.value);
    }
    if let Some(writer) = &mut writer {
        let default_every = || (until_s > 0.0).then_some(until_s / N_ROWS);
        if let Some(every) = arguments.every.or_else(default_every) {
            simulation = simulation.every(every);
        }
        simulation = simulation.record_to(writer);
    }
    simulation.run().map_err(|error| match error {
        SetupError::Motion(_) | SetupError::Record(_) => Failure::stopped(error),
        _ => Failure::wrong_use(error),
    })
}

fn run_json(run: &Run, method: Method) -> Json {
    let (info, last, cost) = (run.info(), run.last(), run.cost);
    let coordinates = || info.coordinates.iter().map(|c| c.name);
    let energy = last.energy;
    Json::object([
        ("model", Json::text(info.model)),
        ("scene", Json::text(info.name)),
        ("method", Json::text(method.name())),
        ("t", Json::Number(last.t)),
        ("state", Json::numbers(coordinates(), last.coordinates)),
        ("rate", Json::numbers(coordinates(), last.velocities)),
        ("acceleration", Json::numbers(coordinates(), last.accelerations)),
        ("multipliers", Json::numbers(info.rows.iter().map(|row| row.name), last.multipliers)),
        (
            "energy",
            Json::numbers(
                ["kinetic", "potential", "work", "balance"],
                &[energy.kinetic, energy.potential, energy.work, energy.balance],
            ),
        ),
        ("residual", Json::numbers(["position", "velocity"], &[last.position_residual, last.velocity_residual])),
        (
            "cost",
            Json::object([
                ("steps", Json::Count(cost.steps)),
                ("rejected", Json::Count(cost.rejected)),
                ("evaluations", Json::Count(cost.evaluations)),
                ("factorizations", Json::Count(cost.factorizations)),
                ("seconds", Json::Number(cost.seconds)),
            ]),
        ),
        ("outcome", Json::text(run.outcome.to_string())),
    ])
}

fn run_text(run: &Run) -> String {
    let (info, last, cost) = (run.info(), run.last(), run.cost);
    let mut text = format!("{}/{}: {} at t = {} s\n\n", info.model, info.name, outcome_word(&run.outcome), last.t);
    text += &motion_table(&last).to_string();
    if info.n_rows() > 0 {
        let mut table = Table::new(["row", "multiplier", "unit"]);
        for (row, lambda) in info.rows.iter().zip(last.multipliers) {
            table.push([row.name.to_owned(), fixed(*lambda, 12), row.multiplier_unit.to_owned()]);
        }
        text += &format!("\n{table}");
    }
    let energy = last.energy;
    text += &format!(
        "\nkinetic energy {} J, potential energy {} J, work {} J, balance {:.1e} J\n\
         largest constraint residual: positions {:.1e}, velocities {:.1e}\n\
         {} steps, {} evaluations of the accelerations, {:.3} s\n",
        fixed(energy.kinetic, 12),
        fixed(energy.potential, 12),
        fixed(energy.work, 12),
        energy.balance,
        last.position_residual,
        last.velocity_residual,
        cost.steps,
        cost.evaluations,
        cost.seconds
    );
    text
}

fn outcome_word(outcome: &Outcome) -> &'static str {
    if outcome.reached_end() { "reached the end" } else { "stopped" }
}

fn motion_table(last: &Sample<'_>) -> Table {
    let mut table = Table::new(["coordinate", "value", "velocity", "acceleration", "unit"]);
    for (i, coordinate) in last.info.coordinates.iter().enumerate() {
        let [q, v, a] = [last.coordinates[i], last.velocities[i], last.accelerations[i]].map(|x| fixed(x, 12));
        table.push([coordinate.name, &q, &v, &a, coordinate.unit]);
    }
    table
}
