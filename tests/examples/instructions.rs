//! Machine instructions of one step of each scene of the EzyRoller, and of the models written for a scene alone.
//!
//! `cargo run --release --example instructions` counts with valgrind, when it is installed, and prints a table; with
//! `-- --write` it goes into `docs/cost.md`. A scene is run for n and for 2n steps, and the difference counts, so that
//! start and end of a program cancel.

use ezy_core::model::Scene;
use ezy_core::simulate::Simulation;
use ezy_models::ezy_roller::{Coast, Drift, Driven, DrivenOnTarmac};
use ezy_tests::page::write_part;
use ezy_tests::plain_rollers::{coasting, drifting, pumped};
use std::error::Error;
use std::process::Command;

/// Long enough that a few instructions more in a start are less than one a step.
const N_STEPS: u64 = 2000;
const STEP_S: f64 = 1e-3;

/// Runs a scene; monomorphised for it, as a program of a user is.
fn run<S: Scene + Default>(n_steps: u64) -> Result<(), Box<dyn Error>> {
    let scene = S::default();
    let method = ezy_core::integrate::Method::rk4(STEP_S);
    Simulation::new(&scene).method(method).until(STEP_S * n_steps as f64).run()?;
    Ok(())
}

type Runner = fn(u64) -> Result<(), Box<dyn Error>>;

const SCENES: [(&str, &str, Runner); 7] = [
    ("coast", "", run::<Coast>),
    ("driven", "", run::<Driven>),
    ("driven_on_tarmac", "", run::<DrivenOnTarmac>),
    ("drift", "", run::<Drift>),
    ("coast", "model without effects", run::<coasting::Coast>),
    ("driven", "model with the torque alone", run::<pumped::Driven>),
    ("drift", "model with a tyre in place of the skate", run::<drifting::Drift>),
];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    if let [scene, n_steps] = &arguments[..] {
        return SCENES[scene.parse::<usize>()?].2(n_steps.parse()?);
    }
    if Command::new("valgrind").arg("--version").output().is_err() {
        println!("valgrind is not installed; instructions are not counted");
        return Ok(());
    }
    let mut table = "| scene | written as | instructions of a step |\n|---|---|---:|\n".to_owned();
    for (i, (scene, alone, _)) in SCENES.iter().enumerate() {
        let [once, twice] = [instructions(i, N_STEPS)?, instructions(i, 2 * N_STEPS)?];
        let written = if alone.is_empty() { "scene of the EzyRoller" } else { alone };
        table += &format!("| `{scene}` | {written} | {} |\n", (twice - once) / N_STEPS);
    }
    print!("{table}");
    if arguments == ["--write"] {
        write_part("cost.md", "instructions", &table)?;
    }
    Ok(())
}

/// Instructions of a run of this program.
fn instructions(scene: usize, n_steps: u64) -> Result<u64, Box<dyn Error>> {
    let program = std::env::current_exe()?;
    let output = Command::new("valgrind")
        .args(["--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null"])
        .arg(program)
        .args([scene.to_string(), n_steps.to_string()])
        .output()?;
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.contains("I refs") || line.contains("I   refs:"));
    let digits = line.and_then(|line| line.rsplit_once(':')).map(|(_, number)| number.replace([',', ' '], ""));
    digits.and_then(|digits| digits.parse().ok()).ok_or_else(|| format!("valgrind answered:\n{text}").into())
}
