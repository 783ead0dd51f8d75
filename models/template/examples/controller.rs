//! Steers back to the line y = 0, and writes `controller.csv`.

use std::error::Error;
use std::fs::File;

use ezy_core::prelude::*;
use my_mechanism::Ridden;

/// Of the fork's angle and rate, N·m/rad and N·m·s/rad.
const STIFFNESS: f64 = 40.0;
const DAMPING: f64 = 2.0;

fn main() -> Result<(), Box<dyn Error>> {
    // parameters are fields with the declared defaults
    let scene = Ridden {
        k: 0.5,
        ..Ridden::default()
    };
    let info = scene.info();
    let place = |name: &str| {
        info.coordinates
            .iter()
            .position(|c| c.name == name)
            .ok_or(format!("no `{name}`"))
    };
    let (y, frame, fork) = (place("frame.y")?, place("frame.phi")?, place("fork.phi")?);
    let mut file = CsvWriter::new(File::create("controller.csv")?);
    let run = Simulation::new(&scene)
        .method(Method::rk4(1e-3))
        .every(0.01)
        .outputs()
        // called before each step; the inputs hold until the next one
        .control(|_t, state, inputs| {
            let steering = state.q[fork] - state.q[frame];
            let wanted = (-0.2 * state.q[y] - 0.8 * state.q[frame]).clamp(-0.4, 0.4);
            inputs[0] =
                STIFFNESS * (wanted - steering) - DAMPING * (state.v[fork] - state.v[frame]);
        })
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
