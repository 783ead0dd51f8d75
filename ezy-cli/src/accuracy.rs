//! The command `accuracy`.

use std::path::PathBuf;

use serde_json::{Value, json};

use ezy_core::scalar::legible_time;
use ezy_core::simulate::SetupError;
use ezy_study::accuracy::{
    Accuracy, AccuracyError, Advice, Candidate, Comparison, Errors, IS_UNOPTIMISED, Point, Size, WorkPrecision,
};
use ezy_study::output::OutputFolder;

use super::Models;
use super::arguments::AccuracyArguments;
use super::failure::{Failure, print};
use super::interruption::Interruption;
use super::json::print_json;
use super::names::{check_assignments, scene_entry, scene_with};
use super::out_path::check_folder_name;
use super::progress::Progress;
use super::selection::typed;

/// What is named when it is written.
const WRITTEN: &str = if cfg!(feature = "figures") { "page" } else { "numbers" };

pub(super) fn accuracy(models: Models<'_>, arguments: &AccuracyArguments) -> Result<(), Failure> {
    let (model, entry) = scene_entry(models, &arguments.path)?;
    if IS_UNOPTIMISED {
        return Err(Failure::wrong_use(
            "ezy-core was built without optimisation, and times of such a program mean nothing; build with --release, or write into \
             Cargo.toml: [profile.dev.package.ezy-core] opt-level = 3",
        ));
    }
    check_assignments(model, entry, &arguments.start, &arguments.input)?;
    let scene = scene_with(model, entry, &arguments.set)?;
    let mut order = Accuracy::new(scene.as_ref()).budget(arguments.budget);
    if let Some(until_s) = arguments.until {
        order = order.until(until_s);
    }
    order = arguments.start.iter().fold(order, |order, start| order.start(&start.name, start.value));
    order = arguments.input.iter().fold(order, |order, input| order.input(&input.name, input.value));
    let directory = arguments
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("out/accuracy-{}-{}", typed(model.name), entry.name)));
    check_folder_name(&directory)?;
    let interruption = Interruption::listen();
    // a directory that cannot be written is found before the work, not after it
    let written = OutputFolder::create(&directory);
    let folder = written.map_err(|cause| AccuracyError::Write { path: directory.clone(), cause })?;
    let progress = Progress::new();
    let measured = order.interrupted_by(interruption.flag()).measure(|fraction, part| {
        progress.tell(fraction);
        progress.tell_part(part);
    });
    drop(progress);
    let measured = match measured {
        Err(error @ AccuracyError::Interrupted) => return Err(interruption.failure(error)),
        measured => measured?,
    };
    let written = measured.save(folder.path())?;
    match arguments.json {
        true => print_json(&json(&measured))?,
        false => print(&format!("{}\nThe {WRITTEN}: {}\n", text(&measured), written.display()))?,
    }
    if measured.interrupted {
        return Err(interruption
            .failure(format!("the measurement was interrupted; what it had is in {}", folder.path().display())));
    }
    if measured.is_empty() {
        let budget_s = measured.budget_s;
        return Err(Failure::stopped(format!("nothing was measured within {budget_s} s; give more with --budget")));
    }
    Ok(())
}

impl From<AccuracyError> for Failure {
    fn from(error: AccuracyError) -> Self {
        match error {
            AccuracyError::Setup(SetupError::Motion(_) | SetupError::Record(_))
            | AccuracyError::NoReference { .. }
            | AccuracyError::Interrupted
            | AccuracyError::NothingKnown { .. } => Self::stopped(error),
            #[cfg(feature = "figures")]
            AccuracyError::Figure(_) => Self::stopped(error),
            AccuracyError::Write { .. } => Self::wrong_use(format!("{error} with --out")),
            AccuracyError::Budget { .. } => Self::wrong_use(format!("{error} with --budget")),
            AccuracyError::Setup(_) | AccuracyError::NoTime { .. } => Self::wrong_use(error),
            _ => Self::stopped(error),
        }
    }
}

fn text(measured: &WorkPrecision) -> String {
    let mut text =
        format!("{}/{} to t = {} s\n\n", measured.info.model, measured.info.name, legible_time(measured.until_s));
    measured.reservations().iter().for_each(|line| text += &format!("{line}\n\n"));
    measured.advice().iter().for_each(|advice| text += &format!("{advice}\n"));
    text += &format!("\n{}\n", measured.table());
    measured.reference_text().iter().for_each(|line| text += &format!("{line}\n"));
    let missing = measured.missing_text();
    if !missing.is_empty() {
        text += "\nNot measured:\n";
        missing.iter().for_each(|line| text += &format!("  {line}\n"));
    }
    text + &format!("\n{}.\n", measured.machine)
}

/// The measurement as one object.
fn json(measured: &WorkPrecision) -> Value {
    let reference = &measured.reference;
    json!({
        "model": measured.info.model,
        "scene": measured.info.name,
        "until": measured.until_s,
        "until_asked": measured.asked_until_s,
        "machine": measured.machine,
        "processor_share": measured.processor_share,
        "busy": measured.was_busy(),
        "interrupted": measured.interrupted,
        "reference": {
            "by": reference.by,
            "uncertainty": comparison(&reference.uncertainty),
            "second": match &reference.second {
                Ok(second) => json!({
                    "by": second.by,
                    "difference": comparison(&second.difference),
                    "own_difference": comparison(&second.own),
                }),
                Err(why) => json!({ "missing": why }),
            },
        },
        "advice": measured.advice().iter().map(advice).collect::<Value>(),
        "points": measured.points.iter().map(point).collect::<Value>(),
    })
}

fn advice(advice: &Advice) -> Value {
    json!({
        "target": advice.target,
        "use": advice.best.as_ref().map(candidate),
        "others": advice.others.iter().map(candidate).collect::<Value>(),
        "unfinished": advice.unfinished,
        "sentence": advice.to_string(),
    })
}

fn candidate(Candidate { method, error, seconds }: &Candidate) -> Value {
    json!({ "method": method.name(), "setting": method.setting(), "error": error, "seconds": seconds })
}

fn point(point: &Point) -> Value {
    let mut all = json!({
        "method": point.method.name(),
        "setting": point.method.setting(),
        "projection": point.variant.name(),
        "outcome": point.outcome(),
    });
    if let Some(m) = point.measured() {
        all["error"] = comparison(&m.error);
        all["residual"] = json!({ "position": m.position_residual, "velocity": m.velocity_residual });
        all["energy_balance"] = json!(m.energy_balance);
        all["cost"] = json!({
            "steps": m.cost.steps,
            "rejected": m.cost.rejected,
            "evaluations": m.cost.evaluations,
            "factorizations": m.cost.factorizations,
            "seconds_min": m.seconds_min,
            "seconds_median": m.seconds_median,
            "runs": m.n_timed,
            "seconds_on_grid": m.seconds_on_grid,
        });
    }
    all
}

fn comparison(comparison: &Comparison) -> Value {
    let size = |size: &Size| json!({ "absolute": size.absolute, "scaled": size.scaled });
    let errors = |Errors { position, velocity, reaction }: &Errors| json!({ "position": size(position), "velocity": size(velocity), "reaction": size(reaction) });
    json!({ "end": errors(&comparison.end), "largest": errors(&comparison.grid) })
}
