//! A run from Rust: a changed parameter, a tolerance, a column, the last state.
//!
//! `cargo run --example run`

use ezy_core::prelude::*;
use ezy_models::mechanisms::double_pendulum::double_pendulum::Swing;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = Swing::default();
    let run = Simulation::new(&scene).until(2.0).method(Method::dop853(1e-10)).every(0.5).work().run()?;
    println!("{}", run.outcome);
    for (t, angle) in run.column("t")?.iter().zip(run.column("lower.phi")?) {
        println!("{t:.1} s: {angle:.6} rad");
    }
    println!("the energy is off by {:.0e} J", run.last().get("balance")?.abs());
    Ok(())
}
