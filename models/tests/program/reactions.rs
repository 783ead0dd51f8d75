//! The command `reactions` on scenes of the crate, and the works of every scene.

use std::fs;

use ezy_core::prelude::*;
use ezy_core::report::reactions::{Reactions, WorkBalance};
use ezy_models::registry::MODELS;

use crate::run::{assert_wrong_use, directory};
use crate::{json, output};

/// Tolerance of the runs, relative and absolute.
const RTOL: f64 = 1e-9;
/// Errors of steps add up, each of a tolerance: of so many at least, or of as many as there are steps.
const STEPS: u64 = 100;

#[test]
fn analytic_pin_of_the_pendulum_bears_three_weights() {
    let folder = directory("reactions");
    let out = |name: &str| folder.join(name).display().to_string();
    let path = ["reactions", "pendulum/swing", "--until", "2"];
    let [csv, hinges, power] = ["pin.csv", "pin.svg", "power.svg"].map(out);
    let told = output(&[&path[..], &["--out", &csv, "--plot", &hinges, "--plot-power", &power]].concat());
    for words in
        ["Pendulum/swing: reactions and powers from t = 0 s to 2 s", "29.430000", "90.00", "potential", "difference"]
    {
        assert!(told.contains(words), "no `{words}` in {told}");
    }
    let of = json(&[&path[..], &["--json"]].concat());
    let pin = &of["joints"][0];
    let largest = pin["largest"].as_f64().expect("a number");
    assert!((largest / (3.0 * 9.81) - 1.0).abs() <= STEPS as f64 * RTOL, "{pin}");
    assert_eq!((&pin["name"], &pin["unit"], &of["impacts_left_out"]), (&"pin".into(), &"N".into(), &0.into()));
    let rows = fs::read_to_string(&csv).unwrap();
    assert!(rows.starts_with("t [s],lambda.pin.x [N],lambda.pin.y [N],norm.pin [N],power.potential [W]\n"), "{rows}");
    assert_eq!(rows.lines().count(), 2002);
    assert!(fs::read_to_string(&hinges).unwrap().contains("reaction y [N]"));
    assert!(fs::read_to_string(&power).unwrap().contains("power [W]"));
}

#[test]
fn invariant_impulses_are_left_out_and_said_so() {
    let told = output(&["reactions", "pendulum/knocking", "--until", "2"]);
    assert!(told.contains("on a stop") && told.contains("left out"), "{told}");
}

#[test]
fn invariant_wrong_reactions_say_what_to_do() {
    assert_wrong_use(&["reactions", "pendulum/swing", "--plot", "a.pdf"], "figures are written as .svg, .png or .html");
    assert_wrong_use(&["reactions", "pendulum/swing", "--out", "a.json"], "reactions are written as .csv");
    assert_wrong_use(&["reactions", "pendulum/swing", "--every", "0"], "0 s");
    assert_wrong_use(&["reactions", "knifeedge/cycloid", "--until", "0.1", "--plot", "a.svg"], "such as hinges");
    assert_wrong_use(&["loads", "pendulum/swing"], "use 'ezy reactions MODEL/SCENE'");
}

/// The works of all effects and potentials of every scene are the change of its kinetic energy, to the errors of its steps: one tolerance each, of
/// the energy turned over.
#[test]
fn invariant_works_of_every_scene_add_up_to_its_energy() {
    let mut n = 0;
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        let scene = (entry.new)();
        let until_s = scene.info().until_s.min(1.0);
        let method = Method::dop853(RTOL);
        let run =
            Simulation::new(&*scene).method(method).until(until_s).every(until_s / 50.0).work().power().run().unwrap();
        assert!(run.outcome.reached_end(), "{}/{}: {}", scene.info().model, entry.name, run.outcome);
        let samples: Vec<_> = run.samples().collect();
        let reactions = Reactions::of(&samples);
        let turned_over = samples.iter().map(|sample| {
            let potential = (sample.energy.potential - samples[0].energy.potential).abs();
            sample.energy.kinetic + potential + sample.work.iter().map(|work| work.abs()).sum::<f64>()
        });
        let bound = run.cost.steps.max(STEPS) as f64 * RTOL * turned_over.fold(1.0, f64::max);
        let WorkBalance { work, kinetic } = reactions.balance;
        assert!((work - kinetic).abs() <= bound, "{}/{}: {work} J, {kinetic} J", scene.info().model, entry.name);
        n += 1;
    }
    assert!(n > MODELS.len(), "{n} scenes");
}
