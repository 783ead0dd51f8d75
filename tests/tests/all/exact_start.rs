//! Exact rational values at the start, by hand.

use crate::scenes::{Case, coast, distance, driven};
use ezy_core_tests::simulation;

/// A dozen roundings of numbers up to ten.
const ROUNDING: f64 = 1e-13;

/// The first sample of a scene.
fn assert_start(case: &Case, a: [f64; 6], lambda: [f64; 4]) {
    let run = simulation(&*case.scene).until(0.0).run().unwrap();
    let (s, route) = (run.first(), case.route);
    let (da, dl) = (distance(s.accelerations, &a), distance(s.multipliers, &lambda));
    assert!(da <= ROUNDING, "{route}: |da| = {da:.1e}");
    assert!(dl <= ROUNDING, "{route}: |dlambda| = {dl:.1e}");
}

#[test]
fn analytic_accelerations_coast_start() {
    for case in coast() {
        assert_start(
            &case,
            [0.0, 5.0 / 156.0, 25.0 / 156.0, 0.0, -185.0 / 78.0, 0.0],
            [0.0, -185.0 / 78.0, 35.0 / 39.0, 0.0],
        );
    }
}

#[test]
fn analytic_accelerations_driven_start() {
    for case in driven() {
        assert_start(
            &case,
            [0.0, -15.0 / 151.0, -75.0 / 151.0, 0.0, -30.0 / 151.0, -300.0 / 151.0],
            [0.0, 2975.0 / 302.0, -1595.0 / 302.0, -3035.0 / 302.0],
        );
    }
}

#[test]
fn analytic_kinetic_energy_coast_start() {
    for Case { route, scene } in coast() {
        let run = simulation(&*scene).until(0.0).run().unwrap();
        let error = (run.first().energy.kinetic - 371.0 / 16.0).abs();
        assert!(error <= ROUNDING, "{route}: {error:.1e}");
    }
}

#[test]
fn analytic_velocities_coast_start_are_assembled() {
    for Case { route, scene } in coast() {
        let run = simulation(&*scene).until(0.0).run().unwrap();
        let error = distance(run.first().velocities, &[1.0, 0.0, 0.0, 0.5, 0.0, 5.0]);
        assert!(error <= ROUNDING, "{route}: {error:.1e}");
    }
}
