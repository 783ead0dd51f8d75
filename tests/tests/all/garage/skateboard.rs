//! The skateboard against closed forms.

use ezy_core::prelude::*;
use ezy_models::skateboard;

/// RK4 at 5 ms while the steering swings at 3 rad/s: (νh)⁴/120 of 30 rad, relative.
const SPEED: f64 = 1e-8;

/// Mass and moment of inertia about the middle of everything that moves with the deck.
fn inertias(s: &skateboard::Carved) -> [f64; 2] {
    let mass = s.m_deck + s.m_rider + 2.0 * s.m_truck;
    [mass, s.j_deck + s.j_rider + 2.0 * (s.j_truck + s.m_truck * s.r * s.r)]
}

#[test]
fn analytic_skateboard_slows_down_where_it_turns() {
    let scene = skateboard::Carved { delta: 0.1, ..Default::default() };
    let [mass, inertia] = inertias(&scene);
    let run = Simulation::new(&scene).method(Method::rk4(5e-3)).every(0.1).work().run().unwrap();
    for s in run.samples() {
        let slope = |t: f64| (scene.delta + scene.swing * (scene.nu * t).sin()).tan() / scene.r;
        let energy = |slope: f64| mass + inertia * slope * slope;
        let exact = 2.0 * (energy(slope(0.0)) / energy(slope(s.t))).sqrt();
        let speed = s.velocities[0] * s.coordinates[2].cos() + s.velocities[1] * s.coordinates[2].sin();
        assert!((speed / exact - 1.0).abs() <= SPEED, "{:.1e} at {} s", speed / exact - 1.0, s.t);
    }
}

#[test]
fn analytic_skateboard_at_a_steady_lean_runs_a_circle() {
    let scene = skateboard::Carved { delta: 0.2, swing: 0.0, ..Default::default() };
    let run = Simulation::new(&scene).method(Method::rk4(5e-3)).every(0.5).run().unwrap();
    let radius = scene.r / scene.delta.tan();
    for s in run.samples() {
        let (sin, cos) = (2.0 * s.t / radius).sin_cos();
        let error = crate::scenes::distance(&s.coordinates[..2], &[radius * sin, radius * (1.0 - cos)]);
        assert!(error <= SPEED, "{error:.1e} m at {} s", s.t);
    }
}
