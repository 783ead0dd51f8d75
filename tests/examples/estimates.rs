//! Estimates of the error of runs beside their true errors: every scene by every method.
//!
//! `cargo run --release -p ezy-tests --example estimates -- [SCENE] [--write]`: prints those that are off by more than a factor of five, and
//! writes the figure of `docs/accuracy.md`.
//! `cargo run --release -p ezy-tests --example estimates -- --random N [--seed S] [--first I]`: random runs, many of one to three steps; prints those
//! whose estimate is below a fifth of the error, or above a hundred times it.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;

use ezy_core::prelude::*;
use ezy_core::report::figure::Figure;
use ezy_tests::estimates::{Judged, Question, Reference};
use ezy_tests::fuzz::Scenes;
use ezy_tests::fuzz::estimates::{Estimated, LARGEST, SMALLEST, estimated};

/// Tolerances of the methods that have one.
const TOLERANCES: [f64; 6] = [1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14];

/// Steps of RK4 over a run.
const STEPS: [f64; 3] = [1e3, 1e4, 1e5];

/// An estimate is to be within this factor of the error.
const FACTOR: f64 = 5.0;

/// Errors of positions over whole runs, and the estimates over them.
type Points = BTreeMap<&'static str, (Vec<f64>, Vec<f64>)>;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    if let Some(at) = words.iter().position(|word| word == "--random") {
        let number = |at: Option<usize>| at.and_then(|at| words.get(at + 1)).and_then(|word| word.parse::<u64>().ok());
        let option = |name: &str| number(words.iter().position(|word| word == name));
        let Some(n) = number(Some(at)) else {
            eprintln!("usage: estimates --random N [--seed S] [--first I]");
            return ExitCode::from(2);
        };
        return random(n, option("--seed").unwrap_or(1), option("--first").unwrap_or(0));
    }
    let only = words.iter().find(|word| !word.starts_with("--")).map_or("", |word| word);
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
    if words.iter().any(|word| word == "--write")
        && let Err(error) = figure(points).save(Path::new("docs"), "accuracy-estimates")
    {
        eprintln!("docs/accuracy-estimates.svg cannot be written: {error}; run this where the repository is");
        return ExitCode::FAILURE;
    }
    ExitCode::from(u8::from(low > 0))
}

/// Random runs.
fn random(n: u64, seed: u64, first: u64) -> ExitCode {
    let scenes = Scenes::all();
    let [mut n_judged, mut n_values, mut n_low, mut n_high, mut no_reference, mut no_estimate] = [0_u64; 6];
    for i in first..first + n {
        match estimated(&scenes, seed, i) {
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
    println!(
        "{n} random runs, seed {seed}: {n_judged} judged, {no_reference} without a reference, {no_estimate} without an estimate; \
         {n_values} errors above rounding, {n_low} estimates below a fifth, {n_high} above a hundred times"
    );
    ExitCode::from(u8::from(n_low > 0 || n_high * 100 > n_values))
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
