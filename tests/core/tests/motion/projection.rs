//! Back onto the constraints.

use super::accelerations::hoist;
use super::singular::parallelogram;
use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};

model! {
    /// Two rods, the second on a runner.
    pub model Elbow {
        body upper { mass: 3, inertia: 0.25 }
        body lower { mass: 1, inertia: 0.1 }
        hinge shoulder: ground(0, 0) ~ upper(-0.5, 0);
        hinge elbow: upper(0.5, 0) ~ lower(-0.4, 0);
        gravity (0, -9.81);
        start bent { upper angle 0.3 rate 1; lower angle -0.5 rate 2; }
        scene swing { start bent; until 1 s; }
    }
}

/// The tolerance of projections; sizes of rows are near one.
const PROJECTED: f64 = 1e-12;

fn disturbed(system: &mut System<&(dyn Scene + '_)>) -> State {
    let start = system.scene_start();
    let mut state = system.consistent_start(&start).unwrap();
    for (i, (q, v)) in state.q.iter_mut().zip(&mut state.v).enumerate() {
        *q += 1e-3 * (1.0 + i as f64).sin();
        *v += 1e-2 * (2.0 + i as f64).sin();
    }
    state
}

/// Residuals of the hinges, by hand.
fn residuals(q: &[f64], v: &[f64]) -> [f64; 8] {
    let arm = |r: f64, i: usize| {
        let (sin, cos) = q[i + 2].sin_cos();
        [[q[i] + r * cos, q[i + 1] + r * sin], [v[i] - r * sin * v[i + 2], v[i + 1] + r * cos * v[i + 2]]]
    };
    let (shoulder, elbow, end) = (arm(-0.5, 0), arm(0.5, 0), arm(-0.4, 3));
    let part = |level: usize, k: usize| [shoulder[level][k], elbow[level][k] - end[level][k]];
    let [[a, b], [c, d], [e, f], [g, h]] = [part(0, 0), part(0, 1), part(1, 0), part(1, 1)];
    [a, b, c, d, e, f, g, h]
}

fn largest(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |largest, x| x.abs().max(largest))
}

#[test]
fn invariant_projection_leaves_no_residual_and_says_what_it_found() {
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        for metric in [Metric::Mass, Metric::Euclidean] {
            let scene = elbow::Swing::default();
            let mut system = system_of(&scene, backend).unwrap();
            let State { q, v, .. } = disturbed(&mut system);
            for projection in [Projection::Both, Projection::Positions, Projection::Velocities, Projection::None] {
                let (mut q, mut v) = (q.clone(), v.clone());
                let before = residuals(&q, &v);
                assert!((system.position_residual(0.0, &q) - largest(&before[..4])).abs() <= 1e-15);
                assert!((system.velocity_residual(0.0, &q, &v) - largest(&before[4..])).abs() <= 1e-15);
                let projected = system.project(0.0, &mut q, &mut v, projection, metric).unwrap();
                let after = residuals(&q, &v);
                let (positions, velocities) = (largest(&after[..4]), largest(&after[4..]));
                let is = |level: Projection| projection == level || projection == Projection::Both;
                assert_eq!(positions <= PROJECTED, is(Projection::Positions), "{backend:?} {metric:?} {projection:?}");
                assert_eq!(
                    velocities <= PROJECTED,
                    is(Projection::Velocities),
                    "{backend:?} {metric:?} {projection:?}"
                );
                if is(Projection::Positions) {
                    assert!((projected.positions_before.value - largest(&before[..4])).abs() <= 1e-15);
                    assert!(projected.positions_after.value <= PROJECTED);
                }
            }
        }
    }
}

/// The smallest correction in the metric of the masses: M δ is a combination of the rows, so that it does no work on any motion that the
/// constraints allow. The two motions are the rates of the angles.
#[test]
fn analytic_velocity_correction_is_smallest_in_the_metric_of_the_masses() {
    let scene = elbow::Swing::default();
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        let mut system = system_of(&scene, backend).unwrap();
        let State { mut q, v, .. } = disturbed(&mut system);
        system.project_positions(0.0, &mut q, Metric::Mass).unwrap();
        let mut moved = v.clone();
        system.project_velocities(0.0, &q, &mut moved, Metric::Mass).unwrap();
        let mass = system.mass_matrix().to_vec();
        let (s1, c1, s2, c2) = (q[2].sin(), q[2].cos(), q[5].sin(), q[5].cos());
        for motion in [[-0.5 * s1, 0.5 * c1, 1.0, -s1, c1, 0.0], [0.0, 0.0, 0.0, -0.4 * s2, 0.4 * c2, 1.0]] {
            let work: f64 = (0..6).map(|i| motion[i] * mass[i] * (moved[i] - v[i])).sum();
            assert!(work.abs() <= 1e-14, "{backend:?}: {work:.1e}");
        }
        assert!(largest(&[moved[0] - v[0]]) > 1e-4, "there is something to correct");
    }
}

/// Without projection the residuals of a run grow, and its monitors say so; with it they stay, and the drift is what was removed.
#[test]
fn invariant_monitors_tell_residuals_and_drift() {
    let scene = elbow::Swing::default();
    let run = |projection| simulation(&scene).method(Method::rk4(0.01)).project(projection).run().unwrap();
    let (free, held) = (run(Projection::None), run(Projection::Both));
    let last = free.last();
    let found = residuals(last.coordinates, last.velocities);
    assert!((last.position_residual - largest(&found[..4])).abs() <= 1e-15 && last.position_residual > 1e-9);
    assert!((last.velocity_residual - largest(&found[4..])).abs() <= 1e-14 && last.velocity_residual > 1e-9);
    assert!(free.monitors.position_drift.is_none() && free.monitors.velocity_drift.is_none());
    assert!(free.monitors.position_residual.as_ref().unwrap().value >= last.position_residual);
    assert!(held.last().position_residual <= PROJECTED && held.last().velocity_residual <= PROJECTED);
    let (drift, residual) = (held.monitors.position_drift.unwrap(), held.monitors.position_residual.unwrap());
    assert!(drift.value > 1e-10 && residual.value <= PROJECTED, "{drift:?} {residual:?}");
}

#[test]
fn invariant_a_limit_on_drift_ends_a_run() {
    let scene = elbow::Swing::default();
    let order = |drift| simulation(&scene).method(Method::rk4(0.01)).project(Projection::None).max_drift(drift);
    assert!(order(1.0).run().unwrap().outcome.reached_end());
    let run = order(1e-9).run().unwrap();
    assert!(matches!(run.outcome, Outcome::Stopped { t, .. } if t < 0.9), "{:?}", run.outcome);
}

/// In plain numbers, over rows of positions and of velocities: the only motion that is free, the wheel with the block on its rope, gets
/// nothing of the correction.
#[test]
fn analytic_euclidean_velocity_correction_holds_every_kind_of_row() {
    let scene = hoist::Falls::default();
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        let mut system = system_of(&scene, backend).unwrap();
        let q = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0];
        let before = [0.3, -0.2, 1.0, 0.1, 0.5, -0.4];
        let mut v = before;
        let solved = system.project_velocities(0.0, &q, &mut v, Metric::Euclidean).unwrap();
        assert!(!solved.is_rank_deficient && system.velocity_residual(0.0, &q, &v) <= PROJECTED, "{backend:?}: {v:?}");
        assert!((v[2] - before[2] - 0.25 * (v[4] - before[4])).abs() <= PROJECTED, "{backend:?}: {v:?}");
        // positions are corrected for their rows alone
        let mut beside = q.map(|x| x + 1e-3);
        assert!(system.position_residual(0.0, &beside) >= 1e-4, "{backend:?}");
        assert!(system.project_positions(0.0, &mut beside, Metric::Euclidean).unwrap() >= 1, "{backend:?}");
        assert!(system.position_residual(0.0, &beside) <= PROJECTED, "{backend:?}: {beside:?}");
    }
}

model! {
    /// A stone that two equal rows hold, and one that no place fulfils.
    pub model Nowhere {
        count n = 1;
        param a: m = 1;
        body stone[n] { mass: 1, inertia: 1 }
        for i in 0..n {
            constraint first[i]: stone[i].y = 0;
            constraint again[i]: 2 * stone[i].y = 0;
            constraint far[i]: stone[i].x^2 = -a^2;
        }
        start here { for i in 0..n { stone[i] angle 0; } }
        scene stays { start here; until 1 s; }
    }
}

/// Rows are redundant, but it is not these that leave the residual: that is no contradiction of theirs.
#[test]
fn invariant_row_that_cannot_be_met_is_not_told_as_a_contradiction_of_others() {
    let scene = nowhere::Stays::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let mut q = [0.7, 0.1, 0.0];
    let error = system.project_positions(0.0, &mut q, Metric::Mass).unwrap_err();
    let MotionError::ProjectionStalled { row, residual, passes, .. } = error else { panic!("{error}") };
    assert!(row == "far[0]" && residual >= 1.0 && passes == 10 && q[1].abs() <= PROJECTED, "{row} {residual} {q:?}");
}

/// Next to its flat position, at 1e-5 rad, a parallelogram whose bars differ by 4e-8 rad fulfils its hinges to 4e-13 m, but its bars do not turn
/// at one rate any more. Velocities are corrected from where they were, at the positions in which it is one.
#[test]
fn invariant_velocities_next_to_a_flat_position_are_those_at_corrected_positions() {
    let scene = parallelogram::Falls::default();
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        let mut system = system_of(&scene, backend).unwrap();
        let (left, right) = (1e-5_f64 + 2e-8, 1e-5_f64 - 2e-8);
        let bar = (0.5 * (right.sin() - left.sin())).asin();
        let rate = 0.5 * (right.cos() - left.cos()) / bar.cos();
        let arm = |phi: f64| ([0.5 * phi.cos(), 0.5 * phi.sin()], [-0.5 * phi.sin(), 0.5 * phi.cos()]);
        let (([lx, ly], [lu, lv]), ([rx, ry], [ru, rv])) = (arm(left), arm(right));
        let mut q = vec![lx, ly, left, 2.0 + rx, ry, right, 2.0 * lx + bar.cos(), 2.0 * ly + bar.sin(), bar];
        let v = vec![lu, lv, 1.0, ru, rv, 1.0, 2.0 * lu - rate * bar.sin(), 2.0 * lv + rate * bar.cos(), rate];
        let projected = |q: &[f64], system: &mut System<_>| {
            let mut v = v.clone();
            system.project_velocities(0.0, q, &mut v, Metric::Mass).unwrap();
            v
        };
        let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        // where the positions are, the rates would change by a five-hundredth of themselves
        assert!(apart(&projected(&q, &mut system), &v) > 1e-3);
        let mut found = v.clone();
        system.project(0.0, &mut q, &mut found, Projection::Both, Metric::Mass).unwrap();
        assert!(system.position_residual(0.0, &q) <= 1e-15);
        let expected = projected(&q, &mut system);
        assert!(
            apart(&expected, &v) <= 1e-6 && apart(&found, &expected) <= 1e-12,
            "{backend:?}: {found:?} {expected:?}"
        );
    }
}

/// What was asked about velocities before takes no part in a projection of positions.
#[test]
fn invariant_positions_are_projected_alike_whatever_was_asked_before() {
    let scene = hoist::Falls::default();
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        let project = |asks: bool| {
            let mut system = system_of(&scene, backend).unwrap();
            let mut q = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0].map(|x| x + 1e-3);
            assert!(!asks || system.velocity_residual(0.0, &q, &[1.0; 6]) >= 1.0);
            system.project_positions(0.0, &mut q, Metric::Mass).unwrap();
            q
        };
        assert_eq!(project(true), project(false), "{backend:?}");
    }
}
