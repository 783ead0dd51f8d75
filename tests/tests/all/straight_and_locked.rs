//! Motions known in closed form: straight coasting, and the lock with both wheels at one point.

use crate::scenes::{Case, coast, distance, driven, set};
use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use std::f64::consts::PI;

const SPEED: f64 = 1.0;
/// Folded, the bar trails the seat and keeps the course; unfolded, rounding grows as e^(5 t) and the roller turns
/// over after some seconds.
const STRAIGHT_RUNS: [(f64, f64); 2] = [(0.0, 1.0), (PI, 100.0)];
/// Rounding of 1e5 steps: sin π is 1e-16 and turns the path by as much.
const STRAIGHT: f64 = 1e-11;
/// Rounding of the reactions times the masses.
const NO_REACTION: f64 = 1e-11;
/// Rounding of torques over inertias down to 0.005 kg m².
const AT_REST: f64 = 1e-12;

#[test]
fn analytic_coast_straight_stays_uniform() {
    for Case { route, scene } in coast() {
        for (psi, horizon) in STRAIGHT_RUNS {
            let run = simulation(&*scene)
                .method(Method::rk4(1e-3))
                .until(horizon)
                .start("seat.vx", SPEED)
                .start("bar.phi", psi)
                .run()
                .unwrap();
            let (first, last) = (run.first(), run.last());
            let mut expected = first.coordinates.to_vec();
            expected[0] += SPEED * horizon;
            expected[3] += SPEED * horizon;
            let error = distance(&expected, last.coordinates);
            assert!(error <= STRAIGHT, "{route}, psi = {psi}: {error:.1e}");
            let reaction = distance(&[0.0; 4], last.multipliers);
            assert!(reaction <= NO_REACTION, "{route}, psi = {psi}: {reaction:.1e}");
        }
    }
}

#[test]
fn analytic_driven_locked_stays_at_rest() {
    for Case { route, mut scene } in driven() {
        // a + b = c + d = L, folded: both wheels at one point
        set(&mut *scene, &[("c", 0.4), ("d", 0.4)]);
        let run = simulation(&*scene).method(Method::rk4(1e-3)).until(10.0).every(0.5).run().unwrap();
        assert!(run.outcome.reached_end(), "{route}: {}", run.outcome);
        for s in run.samples() {
            let moved = distance(s.coordinates, run.first().coordinates);
            assert!(moved <= AT_REST, "{route}: moved {moved:.1e} at {} s", s.t);
            let load = 2.0 * (PI * s.t).cos() / 0.8;
            let error = distance(s.multipliers, &[0.0, load, -load, -load]);
            assert!(error <= NO_REACTION, "{route}: reactions off by {error:.1e} at {} s", s.t);
        }
    }
}
