//! Thresholds at their edges: cases a factor of ten to either side, by closed forms.

use crate::analysis::inverse_dynamics::InverseDynamics;
use crate::analysis::linearization::null_space;
use crate::analysis::{AnalysisError, Course, Frame, Rests, Spectrum, SteadyMotion};
use crate::dynamics::State;
use crate::dynamics::system_of;
use crate::linalg::Backend;
use nalgebra::DMatrix;

/// Of the three eigenvalues 2, 1 and x, the last one is zero below 1e-11 of the largest entry, 2.
#[test]
fn analytic_eigenvalue_beside_zero_is_told_from_zero() {
    for (x, n_zero) in [(2e-10, 0), (2e-12, 1)] {
        let spectrum = Spectrum::of(&DMatrix::from_diagonal(&[2.0, 1.0, x].to_vec().into())).unwrap();
        assert_eq!((spectrum.n_zero, spectrum.eigenvalues.len()), (n_zero, 3 - n_zero), "{x}: {spectrum:?}");
    }
}

/// The eigenvalues x ± i of [x 1; −1 x] grow where x is above 1e-8.
#[test]
fn analytic_real_part_beside_zero_says_nothing() {
    for (x, n_unstable, n_neutral) in [(1e-7, 2, 0), (1e-9, 0, 2), (-1e-9, 0, 2), (-1e-7, 0, 0)] {
        let spectrum = Spectrum::of(&DMatrix::from_row_slice(2, 2, &[x, 1.0, -1.0, x])).unwrap();
        assert_eq!((spectrum.n_unstable(), spectrum.n_neutral()), (n_unstable, n_neutral), "{x}: {spectrum:?}");
    }
}

/// Ones above the diagonal and minus ones below: 2 i cos(k π/(n + 1)), k from 1 to n, as of a string of beads.
#[test]
fn analytic_two_hundred_eigenvalues_converge() {
    const N: usize = 200;
    // those of a matrix with orthogonal eigenvectors change by its change: of QR, N ε of its norm, 2, and a few operations an entry
    let tolerance = 10.0 * N as f64 * f64::EPSILON * 2.0;
    let entry = |i: usize, j: usize| match j as f64 - i as f64 {
        1.0 => 1.0,
        -1.0 => -1.0,
        _ => 0.0,
    };
    let spectrum = Spectrum::of(&DMatrix::from_fn(N, N, entry)).unwrap();
    let mut found: Vec<f64> = spectrum.eigenvalues.iter().map(|s| s.im).collect();
    found.sort_by(f64::total_cmp);
    assert_eq!(found.len(), N);
    for (k, found) in found.iter().rev().enumerate() {
        let exact = 2.0 * (std::f64::consts::PI * (k + 1) as f64 / (N + 1) as f64).cos();
        assert!((found - exact).abs() <= tolerance, "{found} for {exact}");
    }
}

/// Rows at an angle of x have the ratio x/2 of their singular values: 1e-10 is the edge.
#[test]
fn analytic_rows_at_a_small_angle_are_told_from_equal_ones() {
    for (angle, n_free) in [(2e-9, 1), (2e-11, 2)] {
        let rows = DMatrix::from_row_slice(2, 3, &[1.0, 0.0, 0.0, 1.0, angle, 0.0]);
        assert_eq!(null_space(rows).unwrap().ncols(), n_free, "{angle}");
    }
}

/// A body 1 m from the origin that runs at 1 m/s and turns by x rad/s goes straight below 1e-9 of the speed.
#[test]
fn analytic_slow_turn_is_straight() {
    for (omega, is_straight) in [(1e-8, false), (1e-10, true)] {
        let motion = SteadyMotion {
            state: State { t: 0.0, q: vec![0.0; 3], v: vec![1.0, 0.0, omega], z: Vec::new(), work: Vec::new() },
            accelerations: vec![0.0; 3],
            multipliers: Vec::new(),
            frame: Frame { vx: 1.0, vy: 0.0, omega },
            free: Vec::new(),
            n_steps: 0,
        };
        assert_eq!(matches!(motion.course(), Course::Straight { .. }), is_straight, "{omega}");
    }
}

crate::model! {
    /// A wheel that rows stop at every half turn, with a weak spiral spring, and a load on its pin.
    pub model Weakly {
        param k: N*m = 0.5;
        body wheel { mass: 1, inertia: 1 }
        hinge pin: ground(0, 0) ~ wheel(0, 0);
        constraint stop: sin(wheel.phi) = 0;
        torsion ground ~ wheel: stiffness k, angle 0, damping 0;
        force at wheel(0, 0): (0, 1 N);
        start still { at rest; }
        scene rests { start still; until 1 s; }
    }
}

/// A turn of the spring changes its moment by 2 π k: it was wound above 1e-10 of the load of 1 N.
#[test]
fn analytic_weak_spring_is_wound_or_not() {
    for (moment, n) in [(1e-9, 3), (1e-11, 2)] {
        let scene = weakly::Rests { k: moment / std::f64::consts::TAU };
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let rests = Rests::of(&mut system, &start, &[], 40).unwrap();
        let angles: Vec<f64> = rests.found.iter().map(|rest| rest.motion.state.q[2]).collect();
        assert_eq!(angles.len(), n, "{moment}: {angles:?}");
    }
}

crate::model! {
    /// Two carts on one rail that are held, and pushed by two inputs of nearly the same effect.
    pub model Carts {
        param apart: N = 0; param load: N = 1;
        input one: N = 0; input two: N = 0;
        body a { mass: 1, inertia: 1 }
        body b { mass: 1, inertia: 1 }
        slider rail_a: ground(0, 0) ~ a(0, 0) along ground(1, 0);
        slider rail_b: ground(0, 0) ~ b(0, 0) along ground(1, 0);
        force at a(0, 0): (one + two + load, 0);
        force at b(0, 0): (one + two*(1 + apart/load) + load, 0);
        drive hold_a: a.x = 0;
        drive hold_b: b.x = 0;
        start still { at rest; }
        scene held { start still; until 1 s; }
    }
}

/// [1 1; 1 1 + x] has the ratio x/4 of its singular values: inputs act alike below 1e-12.
#[test]
fn analytic_inputs_that_act_nearly_alike_are_refused() {
    for (apart, are_alike) in [(4e-11, false), (4e-13, true)] {
        let scene = carts::Held { apart, ..Default::default() };
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let start = system.consistent_start(&system.scene_start()).unwrap();
        let mut inverse = InverseDynamics::new(&system, &["hold_a", "hold_b"], &["one", "two"]).unwrap();
        match inverse.at(&mut system, &start) {
            // together they carry the load
            Ok(found) => assert!(!are_alike && (found.inputs[0] + found.inputs[1] + 1.0).abs() <= 1e-12, "{found:?}"),
            Err(error) => assert!(are_alike && matches!(error, AnalysisError::Alike { .. }), "{apart}: {error}"),
        }
    }
}

crate::model! {
    /// A block on a force whose slope is infinite where it starts.
    pub model Steep {
        param k: N = 3;
        param a: m = 1;
        body block { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        force at block(0, 0): (2 N - k*sqrt(block.x/a), 0);
        start origin { block at (0, 0) angle 0; at rest; }
        start aside { block at (0.1, 0) angle 0; at rest; }
        scene begins { start origin; until 1 s; }
        scene rests { start aside; until 1 s; }
    }
}

#[test]
fn analytic_infinite_slope_is_refused_and_beside_it_there_is_a_rest() {
    let scene = steep::Begins::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let error = SteadyMotion::near(&mut system, &start, &[]).unwrap_err();
    assert!(matches!(error, AnalysisError::NotFinite { scene: "begins" }), "{error}");

    let scene = steep::Rests::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    assert!((motion.state.q[0] - 4.0 / 9.0).abs() <= 1e-12, "{:?}", motion.state.q);
}

crate::model! {
    /// A point mass on a string.
    pub model Plumb {
        body bob { mass: 1, inertia: 0 }
        hinge pin: ground(0, 0) ~ bob(0, 1);
        gravity (0, -9.81);
        start level { bob angle pi/2; at rest; }
        scene hangs { start level; until 1 s; }
    }
}

/// A string that is held level carries no weight: the search ends, however large its numbers become.
#[test]
fn invariant_rest_that_no_force_makes_is_not_found() {
    let scene = plumb::Hangs::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let error = SteadyMotion::near(&mut system, &start, &["bob.x"]).unwrap_err();
    assert!(error.to_string().contains("bob"), "{error}");
}
