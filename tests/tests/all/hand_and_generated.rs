//! Every kernel of the generated scenes against the scene written by hand, at random states; and what the generated
//! ones cost.

use crate::scenes::distance;
use ezy_core::model::Scene;
use ezy_models::ezy_roller;
use ezy_tests::hand_roller::HandRoller;

const N_STATES: usize = 2000;
/// Sums of a handful of products of numbers up to ten.
const KERNEL: f64 = 1e-13;
/// The same through K, whose condition is 1e3 to 1e4 and whose light body multiplies rounding by 200; relative.
const SOLUTION: f64 = 1e-12;
/// Multiplications, additions and divisions of one evaluation of the accelerations of the driven scene; a dense LU of K
/// takes 800.
const MOST_OPERATIONS: usize = 100;

/// A state, not on the constraints: the kernels agree everywhere.
struct State {
    t: f64,
    q: Vec<f64>,
    v: Vec<f64>,
}

/// Weyl sequence in thirteen dimensions: fills the box evenly and is the same each time.
fn states() -> impl Iterator<Item = State> {
    let primes: [f64; 13] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0, 31.0, 37.0, 41.0];
    (1..=N_STATES).map(move |n| {
        let x = primes.map(|p| 2.0 * (n as f64 * p.sqrt()).fract() - 1.0);
        State {
            t: 30.0 * (1.0 + x[12]),
            q: (0..6).map(|i| x[i] * if i % 3 == 2 { 4.0 } else { 2.0 }).collect(),
            v: (6..12).map(|i| 3.0 * x[i]).collect(),
        }
    })
}

/// Each scene by hand and generated.
fn pairs() -> [[Box<dyn Scene>; 2]; 2] {
    [
        [Box::new(HandRoller::coast()), Box::new(ezy_roller::Coast::default())],
        [Box::new(HandRoller::driven()), Box::new(ezy_roller::Driven::default())],
    ]
}

fn constants(scene: &dyn Scene) -> Vec<f64> {
    let mut c = vec![0.0; scene.info().n_fixed()];
    scene.constants(&scene.parameters(), &mut c);
    c
}

/// Largest difference over all states of what `kernel` gives by hand and generated, relative to its size.
fn largest_difference(kernel: impl Fn(&dyn Scene, &[f64], &State) -> Vec<f64>) -> f64 {
    let mut worst = 0.0_f64;
    for [hand, generated] in pairs() {
        let (c_hand, c_generated) = (constants(&*hand), constants(&*generated));
        for state in states() {
            let x = kernel(&*hand, &c_hand, &state);
            let y = kernel(&*generated, &c_generated, &state);
            let size = x.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
            let error = distance(&x, &y) / size;
            assert!(!error.is_nan());
            worst = worst.max(error);
        }
    }
    worst
}

/// Calls a kernel that writes `n` numbers.
fn written(n: usize, write: impl FnOnce(&mut [f64])) -> Vec<f64> {
    let mut out = vec![f64::NAN; n];
    write(&mut out);
    out
}

#[test]
fn cross_constraints_and_rates() {
    let error = largest_difference(|s, c, State { t, q, v }| {
        let positions = written(2, |out| s.position_constraint(c, *t, q, out));
        let velocities = written(4, |out| s.velocity_constraint(c, *t, q, v, out));
        [positions, velocities].concat()
    });
    assert!(error <= KERNEL, "{error:.1e}");
}

#[test]
fn cross_jacobian() {
    let error = largest_difference(|s, c, State { t, q, .. }| {
        let pattern = &s.info().jacobian;
        let entries = written(pattern.n_nonzeros(), |out| s.velocity_jacobian(c, *t, q, out));
        let mut full = vec![0.0; 24];
        pattern.entries().for_each(|(k, row, column)| full[6 * row + column] = entries[k]);
        full
    });
    assert!(error <= KERNEL, "{error:.1e}");
}

#[test]
fn cross_convective_terms() {
    let error = largest_difference(|s, c, State { t, q, v }| written(4, |out| s.convective_term(c, *t, q, v, out)));
    assert!(error <= KERNEL, "{error:.1e}");
}

#[test]
fn cross_masses_forces_and_powers() {
    let error = largest_difference(|s, c, State { t, q, v }| {
        let masses = written(6, |out| s.mass_matrix(c, out));
        let forces = written(6, |out| s.applied_force(c, *t, q, v, out));
        let powers = written(s.info().n_effects(), |out| s.power(c, *t, q, v, &v[..4], out));
        [masses, forces, powers].concat()
    });
    assert!(error <= KERNEL, "{error:.1e}");
}

#[test]
fn cross_points_by_name() {
    let error = largest_difference(|s, c, State { t, q, .. }| {
        let points = written(6, |out| s.points(c, *t, q, out));
        let place = |name| s.info().points.iter().position(|p| p.name == name).expect("a point of the model");
        ["A", "B", "C"].map(place).iter().flat_map(|i| [points[2 * i], points[2 * i + 1]]).collect()
    });
    assert!(error <= KERNEL, "{error:.1e}");
}

#[test]
fn cross_accelerations_and_multipliers() {
    let error = largest_difference(|s, c, State { t, q, v }| {
        let (mut a, mut lambda) = (vec![0.0; 6], vec![0.0; 4]);
        assert!(s.accelerations(c, *t, q, v, &mut a, &mut lambda).all_keep());
        [a, lambda].concat()
    });
    assert!(error <= SOLUTION, "{error:.1e}");
}

#[test]
fn cross_corrections() {
    let error = largest_difference(|s, c, State { t, q, v }| {
        let mut delta = vec![0.0; 6];
        assert!(s.correction(c, *t, q, &v[..4], &mut delta).all_keep());
        delta
    });
    assert!(error <= SOLUTION, "{error:.1e}");
}

#[test]
fn regress_operations_of_the_driven_scene() {
    let operations = ezy_roller::Driven::default().info().acceleration_operations;
    assert!(operations.arithmetic() <= MOST_OPERATIONS, "{operations:?}");
    // one pair for each angle, one for the torque
    assert!(operations.trig <= 3, "{operations:?}");
}
