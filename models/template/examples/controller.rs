//! Steers back to the line y = 0, and writes `controller.csv`.

use std::error::Error;
use std::fs::File;

use ezy_core::prelude::*;
use my_mechanism::Ridden;

/// Of the fork's angle and rate, N·m/rad and N·m·s/rad.
const STIFFNESS: f64 = 40.0;
const DAMPING: f64 = 2.0;

/// Called before each step; the inputs hold until the next one. All names are those of the model file.
fn steer(now: &Now<Ridden>, set: &mut Inputs<Ridden>) {
    let wanted = (-0.2 * now.frame.y - 0.8 * now.frame.phi).clamp(-0.4, 0.4);
    let angle = now.fork.phi - now.frame.phi;
    let rate = now.fork.omega - now.frame.omega;
    set.steer = STIFFNESS * (wanted - angle) - DAMPING * rate;
}

fn main() -> Result<(), Box<dyn Error>> {
    // parameters are fields with the declared defaults
    let scene = Ridden {
        k: 0.5,
        ..Ridden::default()
    };
    let mut file = CsvWriter::new(File::create("controller.csv")?);
    let run = Simulation::new(&scene)
        .method(Method::rk4(1e-3))
        .every(0.01)
        .outputs()
        .control(steer)
        .record_to(&mut file)
        .run()?;
    // a run that had to stop keeps what it computed and says why
    println!(
        "{}: {:.1e} m beside the line",
        run.outcome,
        run.last().get("frame.y")?
    );
    Ok(())
}
