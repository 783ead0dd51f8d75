//! The Segway: it stands, and its loop has the eigenvalues and the margin of the linear equations.

use crate::examples::segway::segway::Balance;
use crate::examples::segway::{GAINS, GOAL, controller};
use ezy_core::prelude::*;
use std::f64::consts::FRAC_PI_2;

#[test]
fn invariant_rider_stays_upright_and_arrives() {
    for tilt in [-8.0, 0.0, 5.0] {
        let scene = Balance { tilt, ..Default::default() };
        let run = Simulation::new(&scene).method(Method::rk4(2e-3)).outputs().every(0.1).until(30.0);
        let run = run.control(controller(1.0, GOAL)).run().unwrap();
        assert!(run.column("output.lean").unwrap().iter().all(|lean| lean.abs() < 20.0), "{tilt}");
        // the slowest pair of eigenvalues, -0.40 ± 0.51i, leaves e^-12 of two metres
        assert!((run.last().get("wheel.x").unwrap() - GOAL).abs() < 1e-3, "{tilt}");
    }
}

/// a₀ … a₄ of the loop with a part of the gains, from Lagrange's equations in the place x of the axle and the lean θ:
/// (3/2 M + m) ẍ + m l θ̈ = −τ/r and m l ẍ + (I + m l²) θ̈ − m g l θ = τ with τ = −part (k₁ θ + k₂ θ̇ + k₃ x + k₄ ẋ).
fn characteristic(s: &Balance, part: f64) -> [f64; 5] {
    let [k1, k2, k3, k4] = GAINS.map(|gain| part * gain);
    let (m, ml) = (s.m_rider, s.m_rider * s.l);
    let rows = [
        [[-k3 / s.r, -k4 / s.r, 1.5 * s.m_wheel + m], [-k1 / s.r, -k2 / s.r, ml]],
        [[k3, k4, ml], [k1 - ml * s.g, k2, s.i_rider + ml * s.l]],
    ];
    let mut a = [0.0; 5];
    for i in 0..3 {
        for j in 0..3 {
            a[i + j] += rows[0][0][i] * rows[1][1][j] - rows[0][1][i] * rows[1][0][j];
        }
    }
    a
}

/// Routh and Hurwitz: all roots have a negative real part.
fn is_stable([a0, a1, a2, a3, a4]: [f64; 5]) -> bool {
    a4 > 0.0 && a3 > 0.0 && a2 > 0.0 && a0 > 0.0 && a3 * a2 * a1 > a4 * a1 * a1 + a3 * a3 * a0
}

/// The part of the gains below which it does not stand.
fn least_part(s: &Balance) -> f64 {
    let (mut falls, mut stands) = (0.1, 1.0);
    for _ in 0..60 {
        let middle = 0.5 * (falls + stands);
        *if is_stable(characteristic(s, middle)) { &mut stands } else { &mut falls } = middle;
    }
    stands
}

/// Steps of differences, and what central ones of them are off by, relative to the largest coefficient.
const STEP: f64 = 1e-5;
const DIFFERENCES: f64 = 1e-7;

#[test]
fn fd_loop_has_the_characteristic_polynomial_of_the_linear_equations() {
    let scene = Balance::default();
    let mut stepper = Simulation::new(&scene).method(Method::rk4(1e-3)).stepper().unwrap();
    let mut rates = |[x, lean, vx, lean_rate]: [f64; 4]| {
        let given = [("wheel.x", x), ("rider.phi", FRAC_PI_2 - lean), ("wheel.vx", vx), ("rider.omega", -lean_rate)];
        stepper.reset_with(&given).unwrap();
        let [k1, k2, k3, k4] = GAINS;
        stepper.set().motor = -(k1 * lean + k2 * lean_rate + k3 * x + k4 * vx);
        let a = stepper.accelerations().unwrap();
        [vx, lean_rate, a[0], -a[5]]
    };
    let mut matrix = [[0.0; 4]; 4];
    for k in 0..4 {
        let mut at = |by: f64| rates(std::array::from_fn(|i| if i == k { by } else { 0.0 }));
        let (above, below) = (at(STEP), at(-STEP));
        for (i, row) in matrix.iter_mut().enumerate() {
            row[k] = (above[i] - below[i]) / (2.0 * STEP);
        }
    }
    let a = characteristic(&scene, 1.0);
    let largest = a.iter().fold(0.0_f64, |most, a_k| most.max((a_k / a[4]).abs()));
    for (found, a_k) in faddeev(matrix).into_iter().zip(a) {
        assert!((found - a_k / a[4]).abs() <= DIFFERENCES * largest, "{found} {}", a_k / a[4]);
    }
}

/// Coefficients of det(s − A), by the method of Faddeev and LeVerrier.
fn faddeev(matrix: [[f64; 4]; 4]) -> [f64; 5] {
    let mut coefficients = [0.0, 0.0, 0.0, 0.0, 1.0];
    let mut m = [[0.0; 4]; 4];
    for k in 1..=4 {
        let times = |m: [[f64; 4]; 4]| {
            let entry = |i: usize, j: usize| (0..4).map(|l| matrix[i][l] * m[l][j]).sum::<f64>();
            std::array::from_fn::<[f64; 4], 4, _>(|i| std::array::from_fn(|j| entry(i, j)))
        };
        m = times(m);
        (0..4).for_each(|i| m[i][i] += coefficients[5 - k]);
        let product = times(m);
        coefficients[4 - k] = -(0..4).map(|i| product[i][i]).sum::<f64>() / k as f64;
    }
    coefficients
}

/// How far below and above the margin: more than a controller that acts each 2 ms moves it.
const BESIDE: f64 = 0.05;

#[test]
fn cross_gain_margin_is_that_of_the_linear_equations() {
    let scene = Balance { tilt: 0.01, ..Default::default() };
    let least = least_part(&scene);
    assert!(least < 0.9, "no margin: {least}");
    let swings = |part: f64| {
        let run = Simulation::new(&scene).method(Method::rk4(2e-3)).every(0.05).until(80.0);
        let run = run.control(controller(part, 0.0)).run().unwrap();
        let angles = run.column("rider.phi").unwrap();
        let most = |angles: &[f64]| angles.iter().fold(0.0_f64, |most, angle| most.max((angle - FRAC_PI_2).abs()));
        let quarter = angles.len() / 4;
        most(&angles[3 * quarter..]) / most(&angles[quarter..2 * quarter])
    };
    let [below, above] = [1.0 - BESIDE, 1.0 + BESIDE].map(|beside| swings(least * beside));
    assert!(below > 1.0 && above < 1.0, "{least}: {below} {above}");
}
