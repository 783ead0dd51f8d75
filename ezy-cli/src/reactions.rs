//! The command `reactions`.

use std::path::Path;

use super::Models;
use super::animate::write;
use super::arguments::ReactionsArguments;
use super::drawing;
use super::failure::{Failure, print, print_error};
use super::interruption::Interruption;
use super::json::print_json;
use super::motion::{end, method, refused, simulation};
use super::names::{check_assignments, scene_entry, scene_with};
use super::out_path::check_ending;
use super::progress::Progress;
use super::reactions_text::{Borne, json_of, text_of};
use super::run_end::remarks;
use super::selection::path;
use ezy_core::model::Scene;
use ezy_core::simulate::{Outcome, Run, SetupError};
use ezy_study::report::reactions::{ElementFlows, Reactions};

/// Intervals of a run between its samples, when `--every` is not given.
const N_INTERVALS: f64 = 2000.0;

pub(super) fn reactions(models: Models<'_>, arguments: &ReactionsArguments) -> Result<(), Failure> {
    let (model, entry) = scene_entry(models, &arguments.path)?;
    check_assignments(model, entry, &arguments.motion.start, &arguments.motion.input)?;
    if let Some(every_s) = arguments.every.filter(|every_s| *every_s <= 0.0) {
        return Err(Failure::wrong_use(SetupError::Every { every_s }));
    }
    if let Some(out) = &arguments.out {
        check_ending(out, "reactions", &["csv"])?;
    }
    for plot in [&arguments.plot, &arguments.plot_power].into_iter().flatten() {
        drawing::check()?;
        drawing::check_name(plot)?;
    }
    let scene = scene_with(model, entry, &arguments.motion.set)?;
    let interruption = Interruption::listen();
    let (run, reactions, elements) = simulate(arguments, scene.as_ref(), interruption)?;
    let scene_path = path(model, entry);
    let borne = Borne { path: &scene_path, run: &run, reactions: &reactions, elements: &elements };
    if let Some(out) = &arguments.out {
        write(out, csv(&borne)?)?;
    }
    if let Some(plot) = &arguments.plot {
        draw_joints(&borne, plot)?;
    }
    if let Some(plot) = &arguments.plot_power {
        draw_powers(&borne, plot)?;
    }
    let method = method(&arguments.motion)?;
    let radau_runs = arguments.motion.inputs.is_none() && scene.jacobian_places().is_some();
    let remarks = remarks(&run, method, radau_runs);
    if arguments.json {
        print_json(&json_of(&borne))?;
        print_error(&remarks);
    } else {
        let files = [&arguments.out, &arguments.plot, &arguments.plot_power].into_iter().flatten();
        let files: String = files.map(|file| format!("{}\n", file.display())).collect();
        let files = if files.is_empty() { files } else { format!("\n{files}") };
        print(&format!("{}{}{remarks}{files}", text_of(&borne), run.rank))?;
    }
    match &run.outcome {
        outcome if outcome.reached_end() => Ok(()),
        outcome @ Outcome::Interrupted { .. } => Err(interruption.failure(format!("the run {outcome}"))),
        outcome => Err(Failure::stopped(format!("the run {outcome}"))),
    }
}

/// A run with samples, and its reactions and powers, whose largest values a second run refines.
fn simulate(
    arguments: &ReactionsArguments,
    scene: &dyn Scene,
    interruption: Interruption,
) -> Result<(Run, Reactions, ElementFlows), Failure> {
    let until_s = end(&arguments.motion, &scene.info());
    let method = method(&arguments.motion)?;
    let progress = Progress::new();
    let mut first = simulation(&arguments.motion, scene, method)?
        .work()
        .power()
        .interrupted_by(interruption.flag())
        .on_progress(|fraction| progress.tell(fraction));
    if let Some(every_s) = arguments.every.or((until_s > 0.0).then_some(until_s / N_INTERVALS)) {
        first = first.every(every_s);
    }
    let run = first.run().map_err(refused)?;
    let samples: Vec<_> = run.samples().collect();
    let (mut reactions, mut elements) = (Reactions::of(&samples), ElementFlows::of(scene, &samples));
    if run.outcome.reached_end() {
        let end_s = run.last().t;
        let times = reactions.times_near_largest().iter().chain(elements.times_near_largest());
        let mut times: Vec<f64> = times.copied().filter(|t| *t <= end_s).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let near = simulation(&arguments.motion, scene, method)?.work().power().at(times);
        let near = near.interrupted_by(interruption.flag()).run().map_err(refused)?;
        // of an interrupted one the samples would lack largest values
        if near.outcome.reached_end() {
            let samples: Vec<_> = near.samples().collect();
            reactions.refine(&samples);
            elements.refine(scene, &samples);
        }
    }
    Ok((run, reactions, elements))
}

/// A row for each sample.
fn csv(borne: &Borne<'_>) -> Result<Vec<u8>, Failure> {
    let mut rows = csv::Writer::from_writer(Vec::new());
    let (columns, n_effects) = (borne.reactions.columns(), borne.effects().len());
    let of_elements = borne.elements.columns();
    // effects are the last columns, and their common potential the very last one
    let n = columns.len() - borne.reactions.powers.len() + n_effects;
    let names = columns[..n].iter().chain(&of_elements).map(|column| format!("{} [{}]", column.name, column.unit));
    rows.write_record(names).map_err(Failure::stopped)?;
    for (i, sample) in borne.run.samples().enumerate() {
        let numbers = [&borne.reactions.row(&sample)[..n], borne.elements.powers(i)].concat();
        let numbers = numbers.into_iter().map(|x| format!("{x:?}"));
        rows.write_record(numbers).map_err(Failure::stopped)?;
    }
    rows.into_inner().map_err(Failure::stopped)
}

#[cfg(not(feature = "figures"))]
fn draw_joints(_: &Borne<'_>, _: &Path) -> Result<(), Failure> {
    drawing::check()
}

#[cfg(not(feature = "figures"))]
fn draw_powers(_: &Borne<'_>, _: &Path) -> Result<(), Failure> {
    drawing::check()
}

/// Curves that a figure tells apart; of more, those with the largest values are drawn.
#[cfg(feature = "figures")]
const MOST_CURVES: usize = 8;

/// The reaction of each joint of two rows, one component over the other, with its largest point.
#[cfg(feature = "figures")]
fn draw_joints(borne: &Borne<'_>, path: &Path) -> Result<(), Failure> {
    use super::drawing_of_columns::write;
    use ezy_study::report::figure::Figure;
    use ezy_study::report::reactions::JointReaction;

    let all = borne.reactions.joints.iter().filter(|of| of.direction.is_some());
    let mut joints: Vec<&JointReaction> = all.collect();
    let n = joints.len();
    if n == 0 {
        return Err(Failure::wrong_use(format!(
            "--plot draws joints of two rows, such as hinges, and {} has none; `plot {} 'lambda.*'` draws its multipliers",
            borne.path, borne.path
        )));
    }
    joints.sort_by(|a, b| b.largest.value.total_cmp(&a.largest.value));
    joints.truncate(MOST_CURVES);
    let title = match n {
        ..=MOST_CURVES => format!("{}: reactions", borne.path),
        _ => format!("{}: the {MOST_CURVES} largest of {n} reactions", borne.path),
    };
    let mut figure = Figure::equal(&title, "reaction x [N]", "reaction y [N]");
    for of in &joints {
        let [x, y] = [0, 1].map(|k| {
            let row = of.joint.rows.start + k;
            borne.run.samples().map(|sample| sample.multipliers[row]).collect::<Vec<f64>>()
        });
        figure = figure.line(&of.joint.name, x, y);
    }
    let tip = |of: &&JointReaction| {
        let (sin, cos) = of.direction.unwrap_or_default().sin_cos();
        (of.largest.value * cos, of.largest.value * sin)
    };
    let (x, y) = joints.iter().map(tip).unzip();
    let figure = figure.hinges("largest", x, y).marks("no force", vec![0.0], vec![0.0]);
    write(&figure, &title, "y over x of the reaction of each joint", path)
}

/// The power of each force, of the drives and of the stops over time.
#[cfg(feature = "figures")]
fn draw_powers(borne: &Borne<'_>, path: &Path) -> Result<(), Failure> {
    use super::drawing_of_columns::write;
    use ezy_study::report::figure::Figure;

    let mut curves = borne.power_curves();
    let n = curves.len();
    if n == 0 {
        return Err(Failure::wrong_use(format!(
            "--plot-power: no force does work in {}; leave --plot-power",
            borne.path
        )));
    }
    let largest = |powers: &[f64]| powers.iter().fold(0.0, |most: f64, power| most.max(power.abs()));
    if n > MOST_CURVES {
        curves.sort_by(|a, b| largest(&b.1).total_cmp(&largest(&a.1)));
        curves.truncate(MOST_CURVES);
    }
    let title = match n {
        ..=MOST_CURVES => format!("{}: power", borne.path),
        _ => format!("{}: the {MOST_CURVES} largest of {n} powers", borne.path),
    };
    let times: Vec<f64> = borne.run.samples().map(|sample| sample.t).collect();
    let mut figure = Figure::time_series(&title, "time [s]", "power [W]");
    for (name, power) in curves {
        figure = figure.line(name, times.clone(), power);
    }
    write(&figure, &title, "power of each force over time", path)
}
