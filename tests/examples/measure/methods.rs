//! Motions by every method, judged by a reference and by their own amplification: random ones, or all scenes as they are.

use std::collections::BTreeMap;

use clap::Args;
use ezy_models::registry::MODELS;
use ezy_study::report::figure::Figure;
use ezy_tests::fuzz::Scenes;
use ezy_tests::fuzz::methods::{Case, MARGIN, Told};
use ezy_tests::page::docs;

use super::{Outcome, Random, outcome};

/// Times of a scene's own.
const TIMES: [f64; 2] = [1.0, 3.0];

/// Runs every scene by every method over its time and three times that, judged by a reference and by its own amplification
///
/// Prints a line for each run, as CSV.
#[derive(Debug, Args)]
pub(crate) struct Asked {
    /// Only scenes whose name holds this
    #[arg(value_name = "MODEL/SCENE", default_value = "", hide_default_value = true)]
    only: String,
    /// Write the figure of docs/accuracy.md
    #[arg(long)]
    write: bool,
}

/// Random motions.
pub(crate) fn random(random: &Random) -> Outcome {
    let scenes = Scenes::all();
    let (mut verdicts, mut n_faults, mut n_skipped) = (BTreeMap::new(), 0, 0);
    for i in random.cases() {
        let faults = Case::new(&scenes, random.seed, i).judge(|told| {
            *verdicts.entry((told.judgement, told.method.name())).or_insert(0_u64) += 1;
            n_skipped += told.n_skipped;
        });
        for fault in faults {
            println!("case {i}: {}\n", fault.shrunk());
            n_faults += 1;
        }
    }
    for ((verdict, method), n) in verdicts {
        println!("{n:>9} {method} {verdict:?}");
    }
    println!(
        "{n_skipped:>9} samples in crossings of singular positions, or between an event of one run and of another, not compared"
    );
    outcome(n_faults)
}

/// Tolerances of runs, and their errors in tolerances times amplification.
type Points = BTreeMap<&'static str, (Vec<f64>, Vec<f64>)>;

/// Smaller errors, in tolerances times amplification, are left out of the figure: motions that every method follows to rounding.
const SMALLEST: f64 = 1e-4;

/// Methods of one tolerance stand beside each other in the figure, by this factor.
const BESIDE: f64 = 1.5;

pub(crate) fn run(Asked { only, write }: &Asked) -> Outcome {
    let (mut n_faults, mut points) = (0, Points::new());
    println!("scene,times,method,setting,judgement,excess,amplification,steps,skipped");
    for model in MODELS {
        for entry in model.scenes {
            let name = format!("{}/{}", model.name, entry.name);
            for times in TIMES.into_iter().filter(|_| name.contains(only)) {
                let tell = |told: Told| {
                    let Told { method, judgement, excess, amplification, n_steps, n_skipped } = told;
                    let setting = method.tolerance().map_or(0.0, |tolerance| tolerance.relative);
                    let method = method.name();
                    if setting > 0.0 && excess >= SMALLEST {
                        let (tolerances, errors) = points.entry(method).or_default();
                        tolerances.push(setting);
                        errors.push(excess);
                    }
                    println!(
                        "{name},{times},{method},{setting:e},{judgement:?},{excess:.2e},{amplification:.2e},{n_steps},{n_skipped}"
                    );
                };
                n_faults += Case::shipped(model, entry, times).judge(tell).len();
            }
        }
    }
    if *write {
        figure(points).save(&docs(""), "accuracy-tolerances")?;
    }
    outcome(n_faults)
}

/// Errors over tolerances, with the bound.
fn figure(points: Points) -> Figure {
    let title = "Error over tolerance and amplification";
    let mut figure = Figure::log_log(title, "tolerance", "largest error over tolerance × amplification");
    for (i, (name, (tolerances, errors))) in points.into_iter().enumerate() {
        let tolerances = tolerances.into_iter().map(|tolerance| tolerance * BESIDE.powi(i as i32)).collect();
        figure = figure.cloud(name, tolerances, errors);
    }
    // room above the bound: of a single point nothing is seen
    figure.guide("bound", vec![1e-13, 1e-3], vec![MARGIN; 2]).guide("", vec![1e-13], vec![10.0 * MARGIN])
}
