//! How fast the EzyRoller is after a minute, over the amplitude and the frequency of the rider's torque: a map.
//!
//! `cargo run --release --example speed_map -- N DIR`: N × N runs (100 × 100 without), files and map in DIR (`out/speed-map`). A second
//! call goes on where the first one was killed.

use std::f64::consts::TAU;
use std::path::PathBuf;

use ezy_cli::Progress;
use ezy_core::prelude::*;
use ezy_models::vehicles::ezy_roller::ezy_roller::Driven;
use ezy_study::report::figure::Figure;
use ezy_study::sweep::{Cell, Plan, Results, Sweep};

/// From `low` to `high`, both included.
fn evenly(n: usize, low: f64, high: f64) -> Vec<f64> {
    (0..n).map(|i| low + (high - low) * i as f64 / (n - 1).max(1) as f64).collect()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut words = std::env::args().skip(1);
    let n = words.next().map_or(Ok(100), |n| n.parse())?;
    let folder = PathBuf::from(words.next().unwrap_or_else(|| "out/speed-map".to_owned()));
    let (torques, swings) = (evenly(n, 0.5, 5.0), evenly(n, 0.15, 1.0));
    let plan = Plan::new().grid("m0", torques.iter().copied()).grid("swings", swings.iter().copied());
    let progress = Progress::new();
    let of_names = Driven::default();
    let sweep = Sweep::new(&of_names, plan, |case| {
        let scene = Driven { m0: case.get("m0")?, omega: TAU * case.get("swings")?, ..Driven::default() };
        Ok(case.run(Simulation::new(&scene).method(Method::dop853(1e-6)))?)
    });
    let sweep = sweep.keep(["seat.vx", "seat.vy"]).in_lanes(&of_names).resume().on_progress(|of| {
        progress.tell(of.n_done as f64 / of.n_cases as f64);
    });
    let written = sweep.write(&folder)?;
    drop(progress);
    println!("{} runs, {} failed, {} were there", written.progress.n_done, written.progress.n_failed, written.n_found);

    let results = Results::open(&[&folder])?;
    results.check_complete()?;
    let mut speeds = Vec::new();
    for part in results.parts() {
        // behind both varied values
        speeds.extend(part?.iter().map(|row| match row.cells[2..4] {
            [Cell::Number(vx), Cell::Number(vy)] => vx.hypot(vy),
            _ => f64::NAN,
        }));
    }
    let fastest = speeds.iter().copied().fold(0.0, f64::max);
    let i = speeds.iter().position(|speed| *speed == fastest).unwrap_or(0);
    println!("fastest: {fastest:.3} m/s with {:.3} N m and {:.3} swings a second", torques[i / n], swings[i % n]);
    let title = "Speed of the EzyRoller after a minute";
    let map = Figure::map(title, "swings a second [1/s]", "torque [N·m]", "speed [m/s]", swings, torques, speeds);
    map.save(&folder, "speed")?;
    println!("{}", folder.join("speed.svg").display());
    Ok(())
}
