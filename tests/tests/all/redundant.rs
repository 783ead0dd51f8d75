//! Rows that repeat others and agree: one motion, the smallest reactions, and a word about it.

// that rows repeat others is what the compiler warns of
#![allow(deprecated)]

use ezy_core::dynamics::MotionError;
use ezy_core::model;
use ezy_core::model::Scene;
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};

model! {
    /// A cart on one axle with two wheels, beside the same with one.
    pub model Axle {
        /// where the left wheel stands
        param left_x: m = 0.25;
        /// where the right wheel stands
        param right_x: m = 0.25;
        body cart { mass: 2.0, inertia: 0.3 }
        skate left: at cart(left_x, 0.5) along cart(1, 0);
        force at cart(0, 0.3): (1.0, 0.4);
        /// The second wheel.
        effect pair { skate right: at cart(right_x, -0.5) along cart(1, 0); }
        start moving { cart at (0, 0) angle 0.3 velocity (0.5, _) rate 0.2; }
        scene one { start moving; until 1 s; }
        scene two { start moving; until 1 s; with pair; }
    }
}

model! {
    /// A bar on two parallel cranks that are both driven.
    pub model TwoMotors {
        /// speed of the first motor
        param omega: rad/s = 1.0;
        /// acceleration of the second motor beyond that of the first
        param more: rad/s^2 = 0.0;
        body left { mass: 1.0, inertia: 0.1 }
        body right { mass: 1.0, inertia: 0.1 }
        body bar { mass: 1.0, inertia: 0.3 }
        hinge A: ground(0, 0) ~ left(-0.5, 0);
        hinge B: left(0.5, 0) ~ bar(-1, 0);
        hinge C: right(0.5, 0) ~ bar(1, 0);
        hinge D: ground(2, 0) ~ right(-0.5, 0);
        drive first: left.phi = 1 + omega*t;
        drive second: right.phi = 1 + omega*t + more*t^2/2;
        start turning { bar near angle 0; }
        scene turn { start turning; until 0.4 s; }
    }
}

model! {
    /// A bar on five equal cranks of 1 kg to 5 kg: 18 coordinates, 20 rows of rank 17.
    pub model FiveCranks {
        /// angle of the cranks from the upright
        param from_top: rad = 2.1;
        body a { mass: 1.0, inertia: 1.0/12 }
        body b { mass: 2.0, inertia: 2.0/12 }
        body c { mass: 3.0, inertia: 3.0/12 }
        body d { mass: 4.0, inertia: 4.0/12 }
        body e { mass: 5.0, inertia: 5.0/12 }
        body bar { mass: 10.0, inertia: 0.7 }
        hinge A: ground(0, 0) ~ a(-0.5, 0);
        hinge B: ground(1, 0) ~ b(-0.5, 0);
        hinge C: ground(2, 0) ~ c(-0.5, 0);
        hinge D: ground(3, 0) ~ d(-0.5, 0);
        hinge E: ground(4, 0) ~ e(-0.5, 0);
        hinge P: a(0.5, 0) ~ bar(-2, 0);
        hinge Q: b(0.5, 0) ~ bar(-1, 0);
        hinge R: c(0.5, 0) ~ bar(0, 0);
        hinge S: d(0.5, 0) ~ bar(1, 0);
        hinge T: e(0.5, 0) ~ bar(2, 0);
        gravity (0, -9.81);
        start parallel {
            a angle pi/2 - from_top; b angle pi/2 - from_top; c angle pi/2 - from_top;
            d angle pi/2 - from_top; e angle pi/2 - from_top; bar angle 0; at rest;
        }
        scene swing { start parallel; until 0.5 s; }
    }
}

model! {
    /// A stone that falls between two belts, which carry it along at two points of the same height.
    pub model TwoBelts {
        param speed: m/s = 1.0;
        param front: m = 0.25;
        param rear: m = 0.25;
        /// acceleration of the second belt beyond that of the first
        param more: m/s^2 = 0.0;
        body stone { mass: 1.0, inertia: 1.0 }
        velocity constraint first: stone.vx - front*stone.omega = speed;
        velocity constraint second: stone.vx - rear*stone.omega = speed + more*t;
        gravity (0, -9.81);
        start falling { stone at (0, 0) angle 0 rate 0; }
        scene fall { start falling; until 0.1 s; }
    }
}

/// What tolerances of 1e-10 leave of positions over a second.
const MOTION: f64 = 1e-9;

/// Rounding of multipliers around 1 N: of two equal rows each takes half, by a solution without damping.
const SHARES: f64 = 1e-12;

const METHODS: [Method; 5] =
    [Method::rk4(1e-3), Method::dop853(1e-10), Method::taylor(1e-10), Method::gauss(1e-10), Method::radau(1e-11)];

#[test]
fn cross_two_wheels_on_one_axle_move_like_one() {
    for method in METHODS {
        for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
            let order = |scene: &dyn Scene| simulation(scene).method(method).backend(backend).run().unwrap();
            let one = order(&axle::One::default());
            let two = order(&axle::Two::default());
            for (x, y) in one.last().coordinates.iter().zip(two.last().coordinates) {
                assert!((x - y).abs() <= MOTION, "{method:?} {backend:?}: {x} and {y}");
            }
            let (whole, shares) = (one.last().multipliers[0], two.last().multipliers);
            assert!((shares[0] + shares[1] - whole).abs() <= MOTION, "{method:?} {backend:?}: {shares:?} of {whole}");
            // both wheels have the same row
            assert!((shares[0] - shares[1]).abs() <= SHARES, "{method:?} {backend:?}: {shares:?}");
            let loss = &two.rank.intervals[0].loss;
            assert_eq!(loss.n_redundant, Some(1));
            assert_eq!(loss.rows, ["left", "right"]);
        }
    }
}

#[test]
fn analytic_wheels_beside_one_axle_are_independent() {
    let scene = axle::Two { right_x: 0.3, ..Default::default() };
    let run = simulation(&scene).method(Method::rk4(1e-3)).start("cart.omega", 0.0).run().unwrap();
    assert!(run.rank.intervals.is_empty());
}

#[test]
fn analytic_motors_that_agree_share_the_work_and_others_are_an_error() {
    for method in METHODS {
        let run = simulation(&two_motors::Turn::default()).method(method).run().unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        let scene = two_motors::Turn { more: 0.5, ..Default::default() };
        let error = simulation(&scene).method(method).run().unwrap_err().to_string();
        assert!(error.contains("contradict each other") && error.contains("first, second"), "{method:?}: {error}");
    }
}

/// Over 0.4 s the second motor gets ahead by 0.08 s² of what is more: the cranks differ by half of that.
#[test]
fn analytic_motors_that_part_are_followed_to_a_tenth_of_a_nanometre() {
    let outcome = |more| {
        let scene = two_motors::Turn { more, ..Default::default() };
        simulation(&scene).method(Method::rk4(0.01)).run().unwrap().outcome.to_string()
    };
    let (agree, differ) = (outcome(4e-10), outcome(4e-8));
    assert!(agree.starts_with("reached the end"), "{agree}");
    assert!(differ.contains("contradict each other") && differ.contains("of the positions"), "{differ}");
}

/// A step that is long beside 1e-6 of the speed, and short beside 1e-4 of it.
const STEP_S: f64 = 1e-3;

#[test]
fn analytic_belts_that_differ_are_refused_where_they_begin_to() {
    // as shares of 9.81 m/s² and of 1 m/s: what the belts ask for differs by this after a step
    for (more, level) in [(1.0, "of the accelerations"), (0.02, "of the velocities")] {
        let scene = two_belts::Fall { more, ..Default::default() };
        let run = simulation(&scene).method(Method::rk4(STEP_S)).run();
        let (at, message) = match run {
            Err(error) => (0.0, error.to_string()),
            Ok(run) => (run.last().t, run.outcome.to_string()),
        };
        assert!(at == 0.0 && message.contains("contradict") && message.contains("first, second"), "{at} s: {message}");
        assert!(message.contains(level.trim_start_matches("of ")), "{more}: {message}");
    }
}

/// The closed form I φ'' = m g l sin φ at 0.5 s, with 21 digits.
const FIVE_CRANKS: [(f64, f64); 2] = [(2.1, 3.148_641_106_523_704), (0.2, 0.555_840_754_099_477_2)];

#[test]
fn reference_five_cranks_swing_like_one_and_three_rows_are_redundant() {
    for method in
        [Method::rk4(5e-3), Method::dop853(1e-9), Method::taylor(1e-9), Method::gauss(1e-9), Method::radau(1e-10)]
    {
        for (from_top, expected) in FIVE_CRANKS {
            let scene = five_cranks::Swing { from_top };
            let run = simulation(&scene).method(method).run().unwrap();
            let last = run.last();
            let phi = std::f64::consts::FRAC_PI_2 - last.coordinates[2];
            assert!((phi - expected).abs() <= 1e-8, "{method:?}: {phi}");
            assert!((0..5).all(|i| (last.coordinates[3 * i + 2] - last.coordinates[2]).abs() <= 1e-12));
            let loss = &run.rank.intervals[0].loss;
            assert_eq!((loss.n_redundant, loss.freedom()), (Some(3), Some(1)), "{method:?}");
        }
    }
}

#[test]
fn analytic_check_of_a_wheel_pair_tells_its_freedom_and_its_redundant_row() {
    let report = ezy_core::testing::check_scene(&axle::Two::default()).unwrap();
    let loss = report.rank.clone().unwrap();
    assert_eq!((loss.n_redundant, loss.freedom()), (Some(1), Some(2)));
    assert_eq!(loss.rows, ["left", "right"]);
    assert!(report.to_string().contains("rank 1 of 2, degrees of freedom: 2"), "{report}");
}

const BACKENDS: [Backend; 3] = [Backend::Generated, Backend::Dense, Backend::Sparse];

/// A cart that turns and slips: one wheel at `right_x`, the other at 0.25 m.
fn accelerations_of_axle(right_x: f64, backend: Backend) -> (Result<[f64; 5], MotionError>, bool) {
    let scene = axle::Two { right_x, ..Default::default() };
    let mut system = system_of(&scene, backend).unwrap();
    let mut x = [0.0; 5];
    let (a, lambda) = x.split_at_mut(3);
    let outcome = system.accelerations(0.0, &[0.0, 0.0, 0.3], &[0.5, 0.1, 2.0], a, lambda);
    let is_deficient = outcome.as_ref().is_ok_and(|solved| solved.is_rank_deficient);
    (outcome.map(|_| x), is_deficient)
}

/// Rounding of accelerations of 1 m/s² over a distance of wheels of 3e-6 m is 1e-10 rad/s².
const NEARLY_ONE_AXLE: f64 = 1e-9;

#[test]
fn analytic_wheels_nearly_on_one_axle_hold_the_cart() {
    for backend in BACKENDS {
        for apart in [1e-3, 3e-6] {
            let (solved, lost) = accelerations_of_axle(0.25 + apart, backend);
            // both slip by rows that ask for −ω v along the cart: their difference asks for no angular acceleration
            let alpha = solved.unwrap()[2];
            assert!(!lost && alpha.abs() <= NEARLY_ONE_AXLE, "{backend:?}, {apart:e} m apart: {alpha:e}");
        }
    }
}

#[test]
fn invariant_wheels_within_rounding_of_one_axle_are_refused_by_name() {
    for backend in BACKENDS {
        let message = accelerations_of_axle(0.25 + 1e-9, backend).0.unwrap_err().to_string();
        assert!(
            message.contains("lost in rounding") && message.contains("(left, right; smallest"),
            "{backend:?}: {message}"
        );
    }
}

#[test]
fn analytic_accelerations_of_motors_that_differ_are_refused_by_name() {
    for (more, agrees) in [(0.0, true), (1e-6, false), (0.5, false)] {
        let scene = two_motors::Turn { more, ..Default::default() };
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let state = system.consistent_start(&system.scene_start()).unwrap();
        let (mut a, mut lambda) = (vec![0.0; state.q.len()], vec![0.0; system.info().n_rows()]);
        let outcome = system.accelerations(state.t, &state.q, &state.v, &mut a, &mut lambda);
        assert_eq!(outcome.is_ok(), agrees, "{more}: {outcome:?}");
        assert!(agrees || outcome.unwrap_err().to_string().contains("first, second"), "{more}");
    }
}
