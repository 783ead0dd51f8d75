//! Length and damping of a pendulum from its angle over time: from a CSV file, or from angles with errors of a degree that are made up.
//!
//! `cargo run --release --features optimise --example fit_pendulum -- FILE`

use ezy_core::optimise::{Fit, Free, Measured, sensitivities_at};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use std::fmt::Write;

model! {
    pub model Pendulum {
        param l: m = 0.8;
        param c: N*m*s = 0.05;
        param mass: kg = 1;
        body bob { mass: mass, inertia: 0 }
        hinge pin: ground(0, 0) ~ bob(0, l);
        gravity (0, -9.81);
        torque bob: -c*bob.omega;
        start aside { bob angle 0.5; at rest; }
        scene swing { start aside; until 10 s; }
    }
}

fn swing(l: f64, c: f64, mass: f64, times: &[f64]) -> Result<Run, SetupError> {
    let scene = pendulum::Swing { l, c, mass };
    Simulation::new(&scene).max_steps(10_000).at(times.to_vec()).run()
}

const ERROR_RAD: f64 = 0.017;

/// Twelve numbers between 0 and 1 have the variance 1 in sum: nearly normal. The generator is that of Park and Miller.
fn normal(seed: &mut u64) -> f64 {
    let mut uniform = || {
        *seed = *seed * 48_271 % 2_147_483_647;
        *seed as f64 / 2_147_483_647.0
    };
    (0..12).map(|_| uniform()).sum::<f64>() - 6.0
}

/// A measurement of 10 s: l = 0.8 m, c = 0.05 N m s, mass = 1 kg.
fn made_up() -> Result<String, Box<dyn std::error::Error>> {
    let mut seed = 1;
    let times: Vec<f64> = (1..=200).map(|i| 0.05 * f64::from(i)).collect();
    let exact = swing(0.8, 0.05, 1.0, &times)?.column("bob.phi")?;
    let mut csv = "t [s],bob.phi [rad]\n".to_owned();
    for (t, phi) in times.iter().zip(&exact[1..]) {
        writeln!(csv, "{t:.2},{:.4}", phi + ERROR_RAD * normal(&mut seed))?;
    }
    Ok(csv)
}

/// A positive quantity.
fn positive(name: &str, start: f64) -> Free {
    Free::new(name, start).within(0.0, f64::INFINITY)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let csv = match std::env::args().nth(1) {
        Some(path) => std::fs::read_to_string(path)?,
        None => made_up()?,
    };
    let data = Measured::read(csv.as_bytes())?;

    println!("length and damping, from three times their values:");
    let free = [positive("l", 2.4), positive("c", 0.15)];
    let fitted = Fit::new(free, &data, |x| swing(x[0], x[1], 1.0, data.times())).solve()?;
    print!("{fitted}");

    println!("the mass as well:");
    let free = [positive("l", 2.4), positive("c", 0.15), positive("mass", 3.0)];
    let with_mass = Fit::new(free, &data, |x| swing(x[0], x[1], x[2], data.times())).solve()?;
    print!("{with_mass}");

    println!("damping alone, by sensitivities:");
    let l = fitted.estimates[0].value;
    let alone = Fit::new([positive("c", 0.15)], &data, |x| swing(l, x[0], 1.0, data.times()))
        .derivatives(|x| {
            let scene = pendulum::Swing { l, c: x[0], ..Default::default() };
            let start = System::new(&scene, Backend::Auto).ok()?.scene_start();
            sensitivities_at(&scene, &start, ["c"], Method::dop853(1e-9), &data).ok()
        })
        .solve()?;
    print!("{alone}");
    Ok(())
}
