//! The command `sketch`.

use std::path::PathBuf;

use ezy_core::simulate::Simulation;
use ezy_study::report::drawing;

use super::Models;
use super::animate::write;
use super::arguments::SketchArguments;
use super::failure::{Failure, print};
use super::motion::refused;
use super::names::{check_assignments, scene_entry, scene_with};
use super::out_path::check_ending;
use super::selection::typed;

pub(super) fn sketch(models: Models<'_>, arguments: &SketchArguments) -> Result<(), Failure> {
    let (model, entry) = scene_entry(models, &arguments.path)?;
    check_assignments(model, entry, &arguments.start, &[])?;
    let scene = scene_with(model, entry, &arguments.set)?;
    let path = arguments
        .out
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("out/sketch-{}-{}.svg", typed(model.name), entry.name)));
    check_ending(&path, "sketches", &["svg"])?;
    let simulation = Simulation::new(scene.as_ref()).until(arguments.at);
    let given = arguments.start.iter().fold(simulation, |run, start| run.start(&start.name, start.value));
    let run = given.run().map_err(refused)?;
    write(&path, drawing::sketch(scene.as_ref(), &run.last()))?;
    print(&format!("The sketch: {}\n", path.display()))?;
    match run.outcome.reached_end() {
        true => Ok(()),
        false => Err(Failure::stopped(format!("the run {}; the sketch shows the mechanism there", run.outcome))),
    }
}
