//! Chains of many rows, rows that depend on time, bodies without rows: what the EzyRoller does not have.

use crate::large::chain;
use crate::scenes::{Case, assert_checks, coast, distance, set};
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};
use ezy_tests::crank::{self, Crank};

/// Rounding times the condition of K, which for chains grows with the square of their length.
const ROUNDING: f64 = 1e-14;
/// The projection's promise.
const POSITION: f64 = 1e-12;
/// Reactions of 1e1 N from accelerations good to 1e-12.
const REACTION: f64 = 1e-11;
/// Accelerations over a ratio of masses of 1e10, relative: the light body is read off the heavy one's motion.
const MASS_RATIO: f64 = 1e-6;

#[test]
fn cross_backends_on_chains_of_any_length() {
    for n in [1, 2, 10, 20] {
        let chain = chain::Swing { n };
        let mut solutions = Vec::new();
        for backend in [Backend::Dense, Backend::Sparse] {
            let mut system = system_of(&chain, backend).unwrap();
            let state = system.consistent_start(&system.scene_start()).unwrap();
            let (mut a, mut lambda) = (vec![0.0; 3 * n], vec![0.0; 2 * n]);
            system.accelerations(state.t, &state.q, &state.v, &mut a, &mut lambda).unwrap();
            solutions.push([a, lambda].concat());
        }
        let size = solutions[0].iter().fold(1.0, |m: f64, x| m.max(x.abs()));
        for other in &solutions[1..] {
            let error = distance(&solutions[0], other) / size;
            assert!(error <= ROUNDING * (n * n) as f64, "{n} rods: {error:.1e}");
        }
    }
}

#[test]
fn fd_crank_passes_the_checks() {
    assert_checks(&Crank::default());
}

#[test]
fn analytic_prescribed_angle_is_followed_with_its_torque() {
    let scene = Crank::default();
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        let run = simulation(&scene).backend(backend).method(Method::rk4(1e-2)).every(0.1).run().unwrap();
        assert!(run.outcome.reached_end(), "{backend:?}: {}", run.outcome);
        for s in run.samples() {
            assert!((s.coordinates[2] - crank::angle(s.t)).abs() <= POSITION, "{backend:?} at {} s", s.t);
            assert!((s.velocities[2] - crank::rate(s.t)).abs() <= POSITION, "{backend:?} at {} s", s.t);
            // the torque of the row on the crank is −λ
            let error = (-s.multipliers[2] - crank::drive_torque(s.t)).abs();
            assert!(error <= REACTION, "{backend:?}: {error:.1e} at {} s", s.t);
        }
    }
}

#[test]
fn cross_backends_over_ten_powers_of_mass() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("m2", 46e-10), ("i2", 10e-12)]);
        let ends = [Backend::Generated, Backend::Dense, Backend::Sparse].map(|backend| {
            let run = simulation(&*scene).method(Method::rk4(1e-3)).backend(backend).until(0.5).run().unwrap();
            assert!(run.outcome.reached_end(), "{route} {backend:?}: {}", run.outcome);
            run.last().coordinates.to_vec()
        });
        for end in &ends[1..] {
            let error = distance(end, &ends[0]);
            assert!(error <= MASS_RATIO, "{route}: {error:.1e}");
        }
    }
}
