//! The four-bar against closed forms. Driven, and with a coupler without mass: the hard cases `driven_four_bar` and
//! `massless_coupler`.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::four_bar;
use ezy_tests::garage::{at_times, load, rows, worse};

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
    let order = || simulation(&scene).work().method(Method::rk4(1e-3));
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
        let run = simulation(&scene).method(Method::rk4(step)).run().unwrap();
        let (q, end) = (run.last().coordinates, &table[table.len() - 1]);
        let error = crate::scenes::distance(&[2.0 * q[0], 2.0 * q[1]], &end[3..5]);
        assert!(error <= PIN, "{step} s: {error:.1e}");
    }
}
