//! The tractor with two trailers against references, the road train against concentric circles. Under a torque: the hard case
//! `car_trailers, driven_slalom`.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::{road_train, tractor_trailers};
use ezy_tests::garage::{Names, case, from_states, load, number, start_at};

/// Of the reference, for all states.
const STATE: f64 = 1e-8;

const TRAIN: Names<'static> = &[("front", "steer"), ("car", "tractor"), ("trailer1", "first"), ("trailer2", "second")];

#[test]
fn reference_train_with_locked_steering() {
    let file = load("car_trailers");
    let case = case(&file, "locked_circle");
    let scene = tractor_trailers::Locked::default();
    let order = || start_at(simulation(&scene).method(Method::rk4(2e-3)), &case["model"], TRAIN);
    let worst = from_states(order, 0.5, &case["states"], TRAIN);
    assert!(worst[0] <= STATE && worst[1] <= STATE, "{worst:?}");
}

/// Of the reference, after 100 s.
const RADIUS: f64 = 1e-9;

#[test]
fn analytic_train_settles_on_concentric_circles() {
    let file = load("car_trailers");
    let radii = &case(&file, "locked_circle")["steady_radii"];
    let scene = tractor_trailers::Locked::default();
    let run = simulation(&scene).method(Method::rk4(1e-2)).until(100.0).run().unwrap();
    let (end, v) = (run.last(), run.last().velocities);
    assert!(run.outcome.reached_end());
    for (k, point) in ["A", "B", "C"].into_iter().enumerate() {
        // every axle rolls about one centre with the tractor's rate
        let body = 3 * (k + 1);
        let lever = [scene.rear, scene.axle1, scene.axle2][k];
        let (sin, cos) = end.coordinates[body + 2].sin_cos();
        let rate = v[body + 2];
        let speed = [v[body] + lever * sin * rate, v[body + 1] - lever * cos * rate];
        let error = speed[0].hypot(speed[1]) / v[5] - number(&radii[k]);
        assert!(error.abs() <= RADIUS, "{point}: {error:.1e} m");
    }
}

/// After 40 s at 2 m/s the last trailer has settled to rounding, and the rows hold the circles at any step.
const SETTLED: f64 = 1e-9;

#[test]
fn analytic_road_train_of_any_length_settles_on_concentric_circles() {
    let mut scene = road_train::Circling::default();
    for n in [1, 6] {
        scene.n = n;
        let run = simulation(&scene).method(Method::rk4(4e-2)).until(40.0).run().unwrap();
        assert!(run.outcome.reached_end(), "{n}: {}", run.outcome);
        let end = run.last();
        let rate = end.velocities[5];
        let mut square = (scene.wheelbase / scene.delta.tan()).powi(2);
        for k in 0..n {
            square += scene.c * scene.c - scene.l * scene.l;
            let v = &end.velocities[3 * (k + 2)..];
            let error = v[0].hypot(v[1]) / rate - square.sqrt();
            assert!(error.abs() <= SETTLED, "trailer {k} of {n}: {error:.1e} m");
        }
    }
}
