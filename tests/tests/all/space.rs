//! A body in space, of which positions are more than velocities: against a closed form, with both explicit methods and projection.

use ezy_core::dynamics::Projection;
use ezy_core::linalg::Backend;
use ezy_core::prelude::*;
use ezy_core::testing::check_scene;
use ezy_core_tests::{simulation, system_of};
use ezy_tests::top::{MASS, Top, attitude};
use serde_json::Value;

const UPRIGHT: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

/// A motion of `answers/free_body.json`: Jacobi's functions, to 25 digits.
struct Reference {
    inertia: [f64; 3],
    omega: [f64; 3],
    samples: Vec<(f64, [f64; 3], [[f64; 3]; 3])>,
}

fn number(value: &Value) -> f64 {
    value.as_str().expect("a number as text").parse().expect("a number")
}

fn vector(value: &Value) -> [f64; 3] {
    std::array::from_fn(|i| number(&value[i]))
}

fn reference(case: &str) -> Reference {
    let all: Value = serde_json::from_str(include_str!("../../answers/free_body.json")).expect("a table");
    let case = &all["cases"][case];
    let samples = case["samples"].as_array().expect("samples").iter();
    let sample = |s: &Value| (number(&s["t"]), vector(&s["w"]), std::array::from_fn(|i| vector(&s["R"][i])));
    Reference { inertia: vector(&case["I"]), omega: vector(&case["w0"]), samples: samples.map(sample).collect() }
}

fn free(reference: &Reference) -> Top {
    Top { inertia: reference.inertia, pin: None, gravity: 0.0, start: (UPRIGHT, reference.omega) }
}

/// The same motion of a body on a pin 1 m below its centre, on the axis of least inertia: the pin feels more by m l² about the other two.
fn pinned(reference: &Reference) -> Top {
    let [i, j, k] = reference.inertia;
    let length = 1.0;
    let more = MASS * length * length;
    Top { inertia: [i - more, j - more, k], pin: Some([0.0, 0.0, -length]), ..free(reference) }
}

/// Largest difference of attitudes and angular velocities at the times of the reference.
fn error(top: &Top, reference: &Reference, method: Method) -> f64 {
    let times: Vec<f64> = reference.samples.iter().map(|sample| sample.0).collect();
    let end = times[times.len() - 1];
    let run = simulation(top).method(method).until(end).at(times).run().unwrap();
    assert_eq!(run.samples().len(), reference.samples.len());
    let mut largest = 0.0_f64;
    for (sample, (t, omega, attitude_there)) in run.samples().zip(&reference.samples) {
        assert!((sample.t - t).abs() <= 1e-12);
        let found = attitude(&sample.coordinates[3..]);
        let pairs = found.as_flattened().iter().zip(attitude_there.as_flattened());
        let pairs = pairs.chain(sample.velocities[3..].iter().zip(omega));
        largest = pairs.fold(largest, |largest, (x, y)| largest.max((x - y).abs()));
        let length = sample.coordinates[3..].iter().map(|p| p * p).sum::<f64>().sqrt();
        // four squares, their sum and the division by its root
        assert!((length - 1.0).abs() <= 4.0 * f64::EPSILON, "{t}: {length}");
    }
    largest
}

/// Error over the tolerance that some hundred steps of at most the tolerance leave, with the tolerance of each number.
const OF_STEPS: f64 = 100.0;

/// The slope of three errors differs from the order by the next term of the error.
const ORDER_TOLERANCE: f64 = 0.1;

#[test]
fn order_of_both_methods_in_space() {
    let reference = reference("about_the_long_axis");
    for top in [free(&reference), pinned(&reference)] {
        for (order, method) in [(4.0, Method::rk4 as fn(f64) -> Method), (2.0, Method::midpoint)] {
            let [coarse, fine] = [0.01, 0.005].map(|step_s| error(&top, &reference, method(step_s)));
            let found = (coarse / fine).log2();
            assert!((found - order).abs() <= ORDER_TOLERANCE, "{order} {found}: {coarse:e} {fine:e}");
        }
    }
}

#[test]
fn oracle_free_and_pinned_body_by_dop853() {
    for case in ["about_the_long_axis", "turns_over"] {
        let reference = reference(case);
        for tolerance in [1e-6, 1e-9, 1e-12] {
            let found = error(&free(&reference), &reference, Method::dop853(tolerance));
            assert!(found <= OF_STEPS * tolerance, "{case} {tolerance:e}: {found:e}");
        }
    }
    let reference = reference("about_the_long_axis");
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let found = error(&pinned(&reference), &reference, Method::dop853(tolerance));
        assert!(found <= OF_STEPS * tolerance, "pinned {tolerance:e}: {found:e}");
    }
}

/// A quick top of this kind leans by θ and goes round with Ω, where I₃ s Ω − I₁ Ω² cos θ = m g l: I about the pin, s the spin about its axis.
#[test]
fn analytic_steady_precession_of_a_heavy_top() {
    let (theta, round, length, gravity) = (0.4_f64, 0.7_f64, 0.5, 9.81);
    let (about_pin, axial) = (0.8, 0.3);
    let spin = (MASS * gravity * length + about_pin * round * round * theta.cos()) / (axial * round);
    let across = about_pin - MASS * length * length;
    let (half_s, half_c) = (0.5 * theta).sin_cos();
    // leans towards x, turned about y; its angular velocity in its own axes
    let omega = [-round * theta.sin(), 0.0, spin];
    let top = Top {
        inertia: [across, across, axial],
        pin: Some([0.0, 0.0, -length]),
        gravity,
        start: ([half_c, 0.0, half_s, 0.0], omega),
    };
    let tolerance = 1e-11;
    let run = simulation(&top).method(Method::dop853(tolerance)).until(10.0).every(0.5).run().unwrap();
    for sample in run.samples() {
        let axis = attitude(&sample.coordinates[3..]).map(|row| row[2]);
        let (s, c) = (round * sample.t).sin_cos();
        let expected = [theta.sin() * c, theta.sin() * s, theta.cos()];
        for ((found, expected), place) in axis.iter().zip(expected).zip(sample.coordinates) {
            assert!((found - expected).abs() <= OF_STEPS * tolerance * spin, "{}: {found} {expected}", sample.t);
            assert!((place - length * expected).abs() <= OF_STEPS * tolerance * spin);
        }
        // the pin carries the weight and turns the centre
        let force = MASS * length * theta.sin() * round * round;
        let expected = [-force * c, -force * s, MASS * gravity];
        let size = MASS * length * spin * spin;
        for (lambda, expected) in sample.multipliers.iter().zip(expected) {
            assert!((-lambda - expected).abs() <= OF_STEPS * tolerance * size, "{lambda} {expected}");
        }
    }
}

/// 2e4 steps of RK4: with projection the quaternion keeps its length and the pin its place to rounding, and energy stays within the error of the steps.
/// Without it the length drifts.
#[test]
fn invariant_quaternion_keeps_its_length_with_projection() {
    let top = Top { gravity: 9.81, ..pinned(&reference("about_the_long_axis")) };
    let lengths = |projection: Projection| {
        let run = simulation(&top).method(Method::rk4(0.01)).project(projection).until(200.0).every(5.0).run();
        let run = run.unwrap();
        let of = |p: &[f64]| p.iter().map(|p| p * p).sum::<f64>().sqrt() - 1.0;
        let lengths = run.samples().map(|sample| of(&sample.coordinates[3..]).abs()).fold(0.0, f64::max);
        let rows = run.samples().map(|sample| sample.position_residual).fold(0.0, f64::max);
        [lengths, rows]
    };
    let [length, rows] = lengths(Projection::Both);
    assert!(length <= 4.0 * f64::EPSILON && rows <= 1e-12, "{length:e} {rows:e}");
    let [drifted, _] = lengths(Projection::None);
    assert!(drifted > 1e-9, "{drifted:e}");
}

/// Displacements along the axes of the velocities: slopes are N(q) v, and rows change by G times them.
#[test]
fn invariant_generic_checks_hold_in_space() {
    let reference = reference("about_the_long_axis");
    for top in [free(&reference), Top { gravity: 9.81, ..pinned(&reference) }] {
        let report = check_scene(&top).unwrap();
        let compared: usize = report.checks.iter().map(|check| check.n_compared).sum();
        assert!(top.pin.is_none() || compared > 0, "{report}");
    }
    let top = pinned(&reference);
    let system = system_of(&top, Backend::Auto).unwrap();
    let (q, v) = ([0.1, -0.2, 0.3, 0.5, -0.5, 0.5, 0.5], [1.0, 2.0, 3.0, 0.3, -0.7, 1.1]);
    let mut rates = [0.0; 7];
    system.position_rates(&q, &v, &mut rates);
    let e = 1e-5;
    let moved = |e: f64| {
        let mut moved = q;
        system.retract(&mut moved, &v.map(|v| e * v));
        moved
    };
    let (ahead, behind) = (moved(e), moved(-e));
    for (i, rate) in rates.iter().enumerate() {
        // e²/6 times a third derivative of some units, and rounding over e
        assert!(((ahead[i] - behind[i]) / (2.0 * e) - rate).abs() <= 1e-9, "{i}");
    }
}

#[test]
fn failure_what_space_does_not_have_is_named() {
    let reference = reference("about_the_long_axis");
    let top = free(&reference);
    for method in [Method::radau(1e-9), Method::gauss(1e-9), Method::taylor(1e-9)] {
        let refused = simulation(&top).method(method).run().unwrap_err().to_string();
        assert!(refused.contains("bodies in space") && refused.contains(method.name()), "{refused}");
    }
    let angle = Method::dop853(1e-9).angle_tolerance(1e-9);
    assert!(simulation(&top).method(angle).run().unwrap_err().to_string().contains("quaternions"));
    let zero = Top { start: ([0.0; 4], [1.0, 0.0, 0.0]), ..top };
    let refused = simulation(&zero).run().unwrap_err().to_string();
    assert!(refused.contains("the quaternion of body `top` is zero"), "{refused}");
    // one of another length is brought to unit length
    let long = Top { start: ([2.0, 0.0, 0.0, 0.0], reference.omega), ..top };
    let run = simulation(&long).until(0.0).run().unwrap();
    assert_eq!(run.first().coordinates[3..], UPRIGHT);
}

#[test]
fn invariant_checkpoint_in_space_goes_on_to_the_last_bit() {
    let top = Top { gravity: 9.81, ..pinned(&reference("about_the_long_axis")) };
    let new = || simulation(&top).method(Method::rk4(0.01)).stepper().unwrap();
    let mut first = new();
    first.step(7).unwrap();
    let checkpoint = first.save();
    first.step(9).unwrap();
    let mut other = new();
    other.restore(&checkpoint).unwrap();
    other.step(9).unwrap();
    assert_eq!(first.state(), other.state());
}

#[test]
fn invariant_columns_and_tables_have_all_positions_and_velocities() {
    let top = pinned(&reference("about_the_long_axis"));
    let run = simulation(&top).until(0.1).every(0.05).run().unwrap();
    let last = run.last();
    assert_eq!((last.coordinates.len(), last.velocities.len(), last.accelerations.len()), (7, 6, 6));
    assert_eq!(last.get("top.k").unwrap(), last.coordinates[6]);
    assert_eq!(last.get("top.omega_z").unwrap(), last.velocities[5]);
    assert_eq!(last.get("top.alpha_z").unwrap(), last.accelerations[5]);
    assert_eq!(last.get("top.az").unwrap(), last.accelerations[2]);
}
