//! Accelerations and multipliers at one state, by every solver.

// the rope is a velocity constraint on purpose, so that every kind of row is solved for
#![allow(deprecated)]

use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};

model! {
    /// A block that hangs from a wheel by a rope: the rope is a velocity constraint.
    pub model Hoist {
        param m: kg = 3;
        param j: kg*m^2 = 0.4;
        param r: m = 0.25;
        body wheel { mass: 1, inertia: j }
        body block { mass: m, inertia: 1 }
        hinge axle: ground(0, 1) ~ wheel(0, 0);
        slider rail: ground(0, 0) ~ block(0, 0) along ground(0, 1);
        velocity constraint rope: block.vy = -r * wheel.omega;
        gravity (0, -9.81);
        torque wheel: 0.5;
        start still { wheel angle 0; block at (0, 0) angle 0; at rest; }
        scene falls { start still; until 1 s; }
    }
}

/// Rounding of some tens of operations on numbers of 30.
const ROUNDING: f64 = 1e-13;

const BACKENDS: [Backend; 3] = [Backend::Generated, Backend::Dense, Backend::Sparse];

/// (j + m r²) α = m g r + 0.5 N m, and the rope takes m (g − r α). The multiplier opposes it (docs/notation.md).
#[test]
fn analytic_block_on_a_rope_falls_as_the_wheel_lets_it() {
    for (m, j, r) in [(3.0, 0.4, 0.25), (1e-3, 2.0, 0.1), (50.0, 1e-3, 0.5)] {
        let scene = hoist::Falls { m, j, r };
        for backend in BACKENDS {
            let mut system = system_of(&scene, backend).unwrap();
            let (mut a, mut lambda) = ([0.0; 6], [0.0; 5]);
            system.accelerations(0.0, &[0.0, 1.0, 0.0, 0.0, 0.0, 0.0], &[0.0; 6], &mut a, &mut lambda).unwrap();
            let alpha = (m * 9.81 * r + 0.5) / (j + m * r * r);
            let rope = m * (9.81 - r * alpha);
            assert!((a[2] - alpha).abs() <= ROUNDING * alpha.abs(), "{backend:?}: {a:?} {alpha}");
            assert!(
                (a[4] + r * alpha).abs() <= ROUNDING * alpha.abs() && a[3] == 0.0 && a[5] == 0.0,
                "{backend:?}: {a:?}"
            );
            assert!(
                (lambda[4].abs() - rope.abs()).abs() <= ROUNDING * (rope.abs() + 1.0),
                "{backend:?}: {lambda:?} {rope}"
            );
            // the axle carries the wheel; its share of the rope is the rail's reaction on the ground in this model
            assert!(
                (lambda[1].abs() - 9.81).abs() <= ROUNDING * 9.81 && lambda[0].abs() <= ROUNDING,
                "{backend:?}: {lambda:?}"
            );
        }
    }
}

/// After 1 s the block has fallen by r α/2, with every backend and method.
#[test]
fn analytic_block_falls_uniformly() {
    let scene = hoist::Falls::default();
    let alpha = (3.0 * 9.81 * 0.25 + 0.5) / (0.4 + 3.0 * 0.0625);
    for backend in BACKENDS {
        for method in [
            Method::rk4(0.01),
            Method::dop853(1e-10),
            Method::taylor(1e-10),
            Method::gauss(1e-10),
            Method::radau(1e-10),
        ] {
            let run = simulation(&scene).backend(backend).method(method).run().unwrap();
            let y = run.last().get("block.y").unwrap();
            assert!((y + 0.125 * alpha).abs() <= 1e-11, "{backend:?} {method:?}: {y}");
        }
    }
}

model! {
    /// A row of rods whose number a run sets.
    pub model Rope {
        count n = 6;
        param m: kg = 0.5;
        body link[n] { mass: m, inertia: 0.02 }
        hinge top: ground(0, 0) ~ link[0](-0.25, 0);
        for i in 1..n { hinge pin[i]: link[i-1](0.25, 0) ~ link[i](-0.25, 0); }
        gravity (0, -9.81);
        start hanging { for i in 0..n { link[i] angle -pi/2; } at rest; }
        start slanted { for i in 0..n { link[i] angle -0.3*i; } at rest; }
        scene rests { start hanging; until 0.1 s; }
        scene swings { start slanted; until 0.1 s; }
    }
}

/// The hinge above link i carries the links from i on.
#[test]
fn analytic_hanging_rope_carries_its_weight() {
    for (n, backend) in [(1, Backend::Sparse), (6, Backend::Sparse), (6, Backend::Dense), (60, Backend::Sparse)] {
        let scene = rope::Rests { n, ..Default::default() };
        let mut system = system_of(&scene, backend).unwrap();
        let start = system.scene_start();
        let state = system.consistent_start(&start).unwrap();
        let (mut a, mut lambda) = (vec![0.0; 3 * n], vec![0.0; 2 * n]);
        system.accelerations(0.0, &state.q, &state.v, &mut a, &mut lambda).unwrap();
        assert!(a.iter().all(|a| a.abs() <= 1e-10), "{backend:?}: {a:?}");
        for i in 0..n {
            let weight = 9.81 * 0.5 * (n - i) as f64;
            assert!((lambda[2 * i + 1].abs() - weight).abs() <= 1e-10 * weight, "{backend:?} {i}: {lambda:?}");
            assert!(lambda[2 * i].abs() <= 1e-10 * weight, "{backend:?} {i}: {lambda:?}");
        }
    }
}

#[test]
fn cross_sparse_and_dense_accelerations_of_a_rope_agree() {
    let scene = rope::Swings { n: 12, ..Default::default() };
    let [sparse, dense] = [Backend::Sparse, Backend::Dense].map(|backend| {
        let mut system = system_of(&scene, backend).unwrap();
        let start = system.scene_start();
        let state = system.consistent_start(&start).unwrap();
        let (mut a, mut lambda) = (vec![0.0; 36], vec![0.0; 24]);
        system.accelerations(0.0, &state.q, &state.v, &mut a, &mut lambda).unwrap();
        [a, lambda]
    });
    for (x, y) in sparse.iter().flatten().zip(dense.iter().flatten()) {
        assert!((x - y).abs() <= 1e-10, "{x} {y}");
    }
    assert!(sparse[0].iter().any(|a| a.abs() > 1.0), "it falls");
}

/// More than 500 equations: whether rows depend on each other is not asked, but the smallest pivot of the factors is told. With a mass and a
/// lever of one each it is far from zero, and does not depend on the unit of mass.
#[test]
fn invariant_long_rope_tells_the_smallest_pivot_of_its_factors() {
    let pivot = |n, m| {
        let scene = rope::Rests { n, m };
        let run = simulation(&scene).method(Method::rk4(0.01)).until(0.02).run().unwrap();
        assert!(run.outcome.reached_end() && run.rank.intervals.is_empty(), "{}", run.outcome);
        run.monitors.pivot.expect("there are rows").value
    };
    let of_long = pivot(110, 0.5);
    assert!(of_long > 1e-3 && of_long <= 1.0, "{of_long}");
}

/// A body that is nearly massless on a spring: the dense solver takes any ratio of masses, and a body without mass too.
#[test]
fn invariant_masses_that_a_backend_cannot_take_are_refused_by_name() {
    let scene = hoist::Falls { m: 0.0, ..Default::default() };
    for backend in [Backend::Generated, Backend::Sparse] {
        let error = system_of(&scene, backend).err().expect("a body without mass").to_string();
        assert!(error.contains("block"), "{error}");
    }
    let mut system = system_of(&scene, Backend::Dense).unwrap();
    let (mut a, mut lambda) = ([0.0; 6], [0.0; 5]);
    system.accelerations(0.0, &[0.0, 1.0, 0.0, 0.0, 0.0, 0.0], &[0.0; 6], &mut a, &mut lambda).unwrap();
    assert!((a[2] - 0.5 / 0.4).abs() <= ROUNDING && (a[4] + 0.25 * 0.5 / 0.4).abs() <= ROUNDING, "{a:?}");
    let negative = hoist::Falls { m: -1.0, ..Default::default() };
    let error = system_of(&negative, Backend::Auto).err().expect("a negative mass").to_string();
    assert!(error.contains("block") && error.contains("mass"), "{error}");
}
