//! The gait that drives the EzyRoller farthest from its start in 60 s, with a torque of 1 to 3 N m and 0.2 to 1 swings a second.
//!
//! `cargo run --release --example farthest_gait --features optimise`

use ezy_core::optimise::{Free, Search};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_models::vehicles::ezy_roller::ezy_roller::Driven;
use std::f64::consts::TAU;

fn ride(values: &[f64]) -> Result<Run, SetupError> {
    let scene = Driven { m0: values[0], omega: TAU * values[1], ..Driven::default() };
    Simulation::new(&scene).method(Method::dop853(1e-8)).run()
}

/// Of the seat, from where it started, m.
fn distance(run: &Run) -> f64 {
    let [x, y, ..] = run.last().coordinates else { return f64::NAN };
    x.hypot(*y)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let free = [Free::between("torque", 1.0, 3.0), Free::between("swings", 0.2, 1.0)];
    let best = Search::new(free, ride).seed(1).maximise(distance)?;
    let Driven { m0, omega, .. } = Driven::default();
    let declared = distance(&ride(&[m0, omega / TAU])?);
    println!("declared: {m0:.3} N m, {:.4} swings a second: {declared:.2} m", omega / TAU);
    println!("best:     {:.3} N m, {:.4} swings a second: {:.2} m", best.values[0], best.values[1], best.number);
    println!("{:.2} times as far; {} runs, at a bound: {:?}", best.number / declared, best.n_runs, best.at_bounds);
    Ok(())
}
