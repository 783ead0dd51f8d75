//! Scenes with counts: sizes at run time, cost that grows with the number of bodies and no faster, refusals.

use crate::scenes::assert_checks;
use ezy_core::dynamics::{MotionError, SystemError};
use ezy_core::linalg::{KktFactorization, SparseKkt};
use ezy_core::model::{LayoutFault, Start};
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};
use ezy_models::hanging_net;
use std::sync::Arc;

model! {
    /// Rods of 1 m and 1 kg in a row, hung from one end, at angles that go on turning.
    pub model Chain {
        count n = 100;
        body rod[n] { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ rod[0](-0.5, 0);
        for i in 1..n { hinge pin[i]: rod[i-1](0.5, 0) ~ rod[i](-0.5, 0); }
        gravity (0, -9.81);
        start rolled_up { for i in 0..n { rod[i] angle 0.1*i; } }
        start level { for i in 0..n { rod[i] angle 0; } at rest; }
        scene swing { start rolled_up; until 1 s; }
        scene released { start level; until 1 s; }
    }
}

/// The projection's promise, with the rounding of coordinates of some thousand metres.
const POSITION: f64 = 2e-11;

/// Entries of L for `n` bodies of which body i is joined to body `parent(i)` by two rows.
fn tree_entries(n: usize, parent: impl Fn(usize) -> usize) -> usize {
    let joints = (1..n).flat_map(|i| {
        let (p, row) = (parent(i), 2 * (i - 1));
        (0..2).flat_map(move |axis| [i, p].map(|body| [(row + axis, 3 * body + axis), (row + axis, 3 * body + 2)]))
    });
    let entries = joints.flatten().collect();
    SparseKkt::from_entries(&vec![1.0; 3 * n], 2 * (n - 1), entries).unwrap().n_factor_entries()
}

#[test]
fn invariant_factors_of_any_tree_grow_with_its_size() {
    for name in ["binary", "star", "broom", "scattered"] {
        let parent = |i: usize| match name {
            "binary" => (i - 1) / 2,
            "star" => 0,
            "broom" => (i - 1).min(19),
            _ => (i * 7919 + 13) % i,
        };
        let (small, large) = (tree_entries(1_000, parent), tree_entries(10_000, parent));
        println!("{name}: {small} and {large} entries of L");
        assert!(large <= 12 * small && large <= 60 * 10_000, "{name}: {small}, then {large}");
    }
}

#[test]
fn cross_star_is_solved_as_by_the_dense_backend() {
    // a heavy hub with 60 rods around it: more joints than a hub needs to be taken last
    let (n, rows) = (61, 120);
    let angle = |i: usize| 0.1 * i as f64;
    let (mut entries, mut jacobian) = (Vec::new(), Vec::new());
    for i in 1..n {
        for axis in 0..2 {
            let arm = [-angle(i).sin(), angle(i).cos()][axis];
            let row = 2 * (i - 1) + axis;
            for (column, g) in [(3 * i + axis, -1.0), (3 * i + 2, 0.5 * arm), (axis, 1.0), (2, 0.3 * arm)] {
                entries.push((row, column));
                jacobian.push(g);
            }
        }
    }
    let mass: Vec<f64> = (0..3 * n).map(|i| if i < 3 { 50.0 } else { 1.0 + 0.01 * i as f64 }).collect();
    let right_side: Vec<f64> = (0..3 * n + rows).map(|i| (i as f64 * 0.7).sin()).collect();
    let mut kkt = SparseKkt::from_entries(&mass, rows, entries.clone()).unwrap();
    kkt.factor(&jacobian).unwrap();
    let mut sparse = right_side.clone();
    let (r, s) = sparse.split_at_mut(3 * n);
    kkt.solve(r, s);
    let size = 3 * n + rows;
    let mut dense = nalgebra::DMatrix::zeros(size, size);
    (0..3 * n).for_each(|i| dense[(i, i)] = mass[i]);
    for (&(row, column), g) in entries.iter().zip(&jacobian) {
        dense[(3 * n + row, column)] = *g;
        dense[(column, 3 * n + row)] = *g;
    }
    let oracle = dense.lu().solve(&nalgebra::DVector::from_vec(right_side)).unwrap();
    let error = sparse.iter().zip(oracle.iter()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    // rounding times the condition of K, about 1e3
    assert!(error <= 1e-12 * oracle.amax(), "{error:.1e}");
}

#[test]
fn fd_chains_pass_their_checks() {
    for n in [1, 6] {
        assert_checks(&chain::Swing { n });
    }
}

#[test]
fn invariant_ten_thousand_rods_start_and_move_consistently() {
    let scene = chain::Swing { n: 10_000 };
    let run = simulation(&scene).method(Method::rk4(1e-5)).until(3e-5).run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    assert!(run.last().position_residual <= POSITION, "{:.1e}", run.last().position_residual);
    assert!(run.last().velocity_residual <= POSITION, "{:.1e}", run.last().velocity_residual);
}

/// Hinge forces F of a level chain of equal rods obey F_{k−1} + 4 F_k + F_{k+1} = 0, so that each rod turns √3 − 2 times as fast as the one before. What
/// would be 1e-228 of the first one's rate at the last one is nothing: no number becomes so small that the processor takes long for it.
#[test]
fn analytic_rods_of_a_level_chain_turn_less_and_less_and_then_not_at_all() {
    /// Of some tens of operations.
    const ROUNDING: f64 = 64.0 * f64::EPSILON;
    let scene = chain::Released { n: 400 };
    let run = simulation(&scene).method(Method::rk4(1e-4)).until(2e-4).run().unwrap();
    let angular = |of: &[f64]| of.iter().skip(2).step_by(3).copied().collect::<Vec<f64>>();
    let rates = angular(run.first().accelerations);
    let mut expected = rates[0];
    for (k, rate) in rates.iter().enumerate() {
        assert!((rate - expected).abs() <= ROUNDING * rates[0].abs(), "rod {k}: {rate:e}, {expected:e}");
        expected *= 3.0_f64.sqrt() - 2.0;
    }
    let last = run.last();
    for x in [last.coordinates, last.velocities, last.accelerations].into_iter().flat_map(angular) {
        assert!(x == 0.0 || x.abs() >= 1e-100, "{x:e}");
    }
}

#[test]
fn invariant_consistent_start_of_a_long_chain_is_not_touched() {
    let scene = chain::Swing { n: 1_000 };
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let state = system.consistent_start(&system.scene_start()).unwrap();
    let mut again = Start::free(3_000);
    (again.q, again.v) = (state.q.clone(), state.v.clone());
    let second = system.consistent_start(&again).unwrap();
    assert!(second.q == state.q && second.v == state.v);
}

#[test]
fn analytic_held_rods_of_a_long_chain_carry_the_rest_along() {
    // every angle is held, so that the centres follow by themselves; a held speed of the last rod moves it alone
    let scene = chain::Swing { n: 200 };
    let run = simulation(&scene).until(0.0).start("rod[199].omega", 2.0);
    let run = (0..199).fold(run, |run, i| run.start(format!("rod[{i}].omega"), 0.0)).run().unwrap();
    let (sin, cos) = (0.1_f64 * 199.0).sin_cos();
    let first = run.first();
    let [x, y] = ["rod[199].vx", "rod[199].vy"].map(|name| first.get(name).unwrap());
    assert!((x + sin).abs() <= POSITION && (y - cos).abs() <= POSITION, "{x}, {y}");
}

/// The rows of the bearing then hold nothing that is free.
#[test]
fn invariant_rest_of_a_long_chain_follows_a_rod_that_is_given() {
    let (sin, cos) = 0.5_f64.sin_cos();
    let given = [("rod[0].x", 0.5 * cos), ("rod[0].y", 0.5 * sin), ("rod[0].phi", 0.5)];
    let scene = chain::Swing { n: 60 };
    let run = given.iter().fold(simulation(&scene).until(0.0), |run, (name, value)| run.start(*name, *value));
    let run = run.run().unwrap();
    assert!(given.iter().all(|(name, value)| run.first().get(name).unwrap() == *value));
    assert!(run.first().position_residual <= POSITION, "{:.1e}", run.first().position_residual);
}

#[test]
fn invariant_start_that_cannot_be_met_is_refused_at_any_length() {
    let scene = chain::Swing { n: 500 };
    let refused = simulation(&scene).until(0.0).start("rod[499].x", 1e4).run();
    let message = refused.err().map(|error| error.to_string()).unwrap_or_default();
    assert!(message.contains("contradicts the constraints") && message.contains("more"), "{message}");
    assert!(message.len() < 5_000, "{} bytes", message.len());
}

#[test]
fn invariant_backends_that_do_not_fit_are_refused() {
    let refused = |scene: &chain::Swing, backend| system_of(scene, backend).err();
    let (short, long) = (chain::Swing { n: 3 }, chain::Swing { n: 1_000 });
    assert!(matches!(refused(&short, Backend::Generated), Some(SystemError::NoElimination { .. })));
    assert!(matches!(refused(&long, Backend::Dense), Some(SystemError::TooLargeForDense { n: 5_000, .. })));
    let mut system = system_of(&long, Backend::Auto).unwrap();
    let result = system.project_velocities(0.0, &[0.1; 3_000], &mut [0.1; 3_000], Metric::Euclidean);
    assert!(matches!(result, Err(MotionError::EuclideanTooLarge { .. })), "{result:?}");
}

#[test]
fn invariant_count_of_zero_and_far_too_many_are_refused() {
    let fault = |n| match system_of(&chain::Swing { n }, Backend::Auto).err() {
        Some(SystemError::Layout(fault)) => fault,
        other => panic!("{other:?}"),
    };
    assert_eq!(fault(0), LayoutFault::NoMembers { name: "n" });
    assert_eq!(fault(1_000_001).to_string(), "count `n` is 1000001; give it at most 1000000");
    assert_eq!(fault(1 << 50), LayoutFault::LargeCount { name: "n", count: 1 << 50 });
    let net = hanging_net::Swing { rows: 3_000, columns: 3_000, ..Default::default() };
    let net = system_of(&net, Backend::Auto).err();
    assert!(matches!(net, Some(SystemError::Layout(LayoutFault::TooManyMembers { .. }))), "{net:?}");
}

#[test]
fn invariant_description_is_shared_by_all_who_hold_it() {
    let run = simulation(&chain::Swing { n: 12 }).until(0.0).run().unwrap();
    let other = chain::Swing { n: 13 }.info();
    let info = chain::Swing { n: 12 }.info();
    assert!(Arc::ptr_eq(&info, run.info()) && Arc::ptr_eq(&other, &chain::Swing { n: 13 }.info()));
    assert_eq!((&*info.rows[2].name, &*info.rows[23].name), ("pin[1].x", "pin[11].y"));
    assert_eq!((info.n_coordinates(), info.n_position_rows), (36, 24));
}
