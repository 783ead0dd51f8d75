//! The roller racer and the twistcar, one model, against references. Free, as a caster and as a tractor with a light
//! trailer: the hard cases `roller_racer, free_racer`, `caster_trail_…` and `heavy_tractor_tractrix`.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::roller_racer;
use ezy_tests::garage::{Names, case, from_states, load, start_at};
use ezy_tests::hard::subject::racer_geometry;
use serde_json::Value;

/// Of the references, for all states.
const STATE: f64 = 1e-8;
/// Relative, of the reference.
const ENERGY: f64 = 1e-10;

const RACER: Names<'static> = &[("seat", "seat"), ("handle", "handle")];
const TWISTCAR: Names<'static> = &[("body", "seat"), ("steer", "handle")];

/// Largest differences of positions and velocities of a case from a scene with its geometry and more parameters.
fn differences(
    scene: &mut dyn Scene,
    case: &Value,
    more: &[(&'static str, f64)],
    names: Names<'_>,
    step_s: f64,
    every_s: f64,
) -> [f64; 2] {
    crate::scenes::set(scene, &racer_geometry(&case["model"]));
    crate::scenes::set(scene, more);
    let scene = &*scene;
    let order = || start_at(simulation(scene).method(Method::rk4(step_s)), &case["model"], names);
    from_states(order, every_s, &case["states"], names)
}

#[test]
fn reference_racer_rowed() {
    let file = load("roller_racer");
    let case = case(&file, "rowed_racer");
    let worst = differences(&mut roller_racer::Rowed::default(), case, &[], RACER, 5e-4, 0.5);
    assert!(worst[0] <= STATE && worst[1] <= STATE, "{worst:?}");
}

#[test]
fn reference_twistcar() {
    let file = load("roller_racer");
    let more = [("m0", 0.5), ("omega", 3.0), ("phase", std::f64::consts::FRAC_PI_2), ("k", 0.8), ("damping", 0.05)];
    let case = case(&file, "twistcar");
    let worst = differences(&mut roller_racer::Twistcar::default(), case, &more, TWISTCAR, 1e-3, 0.5);
    assert!(worst[0] <= STATE && worst[1] <= STATE, "{worst:?}");
}

#[test]
fn invariant_free_racer_keeps_its_energy() {
    let scene = roller_racer::Coast::default();
    let run = simulation(&scene).method(Method::rk4(5e-4)).every(0.5).work().run().unwrap();
    for s in run.samples() {
        let error = s.energy.balance / s.energy.kinetic;
        assert!(error.abs() <= ENERGY, "{error:.1e} at {} s", s.t);
    }
}

/// RK4 at 1 ms while the speed is above the knee of 1 cm/s, which lasts 10 ms.
const ROLLING_OUT: f64 = 1e-10;

#[test]
fn analytic_racer_rolls_out_straight() {
    let scene = roller_racer::RollingOut { resistance: 1.0, ..Default::default() };
    let order = simulation(&scene).method(Method::rk4(1e-3)).until(1.1).every(0.1);
    let run = order.start("seat.omega", 0.0).start("handle.phi", 0.0).run().unwrap();
    // (m1 + m2) v' = −2 f v/√(v² + u²): the sum √(v² + u²) + u ln(v/(u + √(v² + u²))) falls steadily
    let u = scene.knee;
    let sum = |v: f64| v.hypot(u) + u * (v / (u + v.hypot(u))).ln();
    for s in run.samples() {
        let fallen = 2.0 * scene.resistance / (scene.m1 + scene.m2) * s.t;
        let error = sum(s.velocities[0]) - (sum(1.0) - fallen);
        assert!(error.abs() <= ROLLING_OUT, "{error:.1e} m/s at {} s", s.t);
    }
}
