//! Projections: what they leave, what they do not touch, what they cost in energy.

use crate::scenes::{Case, all, distance, driven};
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};

/// What the projection promises.
const POSITION_RESIDUAL: f64 = 1e-12;
/// One linear solve: rounding times the condition of K.
const VELOCITY_RESIDUAL: f64 = 1e-13;
/// Energies of 1e2 J: rounding.
const ENERGY: f64 = 1e-12;

const METRICS: [Metric; 2] = [Metric::Mass, Metric::Euclidean];

/// A consistent state in motion, and the same with every coordinate and velocity disturbed by about `size`.
fn disturbed(scene: &dyn Scene, size: f64) -> (f64, Vec<f64>, Vec<f64>) {
    let run = simulation(scene).method(Method::rk4(1e-3)).until(0.7).run().unwrap();
    let s = run.last();
    let off = |x: &[f64], phase: f64| {
        x.iter().enumerate().map(|(i, x)| x + size * (1.7 * i as f64 + phase).sin()).collect::<Vec<_>>()
    };
    (s.t, off(s.coordinates, 0.3), off(s.velocities, 1.1))
}

#[test]
fn invariant_both_projections_leave_no_residual() {
    for Case { route, scene } in all() {
        for metric in METRICS {
            let run = simulation(&*scene).method(Method::rk4(0.01)).metric(metric).until(1.0).every(0.1);
            for s in run.run().unwrap().samples() {
                let (position, velocity) = (s.position_residual, s.velocity_residual);
                assert!(position <= POSITION_RESIDUAL, "{route} {metric:?}: {position:.1e} at {} s", s.t);
                assert!(velocity <= VELOCITY_RESIDUAL, "{route} {metric:?}: {velocity:.1e} at {} s", s.t);
            }
        }
    }
}

#[test]
fn invariant_projection_brings_a_disturbed_state_back() {
    for Case { route, scene } in all() {
        let (t, q, v) = disturbed(&*scene, 1e-2);
        for metric in METRICS {
            let mut system = system_of(&*scene, Backend::Auto).unwrap();
            let (mut q, mut v) = (q.clone(), v.clone());
            assert!(system.position_residual(t, &q) > 1e-3 && system.velocity_residual(t, &q, &v) > 1e-3);
            let passes = system.project_positions(t, &mut q, metric).unwrap();
            system.project_velocities(t, &q, &mut v, metric).unwrap();
            assert!((2..=4).contains(&passes), "{route} {metric:?}: {passes} passes of a quadratic iteration");
            assert!(system.position_residual(t, &q) <= POSITION_RESIDUAL, "{route} {metric:?}");
            assert!(system.velocity_residual(t, &q, &v) <= VELOCITY_RESIDUAL, "{route} {metric:?}");
        }
    }
}

#[test]
fn invariant_consistent_positions_are_left_to_the_bit() {
    for Case { route, scene } in all() {
        let mut system = system_of(&*scene, Backend::Auto).unwrap();
        let state = system.consistent_start(&system.scene_start()).unwrap();
        let mut q = state.q.clone();
        assert_eq!(system.project_positions(state.t, &mut q, Metric::Mass), Ok(0), "{route}");
        assert_eq!(q, state.q, "{route}");
    }
}

/// The removed velocity is orthogonal in M to what is left: T(ṽ) = T(v) + T(ṽ − v), so T never grows.
#[test]
fn analytic_mass_weighted_projection_splits_the_energy() {
    for Case { route, scene } in all() {
        let (t, mut q, disturbed_v) = disturbed(&*scene, 0.1);
        let mut system = system_of(&*scene, Backend::Auto).unwrap();
        system.project_positions(t, &mut q, Metric::Mass).unwrap();
        let mut v = disturbed_v.clone();
        system.project_velocities(t, &q, &mut v, Metric::Mass).unwrap();
        let removed: Vec<f64> = disturbed_v.iter().zip(&v).map(|(a, b)| a - b).collect();
        let [before, after, part] = [&disturbed_v, &v, &removed].map(|v| system.kinetic_energy(v));
        assert!((before - after - part).abs() <= ENERGY, "{route}: {before} = {after} + {part}");
        assert!(part > 1e-3, "{route}: the disturbance violates the rows");
    }
}

/// The position correction solves for [C; 0]: the skates see no side-slip in it.
#[test]
fn invariant_position_correction_obeys_the_skates() {
    for Case { route, scene } in all() {
        let (t, q, _) = disturbed(&*scene, 1e-3);
        let mut system = system_of(&*scene, Backend::Auto).unwrap();
        let mut residual = [0.0; 4];
        scene.position_constraint(system.fixed(), t, &q, &mut residual[..2]);
        let mut delta = [0.0; 6];
        system.correction(t, &q, &residual, Metric::Mass, &mut delta).unwrap();
        let mut rows = [0.0; 4];
        scene.velocity_constraint(system.fixed(), t, &q, &delta, &mut rows);
        let expected = residual.map(|r| -r);
        let error = distance(&rows, &expected);
        assert!(error <= VELOCITY_RESIDUAL, "{route}: {error:.1e}");
    }
}

/// The Euclidean correction is the shortest: orthogonal to every direction that the rows allow.
#[test]
fn analytic_euclidean_correction_is_the_shortest() {
    for Case { route, scene } in all() {
        let (t, q, v) = disturbed(&*scene, 0.1);
        let mut system = system_of(&*scene, Backend::Auto).unwrap();
        let mut residual = [0.0; 4];
        scene.velocity_constraint(system.fixed(), t, &q, &v, &mut residual);
        let (mut shortest, mut other) = ([0.0; 6], [0.0; 6]);
        system.correction(t, &q, &residual, Metric::Euclidean, &mut shortest).unwrap();
        system.correction(t, &q, &residual, Metric::Mass, &mut other).unwrap();
        // both fulfil the rows, so that their difference is allowed
        let along: f64 = shortest.iter().zip(&other).map(|(s, o)| s * (o - s)).sum();
        assert!(along.abs() <= VELOCITY_RESIDUAL, "{route}: {along:.1e}");
    }
}

/// Without projection the rows drift with the fourth power of the step; with velocities projected much less.
#[test]
fn invariant_velocity_projection_tames_the_drift() {
    for Case { route, scene } in driven() {
        let drift = |projection| {
            let order = simulation(&*scene).method(Method::rk4(0.02)).project(projection).until(10.0);
            order.run().unwrap().last().position_residual
        };
        let (none, velocities) = (drift(Projection::None), drift(Projection::Velocities));
        assert!(none > 1e-8 && velocities < 0.1 * none, "{route}: {none:.1e}, {velocities:.1e}");
    }
}

/// One factorisation at the end of a step serves its velocity projection, its accelerations and the next first stage. Steps of
/// 0.1 ms leave positions within their tolerance.
#[test]
fn regress_a_step_of_rk4_factors_four_times() {
    for Case { route, scene } in all() {
        for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
            let factorizations = |until_s: f64| {
                let run = simulation(&*scene).backend(backend).method(Method::rk4(1e-4)).until(until_s).run().unwrap();
                run.cost.factorizations
            };
            assert_eq!(factorizations(0.004) - factorizations(0.002), 4 * 20, "{route} {backend:?}");
        }
    }
}
