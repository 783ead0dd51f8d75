//! Force laws where a naive formula loses its digits or is 0/0.

use crate::scenes::assert_checks;
use ezy_core::prelude::*;
use ezy_core_tests::simulation;

model! {
    /// A stiff, long spring that is hardly stretched.
    pub model StiffSpring {
        param k: N/m = 1e7;
        param l: m = 5;
        param stretch: m = 1e-6;
        body cart { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        spring ground(0, 0) ~ cart(0, 0): stiffness k, length l;
        start stretched { cart x l + stretch; at rest; }
        scene swing { start stretched; until 0.01 s; }
    }
}

model! {
    /// Laws whose divisor is zero at the start.
    pub model Coinciding {
        param u: m/s = 0;
        body cart { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        spring ground(0, 0) ~ cart(0, 0): stiffness 40, damping 0.5;
        friction at cart(0, 0): force 0, speed u;
        tyre at cart(0, 0) along cart(0, 1): stiffness 1, limit 0, speed 1;
        start here { cart x 0; at rest; }
        start passing { cart x 0 vx 1; }
        scene rest { start here; until 0.1 s; }
        scene pass { start passing; until 0.1 s; }
    }
}

/// Energy of the stretch against ε times the energy that a compression of the whole length would take, in plain numbers:
/// the stretch is known to ε l, so its square to 2 ε l / stretch.
const STRETCH_ENERGY: f64 = 2.0 * f64::EPSILON * 5.0 / 1e-6;

#[test]
fn analytic_energy_of_a_small_stretch_keeps_its_digits() {
    let scene = stiff_spring::Swing::default();
    let run = simulation(&scene).work().method(Method::rk4(1e-6)).every(1e-4).run().unwrap();
    let energy = 0.5 * scene.k * scene.stretch.powi(2);
    for s in run.samples() {
        let total = s.energy.kinetic + s.energy.potential;
        assert!((total / energy - 1.0).abs() <= 2.0 * STRETCH_ENERGY, "{total:e} J at {} s", s.t);
    }
}

#[test]
fn fd_long_spring_passes_the_checks() {
    // stretched by more than the rounding of its length, so that the balance of energy can be met
    assert_checks(&stiff_spring::Swing { k: 1e4, stretch: 0.1, ..Default::default() });
}

#[test]
fn analytic_laws_without_divisor_are_no_force() {
    let run = simulation(&coinciding::Rest::default()).method(Method::rk4(1e-3)).run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    assert_eq!(run.last().get("cart.x").unwrap(), 0.0);
}

/// RK4 at 1 ms of a damped oscillator at 6 rad/s: (h ω)⁵ t/(120 h) is 1e-12 of an amplitude of 0.2.
const PASSING: f64 = 1e-11;

#[test]
fn analytic_damped_spring_passes_through_its_end() {
    let run = simulation(&coinciding::Pass::default()).method(Method::rk4(1e-3)).run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    // ẍ + c ẋ + k x = 0 from x = 0, ẋ = 1
    let (decay, frequency) = (0.25, f64::sqrt(40.0 - 0.25 * 0.25));
    let expected = (-decay * 0.1_f64).exp() * (frequency * 0.1).sin() / frequency;
    let error = (run.last().get("cart.x").unwrap() - expected).abs();
    assert!(error <= PASSING, "{error:.1e}");
}
