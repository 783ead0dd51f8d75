//! Andrews' squeezing mechanism against its reference.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::andrews;
use ezy_tests::garage::{at_times, load, number, rows, worse};

/// Seventeen digits are printed; K has a condition of 1e6.
const DIGITS: f64 = 1e-10;

/// β, Θ, γ, Φ, δ, Ω, ε of the literature, from the angles of K1 … K7 or their rates.
fn angles(of: &[f64]) -> [f64; 7] {
    let [k1, k2, k3, k4, k5, k6, k7] = std::array::from_fn(|i| of[3 * i + 2]);
    [k1, k2 - k1, k3, k4 - k5, k5, k6 - k7, k7]
}

/// Multipliers of E3, E4, E6: the forces of K2 on K3, K4, K6.
fn forces(s: Sample<'_>) -> [f64; 6] {
    std::array::from_fn(|i| s.multipliers[4 + i])
}

#[test]
fn reference_andrews_accelerations_and_multipliers_at_the_start() {
    let file = load("a03_andrews");
    let scene = andrews::Squeeze::default();
    let run = simulation(&scene).until(0.0).run().unwrap();
    let a = angles(run.first().accelerations);
    for (k, name) in ["beta", "Theta", "gamma", "Phi", "delta", "Omega", "epsilon"].into_iter().enumerate() {
        let error = (a[k] - number(&file["initial_accelerations"][name])) / 14222.0;
        assert!(error.abs() <= DIGITS, "{name}: {error:.1e}");
    }
    for (k, force) in forces(run.first()).into_iter().enumerate() {
        let error = (force - number(&file["initial_multipliers"][k])) / 98.6;
        assert!(error.abs() <= DIGITS, "multiplier {k}: {error:.1e}");
    }
}

/// Of the reference, for angles; RK4 at 5 µs is ωh = 8e-3 and leaves 1e-11.
const ANGLE: f64 = 1e-9;
/// Of the reference, 1e-7 of 1000 rad/s.
const RATE: f64 = 1e-4;
/// Of the reference.
const ENERGY: f64 = 1e-9;
/// Of the reference.
const GAP: f64 = 1e-12;
/// Accelerations of 6e5 rad/s² and forces of 200 N follow rates and angles.
const MOTION: f64 = 1e-7;

#[test]
fn reference_andrews_squeezes_for_fifty_milliseconds() {
    let file = load("a03_andrews");
    let table = rows(&file["trajectory"]["rows"]);
    let scene = andrews::Squeeze::default();
    let order = || simulation(&scene).method(Method::rk4(5e-6)).work();
    at_times(order, 0.0025, table.iter().map(|row| row[0]), |i, s| {
        let (q, v) = (angles(s.coordinates), angles(s.velocities));
        let difference = |x: &[f64; 7], from: usize| (0..7).map(|k| x[k] - table[i][from + k]).fold(0.0, worse);
        let (angle, rate) = (difference(&q, 1), difference(&v, 8));
        assert!(angle <= ANGLE, "{angle:.1e} rad at {} s", s.t);
        assert!(rate <= RATE, "{rate:.1e} rad/s at {} s", s.t);
        assert!(s.energy.balance.abs() <= ENERGY, "{:.1e} J at {} s", s.energy.balance, s.t);
        assert!(s.position_residual <= GAP, "{:.1e} m at {} s", s.position_residual, s.t);
        if (s.t - 0.03).abs() < 1e-9 {
            let end = |i: usize| number(&file["end_values_t003"][i]["ours"]);
            let a = angles(s.accelerations);
            let error = (0..7).map(|k| (a[k] - end(14 + k)) / 566749.0).fold(0.0, worse);
            let force = (0..6).map(|k| (forces(s)[k] - end(21 + k)) / 199.0).fold(0.0, worse);
            assert!(error <= MOTION && force <= MOTION, "accelerations {error:.1e}, forces {force:.1e}");
        }
    });
}
