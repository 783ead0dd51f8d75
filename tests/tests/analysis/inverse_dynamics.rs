//! Torques of prescribed motions, against two independent routes with 32 digits.

use ezy_core::analysis::{AnalysisError, InverseDynamics};
use ezy_core::dynamics::State;
use ezy_core::prelude::*;
use ezy_tests::tables::{list, number, numbers, set_parameters, table};
use serde_json::Value;

/// Of torques, accelerations and multipliers, as a share of the largest one.
const EXACT: f64 = 1e-11;

model! {
    /// A four-bar whose crank is led, with a damper at the far end of the coupler.
    pub model FourBar {
        param g: m/s^2 = 9.81; param m1: kg = 1; param m2: kg = 2; param m3: kg = 1.5;
        param l1: m = 0.3; param l2: m = 0.9; param l3: m = 0.7; param x: m = 0.8; param y: m = 0; param cb: N*m*s = 0.4;
        param c0: rad = 0.5; param rate: rad/s = 6; param amp: rad = 0; param freq: rad/s = 1;
        input motor: N*m = 0;
        body crank { mass: m1, inertia: m1*l1*l1/12 }
        body coupler { mass: m2, inertia: m2*l2*l2/12 }
        body rocker { mass: m3, inertia: m3*l3*l3/12 }
        hinge O: ground(0, 0) ~ crank(-l1/2, 0);
        hinge A: crank(l1/2, 0) ~ coupler(-l2/2, 0);
        hinge B: coupler(l2/2, 0) ~ rocker(l3/2, 0);
        hinge D: ground(x, y) ~ rocker(-l3/2, 0);
        torsion coupler ~ rocker: stiffness 0, angle 0, damping cb;
        torque crank: motor;
        gravity (0, -g);
        drive lead: crank.phi = c0 + rate*t + amp*sin(freq*t);
        start any { crank angle 0.5; at rest; }
        scene led { start any; until 1 s; }
    }
}

model! {
    /// Two arms that carry a tool along an ellipse, with a motor at each shoulder.
    pub model FiveBar {
        param g: m/s^2 = 9.81; param m1: kg = 0.8; param m2: kg = 0.5; param m3: kg = 0.5; param m4: kg = 0.8; param mp: kg = 1.2;
        param l1: m = 0.5; param l2: m = 0.7; param l3: m = 0.7; param l4: m = 0.5; param x: m = 0.4; param kd: N*s/m = 2;
        param cx: m = 0.2; param cy: m = 0.8; param rx: m = 0.15; param ry: m = 0.1; param w: rad/s = 4;
        input left: N*m = 0; input right: N*m = 0; input nothing: N*m = 0;
        body arm1 { mass: m1, inertia: m1*l1*l1/12 }
        body arm2 { mass: m2, inertia: m2*l2*l2/12 }
        body arm3 { mass: m3, inertia: m3*l3*l3/12 }
        body arm4 { mass: m4, inertia: m4*l4*l4/12 }
        body tool { mass: mp, inertia: 0.01 }
        hinge O: ground(0, 0) ~ arm1(-l1/2, 0);
        hinge A: arm1(l1/2, 0) ~ arm2(-l2/2, 0);
        hinge P: arm2(l2/2, 0) ~ tool(0, 0);
        hinge Q: arm3(l3/2, 0) ~ tool(0, 0);
        hinge B: arm4(l4/2, 0) ~ arm3(-l3/2, 0);
        hinge E: ground(x, 0) ~ arm4(-l4/2, 0);
        constraint level: tool.phi = 0;
        drag at tool(0, 0): linear kd;
        torque arm1: left + 0*nothing;
        torque arm4: right;
        gravity (0, -g);
        drive across: tool.x = cx + rx*cos(w*t);
        drive up: tool.y = cy + ry*sin(w*t);
        start any { tool at (0.35, 0.8); at rest; }
        scene led { start any; until 1 s; }
    }
}

/// The state of a sample, and that its accelerations and reactions are found with its torques.
fn check<S: Scene>(scene: &S, drives: &[&str], inputs: &[&str], sample: &Value, torques: &[f64]) {
    let mut system = System::new(scene, Backend::Auto).unwrap();
    let mut inverse = InverseDynamics::new(&system, drives, inputs).unwrap();
    let [q, v, a] = ["q", "v", "a"].map(|name| numbers(&sample[name]));
    let state = State { t: number(&sample["t"]), q, v, z: Vec::new(), work: Vec::new() };
    let required = inverse.at(&mut system, &state).unwrap();
    let multipliers = sample["multipliers"].as_object().expect("multipliers by name");
    let largest = |x: &mut dyn Iterator<Item = f64>| x.fold(1.0, |m: f64, x| m.max(x.abs()));
    let forces = largest(&mut multipliers.values().map(number).chain(torques.iter().copied()));
    for (found, torque) in required.inputs.iter().zip(torques) {
        assert!((found - torque).abs() <= EXACT * forces, "{found} for {torque} at {}", state.t);
    }
    let accelerations = largest(&mut a.iter().copied());
    for (found, a) in required.accelerations.iter().zip(&a) {
        assert!((found - a).abs() <= EXACT * accelerations, "{found} for {a} at {}", state.t);
    }
    for (row, found) in system.info().rows.iter().zip(&required.multipliers) {
        let lambda = multipliers.get(&*row.name).map_or(0.0, number);
        assert!((found - lambda).abs() <= EXACT * forces, "{}: {found} for {lambda} at {}", row.name, state.t);
    }
}

fn sets() -> Value {
    table(include_str!("../../answers/linear/inverse_dynamics.json"))
}

#[test]
fn analytic_crank_of_a_four_bar_takes_its_torque() {
    let (table, mut n) = (sets(), 0);
    for set in list(&table["sets"]).iter().filter(|set| set["name"] != "five_bar") {
        let mut scene = four_bar::Led::default();
        set_parameters(&mut scene, &[&set["parameters"], &set["motion"]]);
        for sample in list(&set["samples"]) {
            check(&scene, &["lead"], &["motor"], sample, &[number(&sample["torque_on_the_crank"])]);
            n += 1;
        }
    }
    assert_eq!(n, 10);
}

#[test]
fn analytic_shoulders_of_two_arms_take_their_torques() {
    let (table, mut n) = (sets(), 0);
    for set in list(&table["sets"]).iter().filter(|set| set["name"] == "five_bar") {
        let mut scene = five_bar::Led::default();
        set_parameters(&mut scene, &[&set["parameters"], &set["motion"]]);
        for sample in list(&set["samples"]) {
            check(&scene, &["across", "up"], &["left", "right"], sample, &numbers(&sample["motor_torques"]));
            n += 1;
        }
    }
    assert!(n >= 4, "{n}");
}

#[test]
fn analytic_inputs_that_act_alike_are_refused() {
    let scene = five_bar::Led::default();
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let start = system.consistent_start(&system.scene_start()).unwrap();
    let mut inverse = InverseDynamics::new(&system, &["across", "up"], &["left", "nothing"]).unwrap();
    let error = inverse.at(&mut system, &start).unwrap_err();
    assert!(matches!(error, AnalysisError::Alike { t: 0.0, .. }), "{error}");
    let error = InverseDynamics::new(&system, &["across", "up"], &["left"]).err().unwrap();
    assert_eq!(error.to_string(), "1 inputs cannot take the place of 2 rows; name one input for each row");
    let error = InverseDynamics::new(&system, &["acros"], &["left"]).err().unwrap().to_string();
    assert!(error.starts_with("scene `led` has no constraint `acros`; it has O.x, O.y"), "{error}");
    let error = InverseDynamics::new(&system, &["across"], &["lef"]).err().unwrap().to_string();
    assert_eq!(error, "scene `led` has no input `lef`; it has left, right, nothing");
}

model! {
    /// A motor whose torque has a bound, which is less than the weight of its arm.
    pub model Weak {
        input command: N*m = 0;
        body arm { mass: 2, inertia: 0.5 }
        hinge pivot: ground(0, 0) ~ arm(-0.5, 0);
        torque arm: 5 N*m * tanh(command / 5 N*m);
        gravity (0, -9.81 m/s^2);
        drive path: arm.phi = 0;
        start level { arm at (0.5, 0) angle 0; at rest; }
        scene holds { start level; until 1 s; }
    }
}

#[test]
fn analytic_inputs_that_are_not_enough_name_the_drive() {
    let scene = weak::Holds::default();
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let start = system.consistent_start(&system.scene_start()).unwrap();
    let mut inverse = InverseDynamics::new(&system, &["path"], &["command"]).unwrap();
    let error = inverse.at(&mut system, &start).unwrap_err();
    let AnalysisError::Unbalanced { t: 0.0, drive, left, .. } = &error else { panic!("{error}") };
    // its weight at 0.5 m, less what the motor can do
    assert!(drive == "path" && (left - (9.81 - 5.0)).abs() <= 1e-9, "{error}");
}

model! {
    /// A rod that swings as it is told.
    pub model Swung {
        param m: kg = 2; param i: kg*m^2 = 0.7; param l: m = 0.6; param g: m/s^2 = 9.81;
        param amp: rad = 0.9; param w: rad/s = 5;
        input motor: N*m = 0;
        body arm { mass: m, inertia: i }
        hinge pivot: ground(0, 0) ~ arm(-l, 0);
        torque arm: motor;
        gravity (0, -g);
        drive path: arm.phi = amp*sin(w*t);
        start level { arm at (l, 0) angle 0; arm rate amp*w; }
        scene swings { start level; until 2 s; }
    }
}

#[test]
fn analytic_rod_on_a_sine_takes_its_torque() {
    let scene = swung::Swings::default();
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let mut inverse = InverseDynamics::new(&system, &["path"], &["motor"]).unwrap();
    let run = Simulation::new(&scene).every(0.05).run().unwrap();
    for sample in run.samples() {
        let (q, v) = (sample.coordinates.to_vec(), sample.velocities.to_vec());
        let state = State { t: sample.t, q, v, z: Vec::new(), work: Vec::new() };
        let found = inverse.along(&mut system, &state, sample.accelerations).unwrap();
        let phase = 5.0 * sample.t;
        let (angle, alpha) = (0.9 * phase.sin(), -0.9 * 25.0 * phase.sin());
        let torque = (0.7 + 2.0 * 0.6 * 0.6) * alpha + 2.0 * 9.81 * 0.6 * angle.cos();
        // the largest torque is 43 N m
        assert!((found.inputs[0] - torque).abs() <= EXACT * 43.0, "{} for {torque} at {}", found.inputs[0], sample.t);
        // the second route: the multiplier of the drive, of the run itself
        let lambda = sample.get("lambda.path").unwrap();
        assert!((found.inputs[0] + lambda).abs() <= EXACT * 43.0, "{} for {lambda}", found.inputs[0]);
        let left = found.multipliers[system.info().n_rows() - 1];
        assert!(left.abs() <= EXACT * 43.0, "{left}");
    }
}

model! {
    /// A trolley that is led, and a load that swings below it as it likes.
    pub model Crane {
        input push: N = 0; input kick: N*m = 0;
        body trolley { mass: 3, inertia: 1 }
        body load { mass: 2, inertia: 0.1 }
        constraint rail: trolley.y = 0;
        constraint level: trolley.phi = 0;
        hinge pivot: trolley(0, 0) ~ load(0, 0.8);
        force at trolley(0, 0): (push, 0);
        torque load: kick;
        gravity (0, -9.81 m/s^2);
        drive path: trolley.x = 0.2 m * sin(2 rad/s * t);
        start hangs { trolley at (0, 0); load angle 0.3; trolley velocity (0.4, 0); load rate 0; }
        scene led { start hangs; until 2 s; }
    }
}

#[test]
fn analytic_inputs_that_move_what_is_free_are_refused() {
    let scene = crane::Led::default();
    let run = Simulation::new(&scene).every(0.1).run().unwrap();
    let at = |sample: &ezy_core::record::Sample<'_>, input: &str| {
        let mut system = System::new(&scene, Backend::Auto).unwrap();
        let mut inverse = InverseDynamics::new(&system, &["path"], &[input]).unwrap();
        let (q, v) = (sample.coordinates.to_vec(), sample.velocities.to_vec());
        let state = State { t: sample.t, q, v, z: Vec::new(), work: Vec::new() };
        inverse.along(&mut system, &state, sample.accelerations)
    };
    for sample in run.samples() {
        // where the drive acts: the load is left to itself
        let found = at(&sample, "push").unwrap();
        let lambda = sample.get("lambda.path").unwrap();
        assert!((found.inputs[0] + lambda).abs() <= EXACT * (1.0 + lambda.abs()), "{} {lambda}", found.inputs[0]);
    }
    // a torque on the load leads the trolley, too, but the load then moves otherwise
    let error = at(&run.first(), "kick").unwrap_err();
    let AnalysisError::OtherMotion { t: 0.0, name, with_inputs, with_drives, .. } = &error else { panic!("{error}") };
    assert!(name == "load.omega" && (with_inputs - with_drives).abs() > 1.0, "{error}");
}
