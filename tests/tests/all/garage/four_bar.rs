//! The four-bar against closed forms and references.

use ezy_core::prelude::*;
use ezy_models::four_bar;
use ezy_tests::garage::{Names, at_times, case, from_states, load, rows, start_at, worse};

/// Of the reference; each turn passes two positions in which the rows lose a rank.
const CRANKS_PARALLEL: f64 = 1e-6;
/// Of the reference. RK4 at 1 ms leaves 1e-9 of 65 rad; steps that come near a flat position add to that.
const PIN: f64 = 1e-6;
const RELATIVE_ENERGY: f64 = 1e-8;

#[test]
fn analytic_parallelogram_turns_through_its_flat_positions() {
    let file = load("a02_n_four_bar");
    let table = rows(&file["cases"][0]["rows"]);
    let scene = four_bar::Turning::default();
    let order = || Simulation::new(&scene).work().method(Method::rk4(1e-3));
    at_times(order, 0.1, table.iter().map(|row| row[0]), |i, s| {
        let [t, _, rate, x, y, vx, vy] = table[i][..] else { panic!("seven columns") };
        let (q, v) = (s.coordinates, s.velocities);
        // B is twice as far from A as the crank's centre of mass
        let differences = [2.0 * q[0] - x, 2.0 * q[1] - y, 2.0 * v[0] - vx, 2.0 * v[1] - vy, -v[2] - rate];
        let error = differences.into_iter().fold(0.0, worse);
        assert!(error <= PIN, "{error:.1e} at {t} s");
        assert!((q[8] - q[2]).abs() <= CRANKS_PARALLEL, "{:.1e} rad at {t} s", q[8] - q[2]);
        assert!(s.energy.balance.abs() <= RELATIVE_ENERGY * 19.62, "{:.1e} J at {t} s", s.energy.balance);
    });
}

#[test]
fn analytic_parallelogram_at_steps_that_come_near_its_flat_positions() {
    let file = load("a02_n_four_bar");
    let table = rows(&file["cases"][0]["rows"]);
    let scene = four_bar::Turning::default();
    // the smaller the step, the nearer to flat positions some of them end: 1e-5 rad at 0.2 ms
    for step in [2e-3, 7e-4, 5e-4, 2e-4] {
        let run = Simulation::new(&scene).method(Method::rk4(step)).run().unwrap();
        let (q, end) = (run.last().coordinates, &table[table.len() - 1]);
        let error = crate::scenes::distance(&[2.0 * q[0], 2.0 * q[1]], &end[3..5]);
        assert!(error <= PIN, "{step} s: {error:.1e}");
    }
}

const BARS: Names<'static> = &[("crank", "crank"), ("coupler", "coupler"), ("rocker", "rocker")];

/// RK4 at 0.5 ms over 2 s leaves 1e-11, and 2e-10 in rates; bar of the reference: 1e-9.
const MASSLESS: f64 = 1e-9;

#[test]
fn reference_coupler_without_mass() {
    let file = load("torture");
    let case = case(&file, "massless_coupler");
    let mut scene = four_bar::Turning::default();
    (scene.base, scene.l1, scene.l2, scene.l3) = (2.0, 1.0, 2.0, 1.5);
    (scene.m1, scene.m2, scene.m3) = (1.0, 0.0, 2.0);
    let order = || start_at(Simulation::new(&scene).method(Method::rk4(5e-4)), &case["model"], BARS);
    let worst = from_states(order, 0.25, &case["states"], BARS);
    assert!(worst[0] <= MASSLESS && worst[1] <= MASSLESS, "{worst:?}");
}

/// Positions come from projection alone.
const DRIVEN: f64 = 1e-11;
/// Relative to torques of 1e3 N·m.
const TORQUE: f64 = 1e-9;

#[test]
fn reference_driven_four_bar_with_the_torque_of_its_motor() {
    let file = load("torture");
    let case = case(&file, "driven_four_bar");
    let mut scene = four_bar::Driven::default();
    (scene.base, scene.l1, scene.l2, scene.l3) = (3.0, 1.0, 3.0, 2.5);
    (scene.m1, scene.m2, scene.m3) = (1.0, 2.0, 1.5);
    (scene.angle, scene.omega, scene.swing) = (0.4, 10.0, 0.0);
    let table = rows(&case["rows"]);
    let order = || start_at(Simulation::new(&scene).method(Method::rk4(1e-3)), &case["model"], BARS);
    let worst = from_states(order, 0.1, &case["states"], BARS);
    assert!(worst[0] <= DRIVEN, "{worst:?}");
    at_times(order, 0.1, table.iter().map(|row| row[0]), |i, s| {
        let motor = s.get("lambda.motor").unwrap();
        let error = -motor / table[i][8] - 1.0;
        assert!(error.abs() <= TORQUE, "{error:.1e} at {} s", s.t);
    });
}
