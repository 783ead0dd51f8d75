//! Derivatives of motions by start values and parameters.

use ezy_core::model::Start;
use ezy_core::prelude::*;
use ezy_core::simulate::{SetupError, Tangent};
use ezy_core_tests::{simulation, system_of};
use ezy_models::ezy_roller::Driven;

const METHOD: Method = Method::dop853(1e-12);

/// Of the differences, relative to what is changed: their error is its square times third derivatives of some 1e2, and the
/// error of the runs, 1e-11, over it.
const STEP: f64 = 1e-4;
const DIFFERENCES: f64 = 2e-5;

/// The reference states the norm with two digits.
const NORM: f64 = 2.2e3;
const NORM_DIGITS: f64 = 0.05;

/// Rows along a tangent, of derivatives of size 1e2.
const ROWS: f64 = 1e-10;

/// The reduced state of the driven roller: every freedom that it has.
const REDUCED: [&str; 6] = ["seat.x", "seat.y", "seat.phi", "bar.phi", "seat.vx", "seat.omega"];

/// The folded start of the scene, with the velocities given that the rows leave free.
fn start(scene: &Driven) -> Start {
    let mut start = system_of(scene, Backend::Auto).unwrap().scene_start();
    start.give_velocity(0, 0.0);
    start.give_velocity(2, 0.0);
    start
}

fn tangents<const N: usize>(by: [&str; N], until_s: f64) -> [Tangent; N] {
    let scene = Driven::default();
    let mut run = Sensitivities::new(&scene, &start(&scene), by, METHOD).unwrap();
    run.advance(until_s).unwrap();
    run.tangents()
}

/// Positions and velocities after `until_s` with a change of one quantity.
fn changed(name: &str, change: f64, until_s: f64) -> Vec<f64> {
    let mut scene = Driven::default();
    let mut given: Vec<(&str, f64)> = REDUCED.iter().map(|name| (*name, 0.0)).collect();
    given[3].1 = start(&scene).q[5];
    match given.iter_mut().find(|(other, _)| *other == name) {
        Some((_, value)) => *value += change,
        None => {
            let i = scene.info().parameters.iter().position(|parameter| parameter.name == name).unwrap();
            scene.set_parameter(i, scene.parameter(i) + change);
        }
    }
    let order = simulation(&scene).method(METHOD).until(until_s);
    let run = given.into_iter().fold(order, |order, (name, value)| order.start(name, value)).run().unwrap();
    let last = run.last();
    [last.coordinates, last.velocities].concat()
}

#[test]
fn fd_sensitivities_by_start_values_and_parameters() {
    const BY: [&str; 8] = ["seat.x", "seat.phi", "bar.phi", "seat.vx", "seat.omega", "m0", "b", "i2"];
    let until_s = 3.0;
    for (name, tangent) in BY.into_iter().zip(tangents(BY, until_s)) {
        let step = if name == "i2" { 1e-2 * STEP } else { STEP };
        let (up, down) = (changed(name, step, until_s), changed(name, -step, until_s));
        let found = [tangent.q, tangent.v].concat();
        let size = found.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
        let differences = up.iter().zip(&down).map(|(up, down)| (up - down) / (2.0 * step));
        let error = differences.zip(&found).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs())) / size;
        assert!(error <= DIFFERENCES, "{name}: {error:.1e}");
    }
}

#[test]
fn invariant_tangents_keep_to_the_rows() {
    let scene = Driven::default();
    let mut run = Sensitivities::new(&scene, &start(&scene), REDUCED, METHOD).unwrap();
    run.advance(10.0).unwrap();
    let (system, state) = (system_of(&scene, Backend::Auto).unwrap(), run.state());
    // position constraints do not move with time, so that C_q δq is what they say of δq as a velocity
    for tangent in run.tangents() {
        let mut rows = [0.0; 4];
        scene.velocity_constraint(system.fixed(), state.t, &state.q, &tangent.q, &mut rows);
        assert!(rows[..2].iter().all(|row| row.abs() <= ROWS), "{rows:?}");
    }
}

#[test]
fn reference_norm_of_the_sensitivities_of_the_driven_roller() {
    let tangents = tangents(REDUCED, 60.0);
    let squares = tangents.iter().flat_map(|tangent| tangent.q.iter().chain(&tangent.v)).map(|x| x * x);
    let norm = squares.sum::<f64>().sqrt();
    assert!((norm / NORM - 1.0).abs() <= NORM_DIGITS, "{norm}");
}

#[test]
fn analytic_what_has_no_derivative_is_told() {
    let scene = Driven::default();
    let start = start(&scene);
    let refused = Sensitivities::new(&scene, &start, ["bar.x"], METHOD).err();
    assert!(matches!(refused, Some(SetupError::NotGiven { name }) if name == "bar.x"));
    let refused = Sensitivities::new(&scene, &start, ["m3"], METHOD).err();
    assert!(matches!(refused, Some(SetupError::UnknownName(_))));
}
