//! Inputs and outputs of generated scenes: what they are worth, and where they are not.

use crate::scenes::{assert_checks, distance};
use ezy_core::prelude::*;
use ezy_core_tests::system_of;
use ezy_tests::piloted::piloted;

/// Products of a handful of numbers up to a thousand.
const ROUNDING: f64 = 1e-11;
/// The torque is a factor of the equations in one scene and folded into their constants in the other.
const FOLDED: f64 = 1e-13;

fn ready(scene: &dyn Scene) -> (System<&dyn Scene>, State) {
    let mut system = system_of(scene, Backend::Auto).unwrap();
    let state = system.consistent_start(&system.scene_start()).unwrap();
    (system, state)
}

fn accelerations(system: &mut System<&dyn Scene>, state: &State) -> Vec<f64> {
    let (mut a, mut lambda) = (vec![0.0; 6], vec![0.0; 4]);
    system.accelerations(state.t, &state.q, &state.v, &mut a, &mut lambda).unwrap();
    a
}

#[test]
fn analytic_outputs_are_in_their_units() {
    let scene = piloted::Ridden::default();
    let (system, state) = ready(&scene);
    let mut out = vec![f64::NAN; scene.info().n_outputs()];
    system.outputs(state.t, &state.q, &state.v, &mut out);
    let names: Vec<&str> = system.info().outputs.iter().map(|output| &*output.name).collect();
    assert_eq!(names, ["speed", "wheel.x", "wheel.y", "steering", "turning", "power"]);
    // 1 m/s; A 0.2 m behind the seat; a right angle; the hinge turns with the bar: C must not slip across the bar
    let rate = state.v[5] - state.v[2];
    let expected = [3.6, 0.0, 0.0, 90.0, rate, 0.5 * rate];
    assert!(distance(&out, &expected) <= ROUNDING, "{out:?}");
    assert!(rate.abs() > 1.0, "{rate}");
}

#[test]
fn invariant_inputs_and_outputs_come_with_their_effects() {
    let names = |scene: &dyn Scene| {
        let info = scene.info();
        (info.inputs.iter().map(|input| input.name).collect::<Vec<_>>(), info.n_outputs())
    };
    assert_eq!(names(&piloted::Coast::default()), (vec![], 5));
    assert_eq!(names(&piloted::Ridden::default()), (vec!["torque"], 6));
    assert_eq!(names(&piloted::Pushed::default()), (vec!["torque", "pull"], 6));
}

#[test]
fn cross_input_and_parameter_of_one_value_move_alike() {
    let (ridden, driven) = (piloted::Ridden::default(), piloted::Driven::default());
    let ((mut by_input, state), (mut by_parameter, _)) = (ready(&ridden), ready(&driven));
    let error = distance(&accelerations(&mut by_input, &state), &accelerations(&mut by_parameter, &state));
    assert!(error <= FOLDED, "{error:.1e}");
    by_input.inputs_mut()[0] = -70.0;
    let turned = piloted::Driven { torque: -70.0 };
    let (mut by_parameter, _) = ready(&turned);
    let error = distance(&accelerations(&mut by_input, &state), &accelerations(&mut by_parameter, &state));
    assert!(error <= FOLDED, "{error:.1e}");
}

#[test]
fn cross_input_of_zero_is_the_scene_without_it() {
    let (ridden, coast) = (piloted::Ridden::default(), piloted::Coast::default());
    let ((mut still, state), (mut without, _)) = (ready(&ridden), ready(&coast));
    still.inputs_mut()[0] = 0.0;
    assert_eq!(accelerations(&mut still, &state), accelerations(&mut without, &state));
}

#[test]
fn fd_scenes_with_inputs_pass_their_checks() {
    for entry in piloted::MODEL.scenes {
        assert_checks(&*(entry.new)());
    }
}

model! {
    /// A puck on a belt, whose slip has a name.
    model Belt {
        param v: m/s = 1.5;
        param u: m/s = 0.1;
        body puck { mass: 1, inertia: 1 }
        let slip = (puck.vx - v) / u;
        force at puck(0, 0): (-3 * tanh(slip), 0);
        start s { at rest; }
        scene carried { start s; until 1 s; }
    }
}

#[test]
fn analytic_equations_are_printed_with_the_names_of_values() {
    let info = belt::Carried::default().info();
    assert_eq!(info.force_entries[0].text, "-3*tanh(slip)");
    let definitions: Vec<_> = info.abbreviations.iter().map(|a| (a.symbol.text, a.formula.text)).collect();
    assert_eq!(definitions, [("slip", "-v/u + puck.vx/u")]);
}
