//! Length and damping of a pendulum, identified from angles that were measured with errors of a degree.
//!
//! `cargo run --example fit_pendulum --features optimise`

use ezy_core::optimise::{Fit, Free, Measured};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;

model! {
    pub model Pendulum {
        param l: m = 0.8;
        param c: N*m*s = 0.05;
        body bob { mass: 1, inertia: 0 }
        hinge pin: ground(0, 0) ~ bob(0, l);
        gravity (0, -9.81);
        torque ground ~ bob: -c*bob.omega;
        start aside { bob angle 0.5; at rest; }
        scene swing { start aside; until 10 s; }
    }
}

const TRUE_VALUES: [f64; 2] = [0.8, 0.05];
const ERROR_RAD: f64 = 0.017;

fn run(values: &[f64], times: &[f64]) -> Result<Run, SetupError> {
    let scene = pendulum::Swing { l: values[0], c: values[1] };
    Simulation::new(&scene).max_steps(10_000).at(times.to_vec()).run()
}

/// Twelve numbers between 0 and 1 have the variance 1 in sum: nearly normal. The generator is that of Park and Miller.
fn normal(seed: &mut u64) -> f64 {
    let mut uniform = || {
        *seed = *seed * 48_271 % 2_147_483_647;
        *seed as f64 / 2_147_483_647.0
    };
    (0..12).map(|_| uniform()).sum::<f64>() - 6.0
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut seed = 1;
    let times: Vec<f64> = (1..=200).map(|i| 0.05 * f64::from(i)).collect();
    let exact = run(&TRUE_VALUES, &times)?.column("bob.phi")?;
    let angles: Vec<f64> = exact[1..].iter().map(|phi| phi + ERROR_RAD * normal(&mut seed)).collect();
    let data = Measured::new(times).column("bob.phi", angles);

    let free = [Free::between("l", 0.7, 0.94), Free::between("c", 0.0, 0.4)];
    let fitted = Fit::new(free, &data, |values| run(values, data.times())).solve()?;
    for (estimate, truth) in fitted.estimates.iter().zip(TRUE_VALUES) {
        let (lower, upper) = estimate.interval;
        println!("{}: true {truth}, found {:.5}, with 95 % in {lower:.5} to {upper:.5}", estimate.name, estimate.value);
    }
    println!("errors of {:.4} rad", fitted.residual_deviation);
    Ok(())
}
