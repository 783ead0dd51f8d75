//! Constraints that repeat each other: they share forces where they agree, and end a run where they do not.

// that rows repeat others is what the compiler warns of
#![allow(deprecated)]

use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::StopReason;
use ezy_core_tests::simulation;

model! {
    /// A stone that falls between two belts, which carry it along at two points of the same height.
    pub model TwoBelts {
        param front: m = 0.25;
        param rear: m = 0.25;
        /// acceleration of the second belt
        param more: m/s^2 = 0.0;
        body stone { mass: 1.0, inertia: 1.0 }
        velocity constraint first: stone.vx - front*stone.omega = 1;
        velocity constraint second: stone.vx - rear*stone.omega = 1 + more*t;
        gravity (0, -9.81);
        start falling { stone at (0, 0) angle 0 rate 0; }
        scene fall { start falling; until 0.1 s; }
    }
}

/// The time and the message with which belts of different accelerations end a run; `None` when it reaches its end.
fn end_of_belts(more: f64, projection: Projection) -> Option<(f64, String)> {
    let scene = two_belts::Fall { more, ..Default::default() };
    let run = simulation(&scene).method(Method::rk4(1e-4)).project(projection).run().unwrap();
    match run.outcome {
        Outcome::ReachedEnd => None,
        Outcome::Stopped { t, reason: StopReason::Motion(reason @ MotionError::ContradictoryRows { .. }), .. } => {
            Some((t, reason.to_string()))
        }
        other => panic!("{more}: {other:?}"),
    }
}

/// Accelerations may differ by 1e-2 of the largest, which is 9.81 m/s², and velocities by 1e-6 of the largest, which is 1 m/s. After
/// equal shares of the two rows, each leaves about half of the difference.
#[test]
fn analytic_belts_end_a_run_when_their_velocities_part() {
    assert_eq!(end_of_belts(0.0, Projection::Both), None);
    assert_eq!(end_of_belts(5e-6, Projection::Both), None, "they part by 5e-7 m/s");
    let (t, message) = end_of_belts(5e-4, Projection::Both).expect("they part by 5e-5 m/s");
    assert!((1e-3..=1e-2).contains(&t) && message.contains("the velocities"), "{t}: {message}");
}

#[test]
fn analytic_belts_end_a_run_when_their_accelerations_differ() {
    assert_eq!(end_of_belts(2e-2, Projection::None), None, "without projection velocities are not compared");
    let scene = two_belts::Fall { more: 2.0, ..Default::default() };
    let error = simulation(&scene).run().expect_err("a fifth of the largest acceleration").to_string();
    assert!(error.contains("the accelerations") && error.contains("first"), "{error}");
}

model! {
    /// A cart on one axle with one or two wheels.
    pub model Axle {
        param left_x: m = 0.25;
        param right_x: m = 0.25;
        body cart { mass: 2.0, inertia: 0.3 }
        skate left: at cart(left_x, 0.5) along cart(1, 0);
        force at cart(0, 0.3): (1.0, 0.4);
        effect pair { skate right: at cart(right_x, -0.5) along cart(1, 0); }
        start moving { cart at (0, 0) angle 0.3 velocity (0.5, _) rate 0.2; }
        scene one { start moving; until 1 s; }
        scene two { start moving; until 1 s; with pair; }
    }
}

/// What tolerances of 1e-10 leave over a second.
const MOTION: f64 = 1e-9;

#[test]
fn cross_two_wheels_on_one_axle_move_like_one_and_halve_its_force() {
    for method in
        [Method::rk4(1e-3), Method::dop853(1e-10), Method::taylor(1e-10), Method::gauss(1e-10), Method::radau(1e-11)]
    {
        let [one, two] = [&axle::One::default() as &dyn Scene, &axle::Two::default()]
            .map(|scene| simulation(scene).method(method).run().unwrap());
        for (x, y) in one.last().coordinates.iter().zip(two.last().coordinates) {
            assert!((x - y).abs() <= MOTION, "{method:?}: {x} and {y}");
        }
        let (whole, shares) = (one.last().multipliers[0], two.last().multipliers);
        assert!((shares[0] + shares[1] - whole).abs() <= MOTION, "{method:?}: {shares:?} of {whole}");
        assert!((shares[0] - shares[1]).abs() <= 1e-12, "{method:?}: {shares:?}");
        assert_eq!(two.rank.intervals[0].loss.rows, ["left", "right"], "{method:?}");
    }
}

model! {
    /// A bar on three parallel cranks: 12 coordinates, 12 rows of rank 11.
    pub model Cranks {
        body a { mass: 1.0, inertia: 1.0/12 }
        body b { mass: 2.0, inertia: 2.0/12 }
        body c { mass: 3.0, inertia: 3.0/12 }
        body bar { mass: 10.0, inertia: 0.7 }
        hinge A: ground(0, 0) ~ a(-0.5, 0);
        hinge B: ground(1, 0) ~ b(-0.5, 0);
        hinge C: ground(2, 0) ~ c(-0.5, 0);
        hinge P: a(0.5, 0) ~ bar(-1, 0);
        hinge Q: b(0.5, 0) ~ bar(0, 0);
        hinge R: c(0.5, 0) ~ bar(1, 0);
        gravity (0, -9.81);
        start parallel { a angle -0.5; b angle -0.5; c angle -0.5; bar angle 0; at rest; }
        scene swing { start parallel; until 0.5 s; }
    }
}

/// A pendulum: 6 kg m²/3 in the cranks and 10 kg at their ends, I = 12 kg m²; m g l = (3 + 10) kg · 9.81 m/s² · 1 m.
/// Energy gives the rate at each angle: ½ I φ'² = −13 g (sin φ − sin φ₀).
#[test]
fn analytic_parallel_cranks_swing_like_a_pendulum() {
    for (method, bound) in [
        (Method::rk4(1e-2), 1e-6),
        (Method::dop853(1e-11), MOTION),
        (Method::taylor(1e-11), MOTION),
        (Method::gauss(1e-11), MOTION),
        (Method::radau(1e-7), 1e-5),
    ] {
        for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
            let run = simulation(&cranks::Swing::default()).method(method).backend(backend).run().unwrap();
            let last = run.last();
            let (phi, rate) = (last.get("a.phi").unwrap(), last.get("a.omega").unwrap());
            let expected = (2.0 * 13.0 * 9.81 * ((-0.5_f64).sin() - phi.sin()) / 12.0).sqrt();
            assert!((rate + expected).abs() <= bound, "{method:?} {backend:?}: {rate} {expected}");
            assert!(["b.phi", "c.phi"].iter().all(|name| (last.get(name).unwrap() - phi).abs() <= 1e-12));
            assert!(
                last.get("bar.phi").unwrap().abs() <= 1e-12 && last.position_residual <= 1e-12,
                "{method:?} {backend:?}"
            );
            assert_eq!(run.rank.intervals[0].loss.n_redundant, Some(1), "{method:?} {backend:?}");
        }
    }
}
