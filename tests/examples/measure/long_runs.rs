//! What monitors cost, and what compensated sums are worth in a long run.
//!
//! Instructions are counted as the difference of two runs.

use clap::Args;
use ezy_core::prelude::*;
use ezy_core::testing::{GivenSteps, StepsBy};
use ezy_core_tests::{simulation, system_of};
use ezy_models::{ezy_roller, knife_edge, pendulum, roller_racer};
use ezy_tests::count_table::{instructions, is_installed};
use ezy_tests::page::write_part;
use std::error::Error;

use super::Outcome;

/// Steps that are counted.
const N: u64 = 2000;
/// Step of what is counted, s.
const STEP_S: f64 = 1e-3;

/// What is counted: unwatched by a stepper, watched in a run; both with works.
const COUNTED: [&str; 4] = ["stepper", "run", "stepper with works", "run with works"];

/// Measures what monitors cost and what compensated sums are worth in a long run
///
/// Instructions are counted with valgrind, where that is installed.
#[derive(Debug, Args)]
pub(crate) struct Asked {
    /// Write the tables into docs/cost.md
    #[arg(long)]
    write: bool,
}

/// What a program under valgrind does.
#[derive(Debug, Args)]
pub(crate) struct Counted {
    which: usize,
    n: u64,
}

/// Does `COUNTED[which]` for `n` steps of the driven EzyRoller.
pub(crate) fn repeat(&Counted { which, n }: &Counted) -> Outcome {
    let scene = ezy_roller::Driven::default();
    let order = simulation(&scene).method(Method::rk4(STEP_S)).until(n as f64 * STEP_S);
    let order = if which < 2 { order } else { order.work() };
    if which.is_multiple_of(2) {
        order.stepper()?.step(n)?;
    } else {
        order.run()?;
    }
    Ok(())
}

fn monitors_table() -> Result<String, Box<dyn Error>> {
    let mut counts = [0; COUNTED.len()];
    for (which, count) in counts.iter_mut().enumerate() {
        let of = |n: u64| instructions(&["count-run".to_owned(), which.to_string(), n.to_string()]);
        *count = (of(2 * N)?.saturating_sub(of(N)?)) / N;
    }
    let [stepper, run, stepper_with_works, run_with_works] = counts;
    let ratio = |run: u64, stepper: u64| run as f64 / stepper as f64;
    Ok(format!(
        "| a step of RK4, `driven` | unwatched | watched | ratio |\n|---|---:|---:|---:|\n\
         | motion | {stepper} | {run} | {:.3} |\n\
         | with works and energy balance | {stepper_with_works} | {run_with_works} | {:.3} |\n",
        ratio(run, stepper),
        ratio(run_with_works, stepper_with_works),
    ))
}

/// Steps of a long run.
const LONG: u64 = 1_000_000;
/// Their length, s: the error of the method is far below rounding then.
const SHORT_S: f64 = 1e-4;

/// Largest error of the coordinates after a long run with both projections, against Taylor's method at 1e-15.
fn error<S: Scene + Default>(compensated: bool) -> Result<f64, Box<dyn Error>> {
    let scene = S::default();
    let run = |method| simulation(&scene).method(method).until(LONG as f64 * SHORT_S).run();
    let end = if compensated {
        run(Method::rk4(SHORT_S))?.last().coordinates.to_vec()
    } else {
        let mut system = system_of(&scene, Backend::Auto)?;
        let mut now = system.consistent_start(&system.scene_start())?;
        now.work.clear();
        let mut steps =
            GivenSteps::new(system_of(&scene, Backend::Auto)?, now.clone(), StepsBy::Method(MethodKind::Rk4))
                .ok_or("no steps")?;
        for n in 1..=LONG {
            now.clone_from(steps.attempt(SHORT_S)?.ok_or("no step")?);
            let State { t, q, v, .. } = &mut now;
            *t = n as f64 * SHORT_S;
            system.project(*t, q, v, Projection::Both, Metric::Mass)?;
            // each step is the first one
            steps.place(&now);
        }
        now.q
    };
    let reference = run(Method::taylor(1e-15))?;
    let differences = end.iter().zip(reference.last().coordinates).map(|(q, exact)| (q - exact).abs());
    Ok(differences.fold(0.0, f64::max))
}

fn compensation_table() -> Result<String, Box<dyn Error>> {
    let mut table = "| a million steps of 0.1 ms | with | without |\n|---|---:|---:|\n".to_owned();
    let mut push = |scene: &str, error: fn(bool) -> Result<f64, Box<dyn Error>>| -> Outcome {
        table += &format!("| {scene} | {:.0e} | {:.0e} |\n", error(true)?, error(false)?);
        Ok(())
    };
    push("`ezyroller/coast`", error::<ezy_roller::Coast>)?;
    push("`rollerracer/coast`", error::<roller_racer::Coast>)?;
    push("`knifeedge/cycloid`", error::<knife_edge::Cycloid>)?;
    push("`pendulum/swing`", error::<pendulum::Swing>)?;
    Ok(table)
}

pub(crate) fn run(asked: &Asked) -> Outcome {
    let mut tables = vec![("compensation", compensation_table()?)];
    if is_installed() {
        tables.push(("monitors", monitors_table()?));
    }
    for (part, table) in tables {
        println!("{table}");
        if asked.write {
            write_part("cost.md", part, &table)?;
        }
    }
    Ok(())
}
