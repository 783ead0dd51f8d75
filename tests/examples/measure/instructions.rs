//! Machine instructions of scenes: of a right side, of a step of RK4, of steps of Taylor's method and of a part of a motion by collocation; of chains, for each rod.
//!
//! Something is done n times and 2n times, and the difference counts, so that start and end of a program cancel.

use clap::Args;
use ezy_core::model::{ModelInfo, Scene};
use ezy_core_tests::plain_rollers::{coasting, drifting, pumped};
use ezy_core_tests::repeated::{COLUMNS, OF_COUNTS, repeat, repeat_with_counts};
use ezy_models::{chain, double_pendulum, ezy_roller, slider_crank};
use ezy_tests::count_table::{CountTable, instructions, is_installed, surroundings};
use ezy_tests::page::{docs, part, write_part};
use std::error::Error;

use super::Outcome;

/// Long enough that a few instructions more in a start are less than one of what is counted.
const N: u64 = 2000;

/// Model, scene, and what the table calls the model. Scenes are made in the crates of their models, and their kernels compiled there.
const SCENES: [(&ModelInfo, &str, &str); 9] = [
    (&ezy_roller::MODEL, "coast", "EzyRoller"),
    (&ezy_roller::MODEL, "driven", "EzyRoller"),
    (&ezy_roller::MODEL, "driven_on_tarmac", "EzyRoller"),
    (&ezy_roller::MODEL, "drift", "EzyRoller"),
    (&coasting::MODEL, "coast", "without effects"),
    (&pumped::MODEL, "driven", "with the torque alone"),
    (&drifting::MODEL, "drift", "with a tyre in place of the skate"),
    (&double_pendulum::MODEL, "swing", "DoublePendulum"),
    (&slider_crank::MODEL, "pushed", "SliderCrank"),
];

/// Rods of the chains that are counted.
const CHAINS: [usize; 2] = [1_000, 10_000];

/// Rods in all that each is done for.
const RODS: usize = 20_000;

/// Makes the scene.
fn made(model: &ModelInfo, scene: &str) -> Result<Box<dyn Scene>, Box<dyn Error>> {
    let entry = model.scenes.iter().find(|entry| entry.name == scene);
    Ok((entry.ok_or_else(|| format!("{} has no scene {scene}", model.name))?.new)())
}

/// Counts machine instructions of scenes with valgrind, where that is installed
#[derive(Debug, Args)]
pub(crate) struct Asked {
    /// Write the table into docs/cost.md
    #[arg(long)]
    write: bool,
    /// Compare it with the table there, if that was counted with the same compiler, library and processor
    #[arg(long, conflicts_with = "write")]
    check: bool,
}

/// What a program under valgrind repeats.
#[derive(Debug, Args)]
pub(crate) struct Counted {
    /// Its place in the table; of a chain the number of its rods
    scene: usize,
    column: usize,
    n: u64,
}

pub(crate) fn repeat_scene(counted: &Counted) -> Outcome {
    let (model, scene, _) = SCENES.get(counted.scene).ok_or("there is no such scene")?;
    repeat(&*made(model, scene)?, counted.column, counted.n).map(|_| ())
}

pub(crate) fn repeat_chain(counted: &Counted) -> Outcome {
    repeat_with_counts(&*chain_of(counted.scene)?, counted.column, counted.n)
}

/// A chain of 1 m and 1 kg.
fn chain_of(n: usize) -> Result<Box<dyn Scene>, Box<dyn Error>> {
    let mut scene = made(&chain::MODEL, "swing")?;
    scene.set_count(0, n);
    for (i, parameter) in scene.info().parameters.iter().enumerate() {
        if ["l", "m"].contains(&parameter.name) {
            scene.set_parameter(i, 1.0 / n as f64);
        }
    }
    Ok(scene)
}

pub(crate) fn run(asked: &Asked) -> Outcome {
    if !is_installed() {
        println!("valgrind is not installed; instructions are not counted");
        return Ok(());
    }
    let mut table = CountTable::new(surroundings(), &COLUMNS);
    for (i, (model, scene, called)) in SCENES.iter().enumerate() {
        let made = made(model, scene)?;
        let mut counts = Vec::new();
        for column in 0..COLUMNS.len() {
            counts.push(if repeat(&*made, column, 1)? { Some(count("count-scene", i, column, N)? / N) } else { None });
        }
        table.push(&format!("`{scene}`, {called}"), counts);
    }
    settle(asked, "instructions", &table)?;
    let mut chains = CountTable::new(surroundings(), &OF_COUNTS);
    for n in CHAINS {
        let times = (RODS / n) as u64;
        let of = |column| Ok(Some(count("count-chain", n, column, times)? / RODS as u64));
        let counts: Result<_, Box<dyn Error>> = (0..OF_COUNTS.len()).map(of).collect();
        chains.push(&format!("`chain/swing`, {n} rods"), counts?);
    }
    settle(asked, "chains", &chains)
}

/// Writes a table into the page, or compares it with the one there, as asked.
fn settle(asked: &Asked, name: &str, table: &CountTable) -> Outcome {
    print!("{table}");
    if asked.write {
        write_part("cost.md", name, &table.to_string())?;
    }
    if asked.check {
        let page = std::fs::read_to_string(docs("cost.md"))?;
        let recorded = part(&page, name).and_then(CountTable::read);
        println!("{}", table.compare(&recorded.ok_or_else(|| format!("docs/cost.md has no table of {name}"))?)?);
    }
    Ok(())
}

/// Instructions of doing what a column counts `times` times.
fn count(command: &str, scene: usize, column: usize, times: u64) -> Result<u64, Box<dyn Error>> {
    let of = |n: u64| instructions(&[command.to_owned(), scene.to_string(), column.to_string(), n.to_string()]);
    Ok(of(2 * times)?.saturating_sub(of(times)?))
}
