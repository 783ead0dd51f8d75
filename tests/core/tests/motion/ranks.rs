//! Rows that depend on each other: how many, which, and what is said where a motion cannot go on because of it.

// that rows repeat others is what the compiler warns of
#![allow(deprecated)]

use super::redundant::{cranks, two_belts};
use super::singular::parallelogram;
use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::{SetupError, StopReason};
use ezy_core_tests::{simulation, system_of};

model! {
    /// Blocks that two rows each hold at the same place, and that are pushed.
    pub model Doubled {
        count n = 3;
        param apart: m = 0;
        body block[n] { mass: 2, inertia: 1 }
        for i in 0..n {
            constraint first[i]: block[i].x = 0;
            constraint again[i]: 2 * block[i].x = 2 * apart;
            force at block[i](0, 0): (6 + i, 4);
        }
        start here { for i in 0..n { block[i] at (0, 0) angle 0; } at rest; }
        scene pushed { start here; until 0.1 s; }
    }
}

model! {
    /// Two bars between two fixed points, which they just reach.
    pub model Stretched {
        param apart: m = 2;
        body left { mass: 1, inertia: 1/12 }
        body right { mass: 1, inertia: 1/12 }
        hinge A: ground(0, 0) ~ left(-0.5, 0);
        hinge B: left(0.5, 0) ~ right(-0.5, 0);
        hinge C: right(0.5, 0) ~ ground(apart, 0);
        gravity (0, -9.81);
        start straight { left angle 0; right angle 0; at rest; }
        start bent { left near angle 0.5; right near angle (-0.5); at rest; }
        scene hangs { start straight; until 0.1 s; }
        scene hinged { start bent; until 0.1 s; }
    }
}

model! {
    /// A crank that is driven farther than its rod reaches.
    pub model ShortRod {
        param omega: rad/s = 1.0;
        body crank { mass: 1.0, inertia: 0.1 }
        body rod { mass: 1.0, inertia: 0.1 }
        body block { mass: 1.0, inertia: 0.1 }
        hinge A: ground(0, 0) ~ crank(0, 0);
        hinge B: crank(1, 0) ~ rod(0, 0);
        hinge C: rod(0.5, 0) ~ block(0, 0);
        slider guide: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        drive motor: crank.phi = 0.2 + omega*t;
        start turning { rod near angle (-0.4); }
        scene turn { start turning; until 1 s; }
    }
}

model! {
    /// A cart with two wheels across nearly one axle.
    pub model Axle {
        param apart: m = 0;
        body cart { mass: 2.0, inertia: 0.3 }
        skate left: at cart(0.25, 0.5) along cart(1, 0);
        skate right: at cart(0.25 + apart, -0.5) along cart(1, 0);
        force at cart(0, 0.3): (1.0, 0.4);
        start moving { cart at (0, 0) angle 0.3 velocity (0.5, _) rate 0; }
        scene rolls { start moving; until 1 s; }
    }
}

const BACKENDS: [Backend; 3] = [Backend::Generated, Backend::Dense, Backend::Sparse];

fn start_of<S: Scene + ?Sized>(system: &mut System<&S>) -> State {
    let start = system.scene_start();
    system.consistent_start(&start).unwrap()
}

/// Three parallel cranks: a row too many everywhere; in the level position, where bar and cranks are in one line, two.
#[test]
fn analytic_rank_of_parallel_cranks() {
    let scene = cranks::Swing::default();
    for backend in BACKENDS {
        let mut system = system_of(&scene, backend).unwrap();
        let state = start_of(&mut system);
        let loss = system.rank_loss(0.0, &state.q);
        assert_eq!((loss.n_coordinates, loss.n_rows, loss.n_redundant, loss.freedom()), (12, 12, Some(1), Some(1)));
        let names = "A.x, A.y, B.x, B.y, C.x, C.y, P.x, P.y, Q.x, Q.y, R.x, R.y";
        assert_eq!(loss.rows.join(", "), names);
        let expected = format!("rank 11 of 12, degrees of freedom: 1; these depend on each other: {names}");
        assert_eq!(loss.to_string(), expected);
        let level = [0.5, 0.0, 0.0, 1.5, 0.0, 0.0, 2.5, 0.0, 0.0, 2.0, 0.0, 0.0];
        let loss = system.rank_loss(0.0, &level);
        assert_eq!((loss.n_redundant, loss.freedom()), (Some(2), Some(2)), "{loss}");
        assert_eq!(loss.rows.join(", "), "A.x, B.x, C.x, P.x, Q.x, R.x", "those along the line of all bars");
    }
    let stretched = stretched::Hangs::default();
    let mut system = system_of(&stretched, Backend::Auto).unwrap();
    let loss = system.rank_loss(0.0, &[0.5, 0.0, 0.0, 1.5, 0.0, 0.0]);
    assert_eq!((loss.n_redundant, loss.freedom()), (Some(1), Some(1)));
    assert_eq!(loss.rows, ["A.x", "B.x", "C.x"]);
    let loss = system.rank_loss(0.0, &[0.5, 0.0, 0.3, 1.5, 0.0, -0.2]);
    assert_eq!((loss.n_redundant, loss.freedom(), loss.rows.len()), (Some(0), Some(0), 0));
}

/// Up to 500 equations it is told which rows depend on each other, beyond that one of them does: 5 equations a block. Each of the two rows
/// takes the share of the push that goes with its size: with rows scaled to one half of it, so that λ and 2 λ' are 3 N.
#[test]
fn analytic_doubled_rows_share_a_push_in_systems_of_any_size() {
    for (n, backend, redundant) in [
        (3, Backend::Dense, Some(3)),
        (3, Backend::Sparse, Some(3)),
        (100, Backend::Sparse, Some(100)),
        (101, Backend::Sparse, None),
    ] {
        let scene = doubled::Pushed { n, ..Default::default() };
        let mut system = system_of(&scene, backend).unwrap();
        let state = start_of(&mut system);
        let (mut a, mut lambda) = (vec![0.0; 3 * n], vec![0.0; 2 * n]);
        let solved = system.accelerations(0.0, &state.q, &state.v, &mut a, &mut lambda).unwrap();
        assert!(solved.is_rank_deficient, "{n} {backend:?}");
        // beyond 500 equations rows are damped by 1e-9: rounding of 1e-16 over that
        let within = if redundant.is_some() { 1e-12 } else { 1e-6 };
        for i in 0..n {
            let push = 6.0 + i as f64;
            assert!(a[3 * i].abs() <= 1e-9 && (a[3 * i + 1] - 2.0).abs() <= 1e-12 && a[3 * i + 2] == 0.0, "{n} {i}");
            let shares = [lambda[i], 2.0 * lambda[n + i]];
            let close = shares.iter().all(|share| (share.abs() - 0.5 * push).abs() <= within * push);
            assert!(close, "{n} {backend:?} {i}: {shares:?} of {push}");
        }
        let loss = system.rank_loss(0.0, &state.q);
        assert_eq!((loss.n_coordinates, loss.n_rows, loss.n_redundant), (3 * n, 2 * n, redundant));
        match redundant {
            Some(_) => assert_eq!((loss.rows.len(), loss.freedom()), (2 * n, Some(2 * n))),
            None => {
                assert_eq!((loss.rows.len(), loss.freedom()), (1, None));
                let expected = format!("of 202 rows these, and others, depend on each other: {}", loss.rows[0]);
                assert_eq!(loss.to_string(), expected);
            }
        }
        let mut v = vec![1.0; 3 * n];
        system.project_velocities(0.0, &state.q, &mut v, Metric::Mass).unwrap();
        assert!((0..n).all(|i| v[3 * i].abs() <= 1e-9 && v[3 * i + 1] == 1.0), "{n} {backend:?}");
    }
}

/// Rows that ask for two places leave half of the distance each, and nothing agrees with both.
#[test]
fn analytic_positions_that_contradict_each_other_are_refused_by_name() {
    let scene = doubled::Pushed { n: 2, apart: 1e-3 };
    for backend in [Backend::Dense, Backend::Sparse] {
        let mut system = system_of(&scene, backend).unwrap();
        let error = system.project_positions(0.0, &mut [0.0; 6], Metric::Mass).unwrap_err();
        let MotionError::ContradictoryRows { t, rows, level, residual, tolerance } = &error else { panic!("{error}") };
        assert_eq!((*t, *level, rows.len()), (0.0, "the positions", 4));
        assert!(*residual > 1e-4 && *residual <= 2e-3 && *tolerance == 1e-12, "{residual} {tolerance:e}");
        assert!(
            error.to_string().contains("contradict each other at t = 0 s: first[0], first[1], again[0], again[1]; ")
        );
    }
}

/// Two wheels 1e-9 m from one axle decide nothing that is left of 16 digits; 1e-3 m from it they hold the cart's angle.
#[test]
fn analytic_rows_within_rounding_of_each_other_are_refused_by_name() {
    for backend in BACKENDS {
        let solve = |apart: f64| {
            let scene = axle::Rolls { apart };
            let mut system = system_of(&scene, backend).unwrap();
            let (mut a, mut lambda) = ([0.0; 3], [0.0; 2]);
            let solved = system.accelerations(0.0, &[0.0, 0.0, 0.3], &[0.5, 0.1, 2.0], &mut a, &mut lambda);
            solved.map(|solved| (solved, a, lambda))
        };
        let (solved, a, _) = solve(1e-3).unwrap();
        assert!(!solved.is_rank_deficient && a[2].abs() <= 1e-9, "{backend:?}: {solved:?}");
        let error = solve(1e-9).unwrap_err();
        let MotionError::LostInRounding { rows, smallest_pivot: Some(pivot), residual, .. } = &error else {
            panic!("{backend:?}: {error}")
        };
        assert!(*pivot < 1e-16 && *residual > 1e-12, "{backend:?}: {pivot:e} {residual:e}");
        assert_eq!(rows[..], ["left", "right"]);
        let message = error.to_string();
        assert!(
            message.contains("where constraints nearly depend on each other (left, right; smallest pivot"),
            "{message}"
        );
    }
}

/// Along the line of both bars no force holds their joint against gravity, which is across it: no motion begins there. Where they are bent,
/// they stand still.
#[test]
fn analytic_stretched_bars_are_refused_and_bent_ones_stand() {
    let scene = stretched::Hangs::default();
    for backend in BACKENDS {
        for method in
            [Method::rk4(1e-3), Method::dop853(1e-9), Method::taylor(1e-9), Method::gauss(1e-9), Method::radau(1e-9)]
        {
            let error = simulation(&scene).backend(backend).method(method).run().unwrap_err();
            let SetupError::Motion(MotionError::SingularPosition { t, rows, level, residual }) = &error else {
                panic!("{backend:?} {method:?}: {error}")
            };
            assert!(*t == 0.0 && rows[..] == ["A.x", "B.x", "C.x"], "{method:?}: {rows:?} at {t}");
            assert!(*residual > 0.0 && *level == "the velocities", "{level}: {residual}");
            let message = error.to_string();
            assert!(
                message.contains("is singular: constraints depend on each other there, and not beside it: A.x"),
                "{message}"
            );
        }
    }
    let scene = stretched::Hinged { apart: 1.6 };
    let run = simulation(&scene).method(Method::rk4(0.01)).run().unwrap();
    // each bar carries its own weight, half of it at either end: the joint hands over no vertical force
    let sink = 0.6 / 0.8;
    let last = run.last();
    for (name, expected) in
        [("lambda.B.y", 0.0), ("lambda.A.y", 9.81), ("lambda.C.y", 9.81), ("lambda.B.x", 0.5 * 9.81 / sink)]
    {
        let found = last.get(name).unwrap().abs();
        assert!((found - expected).abs() <= 1e-10, "{name}: {found} {expected}");
    }
    assert!(last.velocities.iter().all(|v| v.abs() <= 1e-12) && run.outcome.reached_end(), "{:?}", last.velocities);
}

/// From its level position on a parallelogram turns as the pendulum that it is, I = 8/3 kg m² and m l = 3 kg m; rates that would turn it
/// into both of its modes at once are refused.
#[test]
fn analytic_parallelogram_leaves_its_level_position() {
    let scene = parallelogram::Falls::default();
    let order = |method, rates: [f64; 2]| {
        let mut order = simulation(&scene).method(method).until(0.3).project_start();
        for (name, rate) in ["left", "right"].into_iter().zip(rates) {
            order = order.start(format!("{name}.phi"), 0.0).start(format!("{name}.omega"), rate);
        }
        order.start("bar.omega", 0.0).run()
    };
    for method in [Method::rk4(1e-3), Method::dop853(1e-9), Method::taylor(1e-9)] {
        let run = order(method, [-3.0; 2]).unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        let (phi, rate) = (run.last().get("left.phi").unwrap(), run.last().get("left.omega").unwrap());
        let expected = -(9.0 - 2.0 * 3.0 * 9.81 / (8.0 / 3.0) * phi.sin()).sqrt();
        assert!((rate - expected).abs() <= 1e-7 && phi < -0.9, "{method:?}: {phi} {rate} {expected}");
        let refused = order(method, [-3.0, 0.0]).unwrap_err();
        assert!(matches!(refused, SetupError::Motion(MotionError::SingularPosition { .. })), "{method:?}: {refused}");
    }
}

/// The crank's end is above the reach of the rod from sin φ = 1/2 on.
#[test]
fn analytic_crank_beyond_the_reach_of_its_rod_ends_the_run_with_the_rows() {
    let reach = 0.5_f64.asin() - 0.2;
    for method in [Method::rk4(1e-3), Method::dop853(1e-7)] {
        let run = simulation(&short_rod::Turn::default()).method(method).run().unwrap();
        let Outcome::Stopped { t, reason: StopReason::Motion(error), .. } = &run.outcome else {
            panic!("{method:?}: {}", run.outcome)
        };
        assert!(*t <= reach + 1e-9 && *t >= reach - 2e-3, "{method:?}: {t} of {reach}");
        let MotionError::LockedUp { rows, smallest_pivot, cause, .. } = error else { panic!("{method:?}: {error}") };
        assert!(
            rows.iter().any(|row| row == "motor") && *smallest_pivot < 1e-2,
            "{method:?}: {rows:?} {smallest_pivot:e}"
        );
        let is_cause = matches!(**cause, MotionError::StepCollapsed { .. } | MotionError::ProjectionStalled { .. });
        assert!(is_cause && error.to_string().contains(&cause.to_string()), "{method:?}: {error}");
    }
}

/// What belts that differ leave is told as a share of the speed of 1 m/s that it is compared with.
#[test]
fn analytic_velocities_that_contradict_each_other_leave_their_difference() {
    let scene = two_belts::Fall { more: 1.0, ..Default::default() };
    let q = [0.0; 3];
    for backend in BACKENDS {
        let mut system = system_of(&scene, backend).unwrap();
        // belts at 1 m/s and 1.001 m/s
        let error = system.project_velocities(1e-3, &q, &mut [1.0, 0.0, 0.0], Metric::Mass).unwrap_err();
        let MotionError::ContradictoryRows { t, rows, level, residual, tolerance } = &error else { panic!("{error}") };
        assert_eq!((*t, *level, *tolerance), (1e-3, "the velocities", 1e-6));
        assert_eq!(rows[..], ["first", "second"]);
        assert!((*residual - 1e-3).abs() <= 1e-12, "{backend:?}: {residual:e}");
        // at 1 m/s and 1 m/s + 1e-7 m/s they agree
        let mut v = [0.0; 3];
        let solved = system.project_velocities(1e-7, &q, &mut v, Metric::Mass).unwrap();
        // v − 0.25 ω = 1, smallest: along (1, −0.25) over 1 + 1/16
        assert!(
            solved.is_rank_deficient && (v[0] - 16.0 / 17.0).abs() <= 1e-7 && (v[2] + 4.0 / 17.0).abs() <= 1e-7,
            "{v:?}"
        );
    }
}
