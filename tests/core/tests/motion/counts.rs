//! Scenes with counts beside the same mechanism written out, with and without the feature `sparse`.

use super::starts::chain;
use ezy_core::dynamics::SystemError;
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};

model! {
    /// The chain of three rods, body by body.
    pub model ThreeRods {
        param first: rad = 0.3;
        body a { mass: 1, inertia: 1/12 }
        body b { mass: 1, inertia: 1/12 }
        body c { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ a(-0.5, 0);
        hinge upper: a(0.5, 0) ~ b(-0.5, 0);
        hinge lower: b(0.5, 0) ~ c(-0.5, 0);
        gravity (0, -9.81);
        start spread { a angle first; b angle first + 0.1; c angle first + 0.2; a rate 1; }
        scene swing { start spread; until 1 s; }
    }
}

model! {
    /// The chain of three rods as an array of a fixed size.
    pub model RodsOfAnArray {
        param first: rad = 0.3;
        body rod[3] { mass: 1, inertia: 1/12 }
        hinge top: ground(0, 0) ~ rod[0](-0.5, 0);
        for i in 1..3 { hinge pin[i]: rod[i-1](0.5, 0) ~ rod[i](-0.5, 0); }
        gravity (0, -9.81);
        start spread { for i in 0..3 { rod[i] angle first + 0.1*i; } rod[0] rate 1; }
        scene swing { start spread; until 1 s; }
    }
}

model! {
    /// Sledges in a row, which hinges and springs join.
    pub model Sledges {
        count n = 4;
        body sledge[n] { mass: 2, inertia: 1/3 }
        for i in 1..n {
            hinge pin[i]: sledge[i-1](0.5, 0.1) ~ sledge[i](-0.5, 0);
            spring sledge[i-1](0.2, 0.3) ~ sledge[i](0, 0.4): stiffness 30, length 0.5, damping 2;
        }
        for i in 0..n { skate runner[i]: at sledge[i](0.1, 0) along sledge[i](1, 0); }
        start row { sledge[0] at (0, 0); for i in 0..n { sledge[i] angle 0; } at rest; }
        scene slide { start row; until 1 s; }
    }
}

/// Of four evaluations a step, of numbers up to 70 (the force of the top hinge, N), if all of it adds up.
const ROUNDING: f64 = 4.0 * 100.0 * 70.0 * f64::EPSILON;

#[test]
fn cross_chain_of_an_array_moves_as_written_out() {
    let end = |scene: &dyn Scene| {
        let run = simulation(scene).method(Method::rk4(0.01)).run().unwrap();
        assert!(run.outcome.reached_end(), "{}", run.outcome);
        let end = run.last();
        [end.coordinates, end.velocities, end.accelerations, end.multipliers].concat()
    };
    let written = end(&three_rods::Swing::default());
    for found in [end(&chain::Swing::default()), end(&rods_of_an_array::Swing::default())] {
        assert_eq!(found.len(), written.len());
        for (found, expected) in found.iter().zip(&written) {
            assert!((found - expected).abs() <= ROUNDING, "{found} {expected}");
        }
    }
}

/// Of angles that are only turned kernels read the table: with that of other angles they give what they give there.
#[test]
fn cross_kernels_of_a_scene_with_counts_take_sines_from_a_table() {
    let scene = sledges::Slide::default();
    let system = system_of(&scene, Backend::Auto).unwrap();
    let (scene, c): (&dyn Equations<f64>, _) = (&scene, system.fixed());
    assert!(scene.takes_sines());
    let info = system.info();
    let number = |i: usize| (1.7 * i as f64).sin();
    let (q, v): (Vec<f64>, Vec<f64>) = (0..12).map(|i| (number(i), number(i + 20))).unzip();
    let table: Vec<[f64; 2]> = q.chunks(3).map(|body| body[2].sin_cos().into()).collect();
    let mut without_angles = q.clone();
    without_angles.chunks_mut(3).for_each(|body| body[2] = f64::NAN);
    let written = |n: usize, write: &dyn Fn(&mut [f64])| {
        let mut out = vec![f64::NAN; n];
        write(&mut out);
        assert!(out.iter().all(|x| x.is_finite()), "{out:?}");
        out
    };
    let [n_h, n_c, n_g] = [info.n_position_rows, info.n_rows(), info.jacobian.n_nonzeros()];
    let x = &without_angles[..];
    let found = [
        written(n_h, &|out| scene.position_constraint_with_sines(c, 0.0, x, &table, out)),
        written(n_c, &|out| scene.velocity_constraint_with_sines(c, 0.0, x, &v, &table, out)),
        written(n_g, &|out| scene.velocity_jacobian_with_sines(c, 0.0, x, &table, out)),
        written(n_c, &|out| scene.convective_term_with_sines(c, 0.0, x, &v, &table, out)),
        written(12, &|out| scene.applied_force_with_sines(c, 0.0, x, &v, &table, out)),
    ];
    let expected = [
        written(n_h, &|out| scene.position_constraint(c, 0.0, &q, out)),
        written(n_c, &|out| scene.velocity_constraint(c, 0.0, &q, &v, out)),
        written(n_g, &|out| scene.velocity_jacobian(c, 0.0, &q, out)),
        written(n_c, &|out| scene.convective_term(c, 0.0, &q, &v, out)),
        written(12, &|out| scene.applied_force(c, 0.0, &q, &v, out)),
    ];
    assert_eq!(found, expected);
    // a scene without counts calls its own
    let scene = three_rods::Swing::default();
    assert!(!Equations::<f64>::takes_sines(&scene));
}

#[test]
fn invariant_only_what_is_too_large_for_the_dense_solver_needs_sparse_factors() {
    // 3 n coordinates and 2 n rows
    let system = |n| system_of(&chain::Swing { n, ..Default::default() }, Backend::Auto).map(|_| ());
    assert_eq!(system(600), Ok(()));
    if cfg!(feature = "sparse") {
        assert_eq!(system(601), Ok(()));
        return;
    }
    let error = system(601).unwrap_err();
    assert_eq!(error, SystemError::WithoutSparse { scene: "swing" });
    assert!(error.to_string().ends_with("add \"sparse\" to its features in Cargo.toml"), "{error}");
}
