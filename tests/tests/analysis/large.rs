//! Scenes with counts: hundreds of equations, whose factors are sparse.

use ezy_core::analysis::{Course, Linearization, SteadyMotion};
use ezy_core::dynamics::System;
use ezy_core::linalg::Backend;
use ezy_core::model::Scene;
use ezy_models::{chain, hanging_net};
use nalgebra::DMatrix;

/// What the tests of LAPACK allow to be left of A x − s x, in n ε ‖A‖ ‖x‖ (its file `nep.in`).
const OF_LAPACK: f64 = 20.0;

/// The steady motion near the start of a scene, its linear equations, and the frequencies of what swings without damping, rad/s, ascending.
fn swinging<S: Scene>(scene: &S) -> (SteadyMotion, Vec<f64>) {
    let mut system = System::new(scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    let linear = Linearization::of(&mut system, &motion).unwrap();
    let spectrum = linear.spectrum().unwrap();
    let mut found: Vec<f64> = spectrum.eigenvalues.iter().map(|s| s.im).filter(|im| *im > 0.0).collect();
    found.sort_by(f64::total_cmp);
    let tolerance = rounding(linear.a.nrows(), found[found.len() - 1]);
    assert!(spectrum.eigenvalues.iter().all(|s| s.re.abs() <= tolerance), "damping in {:?}", spectrum.eigenvalues);
    (motion, found)
}

/// What rounding does to eigenvalues, 1/s: that of a matrix as large as the square of the highest frequency ω, times the condition of its
/// eigenvectors, places and velocities in the ratio 1 s to ω.
///
/// # Source
/// Bauer, Fike (1960).
fn rounding(n: usize, highest: f64) -> f64 {
    n as f64 * f64::EPSILON * highest.powi(3)
}

fn assert_frequencies(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    let tolerance = rounding(2 * expected.len(), expected[expected.len() - 1]);
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance, "{found} rad/s for {expected}");
    }
}

fn roots_of_eigenvalues(matrix: DMatrix<f64>) -> Vec<f64> {
    let mut roots: Vec<f64> = matrix.symmetric_eigen().eigenvalues.iter().map(|x| x.sqrt()).collect();
    roots.sort_by(f64::total_cmp);
    roots
}

/// ω² of K x = ω² M x in the angles of the rods, from their kinetic and potential energy.
#[test]
fn analytic_hanging_chain_of_forty_rods_swings_as_its_energies_say() {
    const N: usize = 40;
    let scene = chain::Swing { n: N, ..Default::default() };
    let (m, l, g) = (scene.m, scene.l, scene.g);
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let mut start = system.scene_start();
    start.q_given.fill(false);
    for (k, body) in start.q.chunks_exact_mut(3).enumerate() {
        // steep, but not straight
        body[2] = -1.4 + 0.1 * (k as f64).sin();
    }
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    assert!(motion.free.is_empty() && motion.course() == Course::Rest);
    let linear = Linearization::of(&mut system, &motion).unwrap();
    let spectrum = linear.spectrum().unwrap();
    let mut found: Vec<f64> = spectrum.eigenvalues.iter().map(|s| s.im).filter(|im| *im > 0.0).collect();
    found.sort_by(f64::total_cmp);

    // of the centre of rod k by the angle of rod i
    let lever = |k: usize, i: usize| if i < k { l } else { 0.5 * l };
    let mass = DMatrix::from_fn(N, N, |i, j| {
        let own = if i == j { m * l * l / 12.0 } else { 0.0 };
        own + (i.max(j)..N).map(|k| m * lever(k, i) * lever(k, j)).sum::<f64>()
    });
    let stiffness: Vec<f64> = (0..N).map(|i| (i..N).map(|k| m * g * lever(k, i)).sum()).collect();
    let scaled = DMatrix::from_fn(N, N, |i, j| mass[(i, j)] / (stiffness[i] * stiffness[j]).sqrt());
    let mut expected: Vec<f64> = roots_of_eigenvalues(scaled).into_iter().map(f64::recip).collect();
    expected.reverse();
    assert_frequencies(&found, &expected);
    // the pin carries all
    let carried = motion.multipliers[1].abs();
    assert!((carried - N as f64 * m * g).abs() <= N as f64 * 1e-13 * carried, "{carried} N");

    let modes = linear.modes(&spectrum).unwrap();
    for mode in &modes {
        let left = linear.a.map(|x| nalgebra::Complex::new(x, 0.0)) * &mode.vector - &mode.vector * mode.eigenvalue;
        let largest = linear.a.norm() * mode.vector.norm();
        assert!(left.norm() <= OF_LAPACK * 2.0 * N as f64 * f64::EPSILON * largest, "{}", mode.eigenvalue);
    }
}

/// Its rows sway like n equal masses on a string: ω² a/g are the roots of the Laguerre polynomial Lₙ, eigenvalues of its Jacobi matrix.
///
/// # Source
/// Lamb, Higher Mechanics, §88, for the string; Golub, Welsch (1969) for the matrix.
#[test]
fn analytic_hanging_net_comes_to_rest_and_sways_row_by_row() {
    const ROWS: usize = 9;
    let scene = hanging_net::Swing { rows: ROWS, columns: 6, ..Default::default() };
    let (motion, found) = swinging(&scene);
    assert_eq!(motion.course(), Course::Rest);
    // nothing turns a knot
    assert_eq!(motion.free.len(), 9 * 6);
    assert!(motion.free.iter().all(|name| name.ends_with(".phi")), "{:?}", motion.free);
    let n = ROWS - 1;
    let laguerre = DMatrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
        0 => 2.0 * i as f64 + 1.0,
        1 => i.max(j) as f64,
        _ => 0.0,
    });
    assert_frequencies(&found, &roots_of_eigenvalues(laguerre * (scene.g / scene.a)));
}

ezy_core::model! {
    /// Rods with springs between them, which nothing holds.
    model Floating {
        count n = 60;
        param l: m = 0.1;
        body link[n] { mass: 1, inertia: 1e-3 }
        for i in 1..n {
            hinge pin[i]: link[i-1](l/2, 0) ~ link[i](-l/2, 0);
            torsion link[i-1] ~ link[i]: stiffness 2, angle 0, damping 0;
        }
        start bent { link[0] at (1, 2) angle 0.3; for i in 1..n { link[i] angle 0.3 + 0.001*i; } at rest; }
        scene drifts { start bent; until 1 s; }
    }
}

#[test]
fn analytic_floating_rods_are_straight_and_free_in_place_and_heading() {
    let scene = floating::Drifts::default();
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    let motion = SteadyMotion::near(&mut system, &start, &[]).unwrap();
    assert_eq!(motion.free.len(), 3, "{:?}", motion.free);
    let angle = motion.state.q[2];
    assert!(motion.state.q.iter().skip(2).step_by(3).all(|phi| (phi - angle).abs() <= 1e-10), "{:?}", motion.state.q);
    let spectrum = Linearization::of(&mut system, &motion).unwrap().spectrum().unwrap();
    assert_eq!((spectrum.n_zero, &spectrum.zero_blocks[..]), (6, &[2, 2, 2][..]));
}
