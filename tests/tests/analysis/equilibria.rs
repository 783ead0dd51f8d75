//! Equilibria of mechanisms, their reactions and small vibrations, against closed forms.

use ezy_core::analysis::{Linearization, Rests, SteadyMotion};
use ezy_core::dynamics::System;
use ezy_core::linalg::Backend;
use ezy_core::model;
use ezy_core::model::SceneInfo;
use ezy_core::prelude::*;
use ezy_tests::tables::{list, number, set_parameters, table};
use nalgebra::Complex;
use serde_json::Value;

/// Of positions and multipliers, as a share of the largest one.
const STEADY: f64 = 1e-11;
/// Of eigenvalues, as a share of the largest one.
const EIGENVALUES: f64 = 1e-10;
/// How far beside an equilibrium the search begins, rad.
const BESIDE: f64 = 0.02;
/// m g l/2 of the sprung pendulum, N m.
pub(crate) const SPRUNG_WEIGHT: f64 = 9.81;
/// Starts of a search for all equilibria.
const N_STARTS: usize = 128;

model! {
    /// Crank, rod and piston, with a spring on the piston and a torque on the crank.
    pub model SliderCrank {
        param g: m/s^2 = 9.81; param m1: kg = 1; param m2: kg = 1.5; param m3: kg = 2; param r: m = 0.3; param l: m = 0.8;
        param x: m = 2; param k: N/m = 400; param s0: m = 1.1; param tau: N*m = 5;
        body crank { mass: m1, inertia: m1*r*r/12 }
        body rod { mass: m2, inertia: m2*l*l/12 }
        body piston { mass: m3, inertia: 0.01 }
        hinge O: ground(0, 0) ~ crank(-r/2, 0);
        hinge A: crank(r/2, 0) ~ rod(-l/2, 0);
        hinge B: rod(l/2, 0) ~ piston(0, 0);
        constraint rail: piston.y = 0;
        constraint level: piston.phi = 0;
        spring ground(x, 0) ~ piston(0, 0): stiffness k, length s0;
        torque crank: tau;
        gravity (0, -g);
        start away { crank angle 0.5; at rest; }
        scene rests { start away; until 1 s; }
    }
}

model! {
    /// A four-bar under its weight.
    pub model FourBar {
        param g: m/s^2 = 9.81; param m1: kg = 1; param m2: kg = 2; param m3: kg = 1.5;
        param l1: m = 0.3; param l2: m = 0.9; param l3: m = 0.7; param x: m = 0.8; param y: m = 0;
        body crank { mass: m1, inertia: m1*l1*l1/12 }
        body coupler { mass: m2, inertia: m2*l2*l2/12 }
        body rocker { mass: m3, inertia: m3*l3*l3/12 }
        hinge O: ground(0, 0) ~ crank(-l1/2, 0);
        hinge A: crank(l1/2, 0) ~ coupler(-l2/2, 0);
        hinge B: coupler(l2/2, 0) ~ rocker(l3/2, 0);
        hinge D: ground(x, y) ~ rocker(-l3/2, 0);
        gravity (0, -g);
        start away { crank angle 0; coupler near angle 0.8; rocker near angle 1.8; at rest; }
        scene rests { start away; until 1 s; }
    }
}

model! {
    /// A rod on a pin, with a torsion spring that holds it up.
    pub model SprungPendulum {
        param g: m/s^2 = 9.81; param m: kg = 2; param l: m = 1; param k: N*m = 6; param e: rad = 0;
        body rod { mass: m, inertia: m*l*l/12 }
        hinge O: ground(0, 0) ~ rod(-l/2, 0);
        torsion ground ~ rod: stiffness k, angle pi/2 + e, damping 0;
        gravity (0, -g);
        start away { rod angle 1; at rest; }
        scene rests { start away; until 1 s; }
    }
}

model! {
    /// Two rods that differ.
    pub model DoublePendulum {
        param g: m/s^2 = 9.81; param m0: kg = 2; param l0: m = 0.6; param m1: kg = 0.7; param l1: m = 1.1;
        body link0 { mass: m0, inertia: m0*l0*l0/12 }
        body link1 { mass: m1, inertia: m1*l1*l1/12 }
        hinge pin0: ground(0, 0) ~ link0(-l0/2, 0);
        hinge pin1: link0(l0/2, 0) ~ link1(-l1/2, 0);
        gravity (0, -g);
        start away { link0 angle -1; link1 angle -1; at rest; }
        scene rests { start away; until 1 s; }
    }
}

model! {
    /// Ten equal rods that hang or stand.
    pub model TenRods {
        param g: m/s^2 = 9.81; param m0: kg = 0.5; param l0: m = 0.3;
        body link[10] { mass: m0, inertia: m0*l0*l0/12 }
        hinge pin0: ground(0, 0) ~ link[0](-l0/2, 0);
        for i in 1..10 { hinge pin[i]: link[i-1](l0/2, 0) ~ link[i](-l0/2, 0); }
        gravity (0, -g);
        start away { for i in 0..10 { link[i] angle -1; } at rest; }
        scene rests { start away; until 1 s; }
    }
}

model! {
    /// Twenty equal rods between two points.
    pub model Chain {
        param g: m/s^2 = 9.81; param m: kg = 0.1; param l: m = 0.1; param x: m = 1.2; param y: m = 0;
        body link[20] { mass: m, inertia: m*l*l/12 }
        hinge pin0: ground(0, 0) ~ link[0](-l/2, 0);
        for i in 1..20 { hinge pin[i]: link[i-1](l/2, 0) ~ link[i](-l/2, 0); }
        hinge pin20: link[19](l/2, 0) ~ ground(x, y);
        gravity (0, -g);
        start away { at rest; }
        scene rests { start away; until 1 s; }
    }
}

/// The scene with the parameters of a set.
fn scene_of<S: Scene + Default>(of: &Value) -> S {
    let mut scene = S::default();
    set_parameters(&mut scene, &[&of["parameters"]]);
    scene
}

/// Names of members as the tables have them: `link3` for `link[3]`.
fn flat(name: &str) -> String {
    name.replace(['[', ']'], "")
}

/// Coordinates of an entry, by the bodies of the scene.
pub(crate) fn positions(info: &SceneInfo, entry: &Value) -> Vec<f64> {
    let bodies = info.bodies.iter().map(|body| &entry["steady"]["bodies"][flat(body)]);
    bodies.flat_map(|values| [0, 1, 2].map(|part| number(&values[part]))).collect()
}

fn assert_close(found: &[f64], expected: &[f64], least: f64, motion: &SteadyMotion) {
    let largest = expected.iter().fold(least, |m: f64, x| m.max(x.abs()));
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= STEADY * largest, "{found} for {expected}: {motion:?}");
    }
}

/// From a start beside it, the equilibrium of an entry is found, with these reactions and eigenvalues.
fn check<S: Scene>(scene: &S, entry: &Value, beside: f64) {
    let mut system = System::new(scene, Backend::Auto).unwrap();
    let info = system.info().clone();
    let expected = positions(&info, entry);
    let mut start = system.scene_start();
    start.q.copy_from_slice(&expected);
    start.q_given.fill(false);
    start.q.iter_mut().skip(2).step_by(3).for_each(|angle| *angle += beside);
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap_or_else(|error| panic!("{error}: {entry}"));
    assert!(motion.free.is_empty(), "{motion:?}");
    check_motion(&mut system, &motion, entry);
}

/// A motion that was found has the coordinates, reactions and eigenvalues of an entry.
fn check_motion<S: Scene>(system: &mut System<&S>, motion: &SteadyMotion, entry: &Value) {
    let info = system.info().clone();
    assert_close(&motion.state.q, &positions(&info, entry), 1.0, motion);
    let multipliers = &entry["steady"]["multipliers"];
    let expected: Vec<f64> = info.rows.iter().map(|row| number(&multipliers[flat(&row.name)])).collect();
    assert_close(&motion.multipliers, &expected, 1.0, motion);

    let spectrum = Linearization::of(system, motion).unwrap().spectrum().unwrap();
    assert_eq!(Some(spectrum.n_zero as u64), entry["zero_eigenvalues"]["count"].as_u64(), "{spectrum:?}");
    let expected = list(&entry["eigenvalues"]).iter().map(|s| Complex::new(number(&s[0]), number(&s[1])));
    let mut expected: Vec<Complex<f64>> = expected.collect();
    assert_eq!(spectrum.eigenvalues.len(), expected.len(), "{spectrum:?}");
    let largest = expected.iter().fold(0.0, |m: f64, s| m.max(s.norm()));
    let n_unstable = expected.iter().filter(|s| s.re > 0.0).count();
    for found in &spectrum.eigenvalues {
        let distance = |i: &usize| (expected[*i] - found).norm();
        let nearest = (0..expected.len()).min_by(|i, j| distance(i).total_cmp(&distance(j)));
        let exact = expected.swap_remove(nearest.expect("one is left"));
        assert!((found - exact).norm() <= EIGENVALUES * largest, "{found} for {exact}");
    }
    assert_eq!(spectrum.n_unstable(), n_unstable, "{spectrum:?}");
    // a set that has only one equilibrium, a stable one, does not say how many modes grow
    if let Some(unstable) = entry["unstable"].as_u64() {
        assert_eq!(n_unstable as u64, unstable, "{spectrum:?}");
    }
}

/// The entries of the sets of a model, as sets with their equilibria.
fn sets_of<'t>(table: &'t Value, model: &'t str) -> impl Iterator<Item = &'t Value> {
    list(&table["sets"]).iter().filter(move |of| of["model"].as_str() == Some(model))
}

/// Every equilibrium of every set of a model is reached from beside it.
fn check_all<S: Scene + Default>(model: &str) -> usize {
    let table = table(include_str!("../../answers/linear/equilibria.json"));
    let mut n = 0;
    for of in sets_of(&table, model) {
        for entry in list(&of["equilibria"]) {
            for beside in [0.0, BESIDE, -BESIDE] {
                check(&scene_of::<S>(of), entry, beside);
            }
            n += 1;
        }
    }
    n
}

#[test]
fn analytic_slider_cranks_rest() {
    assert_eq!(check_all::<slider_crank::Rests>("slider_crank"), 10);
}

#[test]
fn analytic_four_bars_rest() {
    assert_eq!(check_all::<four_bar::Rests>("four_bar"), 8);
}

#[test]
fn analytic_sprung_pendulums_rest() {
    assert_eq!(check_all::<sprung_pendulum::Rests>("sprung_pendulum"), 7);
}

/// Every pendulum of the table whose name begins so is reached from beside its equilibrium; how many there are.
fn pendulums<S: Scene + Default>(name: &str) -> usize {
    let table = table(include_str!("../../answers/linear/pendulums.json"));
    let sets = list(&table["sets"]).iter().filter(|of| of["name"].as_str().is_some_and(|of| of.starts_with(name)));
    let mut n = 0;
    for of in sets {
        for beside in [0.0, BESIDE, -BESIDE] {
            check(&scene_of::<S>(of), of, beside);
        }
        n += 1;
    }
    n
}

#[test]
fn analytic_double_pendulums_hang_and_stand() {
    assert_eq!(pendulums::<double_pendulum::Rests>("double_"), 8);
}

#[test]
fn analytic_ten_rods_hang_and_stand() {
    assert_eq!(pendulums::<ten_rods::Rests>("ten_"), 2);
}

#[test]
fn analytic_chain_hangs_between_two_points() {
    let table = table(include_str!("../../answers/linear/equilibria.json"));
    let of = list(&table["sets"]).iter().find(|of| of["name"] == "chain_20").expect("the chain");
    for beside in [0.0, BESIDE] {
        check(&scene_of::<chain::Rests>(of), of, beside);
    }
}

/// From starts over full turns all equilibria of these entries are found, each with all that its entry says, and no others of which the table
/// tells (`is_told`, by the coordinates).
fn check_rests<S: Scene>(scene: &S, entries: &[&Value], is_told: fn(&[f64]) -> bool) {
    let mut system = System::new(scene, Backend::Auto).unwrap();
    let info = system.info().clone();
    let start = system.scene_start();
    let rests = Rests::of(&mut system, &start, &[], N_STARTS).unwrap();
    let counts: Vec<usize> = rests.found.iter().map(|rest| rest.n_starts).collect();
    println!("{}: {counts:?} and {} lost", info.name, rests.n_lost);
    let told = rests.found.iter().filter(|rest| is_told(&rest.motion.state.q));
    assert_eq!(told.clone().count(), entries.len(), "{rests:?}");
    assert_eq!(counts.iter().sum::<usize>() + rests.n_lost, N_STARTS);
    for entry in entries {
        let expected = positions(&info, entry);
        let turns = |x: f64| x - std::f64::consts::TAU * (x / std::f64::consts::TAU).round();
        let apart = |q: &[f64]| q.iter().zip(&expected).fold(0.0, |m: f64, (x, y)| m.max(turns(x - y).abs()));
        let nearest = told.clone().min_by(|a, b| apart(&a.motion.state.q).total_cmp(&apart(&b.motion.state.q)));
        let mut motion = nearest.expect("one is found").motion.clone();
        // the table has its own turn of each angle
        for (x, y) in motion.state.q.iter_mut().zip(&expected) {
            *x = y + turns(*x - y);
        }
        check_motion(&mut system, &motion, entry);
    }
}

fn check_all_rests<S: Scene + Default>(model: &str, is_told: fn(&[f64]) -> bool) {
    let table = table(include_str!("../../answers/linear/equilibria.json"));
    for of in sets_of(&table, model) {
        check_rests(&scene_of::<S>(of), &list(&of["equilibria"]).iter().collect::<Vec<_>>(), is_told);
    }
}

/// The table has those with the piston on the right; rods that are assembled to the left have theirs, too.
#[test]
fn analytic_all_rests_of_slider_cranks_are_found() {
    check_all_rests::<slider_crank::Rests>("slider_crank", |q| q[6] > 0.0);
}

/// Both ways of assembly.
#[test]
fn analytic_all_rests_of_four_bars_are_found() {
    check_all_rests::<four_bar::Rests>("four_bar", |_| true);
}

#[test]
fn analytic_all_rests_of_sprung_pendulums_are_found() {
    check_all_rests::<sprung_pendulum::Rests>("sprung_pendulum", |_| true);
}

#[test]
fn analytic_double_pendulum_has_four_rests() {
    let table = table(include_str!("../../answers/linear/pendulums.json"));
    for name in ["double_equal", "double_unequal"] {
        let sets = list(&table["sets"]).iter().filter(|of| of["name"].as_str().is_some_and(|of| of.starts_with(name)));
        let sets: Vec<&Value> = sets.collect();
        check_rests(&scene_of::<double_pendulum::Rests>(sets[0]), &sets, |_| true);
    }
}
