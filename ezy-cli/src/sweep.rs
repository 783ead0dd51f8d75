//! The command `sweep`.

use std::fs::File;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::Models;
use super::drawing;
use super::failure::{Failure, print};
use super::interruption::Interruption;
use super::json::print_json;
use super::motion::{end, inputs, method, simulation_with};
use super::motion_arguments::MotionArguments;
use super::names::{check_assignments, scene_entry, scene_with, whole_number};
use super::out_path::check_folder_name;
use super::progress::Progress;
use super::selection::path;
use super::slurm;
use super::sweep_arguments::SweepArguments;
use super::sweep_maps;
use super::value::{Assignment, parse_number};
use super::vary::{Target, Variation, set, target};
use ezy_core::model::{Scene, SceneInfo};
use ezy_core::record::LimitedReader;
use ezy_core::simulate::InputTable;
use ezy_study::sweep::{
    Case, Finished, Format, Kept, Plan, RanAlone, Refused, Samples, Sweep, SweepError, Value, Written,
};

pub(super) fn sweep(models: Models<'_>, arguments: &SweepArguments) -> Result<(), Failure> {
    let (model, entry) = scene_entry(models, &arguments.path)?;
    let motion = &arguments.motion;
    check_assignments(model, entry, &motion.start, &motion.input)?;
    let scene = scene_with(model, entry, &motion.set)?;
    let info = scene.info();
    let plan = plan(arguments, &info)?;
    // a start that no case has is said before they run
    motion.start.iter().try_for_each(|start| target(&start.name, &info).map(|_| ()))?;
    let targets = plan.names().into_iter().map(|name| target(name, &info)).collect::<Result<Vec<_>, _>>()?;
    let runs = Runs { arguments: motion, targets, names: plan.names(), inputs: inputs(motion, &info)?, info: &info };
    runs.check_settings(&plan)?;
    let folder = folder(arguments, &path(model, entry))?;
    let interruption = Interruption::listen();
    let progress = Progress::of_cases(plan.n_cases().map_err(Failure::wrong_use)?);
    let is_known = cfg!(feature = "parquet") || arguments.format.0 == Format::Csv;
    if !is_known {
        return Err(Failure::wrong_use(
            "this program was built without Parquet; add \"parquet\" to the features of ezy-cli in Cargo.toml, or write CSV and read that",
        ));
    }
    if arguments.plot {
        drawing::check()?;
        sweep_maps::check(&plan)?;
    }
    let make = || scene_with(model, entry, &motion.set);
    let mut sweep = Sweep::new(&*scene, plan.clone(), |case| runs.run(&make, case))
        .keep(kept(arguments, &info))
        .format(arguments.format.0)
        .interrupted_by(interruption.flag())
        .on_progress(|of| {
            progress.tell_cases(of.n_done, of.n_cases);
            if of.n_failed > 0 {
                progress.tell_part(&format!("{} failed", of.n_failed));
            }
        });
    for (name, value) in runs.settings()? {
        sweep = sweep.setting(name, value);
    }
    if let Some(every_s) = arguments.every {
        sweep = sweep.every(every_s);
    }
    if arguments.lanes {
        sweep = sweep.in_lanes(&*scene);
    }
    if let Some(n) = arguments.threads {
        sweep = sweep.threads(n as usize);
    }
    if let Some(n) = arguments.part {
        sweep = sweep.cases_per_part(n);
    }
    if let Some([i, n]) = arguments.shard {
        sweep = sweep.shard(i, n);
    }
    if arguments.resume {
        sweep = sweep.resume();
    }
    if let Some(n) = arguments.slurm {
        sweep.check().map_err(refused)?;
        let name = format!("sweep-{}", path(model, entry).replace('/', "-"));
        return print(&format!("{}\n", slurm::write(&folder, &name, n)?));
    }
    let written = sweep.write(&folder);
    drop(progress);
    let written = written.map_err(refused)?;
    if arguments.json {
        print_json(&json_of(&written, &folder))?;
    } else {
        print(&text_of(&written, &folder))?;
    }
    let [n_complete, n_parts] = written.n_parts;
    match (&written.first_failure, interruption.is_asked() && n_complete < n_parts) {
        (_, true) => Err(interruption.failure("the sweep was interrupted; the same command with --resume goes on")),
        (Some((case, why)), _) if written.progress.n_failed == written.progress.n_done => {
            Err(Failure::stopped(format!("every run failed; case {case}: {why}")))
        }
        _ if arguments.plot => sweep_maps::write(&folder, &plan, &path(model, entry)),
        _ => Ok(()),
    }
}

fn refused(error: SweepError) -> Failure {
    match error {
        SweepError::Exists { folder, n_parts: [n_complete, n_parts] } => Failure::wrong_use(format!(
            "`{}` has results of this sweep: {n_complete} of {n_parts} parts are complete; add --resume, or give --out another folder",
            folder.display()
        )),
        SweepError::File { .. } => {
            Failure::stopped(format!("{error}; what was computed is kept: the same command with --resume goes on"))
        }
        error => Failure::wrong_use(error),
    }
}

/// How the cases of a plan are run.
struct Runs<'a> {
    arguments: &'a MotionArguments,
    /// What each value of a case belongs to, and its name.
    targets: Vec<Target>,
    names: Vec<&'a str>,
    inputs: Vec<(String, InputTable)>,
    info: &'a SceneInfo,
}

impl Runs<'_> {
    fn run(&self, make: &dyn Fn() -> Result<Box<dyn Scene>, Failure>, case: &Case<'_>) -> Result<Finished, Refused> {
        let of_failure = |failure: Failure| Refused::new(failure.message());
        let mut scene = make().map_err(of_failure)?;
        let varied = || self.targets.iter().zip(&self.names).zip(case.values());
        for ((target, name), value) in varied() {
            match target {
                Target::Parameter(i) => scene.set_parameter(*i, value.number()),
                Target::Count(i) => {
                    let count = Assignment { name: (*name).to_owned(), value: value.number() };
                    scene.set_count(*i, whole_number(&count).map_err(of_failure)?);
                }
                Target::Input | Target::Start | Target::Setting => {}
            }
        }
        let mut arguments = self.arguments.clone();
        for ((target, name), value) in varied() {
            if *target == Target::Setting {
                self.set(&mut arguments, name, *value).map_err(of_failure)?;
            }
        }
        let method = method(&arguments).map_err(of_failure)?;
        let mut simulation = simulation_with(&arguments, scene.as_ref(), method, self.inputs.iter().cloned());
        for ((target, name), value) in varied() {
            match target {
                Target::Input => simulation = simulation.input(*name, value.number()),
                Target::Start => simulation = simulation.start(*name, value.number()),
                Target::Parameter(_) | Target::Count(_) | Target::Setting => {}
            }
        }
        Ok(case.run(simulation)?)
    }

    fn set(&self, arguments: &mut MotionArguments, name: &str, value: Value<'_>) -> Result<(), Failure> {
        match value {
            Value::Number(x) => set(arguments, name, &format!("{x:?}"), self.info),
            Value::Word(word) => set(arguments, name, word, self.info),
        }
    }

    /// That each combination of settings makes a method: what is wrong with all cases of a value is said before they run.
    fn check_settings(&self, plan: &Plan) -> Result<(), Failure> {
        let has_settings = self.targets.contains(&Target::Setting);
        let n = if has_settings { plan.n_cases().map_err(Failure::wrong_use)?.min(MOST_CHECKED) } else { 1 };
        for index in 0..n {
            let mut arguments = self.arguments.clone();
            for ((target, name), value) in self.targets.iter().zip(&self.names).zip(plan.values(index)) {
                if *target == Target::Setting {
                    self.set(&mut arguments, name, value)?;
                }
            }
            method(&arguments)?;
        }
        Ok(())
    }

    /// All that the motions depend on besides what is varied.
    fn settings(&self) -> Result<Vec<(&'static str, serde_json::Value)>, Failure> {
        let of = self.arguments;
        let by_name =
            |all: &[Assignment]| all.iter().map(|a| (a.name.clone(), json!(a.value))).collect::<serde_json::Value>();
        let method = method(of)?;
        let tolerance = method.tolerance().map(|of| json!([of.relative, of.absolute, of.angle]));
        let tables: Vec<String> = self.inputs.iter().map(|(name, table)| format!("{name}: {table:?}")).collect();
        Ok(vec![
            ("until", json!(end(of, self.info))),
            ("method", json!(method.name())),
            ("step", json!(method.step_s())),
            ("tolerance", json!(tolerance)),
            ("project", json!(format!("{:?}", of.project).to_lowercase())),
            ("metric", json!(format!("{:?}", of.metric).to_lowercase())),
            ("set", by_name(&of.set)),
            ("start", by_name(&of.start)),
            ("project start", json!(of.project_start)),
            ("inputs", json!(tables)),
            ("limits", json!([of.max_drift, of.max_energy_error, of.max_steps.map(|n| n as f64)])),
        ])
    }
}

/// Cases whose settings are looked at before the first run.
const MOST_CHECKED: u64 = 1000;

/// What `--vary`, `--sample` and `--list` ask for.
fn plan(arguments: &SweepArguments, info: &SceneInfo) -> Result<Plan, Failure> {
    let mut plan = Plan::new();
    if let Some(file) = &arguments.list {
        let (names, numbers) = list(file)?;
        plan = plan.list(names, numbers);
    }
    if let Some(n) = arguments.samples {
        let samples = Samples::new(arguments.design.0, n, arguments.seed);
        plan = plan.samples(arguments.sample.iter().fold(samples, |all, of| all.over(&of.name, of.low, of.high)));
    }
    for Variation { name, values } in &arguments.vary {
        let number =
            |value: &String| parse_number(value).map_err(|why| Failure::wrong_use(format!("--vary {name}: {why}")));
        plan = match target(name, info)? {
            Target::Setting if ["method", "project", "metric"].contains(&name.as_str()) => {
                plan.words(name, values.iter().map(String::as_str))
            }
            _ => plan.grid(name, values.iter().map(number).collect::<Result<Vec<f64>, _>>()?),
        };
    }
    match plan.n_cases() {
        Ok(_) => Ok(plan),
        Err(_) if plan == Plan::new() => {
            let name = info.parameters.first().map_or("NAME", |parameter| parameter.name);
            Err(Failure::wrong_use(format!(
                "nothing is varied; give --vary {name}=START:END:STEP, --sample {name}=LOW:HIGH --samples N, or --list FILE.csv"
            )))
        }
        Err(why) => Err(Failure::wrong_use(why)),
    }
}

/// Names and numbers of a CSV file; a name may carry its unit, `m0 [N*m]`.
fn list(path: &Path) -> Result<(Vec<String>, Vec<f64>), Failure> {
    let wrong = |what: &dyn std::fmt::Display| Failure::wrong_use(format!("`{}`: {what}", path.display()));
    let file = File::open(path).map_err(|error| wrong(&error))?;
    let mut rows =
        csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(LimitedReader::new(file));
    let name = |heading: &str| heading.rsplit_once(" [").map_or(heading, |(name, _)| name).to_owned();
    let names: Vec<String> = rows.headers().map_err(|error| wrong(&error))?.iter().map(name).collect();
    let mut numbers = Vec::new();
    for (i, row) in rows.records().enumerate() {
        let row = row.map_err(|error| wrong(&error))?;
        for (name, text) in names.iter().zip(&row) {
            let number = parse_number(text);
            numbers.push(number.map_err(|why| wrong(&format!("row {}, column `{name}`: {why}", i + 1)))?);
        }
    }
    if numbers.is_empty() {
        return Err(wrong(&"it has no rows; give it a row of names, and a row of numbers for each case"));
    }
    Ok((names, numbers))
}

/// What `--keep` asks for.
fn kept(arguments: &SweepArguments, info: &SceneInfo) -> Vec<Kept> {
    if !arguments.keep.is_empty() {
        return arguments.keep.clone();
    }
    let positions = info.coordinates.iter().map(|c| c.name.to_string());
    let velocities = info.velocities.iter().map(|c| c.name.to_string());
    let outputs = info.outputs.iter().map(|output| format!("output.{}", output.name));
    let states = info.states.iter().map(|state| format!("state.{}", state.name));
    positions.chain(velocities).chain(states).chain(outputs).map(Kept::End).collect()
}

fn folder(arguments: &SweepArguments, scene: &str) -> Result<PathBuf, Failure> {
    let default = || PathBuf::from(format!("out/sweep-{}", scene.replace('/', "-")));
    let folder = arguments.out.clone().unwrap_or_else(default);
    check_folder_name(&folder)?;
    Ok(folder)
}

fn text_of(written: &Written, folder: &Path) -> String {
    let Written { progress, n_found, first_failure, n_parts: [n_complete, n_parts], alone } = written;
    let mut text = format!("{} cases computed", progress.n_done);
    if *n_found > 0 {
        text += &format!(", {n_found} were there");
    }
    if let Some(RanAlone { n_cases, first, why }) = alone {
        text += &format!("; {n_cases} ran by themselves, the first one is case {first}: {why}");
    }
    if let Some((case, why)) = first_failure {
        text += &format!("; {} failed, the first one is case {case}: {why}", progress.n_failed);
    }
    text + &format!("\n{n_complete} of {n_parts} parts complete\n{}\n", folder.display())
}

fn json_of(written: &Written, folder: &Path) -> serde_json::Value {
    let Written { progress, n_found, first_failure, n_parts: [n_complete, n_parts], alone } = written;
    json!({
        "folder": folder.display().to_string(),
        "computed": progress.n_done,
        "found": n_found,
        "failed": progress.n_failed,
        "first_failure": first_failure.as_ref().map(|(case, why)| json!({ "case": case, "why": why })),
        "alone": alone.map(|RanAlone { n_cases, first, why }| json!({ "cases": n_cases, "first": first, "why": why })),
        "parts_complete": n_complete,
        "parts": n_parts,
    })
}
