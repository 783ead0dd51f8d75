//! A belt of 2h links: a closed loop that hangs from a peg, or turns freely.
//!
//! `cargo run --example belt` lets a belt of 3 m fall; `cargo run --example belt -- list` is its command line.

use ezy_core::prelude::*;
use std::process::ExitCode;

model! {
    /// A closed loop of 2h links that begins as a regular polygon.
    pub model Belt {
        count h = 6;
        /// length and mass of a link
        param l: m = 0.5;
        param m: kg = 0.2;
        param w: rad/s = 5;

        body link[2*h] { mass: m, inertia: m*l^2/12 }
        for i in 1..2*h { hinge pin[i]: link[i-1](l/2, 0) ~ link[i](-l/2, 0); }
        hinge closing: link[2*h-1](l/2, 0) ~ link[0](-l/2, 0);

        effect peg {
            hinge hung: ground(0, 0) ~ link[h](-l/2, 0);
            gravity (0, -9.81);
        }

        start round { for i in 0..2*h { link[i] angle pi/(2*h)*(2*i + 1); } at rest; }
        start turning { for i in 0..2*h { link[i] angle pi/(2*h)*(2*i + 1) rate w; } }
        scene fall { start round; until 1 s; with peg; }
        scene spin { start turning; until 1 s; }
    }
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    if std::env::args().len() > 1 {
        return Ok(ezy_cli::main(&[&belt::MODEL]));
    }
    for h in [3, 6, 12] {
        // 3 m and 1.2 kg of belt
        let scene = belt::Fall { h, l: 1.5 / h as f64, m: 0.6 / h as f64, ..Default::default() };
        let run = Simulation::new(&scene).method(Method::dop853(1e-9)).work().run()?;
        let lowest = (0..2 * h).filter_map(|i| run.last().get(&format!("link[{i}].y")).ok()).fold(0.0, f64::min);
        println!("{} links: after 1 s the middle of the lowest link is at y = {lowest:.6} m", 2 * h);
    }
    Ok(ExitCode::SUCCESS)
}
