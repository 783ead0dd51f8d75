//! The skid-steer robot in a steady turn against a Newton solution of three balances.

use crate::examples::skid_steer::skid_steer::Turning;
use ezy_core::prelude::*;

/// Force ahead, force to the left and moment that are left over, in the axes of a robot that turns steadily.
fn residual(s: &Turning, [u, v, rate]: [f64; 3], wheels: [f64; 2]) -> [f64; 3] {
    // the centre of mass accelerates by rate × velocity
    let mut left_over = [s.m * rate * v, -s.m * rate * u, 0.0];
    for (x, share) in [(s.a, s.b), (-s.b, s.a)] {
        for (y, wheel) in [(s.w, wheels[0]), (-s.w, wheels[1])] {
            let (ahead, across) = (u - rate * y - wheel, v + rate * x);
            let load = s.m * s.g * share / (s.a + s.b) / 2.0;
            let force = -s.mu * load / (ahead * ahead + across * across + s.smooth * s.smooth).sqrt();
            left_over[0] += force * ahead;
            left_over[1] += force * across;
            left_over[2] += force * (x * across - y * ahead);
        }
    }
    left_over
}

/// Newton's method with differences for derivatives; three equations by Cramer's rule.
fn steady_turn(s: &Turning, wheels: [f64; 2]) -> [f64; 3] {
    let det = |m: [[f64; 3]; 3]| {
        let minor = |i: usize, j: usize| m[1][i] * m[2][j] - m[1][j] * m[2][i];
        m[0][0] * minor(1, 2) - m[0][1] * minor(0, 2) + m[0][2] * minor(0, 1)
    };
    let mut z = [(wheels[0] + wheels[1]) / 2.0, 0.0, (wheels[1] - wheels[0]) / (4.0 * s.w)];
    for _ in 0..50 {
        let f = residual(s, z, wheels);
        let step = 1e-6;
        let column = |k: usize| {
            let moved = |by: f64| residual(s, std::array::from_fn(|i| z[i] + if i == k { by } else { 0.0 }), wheels);
            let (above, below) = (moved(step), moved(-step));
            std::array::from_fn::<f64, 3, _>(|i| (above[i] - below[i]) / (2.0 * step))
        };
        let columns = [column(0), column(1), column(2)];
        let whole = det(columns);
        for k in 0..3 {
            let mut replaced = columns;
            replaced[k] = f;
            z[k] -= det(replaced) / whole;
        }
    }
    z
}

/// Of a speed: what 30 s leave of the transient, and the tolerance of the run.
const STEADY: f64 = 1e-8;

#[test]
fn cross_steady_turn_balances_forces_and_moments() {
    for (b, wheels) in [(0.35, [0.6, 1.0]), (0.25, [-0.5, 0.5]), (0.45, [0.2, 1.2])] {
        let scene = Turning { b, ..Default::default() };
        let run = Simulation::new(&scene).method(Method::dop853(1e-11)).until(30.0).outputs();
        let run = run.input("left", wheels[0]).input("right", wheels[1]).run().unwrap();
        let found = ["output.speed", "output.drift", "chassis.omega"].map(|name| run.last().get(name).unwrap());
        let expected = steady_turn(&scene, wheels);
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() <= STEADY, "{b} {wheels:?}: {found} {expected}");
        }
        // it slips: without, it would turn much faster
        assert!(found[2] < 0.8 * (wheels[1] - wheels[0]) / (2.0 * scene.w), "{found:?}");
    }
}
