//! The double pendulum against a reference and at its release. Over ten powers of mass: the hard cases `mass_ratio_…`.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::double_pendulum;
use ezy_tests::garage::{at_times, case, load, number, worse};

/// Of the reference, times the amplification of errors that it states.
const ANGLE: f64 = 1e-9;
/// The energy turned over is 20 J.
const ENERGY: f64 = 1e-8;

#[test]
fn reference_double_pendulum_within_its_amplification() {
    let file = load("chain_pendulum");
    let states = case(&file, "double_1m")["states"].as_array().unwrap();
    let scene = double_pendulum::Swing::default();
    let order = || simulation(&scene).work().method(Method::rk4(2e-4));
    at_times(order, 0.5, states.iter().map(|state| number(&state["t"])), |i, s| {
        let state = &states[i];
        let mut error = 0.0;
        for (k, angle) in [2, 5].into_iter().enumerate() {
            error = worse(error, s.coordinates[angle] - number(&state["angles"][k]));
            error = worse(error, s.velocities[angle] - number(&state["rates"][k]));
        }
        let bar = ANGLE * number(&state["error_amplification"]);
        assert!(error <= bar, "{error:.1e} > {bar:.1e} at {} s", s.t);
        assert!(s.energy.balance.abs() <= ENERGY, "{:.1e} J at {} s", s.energy.balance, s.t);
    });
}

#[test]
fn analytic_double_pendulum_at_release() {
    let scene = double_pendulum::Swing::default();
    let run = simulation(&scene).until(0.0).run().unwrap();
    let a = run.first().accelerations;
    // K of two hinges has a condition of 1e2
    for (value, exact) in [(a[2], -9.0 / 7.0 * 9.81), (a[5], 3.0 / 7.0 * 9.81)] {
        assert!((value - exact).abs() <= 1e-13 * exact.abs(), "{value} for {exact}");
    }
}
