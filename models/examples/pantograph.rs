//! A pantograph: four bars that draw a figure `k` times as large.
//!
//! `cargo run --example pantograph` prints both figures; `cargo run --example pantograph -- list` is its command line.

use ezy_core::prelude::*;
use std::process::ExitCode;

model! {
    /// A parallelogram of four bars: the pen Q is on the line through O and the tracer P, `k` times as far away.
    pub model Pantograph {
        param k = 2;
        /// from O to the tracer's bar, and from there to the tracer
        param a: m = 0.3;
        param c: m = 0.4;
        /// mass of a bar per length
        param rho: kg/m = 1;
        /// size of the figure, and how often it is drawn in a second
        param size: m = 0.08;
        param f: Hz = 0.5;

        body upper { mass: rho*k*a, inertia: rho*(k*a)^3/12 }
        body outer { mass: rho*k*c, inertia: rho*(k*c)^3/12 }
        body inner { mass: rho*c, inertia: rho*c^3/12 }
        body short { mass: rho*(k-1)*a, inertia: rho*((k-1)*a)^3/12 }

        hinge O: ground(0, 0) ~ upper(-k*a/2, 0);
        hinge A: upper(k*a/2, 0) ~ outer(-k*c/2, 0);
        hinge B: upper(a - k*a/2, 0) ~ inner(-c/2, 0);
        hinge C: outer(c - k*c/2, 0) ~ short((k-1)*a/2, 0);
        hinge P: inner(c/2, 0) ~ short(-(k-1)*a/2, 0);
        point Q = outer(k*c/2, 0);
        drive across: P.x = 0.4 m + size*cos(2*pi*f*t);
        drive up: P.y = 0.1 m + size*sin(4*pi*f*t);

        output tracer: m = P.r;
        output pen: m = Q.r;
        start drawn { upper near angle 0.9; short near angle 0.9; inner near angle -0.6; outer near angle -0.6; }
        scene eight { start drawn; until 2 s; }
    }
}

fn main() -> Result<ExitCode, Box<dyn std::error::Error>> {
    if std::env::args().len() > 1 {
        return Ok(ezy_cli::main(&[&pantograph::MODEL]));
    }
    let run = Simulation::new(&pantograph::Eight::default()).outputs().every(0.25).run()?;
    println!("t [s]   tracer P [m]          pen Q [m]");
    for s in run.samples() {
        let [px, py] = ["output.tracer.x", "output.tracer.y"].map(|name| s.get(name).unwrap_or(f64::NAN));
        let [qx, qy] = ["output.pen.x", "output.pen.y"].map(|name| s.get(name).unwrap_or(f64::NAN));
        println!("{:.2}    {px:9.6} {py:9.6}   {qx:9.6} {qy:9.6}", s.t);
    }
    Ok(ExitCode::SUCCESS)
}
