//! A bar without mass and inertia: M is singular, K is not.

use crate::scenes::{Case, coast, distance, driven, rk4, set};
use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_core_tests::simulation;
use std::f64::consts::PI;

const HORIZON: f64 = 5.0;
const STEP: f64 = 1e-3;
/// Both integrations have order four, with different constants; 1e-11 each at this step.
const TWO_ROUTES: f64 = 1e-10;
/// A bar of 1e-6 of its mass changes the motion by about as much.
const LIGHT: f64 = 1e-6;
const LIGHT_CHANGES: f64 = 1e-5;

const MASSLESS: [(&str, f64); 2] = [("m2", 0.0), ("i2", 0.0)];

/// The roller without bar masses in its own two speeds, u of wheel A and w of the seat, by Kane's equations:
/// m1 u' = m1 a w² − τ sin ψ / l, (I1 + m1 a²) w' = −m1 a u w + τ (1 + L cos ψ / l), L = a + b, l = c + d.
/// State: x_A, y_A, φ1, φ2, u, w.
fn reduced(t: f64, y: &[f64; 6]) -> [f64; 6] {
    let (a, long, short, m1, i1) = (0.2, 0.8, 0.2, 46.0, 10.0);
    let [_, _, f1, f2, u, w] = *y;
    let (sin_psi, cos_psi) = (f2 - f1).sin_cos();
    let torque = 2.0 * (PI * t).cos();
    [
        u * f1.cos(),
        u * f1.sin(),
        w,
        (u * sin_psi - long * w * cos_psi) / short,
        a * w * w - torque * sin_psi / short / m1,
        (-m1 * a * u * w + torque * (1.0 + long * cos_psi / short)) / (i1 + m1 * a * a),
    ]
}

#[test]
fn cross_driven_massless_bar_against_the_reduced_equations() {
    let n = (HORIZON / STEP).round() as usize;
    let y = (0..n).fold([-0.2, 0.0, 0.0, PI, 0.0, 0.0], |y, i| rk4(reduced, i as f64 * STEP, &y, STEP));
    for Case { route, mut scene } in driven() {
        set(&mut *scene, &MASSLESS);
        let run = simulation(&*scene).method(Method::rk4(STEP)).until(HORIZON).run().unwrap();
        assert!(run.outcome.reached_end(), "{route}: {}", run.outcome);
        let q = run.last().coordinates;
        let wheel = [q[0] - 0.2 * q[2].cos(), q[1] - 0.2 * q[2].sin(), q[2], q[5]];
        let error = distance(&wheel, &y[..4]);
        assert!(error <= TWO_ROUTES, "{route}: {error:.1e}");
    }
}

#[test]
fn cross_driven_massless_bar_is_the_limit_of_light_bars() {
    for (Case { route, mut scene }, Case { scene: mut light, .. }) in driven().into_iter().zip(driven()) {
        set(&mut *scene, &MASSLESS);
        set(&mut *light, &[("m2", LIGHT), ("i2", 0.005 * LIGHT)]);
        let run = |scene| simulation(scene).method(Method::rk4(1e-3)).until(HORIZON).run().unwrap();
        let error = distance(run(&*scene).last().coordinates, run(&*light).last().coordinates);
        assert!(error <= LIGHT_CHANGES, "{route}: {error:.1e}");
    }
}

#[test]
fn invariant_backends_that_divide_by_masses_refuse_a_massless_bar() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &MASSLESS);
        for backend in [Backend::Generated, Backend::Sparse] {
            let error = simulation(&*scene).backend(backend).run().unwrap_err().to_string();
            assert!(error.contains("mass of body `bar` is zero") && error.contains("dense"), "{route}: {error}");
        }
    }
}

#[test]
fn invariant_angle_without_inertia_or_row_is_named() {
    for Case { route, mut scene } in driven() {
        // wheel and hinge at the seat's centre of mass leave nothing that turns it
        set(&mut *scene, &[("a", 0.0), ("b", 0.0), ("i1", 0.0)]);
        let error = simulation(&*scene).run().unwrap_err();
        assert!(
            matches!(&error, SetupError::Motion(MotionError::UndeterminedMotion { coordinates, .. }) if coordinates[..] == ["seat.phi"]),
            "{route}: {error}"
        );
    }
}

/// So small an inertia that the generated elimination loses all digits of the bar's pivot, while K is regular.
const TINY_INERTIA: f64 = 1e-15;
/// Steps by the same factorisation; what the generated elimination may still do in between differs by rounding.
const SAME_SOLVER: f64 = 1e-12;

#[test]
fn cross_vanished_pivot_is_decided_by_the_pivoted_backend() {
    for Case { route, mut scene } in driven() {
        set(&mut *scene, &[("i2", TINY_INERTIA)]);
        let ends = [Backend::Auto, Backend::Dense].map(|backend| {
            let run = simulation(&*scene).method(Method::rk4(1e-3)).backend(backend).until(1.0).run().unwrap();
            assert!(run.outcome.reached_end(), "{route} {backend:?}: {}", run.outcome);
            run.last().coordinates.to_vec()
        });
        let apart = distance(&ends[0], &ends[1]);
        assert!(apart <= SAME_SOLVER, "{route}: {apart:e}");
    }
}

/// The method's own error over one second at 1 ms, and rounding; the energy turned over is 8e-3 J.
const ENERGY_OF_LIGHT_BARS: f64 = 1e-12;

#[test]
fn invariant_energy_balance_of_bars_of_any_lightness() {
    for Case { route, mut scene } in driven() {
        for exponent in [0, 1, 2, 3, 4, 5, 6, 7, 8, 10, 12, 15, 18, 20, 25, 30, 50, 100, 200, 300] {
            let light = 10_f64.powi(-exponent);
            set(&mut *scene, &[("m2", light), ("i2", light)]);
            let run = simulation(&*scene).method(Method::rk4(1e-3)).work().until(1.0).run().unwrap();
            assert!(run.outcome.reached_end(), "{route} 1e-{exponent}: {}", run.outcome);
            let balance = run.last().energy.balance.abs();
            assert!(balance <= ENERGY_OF_LIGHT_BARS, "{route} 1e-{exponent}: {balance:e} J");
        }
    }
}
