//! Estimates of the error of runs beside their true errors: every scene by every method.

use std::collections::BTreeMap;

use clap::Args;
use ezy_core::prelude::*;
use ezy_study::report::figure::Figure;
use ezy_tests::estimates::{Judged, Question, Reference};
use ezy_tests::fuzz::Scenes;
use ezy_tests::fuzz::estimates::{Estimated, LARGEST, SMALLEST, estimated};
use ezy_tests::page::docs;

use super::{Outcome, Random};

/// Tolerances of the methods that have one.
const TOLERANCES: [f64; 6] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];

/// Steps of RK4 over a run.
const STEPS: [f64; 3] = [1e3, 1e4, 1e5];

/// An estimate is to be within this factor of the error.
const FACTOR: f64 = 5.0;

/// Errors of positions over whole runs, and the estimates over them.
type Points = BTreeMap<&'static str, (Vec<f64>, Vec<f64>)>;

/// Compares the estimates of the errors of every scene by every method with the true errors
///
/// Prints those that are off by more than a factor of five.
#[derive(Debug, Args)]
pub(crate) struct Asked {
    /// Only scenes whose name holds this
    #[arg(value_name = "MODEL/SCENE", default_value = "", hide_default_value = true)]
    only: String,
    /// Write the figure of docs/accuracy.md, where the repository is
    #[arg(long)]
    write: bool,
}

pub(crate) fn run(Asked { only, write }: &Asked) -> Outcome {
    let (mut points, mut n, mut low, mut high) = (Points::new(), 0, 0, 0);
    for model in ezy_models::registry::MODELS {
        for entry in model.scenes {
            let name = format!("{}/{}", model.name, entry.name);
            if !name.contains(only) {
                continue;
            }
            let scene = (entry.new)();
            let question = Question::of(&*scene);
            let Some(reference) = Reference::of(&question) else {
                println!("{name}: no reference");
                continue;
            };
            for method in methods(scene.info().until_s) {
                let judged = match reference.judge(&question, method) {
                    Ok((judged, _)) => judged,
                    Err(why) => {
                        println!("{name}, {}: {why}", setting(method));
                        continue;
                    }
                };
                for Judged { quantity, unit, is_at_end, estimate, error } in judged {
                    n += 1;
                    let ratio = estimate / error;
                    if !(1.0 / FACTOR..=FACTOR).contains(&ratio) {
                        if ratio < 1.0 {
                            low += 1
                        } else {
                            high += 1
                        }
                        let when = if is_at_end { "at the end" } else { "largest" };
                        println!(
                            "{name}, {}: {quantity} [{unit}], {when}: {estimate:.1e} for {error:.1e}",
                            setting(method)
                        );
                    }
                    if quantity == "positions" && !is_at_end {
                        let (errors, ratios) = points.entry(method.name()).or_default();
                        errors.push(error);
                        ratios.push(ratio);
                    }
                }
            }
        }
    }
    println!("{n} compared; beyond a factor of {FACTOR}: {low} too low, {high} too high");
    if *write {
        figure(points).save(&docs(""), "accuracy-estimates")?;
    }
    if low == 0 { Ok(()) } else { Err(format!("{low} estimates are too low").into()) }
}

/// Random runs.
pub(crate) fn random(random: &Random) -> Outcome {
    let scenes = Scenes::all();
    let [mut n_judged, mut n_values, mut n_low, mut n_high, mut no_reference, mut no_estimate] = [0_u64; 6];
    for i in random.cases() {
        match estimated(&scenes, random.seed, i) {
            Estimated::NoReference => no_reference += 1,
            Estimated::NoEstimate => no_estimate += 1,
            Estimated::Judged { command, judged } => {
                n_judged += 1;
                n_values += judged.len() as u64;
                for value in judged {
                    let Judged { quantity, unit, is_at_end, estimate, error } = &value;
                    let (is_low, is_high) = (value.ratio() < SMALLEST, value.ratio() > LARGEST);
                    n_low += u64::from(is_low);
                    n_high += u64::from(is_high);
                    if is_low || is_high {
                        let when = if *is_at_end { "at the end" } else { "largest" };
                        println!("{i}: {quantity} [{unit}], {when}: {estimate:.1e} for {error:.1e}: {command}");
                    }
                }
            }
        }
    }
    let Random { n, seed, .. } = random;
    println!(
        "{n} random runs, seed {seed}: {n_judged} judged, {no_reference} without a reference, {no_estimate} without an estimate; \
         {n_values} errors above rounding, {n_low} estimates below a fifth, {n_high} above a hundred times"
    );
    if n_low > 0 || n_high * 100 > n_values {
        return Err("estimates are too low, or too many too high".into());
    }
    Ok(())
}

fn methods(until_s: f64) -> impl Iterator<Item = Method> {
    let with_tolerance = TOLERANCES.iter().flat_map(|&r| [Method::dop853(r), Method::taylor(r), Method::radau(r)]);
    with_tolerance.chain(STEPS.map(|n| Method::rk4(until_s / n)))
}

fn setting(method: Method) -> String {
    match method.step_s() {
        Some(step_s) => format!("{} with steps of {step_s} s", method.name()),
        None => format!("{} at {:e}", method.name(), method.setting()),
    }
}

/// Estimate over error, with the lines of equality and of the factor.
fn figure(points: Points) -> Figure {
    let title = "Estimated over true error";
    let mut figure = Figure::log_log(title, "largest true error of positions [m, rad]", "estimated over true error");
    for (name, (errors, ratios)) in points {
        figure = figure.cloud(name, errors, ratios);
    }
    for (name, ratio) in [("equal", 1.0), ("a factor of five", FACTOR), ("", 1.0 / FACTOR)] {
        figure = figure.guide(name, vec![1e-13, 1e2], vec![ratio; 2]);
    }
    // room above and below: of a single point nothing is seen
    [0.1, 10.0].into_iter().fold(figure, |figure, ratio| figure.guide("", vec![1e-13], vec![ratio]))
}
