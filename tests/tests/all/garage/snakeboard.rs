//! The snakeboard against references, with trucks without mass; the skateboard against closed forms. With locked steering, and
//! through a right angle: the hard cases `snakeboard, locked_steering` and `snakeboard_through_90deg`.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::{skateboard, snakeboard};
use ezy_tests::garage::{Names, case, from_states, load, start_at};
use ezy_tests::hard::subject::gait;

/// Of the reference, for all states.
const STATE: f64 = 1e-8;
/// RK4 leaves (ωh)⁴/120 a radian: 1e-9 for gaits of 1 rad/s.
const STEP: f64 = 2e-2;

const BOARD: Names<'static> = &[("board", "board"), ("rotor", "rotor"), ("front", "front"), ("back", "back")];

#[test]
fn reference_snakeboard_gaits() {
    let file = load("snakeboard");
    for name in ["drive_gait", "rotate_gait"] {
        let case = case(&file, name);
        let scene = gait(&case["model"]);
        let order = || start_at(simulation(&scene).method(Method::rk4(STEP)), &case["model"], BOARD);
        let worst = from_states(order, 0.5, &case["states"], BOARD);
        assert!(worst[0] <= STATE && worst[1] <= STATE, "{name}: {worst:?}");
    }
}

#[test]
fn reference_snakeboard_stroked_by_a_torque() {
    let file = load("snakeboard");
    let case = case(&file, "torque_driven");
    let scene = snakeboard::Stroked::default();
    let order = || start_at(simulation(&scene).method(Method::rk4(2.5e-3)), &case["model"], BOARD);
    let worst = from_states(order, 0.5, &case["states"], BOARD);
    assert!(worst[0] <= STATE && worst[1] <= STATE, "{worst:?}");
}

/// p is conserved exactly; relative, of the reference.
const MOMENTUM: f64 = 1e-11;

#[test]
fn invariant_snakeboard_with_locked_steering_keeps_its_momentum() {
    let file = load("snakeboard");
    let case = case(&file, "locked_steering");
    let scene = gait(&case["model"]);
    let order = start_at(simulation(&scene).method(Method::rk4(5e-3)), &case["model"], BOARD);
    let run = order.until(5.0).every(0.5).run().unwrap();
    let slope = scene.front_offset.tan() / scene.r;
    let inertia = scene.j_board + scene.j_rotor + 2.0 * scene.j_truck;
    let momentum = |s: Sample<'_>| {
        let (q, v) = (s.coordinates, s.velocities);
        let speed = v[0] * q[2].cos() + v[1] * q[2].sin();
        let mass = scene.m_board + scene.m_rotor;
        mass * speed + inertia * speed * slope * slope + scene.j_rotor * (v[5] - v[2]) * slope
    };
    let first = momentum(run.first());
    for s in run.samples() {
        let error = momentum(s) / first - 1.0;
        assert!(error.abs() <= MOMENTUM, "{error:.1e} at {} s", s.t);
    }
}

/// A truck of 1e-9 of a board's mass of 4 kg; of the reference.
const LIGHT_TRUCK: f64 = 1e-9;

#[test]
fn cross_snakeboard_with_trucks_of_a_microgram_each() {
    let ends = [0.0, 1e-9].map(|m_truck| {
        let scene = snakeboard::Serpentine { m_truck, ..Default::default() };
        let run = simulation(&scene).method(Method::rk4(STEP)).until(5.0).run().unwrap();
        run.last().coordinates.to_vec()
    });
    let apart = crate::scenes::distance(&ends[0], &ends[1]);
    assert!(apart <= LIGHT_TRUCK, "{apart:.1e}");
}

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
    let run = simulation(&scene).method(Method::rk4(5e-3)).every(0.1).work().run().unwrap();
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
    let run = simulation(&scene).method(Method::rk4(5e-3)).every(0.5).run().unwrap();
    let radius = scene.r / scene.delta.tan();
    for s in run.samples() {
        let (sin, cos) = (2.0 * s.t / radius).sin_cos();
        let error = crate::scenes::distance(&s.coordinates[..2], &[radius * sin, radius * (1.0 - cos)]);
        assert!(error <= SPEED, "{error:.1e} m at {} s", s.t);
    }
}
