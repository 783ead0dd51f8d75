//! Motions by every method, judged by a reference and by their own amplification: random ones, or all scenes as they are.
//!
//! `cargo run --release -p ezy-tests --example methods -- 1000 --seed 1`
//! `cargo run --release -p ezy-tests --example methods -- --scenes [SCENE] [--write]`: each over its time and three times that, a line for each run, as
//! CSV; writes the figure of `docs/accuracy.md`

use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;

use ezy_core::report::figure::Figure;
use ezy_models::registry::MODELS;
use ezy_tests::fuzz::Scenes;
use ezy_tests::fuzz::methods::{Case, MARGIN, Told};

/// Times of a scene's own.
const TIMES: [f64; 2] = [1.0, 3.0];

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let option = |name: &str, otherwise: u64| match words.iter().position(|word| word == name) {
        Some(i) => words.get(i + 1).and_then(|text| text.parse().ok()),
        None => Some(otherwise),
    };
    if words.first().is_some_and(|word| word == "--scenes") {
        let only = words[1..].iter().find(|word| !word.starts_with("--")).map_or("", |word| word);
        return scenes(only, words.iter().any(|word| word == "--write"));
    }
    let n = words.first().and_then(|text| text.parse::<u64>().ok());
    let (Some(n), Some(seed), Some(first)) = (n, option("--seed", 1), option("--first", 0)) else {
        eprintln!("usage: methods N [--seed S] [--first I], or methods --scenes [SCENE]");
        return ExitCode::from(2);
    };
    let scenes = Scenes::all();
    let (mut verdicts, mut n_faults, mut n_skipped) = (BTreeMap::new(), 0, 0);
    for i in first..first + n {
        let faults = Case::new(&scenes, seed, i).judge(|told| {
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
    println!("{n_skipped:>9} samples within crossings of singular positions, not compared");
    ExitCode::from(u8::from(n_faults > 0))
}

/// Tolerances of runs, and their errors in tolerances times amplification.
type Points = BTreeMap<&'static str, (Vec<f64>, Vec<f64>)>;

/// Smaller errors, in tolerances times amplification, are left out of the figure: motions that every method follows to rounding.
const SMALLEST: f64 = 1e-4;

/// Methods of one tolerance stand beside each other in the figure, by this factor.
const BESIDE: f64 = 1.5;

/// Every scene whose name contains `only`.
fn scenes(only: &str, write: bool) -> ExitCode {
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
    if write && let Err(error) = figure(points).save(Path::new("docs"), "accuracy-tolerances") {
        eprintln!("docs/accuracy-tolerances.svg cannot be written: {error}; run this where the repository is");
        return ExitCode::FAILURE;
    }
    ExitCode::from(u8::from(n_faults > 0))
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
