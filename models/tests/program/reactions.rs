//! The command `reactions` on scenes of the crate, and the works of every scene.

use std::fs;

use ezy_core::prelude::*;
use ezy_models::registry::MODELS;
use ezy_study::report::reactions::{Reactions, WorkBalance};

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
        ["Pendulum/swing: reactions and powers from t = 0 s to 2 s", "29.430000", "90.00", "gravity", "difference"]
    {
        assert!(told.contains(words), "no `{words}` in {told}");
    }
    let of = json(&[&path[..], &["--json"]].concat());
    let pin = &of["joints"][0];
    let largest = pin["largest"].as_f64().expect("a number");
    assert!((largest / (3.0 * 9.81) - 1.0).abs() <= STEPS as f64 * RTOL, "{pin}");
    assert_eq!((&pin["name"], &pin["unit"], &of["impacts_left_out"]), (&"pin".into(), &"N".into(), &0.into()));
    let rows = fs::read_to_string(&csv).unwrap();
    assert!(rows.starts_with("t [s],lambda.pin.x [N],lambda.pin.y [N],norm.pin [N],power.gravity [W]\n"), "{rows}");
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

/// At two states of every scene, with skates that slide to either side: the powers of all forces add up to F · v, and those of an effect whose forces
/// have no potential to its power where no constraint moves.
#[test]
fn cross_powers_of_forces_add_up_to_those_of_effects() {
    /// Rounding of sums of some hundred terms, relative to their sizes.
    const ROUNDING: f64 = 1e-11;
    let (mut n_scenes, mut n_effects) = (0, 0);
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        let scene = (entry.new)();
        let info = scene.info();
        let elements = scene.force_elements();
        let (n_q, n_v) = (info.n_coordinates(), info.n_velocities());
        // numbers that are special in no way
        let mut numbers = (1..).map(|k| 2.0 * (1.7 * f64::from(k)).sin());
        for side in [1.0, -1.0] {
            let mut parameters: Vec<f64> = (0..info.parameters.len()).map(|i| scene.parameter(i)).collect();
            let holds = |i: usize| i == 0 || info.switches[i - 1].row != info.switches[i].row;
            parameters.extend((0..info.switches.len()).map(|i| if holds(i) { 0.0 } else { side }));
            let mut c = vec![0.0; info.n_fixed()];
            let given = info.n_inputs() + info.n_states();
            c[..given].iter_mut().for_each(|x| *x = 1.0 + 0.2 * numbers.next().unwrap());
            scene.constants(&parameters, &mut c);
            let [q, v] = [n_q, n_v].map(|n| numbers.by_ref().take(n).collect::<Vec<f64>>());
            let t = 0.3;
            let (mut force, mut powers) = (vec![0.0; n_v], vec![f64::NAN; elements.len()]);
            let mut of_effects = vec![0.0; info.n_effects()];
            scene.applied_force(&c, t, &q, &v, &mut force);
            scene.element_powers(&c, t, &q, &v, &mut powers);
            scene.power(&c, t, &q, &v, &vec![0.0; info.n_rows()], &mut of_effects);
            let terms = force.iter().zip(&v).map(|(force, v)| force * v);
            let size = terms.clone().chain(powers.iter().copied()).map(f64::abs).fold(1.0, f64::max) * n_v as f64;
            let difference = powers.iter().sum::<f64>() - terms.sum::<f64>();
            assert!(difference.abs() <= ROUNDING * size, "{}/{}: {difference} of {size} W", info.model, entry.name);
            for (effect, of_effect) in info.effects.iter().zip(&of_effects) {
                let group = Some(effect.name).filter(|name| *name != "model");
                let own: Vec<usize> = (0..elements.len()).filter(|&i| elements[i].effect == group).collect();
                if own.iter().any(|&i| elements[i].has_potential) || ["drives", "stops"].contains(&effect.name) {
                    continue;
                }
                let difference = own.iter().map(|&i| powers[i]).sum::<f64>() - of_effect;
                let of = effect.name;
                assert!(difference.abs() <= ROUNDING * size, "{}/{}, {of}: {difference}", info.model, entry.name);
                n_effects += 1;
            }
        }
        n_scenes += 1;
    }
    assert!(n_scenes > MODELS.len() && n_effects > MODELS.len(), "{n_scenes} {n_effects}");
}
