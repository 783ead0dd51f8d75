//! Runs that step together, and derivatives of runs.

use super::events::pendulum;
use super::singular::parallelogram;
use super::states::cruise;
use ezy_core::dynamics::MotionError;
use ezy_core::model::{Equations, Start};
use ezy_core::prelude::*;
use ezy_core::scalar;
use ezy_core::simulate::SetupError;
use ezy_core_tests::{simulation, system_of};
use std::f64::consts::FRAC_PI_6;

model! {
    /// A mass on a spring.
    pub model Spring {
        param k: N/m = 8;
        param m: kg = 2;
        body block { mass: m, inertia: 1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        spring ground(0, 0) ~ block(0, 0): stiffness k;
        start out { block at (1, 0) angle 0 velocity (0, 0); }
        scene swings { start out; until 1.7 s; }
    }
}

const METHODS: [(Method, f64); 2] = [(Method::rk4(5e-3), 1e-8), (Method::dop853(1e-11), 1e-9)];

/// x = cos √(k/m) t in each lane.
#[test]
fn analytic_springs_swing_together() {
    let scenes: [spring::Swings; 4] = std::array::from_fn(|i| spring::Swings { k: 4.0 + 3.0 * i as f64, m: 2.0 });
    for (method, bound) in METHODS {
        let start = |scene: &spring::Swings| {
            let mut system = system_of(scene, Backend::Generated).unwrap();
            let start = system.scene_start();
            system.consistent_start(&start).unwrap()
        };
        let starts = scenes.each_ref().map(start);
        let mut together = Ensemble::new(&scenes, starts.each_ref(), method).unwrap();
        for until in [0.61, 1.7] {
            together.advance(until).unwrap();
            assert_eq!(together.time(), until);
            for (lane, scene) in scenes.iter().enumerate() {
                let omega = (scene.k / scene.m).sqrt();
                let state = together.state(lane);
                assert!((state.q[0] - (omega * until).cos()).abs() <= bound, "{method:?} {lane}: {:?}", state.q);
                assert!(
                    (state.v[0] + omega * (omega * until).sin()).abs() <= 10.0 * bound,
                    "{method:?} {lane}: {:?}",
                    state.v
                );
            }
        }
    }
}

/// x = x₀ cos ωt + v₀/ω sin ωt with ω² = k/m: derivatives by x₀, v₀, k and m.
#[test]
fn analytic_derivatives_of_a_spring() {
    let scene = spring::Swings::default();
    for (method, bound) in METHODS {
        let start = system_of(&scene, Backend::Generated).unwrap().scene_start();
        let mut run = Sensitivities::new(&scene, &start, ["block.x", "block.vx", "k", "m"], method).unwrap();
        run.advance(1.7).unwrap();
        let (omega, t) = ((scene.k / scene.m).sqrt(), 1.7);
        let (sin, cos) = (omega * t).sin_cos();
        let by_omega = [-t * sin, -sin - omega * t * cos];
        let expected = [
            [cos, -omega * sin],
            [sin / omega, cos],
            by_omega.map(|x| x / (2.0 * omega * scene.m)),
            by_omega.map(|x| -x * omega / (2.0 * scene.m)),
        ];
        assert!((run.state().q[0] - cos).abs() <= bound, "{method:?}");
        for (tangent, expected) in run.tangents().iter().zip(expected) {
            let found = [tangent.q[0], tangent.v[0]];
            let close = found.iter().zip(expected).all(|(x, y)| (x - y).abs() <= 100.0 * bound);
            assert!(close, "{method:?}: {found:?} {expected:?}");
        }
    }
}

/// Steps of 0.05 s leave the hinge of a pendulum by 1e-6 m, and what is projected fulfils it: energy gives the rate at each angle.
#[test]
fn analytic_pendulums_in_lanes_keep_their_hinges_and_energies() {
    let scenes: [pendulum::Swing; 4] = std::array::from_fn(|i| pendulum::Swing { l: 0.5 + 0.5 * i as f64 });
    let starts = scenes.each_ref().map(|scene| {
        let mut system = system_of(scene, Backend::Generated).unwrap();
        let start = system.scene_start();
        system.consistent_start(&start).unwrap()
    });
    for (method, bound) in [(Method::rk4(1e-3), 1e-8), (Method::dop853(1e-11), 1e-8), (Method::rk4(0.05), 0.1)] {
        let mut together = Ensemble::new(&scenes, starts.each_ref(), method).unwrap();
        together.advance(0.9).unwrap();
        for (lane, scene) in scenes.iter().enumerate() {
            let State { q, v, .. } = together.state(lane);
            let (half, (sin, cos)) = (scene.l / 2.0, q[2].sin_cos());
            let hinge = [q[0] - half * cos, q[1] - half * sin, v[0] + half * sin * v[2], v[1] - half * cos * v[2]];
            assert!(hinge.iter().all(|c| c.abs() <= 1e-12), "{method:?} {lane}: {hinge:?}");
            let rate = (2.0 * 2.0 * 9.81 * half * -sin / (0.375 + 2.0 * half * half)).sqrt();
            assert!((v[2].abs() - rate).abs() <= bound, "{method:?} {lane}: {} {rate}", v[2]);
        }
    }
}

/// A pendulum at the angle φ with the rate ω: the start moves its centre along, d(x, y) = r (−sin φ, cos φ) dφ, and its velocity. A later
/// state depends on the start as differences of runs do.
#[test]
fn fd_derivatives_of_a_pendulum_follow_its_hinge() {
    let scene = pendulum::Swing::default();
    let start = |phi: f64, omega: f64| {
        let mut start = Start::free(3);
        start.give_position(2, phi);
        start.give_velocity(2, omega);
        start
    };
    let mut run =
        Sensitivities::new(&scene, &start(0.3, 2.0), ["bob.phi", "bob.omega", "l"], Method::rk4(2e-3)).unwrap();
    let [by_phi, by_omega, by_length] = run.tangents();
    let (r, (sin, cos)) = (0.75, 0.3_f64.sin_cos());
    for (found, expected) in [
        (&by_phi.q, [-r * sin, r * cos, 1.0]),
        (&by_phi.v, [-r * cos * 2.0, -r * sin * 2.0, 0.0]),
        (&by_omega.q, [0.0; 3]),
        (&by_omega.v, [-r * sin, r * cos, 1.0]),
        (&by_length.q, [0.5 * cos, 0.5 * sin, 0.0]),
        (&by_length.v, [-0.5 * sin * 2.0, 0.5 * cos * 2.0, 0.0]),
    ] {
        assert!(found.iter().zip(expected).all(|(x, y)| (x - y).abs() <= 1e-12), "{found:?} {expected:?}");
    }
    run.advance(0.8).unwrap();
    let end = |phi: f64, omega: f64, l: f64| {
        let scene = pendulum::Swing { l };
        let order = simulation(&scene).method(Method::rk4(2e-3)).until(0.8).without_events();
        let run = order.start("bob.phi", phi).start("bob.omega", omega).run().unwrap();
        [run.last().coordinates, run.last().velocities].concat()
    };
    // differences of the fourth part of ε^(1/3): truncation h² and rounding ε/h are 1e-9
    const STEP: f64 = 1e-5;
    let difference = |[phi, omega, l]: [f64; 3]| {
        let [up, down] = [1.0, -1.0].map(|s| end(0.3 + s * phi * STEP, 2.0 + s * omega * STEP, 1.5 + s * l * STEP));
        up.iter().zip(down).map(|(x, y)| (x - y) / (2.0 * STEP)).collect::<Vec<_>>()
    };
    for (tangent, by) in run.tangents().iter().zip([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]) {
        let found = [&tangent.q[..], &tangent.v].concat();
        let expected = difference(by);
        assert!(found.iter().zip(&expected).all(|(x, y)| (x - y).abs() <= 1e-7), "{by:?}: {found:?} {expected:?}");
    }
}

model! {
    /// Two rods on a pivot that is driven sideways, with a torque from outside.
    pub model Driven {
        param l: m = 1;
        param g: m/s^2 = 9.81;
        input push: N*m = 0.5;
        body upper { mass: 1, inertia: 1/12 }
        body lower { mass: 2, inertia: 1/6 }
        hinge pin: upper(l/2, 0) ~ lower(-1/2, 0);
        constraint pivot_x: upper.x - l/2*cos(upper.phi) = 0.1*sin(3*t);
        constraint pivot_y: upper.y - l/2*sin(upper.phi) = 0;
        gravity (0, -g);
        torque lower: push*cos(t);
        output height: m = lower.y;
        start aside { upper angle 0.3; lower angle -0.4; upper rate 1; lower rate 0; }
        scene swings { start aside; until 2 s; }
    }
}

/// With lengths, inputs, starts and times of their own, of one, three and eight; but for what projections leave, 1e-12 of a row in each of a
/// hundred steps.
#[test]
fn cross_eight_steppers_are_single_ones() {
    for n in [1, 3, 8] {
        let scenes: Vec<_> = (0..n).map(|i| driven::Swings { l: 1.0 + 0.1 * i as f64, g: 9.81 }).collect();
        let stepper = |scene: &driven::Swings| {
            let scene: std::sync::Arc<dyn Scene> = std::sync::Arc::new(driven::Swings { ..*scene });
            Simulation::new(scene).method(Method::rk4(2e-3)).stepper().unwrap()
        };
        let [mut ones, mut together] = [(); 2].map(|()| scenes.iter().map(stepper).collect::<Vec<_>>());
        let mut lanes = EightSteppers::new(&mut together.iter_mut().collect::<Vec<_>>()).unwrap();
        for round in 0..3 {
            for steppers in [&mut ones, &mut together] {
                for (i, stepper) in steppers.iter_mut().enumerate() {
                    stepper.inputs_mut()[0] = 0.3 * i as f64 - f64::from(round);
                }
                // times of their own
                steppers[0].step(7).unwrap();
            }
            ones.iter_mut().for_each(|stepper| stepper.step(100).unwrap());
            assert!(lanes.step(&mut together.iter_mut().collect::<Vec<_>>(), 100));
            for (one, other) in ones.iter_mut().zip(&mut together) {
                let (a, b) = (one.state().clone(), other.state().clone());
                assert_eq!(a.t, b.t);
                for (x, y) in a.q.iter().chain(&a.v).zip(b.q.iter().chain(&b.v)) {
                    assert!((x - y).abs() <= 1e-10 * x.abs().max(1.0), "{n} {round}: {x} {y}");
                }
                assert!((one.outputs()[0] - other.outputs()[0]).abs() <= 1e-10);
            }
            // one of them begins again
            for steppers in [&mut ones, &mut together] {
                steppers[n - 1].reset_with(&[("upper.phi", 0.1 * f64::from(round))]).unwrap();
            }
        }
    }
}

/// Numbers that are not finite, a parallelogram that comes to lie on a line, and what has to be located: the steppers are where they were.
#[test]
fn invariant_eight_steppers_leave_undone_what_they_cannot() {
    let scene = driven::Swings::default();
    let mut stepper = Simulation::new(&scene).method(Method::rk4(2e-3)).stepper().unwrap();
    let mut lanes = EightSteppers::new(&mut [&mut stepper]).unwrap();
    stepper.inputs_mut()[0] = f64::NAN;
    let before = stepper.state().clone();
    assert!(!lanes.step(&mut [&mut stepper], 3) && *stepper.state() == before && stepper.step(1).is_err());
    stepper.inputs_mut()[0] = 0.0;
    assert!(!lanes.step(&mut [], 3) && lanes.step(&mut [&mut stepper], 3));

    let scene = parallelogram::Falls::default();
    let order = || Simulation::new(&scene).method(Method::rk4(1e-3));
    let (mut alone, mut stepper) = (order().stepper().unwrap(), order().stepper().unwrap());
    let mut lanes = EightSteppers::new(&mut [&mut stepper]).unwrap();
    let mut n_undone = 0;
    for _ in 0..200 {
        let before = stepper.state().clone();
        if !lanes.step(&mut [&mut stepper], 10) {
            assert_eq!(*stepper.state(), before);
            n_undone += 1;
            stepper.step(10).unwrap();
        }
        alone.step(10).unwrap();
    }
    assert!(n_undone > 0);
    for (x, y) in alone.state().q.iter().zip(&stepper.state().q) {
        assert!((x - y).abs() <= 1e-6, "{x} {y}");
    }

    // others than those that they were made of
    let scenes = [driven::Swings::default(), driven::Swings { l: 2.0, ..Default::default() }];
    let mut steppers =
        scenes.each_ref().map(|scene| Simulation::new(scene).method(Method::rk4(2e-3)).stepper().unwrap());
    let mut lanes = EightSteppers::new(&mut steppers.iter_mut().collect::<Vec<_>>()).unwrap();
    assert!(!lanes.step(&mut steppers.iter_mut().rev().collect::<Vec<_>>(), 1));
    assert!(lanes.step(&mut steppers.iter_mut().collect::<Vec<_>>(), 1));

    let scene = spring::Swings::default();
    let mut other = Simulation::new(&scene).method(Method::midpoint(1e-3)).stepper().unwrap();
    let why = EightSteppers::new(&mut [&mut other]).err().unwrap().to_string();
    assert!(why.contains("by rk4 with one step"), "{why}");
    let scene = cruise::Cruises::default();
    let mut states = Simulation::new(&scene).method(Method::rk4(1e-3)).stepper().unwrap();
    let why = EightSteppers::new(&mut [&mut states]).err().unwrap().to_string();
    assert!(why.contains("first-order states"), "{why}");
}

/// In lanes the elimination alone solves: where a pivot of it vanishes, the row is named.
#[test]
fn invariant_lanes_refuse_a_position_in_which_a_pivot_vanishes() {
    let scenes = [parallelogram::Falls::default(), parallelogram::Falls::default()];
    let level = State {
        t: 0.0,
        q: vec![0.5, 0.0, 0.0, 2.5, 0.0, 0.0, 1.0, 0.0, 0.0],
        v: vec![0.0, -0.5, -1.0, 0.0, -0.5, -1.0, 0.0, -1.0, 0.0],
        z: Vec::new(),
        work: Vec::new(),
    };
    for method in [Method::rk4(1e-3), Method::dop853(1e-9)] {
        let mut together = match Ensemble::new(&scenes, [&level, &level], method) {
            Ok(together) => together,
            Err(error) => {
                assert!(error.to_string().contains("vanishes at t = 0 s in the generated elimination"), "{error}");
                continue;
            }
        };
        let error = together.advance(0.1).unwrap_err();
        assert!(
            matches!(&error, MotionError::LostPivot { t, row } if *t == 0.0 && row.contains(".x")),
            "{method:?}: {error}"
        );
        assert_eq!(together.time(), 0.0);
    }
}

model! {
    /// Two carts on a rope. The place of one and the speed of the other are given.
    pub model Pair {
        body one { mass: 1, inertia: 1 }
        body two { mass: 3, inertia: 1 }
        constraint rope: two.x = one.x + 1;
        start here { one x 0; two vx 2; one y 0; two y 0; one vy 0; two vy 0; one angle 0 rate 0; two angle 0 rate 0; }
        scene glides { start here; until 1 s; }
    }
}

model! {
    /// A crank and a rod whose angle is a guess.
    pub model Crank {
        param r: m = 0.5;
        param l: m = 1;
        body crank { mass: 1, inertia: 1 }
        body rod { mass: 1, inertia: 1 }
        hinge bearing: ground(0, 0) ~ crank(0, 0);
        hinge pin: crank(r, 0) ~ rod(-l, 0);
        constraint guide: rod.y = 0;
        start upright { crank angle pi/2; rod near angle -pi/6; at rest; }
        start held { crank angle pi/2; rod angle -pi/6; at rest; }
        scene follows { start upright; until 1 s; }
        scene stands { start held; until 1 s; }
    }
}

/// l sin φ = −r: a near angle gives way to a change of the crank, dφ/dr = −1/(l cos φ), and one that is held does not let it change.
#[test]
fn analytic_what_a_start_does_not_let_change_is_told() {
    fn of<'s, S: Scene + Equations<scalar::Dual<1>>>(scene: &'s S) -> Result<Sensitivities<'s, 1>, SetupError> {
        let start = System::new(scene, Backend::Auto).unwrap().scene_start();
        Sensitivities::new(scene, &start, ["r"], Method::rk4(1e-2))
    }
    let follows = crank::Follows::default();
    let [by_length] = of(&follows).unwrap().tangents();
    let expected = -1.0 / (FRAC_PI_6.cos());
    assert!((by_length.q[5] - expected).abs() <= 1e-12, "{:?}", by_length.q);
    let error = of(&crank::Stands::default()).err().unwrap();
    assert!(matches!(&error, SetupError::HeldByStart { name } if name == "r"), "{error}");
}

model! {
    /// Rods on a line, the first of which is held twice.
    pub model Garland {
        count n = 4;
        param m: kg = 0.5;
        param r: m = 0.25;
        body link[n] { mass: m, inertia: 0.02 }
        hinge top: ground(0, 0) ~ link[0](-r, 0);
        constraint again: link[0].x^2 + link[0].y^2 = r^2;
        for i in 1..n { hinge pin[i]: link[i-1](r, 0) ~ link[i](-r, 0); }
        gravity (0, -9.81);
        start slanted { for i in 0..n { link[i] angle -0.3*i; } at rest; }
        scene swings { start slanted; until 0.4 s; }
    }
}

/// Scenes with counts and with redundant rows, which no elimination solves, have derivatives, too: by length, mass and an angle.
#[test]
fn fd_derivatives_of_a_scene_with_counts_and_redundant_rows() {
    let scene = garland::Swings::default();
    let start = system_of(&scene, Backend::Auto).unwrap().scene_start();
    let until = scene.info().until_s;
    let mut run = Sensitivities::new(&scene, &start, ["r", "m", "link[1].phi"], Method::rk4(1e-3)).unwrap();
    run.advance(until).unwrap();
    let end = |r: f64, m: f64, phi: f64| {
        let scene = garland::Swings { r, m, ..Default::default() };
        let run = simulation(&scene).method(Method::rk4(1e-3)).start("link[1].phi", phi).run().unwrap();
        [run.last().coordinates, run.last().velocities].concat()
    };
    // differences of the fourth part of ε^(1/3): truncation h² and rounding ε/h are 1e-9
    const STEP: f64 = 1e-5;
    for (tangent, by) in run.tangents().iter().zip([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]) {
        let [up, down] = [STEP, -STEP].map(|h| end(0.25 + h * by[0], 0.5 + h * by[1], -0.3 + h * by[2]));
        let expected: Vec<f64> = up.iter().zip(&down).map(|(up, down)| (up - down) / (2.0 * STEP)).collect();
        let found = [&tangent.q[..], &tangent.v].concat();
        let size = found.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
        assert!(
            found.iter().zip(&expected).all(|(x, y)| (x - y).abs() <= 1e-7 * size),
            "{by:?}: {found:?} {expected:?}"
        );
    }
}

/// What is given stays, and the other cart follows: places by the place of one, speeds by the speed of the other.
#[test]
fn analytic_derivatives_by_start_values_keep_what_is_given() {
    let scene = pair::Glides::default();
    let start = system_of(&scene, Backend::Auto).unwrap().scene_start();
    let mut run = Sensitivities::new(&scene, &start, ["one.x", "two.vx"], Method::rk4(0.5)).unwrap();
    run.advance(1.0).unwrap();
    let [by_place, by_speed] = run.tangents();
    let found = [by_place, by_speed].map(|by| [by.q[0], by.q[3], by.v[0], by.v[3]]);
    for (found, expected) in found.as_flattened().iter().zip([1.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0]) {
        assert!((found - expected).abs() <= 4.0 * f64::EPSILON, "{found} {expected}");
    }
}
