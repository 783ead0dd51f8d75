//! Motions that go on for long, and fast ones: what would add up from step to step does not.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::pendulum;
use ezy_tests::garage::{load, rows};

/// The projection's promise, whatever the angle.
const GAP: f64 = 1e-12;

/// A million radians, of which a double keeps 1e-10: a lever of 5 cm turns by 6e-12 m from one to the next.
const FAR_ROUND: f64 = 159_155.0 * std::f64::consts::TAU;

#[test]
fn invariant_rotor_keeps_its_hinge_at_a_million_radians() {
    let scene = pendulum::Swing { l: 0.05, i: 0.01, ..Default::default() };
    for method in [Method::rk4(1e-6), Method::dop853(1e-12), Method::taylor(1e-12)] {
        let order = simulation(&scene).method(method).until(2e-3);
        let run = order.start("bob.phi", FAR_ROUND).start("bob.omega", 1e4).run().unwrap();
        let gap = run.monitors.position_residual.unwrap();
        assert!(run.outcome.reached_end() && gap.value <= GAP, "{method:?}: {gap:?}, {}", run.outcome);
    }
}

/// Steps of 0.1 s round at 1e-14 of the energy each: 1e-11 of it in 2,000 s, and half of that in the phase of 1e3 rad.
const STATE: f64 = 1e-8;

#[test]
fn analytic_pendulum_after_two_hundred_turns() {
    let scene = pendulum::Swing::default();
    let run = simulation(&scene).method(Method::taylor(1e-13)).until(500.0).run().unwrap();
    let file = load("a01_simple_pendulum");
    let table = rows(&file["exact"]["rows"]);
    let exact = table.iter().find(|row| row[0] == 500.0).expect("a row at 500 s");
    let last = run.last();
    let errors = [last.coordinates[0] - exact[1], last.coordinates[1] - exact[2]];
    assert!(errors.iter().all(|error| error.abs() <= STATE), "{errors:?}");
    assert!(run.monitors.position_residual.as_ref().unwrap().value <= GAP, "{:?}", run.monitors);
}
