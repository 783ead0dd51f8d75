//! Scenes with counts beside the same mechanism written out, with and without the feature `sparse`.

use super::starts::chain;
use crate::{simulation, system_of};
use ezy_core::dynamics::SystemError;
use ezy_core::prelude::*;

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
