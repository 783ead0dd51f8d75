//! Runs the damped pendulum and writes `pendulum.csv`.

use std::error::Error;
use std::fs::File;

use ezy_core::prelude::*;
use my_mechanism::Damped;

fn main() -> Result<(), Box<dyn Error>> {
    // parameters are fields with the declared defaults
    let scene = Damped { k: 0.5, ..Damped::default() };
    let mut file = CsvWriter::new(File::create("pendulum.csv")?);
    let run = Simulation::new(&scene).method(Method::rk4(1e-3)).every(0.01).record_to(&mut file).run()?;
    // a run that had to stop keeps what it computed and says why
    println!("{}: the rod is at {:.4} rad", run.outcome, run.last().get("rod.phi")?);
    Ok(())
}
