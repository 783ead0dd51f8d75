//! A system at one state: which solver it takes, what it refuses, corrections, inputs, and what work is counted.

// that rows repeat others is what the compiler warns of
#![allow(deprecated)]

use super::events::pendulum;
use super::ranks::doubled;
use super::redundant::cranks;
use super::singular::parallelogram;
use super::starts::{chain, four_bar, tackle};
use ezy_core::dynamics::{MotionError, StrainSource, SystemError};
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};
use std::f64::consts::FRAC_PI_6;
use std::sync::Arc;
use std::thread;

model! {
    /// A rod on a hinge and a block on a rail.
    pub model Pair {
        param m: kg = 1;
        param j: kg*m^2 = 1;
        param lever: m = 1;
        param slope = 1;
        body rod { mass: 1, inertia: j }
        body block { mass: m, inertia: m * lever^2 }
        hinge pivot: ground(0, 0) ~ rod(-lever, 0);
        constraint rail: slope * block.y = 0;
        constraint level: block.phi = 0;
        gravity (0, -9.81);
        start still { rod angle 0; block at (0, 0) angle 0; at rest; }
        scene moves { start still; until 1 s; }
    }
}

model! {
    /// Two geared blocks, one of which the caller pushes.
    pub model Gearbox {
        param ratio = 2;
        input push: N = 6;
        body first { mass: 1, inertia: 1 }
        body second { mass: 3, inertia: 1 }
        constraint gears: first.x = ratio * second.x;
        force at first(0, 0): (push, 0);
        start here { first at (0, 0) angle 0; second at (0, 0) angle 0; at rest; }
        scene drives { start here; until 1 s; }
    }
}

model! {
    /// A stone of 2 kg that circles on a rod of 1 m while one force pushes and another one brakes it.
    pub model Circling {
        param speed: m/s = 3;
        body stone { mass: 2, inertia: 1 }
        rod tie: ground(0, 0) ~ stone(0, 0) length 1;
        effect push {
            param f: N = 10;
            force at stone(0, 0) along stone(0, 1): f;
        }
        effect brake {
            param drag: N = 1;
            force at stone(0, 0) along stone(0, 1): -drag;
        }
        start right { stone at (1, 0) angle 0 velocity (0, speed); }
        scene round { start right; until 1 s; with push, brake; }
    }
}

/// Rounding of some tens of operations on numbers of ten.
const ROUNDING: f64 = 1e-13;

const BACKENDS: [Backend; 3] = [Backend::Generated, Backend::Dense, Backend::Sparse];

fn start_of<S: Scene + ?Sized>(system: &mut System<&S>) -> State {
    let start = system.scene_start();
    system.consistent_start(&start).unwrap()
}

fn refused(scene: &dyn Scene, backend: Backend) -> String {
    system_of(scene, backend).err().expect("it is refused").to_string()
}

#[test]
fn invariant_systems_that_cannot_be_set_up_say_why() {
    let pair = pair::Moves::default();
    let nan = pair::Moves { lever: f64::NAN, ..pair };
    assert_eq!(refused(&nan, Backend::Auto), "parameter `lever` is NaN; give it a finite value");
    let negative = pair::Moves { j: -0.5, ..pair };
    let expected = "the inertia of body `rod` is -0.5; it must be finite and not negative";
    assert_eq!(refused(&negative, Backend::Dense), expected);
    let massless = pair::Moves { m: 0.0, ..pair };
    for (backend, name) in [(Backend::Generated, "generated"), (Backend::Sparse, "sparse")] {
        let expected = format!(
            "the mass of body `block` is zero, which the {name} backend cannot solve with; use `auto` or `dense`"
        );
        assert_eq!(refused(&massless, backend), expected);
    }
    let chain = chain::Swing::default();
    assert!(
        refused(&chain, Backend::Generated).starts_with("scene `swing` has no generated elimination: it has counts")
    );
    // 3 n coordinates and 2 n rows
    let system = |n, backend| system_of(&doubled::Pushed { n, ..Default::default() }, backend).map(|_| ());
    assert!(system(600, Backend::Dense).is_ok());
    assert_eq!(system(601, Backend::Dense), Err(SystemError::TooLargeForDense { n: 3005, limit: 3000 }));
    assert!(matches!(system(0, Backend::Auto), Err(SystemError::Layout(_))));
}

/// The inertia j of a rod on a lever of r is felt like a mass j/r²: from 1e-4 of the heaviest on the elimination is taken.
#[test]
fn analytic_light_bodies_are_left_to_the_pivoted_solver() {
    let eliminates = |scene: pair::Moves| system_of(&scene, Backend::Auto).unwrap().uses_elimination();
    for lever in [0.25, 1.0, 4.0] {
        for (share, expected) in [(1.2e-4, true), (0.8e-4, false)] {
            let j = share * lever * lever;
            assert_eq!(eliminates(pair::Moves { j, lever, ..Default::default() }), expected, "{lever} {share}");
        }
    }
    for (m, expected) in [(1.2e-4, true), (0.8e-4, false), (0.8e4, true), (1.2e4, false)] {
        assert_eq!(eliminates(pair::Moves { m, ..Default::default() }), expected, "{m} kg");
    }
}

/// Rows of 1 and of `slope`: from a ratio of 1e12 on, or beyond 1e50, the elimination does not scale enough.
#[test]
fn analytic_slopes_too_far_apart_are_left_to_the_pivoted_solver() {
    for (slope, expected) in
        [(1e11, true), (1e-11, true), (1e13, false), (1e-13, false), (1e60, false), (1e-60, false), (0.0, true)]
    {
        let scene = pair::Moves { slope, ..Default::default() };
        assert_eq!(system_of(&scene, Backend::Auto).unwrap().uses_elimination(), expected, "{slope:e}");
        let generated = system_of(&scene, Backend::Generated).map(|_| ());
        assert_eq!(generated.is_ok(), expected, "{slope:e}");
        assert!(expected || generated == Err(SystemError::OutOfRange { scene: "moves" }), "{slope:e}");
    }
}

/// With G = [1, 2]: −r (1/m, 2/n)/(1/m + 4/n) in the metric of the masses, and −r (1, 2)/5 in plain numbers.
#[test]
fn analytic_corrections_are_smallest_in_their_metric() {
    let scene = tackle::Moves::default();
    for backend in BACKENDS {
        let mut system = system_of(&scene, backend).unwrap();
        let share = 1.0 / 3.0 + 4.0 / 5.0;
        for (metric, by) in [(Metric::Mass, [1.0 / 3.0 / share, 2.0 / 5.0 / share]), (Metric::Euclidean, [0.2, 0.4])] {
            for r in [0.5, -2.0] {
                let mut delta = [7.0; 6];
                let solved = system.correction(0.0, &[0.0; 6], &[r], metric, &mut delta).unwrap();
                assert!(!solved.is_rank_deficient && solved.smallest_pivot > 0.1, "{backend:?} {metric:?}: {solved:?}");
                for (i, found) in delta.into_iter().enumerate() {
                    let expected = [-r * by[0], 0.0, 0.0, -r * by[1], 0.0, 0.0][i];
                    assert!((found - expected).abs() <= ROUNDING, "{backend:?} {metric:?}: {delta:?}");
                }
            }
        }
    }
    let scene = doubled::Pushed { n: 601, ..Default::default() };
    let mut system = system_of(&scene, Backend::Sparse).unwrap();
    let error = system.project_velocities(0.0, &vec![0.0; 1803], &mut vec![1.0; 1803], Metric::Euclidean).unwrap_err();
    assert_eq!(error, MotionError::EuclideanTooLarge { n: 3005, limit: 3000 });
}

/// The push p on 1 kg and 3 kg that are geared by i: a₂ = i p/(3 + i²), a₁ = i a₂. What was found with one push, also ahead at the end of a
/// step, is not used for another.
#[test]
fn analytic_inputs_change_accelerations_at_once() {
    let scene = gearbox::Drives::default();
    for backend in BACKENDS {
        let mut system = system_of(&scene, backend).unwrap();
        for push in [6.0, -3.0, 1.0] {
            system.inputs_mut()[0] = push;
            let (mut q, mut v) = ([0.0; 6], [2.0, 0.0, 0.0, 1.0, 0.0, 0.0]);
            system.project(0.0, &mut q, &mut v, Projection::Both, Metric::Mass).unwrap();
            let (mut a, mut lambda) = ([0.0; 6], [0.0]);
            system.accelerations(0.0, &q, &v, &mut a, &mut lambda).unwrap();
            let second = 2.0 * push / 7.0;
            assert!((a[3] - second).abs() <= ROUNDING && (a[0] - 2.0 * second).abs() <= ROUNDING, "{backend:?}: {a:?}");
            assert!((lambda[0].abs() - (push - 2.0 * second).abs()).abs() <= ROUNDING, "{backend:?}: {lambda:?}");
        }
        let order = Simulation::new(&scene).backend(backend).method(Method::rk4(0.1));
        let mut stepper = order.stepper().unwrap();
        let mut expected = 0.0;
        for push in [6.0, 6.0, -14.0, 7.0] {
            stepper.set().push = push;
            assert!((stepper.accelerations().unwrap()[3] - 2.0 * push / 7.0).abs() <= ROUNDING, "{backend:?}, {push}");
            stepper.step(1).unwrap();
            expected += 0.1 * 2.0 * push / 7.0;
            assert!((stepper.state().v[3] - expected).abs() <= ROUNDING, "{backend:?}, {push}: {:?}", stepper.state());
        }
    }
}

/// RK4 evaluates accelerations four times a step and once at the start. Each stage factors once; the projection of a step makes one
/// correction of positions, and one elimination, or one factorisation, gives velocities and accelerations at the end.
#[test]
fn regress_evaluations_and_factorisations_of_a_run() {
    const STEPS: u64 = 100;
    let scene = pendulum::Swing::default();
    for backend in BACKENDS {
        for (projection, of_a_step) in [(Projection::Both, 5), (Projection::Velocities, 4), (Projection::None, 4)] {
            let order = simulation(&scene).backend(backend).method(Method::rk4(0.01)).without_events();
            let run = order.project(projection).run().unwrap();
            assert_eq!((run.cost.steps, run.cost.evaluations), (STEPS, 4 * STEPS + 1), "{backend:?} {projection:?}");
            // one factorisation at the start; an elimination also shows the pivots there, to three who ask
            let at_start = if backend == Backend::Generated { 4 } else { 1 };
            assert_eq!(run.cost.factorizations, of_a_step * STEPS + at_start, "{backend:?} {projection:?}");
        }
        // in plain numbers positions and velocities take a correction each, and the next accelerations a factorisation of their own
        let order = simulation(&scene).backend(backend).method(Method::rk4(0.01)).without_events();
        let run = order.metric(Metric::Euclidean).run().unwrap();
        assert_eq!(run.cost.factorizations / STEPS, 6, "{backend:?}: {:?}", run.cost);
    }
}

/// A four-bar a thousand times as large, or as small, is projected in as many passes.
#[test]
fn invariant_passes_of_a_projection_do_not_depend_on_units() {
    let passes = |unit: f64, off: f64| {
        let scene = four_bar::Turning {
            base: 1.3 * unit,
            crank_length: unit,
            coupler_length: 1.4 * unit,
            rocker_length: 1.2 * unit,
        };
        let mut system = system_of(&scene, Backend::Dense).unwrap();
        let State { mut q, .. } = start_of(&mut system);
        q.iter_mut().enumerate().for_each(|(i, q)| *q += off * if i % 3 == 2 { 1.0 } else { unit });
        let passes = system.project_positions(0.0, &mut q, Metric::Euclidean).unwrap();
        assert!(system.position_residual(0.0, &q) <= 2e-12 * unit.max(1e-3) || unit < 1.0, "{unit}");
        passes
    };
    for off in [1e-2, 1e-5] {
        let of_metres = passes(1.0, off);
        assert!((1..=4).contains(&of_metres), "{of_metres} passes");
        for unit in [1e-6, 1e-3, 1e2] {
            assert_eq!(passes(unit, off), of_metres, "{unit} m, off by {off:e}");
        }
    }
    assert_eq!(passes(1.0, 0.0), 0);
}

/// At a million radians rounding of the angle alone is 1e-10 rad, on a lever of 0.75 m.
#[test]
fn analytic_projection_counts_rounding_of_large_coordinates() {
    let scene = pendulum::Swing::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let phi = 1e6_f64;
    let mut q = [0.75 * phi.cos() + 1e-5, 0.75 * phi.sin(), phi];
    let passes = system.project_positions(0.0, &mut q, Metric::Mass).unwrap();
    assert!(passes < 10 && system.position_residual(0.0, &q) <= 4.0 * f64::EPSILON * phi, "{passes} passes");
}

/// A rocker too short to close the loop: the best of ten passes leaves what is told, in the row that is told.
#[test]
fn invariant_projection_that_stalls_tells_row_and_residual() {
    let scene = four_bar::Turning { base: 4.0, ..Default::default() };
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let mut q = [0.5, 0.1, 0.2, 1.7, 0.2, -0.1, 3.4, 0.1, 3.0];
    let error = system.project_positions(0.0, &mut q, Metric::Mass).unwrap_err();
    let MotionError::ProjectionStalled { t, residual, row, passes, tolerance } = error else { panic!("{error}") };
    assert_eq!((t, passes, residual), (0.0, 10, system.position_residual(0.0, &q)));
    assert!(residual > 0.01 && row == "D.y", "{row} {residual}");
    // the longest lever is half of the coupler
    assert!((tolerance / 0.7e-12 - 1.0).abs() <= ROUNDING, "{tolerance:e}");
    let mut q = [f64::NAN; 9];
    let error = system.project_positions(0.0, &mut q, Metric::Mass).unwrap_err();
    assert_eq!(error, MotionError::NotFinite { t: 0.0, quantity: "a position constraint".into() });
}

/// A parallelogram 1e-5 rad beside its level position: a gap of 3e-13 m, which counts as zero elsewhere, is a turn of the bar of 3e-8 rad
/// there. So positions are corrected to their last digits, and velocities again.
#[test]
fn analytic_positions_are_corrected_to_the_last_digit_near_rank_loss() {
    let scene = parallelogram::Falls::default();
    for (phi, is_polished) in [(1e-5_f64, true), (0.4, false)] {
        for metric in [Metric::Mass, Metric::Euclidean] {
            let mut system = system_of(&scene, Backend::Auto).unwrap();
            let (sin, cos) = phi.sin_cos();
            let mut q = [0.5 * cos, 0.5 * sin, phi, 2.0 + 0.5 * cos, 0.5 * sin, phi, 1.0 + cos, sin + 3e-13, 0.0];
            // as an antiparallelogram turns: the rows tell nearly nothing of it when all bars are in one line
            let mut v = [-0.5 * sin, 0.5 * cos, 1.0, 0.5 * sin, -0.5 * cos, -1.0, 0.0, 0.0, -1.0];
            let rows = &mut [0.0; 2];
            rows[0] = system.position_residual(0.0, &q);
            let projected = system.project(0.0, &mut q, &mut v, Projection::Both, metric).unwrap();
            rows[1] = system.position_residual(0.0, &q);
            assert!((rows[0] - 3e-13).abs() <= 1e-15, "{rows:?}");
            let solved = projected.solved.expect("velocities are corrected");
            assert_eq!(rows[1] <= 4.0 * f64::EPSILON, is_polished, "{metric:?}, {phi}: {rows:?} {solved:?}");
            assert!(system.velocity_residual(0.0, &q, &v) <= 1e-15, "{metric:?}, {phi}");
        }
    }
}

/// What moves a stone on a rod hardest: the rod by its speed from m v²/l = F on, or else the force that works most.
#[test]
fn analytic_strain_is_the_reaction_where_speed_rules_and_else_the_force() {
    let strain = |f: f64, drag: f64| {
        let mut scene = circling::Round::default();
        (scene.f, scene.drag) = (f, drag);
        let run = simulation(&scene).method(Method::rk4(1e-7)).max_steps(1).run().unwrap();
        let Outcome::Stopped { strain, .. } = run.outcome else { panic!("{}", run.outcome) };
        strain.expect("something moves")
    };
    // m v²/l = 18 N along −x
    let by_speed = strain(18.0 * 0.99 + 1.0, 1.0);
    let StrainSource::Reaction { row, force } = &by_speed.source else { panic!("{by_speed}") };
    assert_eq!((&**row, &*by_speed.coordinate, by_speed.unit), ("tie", "stone.x", "m"));
    assert!((force + 18.0).abs() <= 1e-4 && (by_speed.acceleration + 9.0).abs() <= 1e-4, "{by_speed}");
    for (f, drag, busiest) in [(30.0, 1.0, "push"), (1.0, 30.0, "brake")] {
        let by_force = strain(f, drag);
        let StrainSource::Applied { coordinate, force, effect } = &by_force.source else { panic!("{by_force}") };
        assert_eq!((&**coordinate, *effect, &*by_force.coordinate), ("stone.y", Some(busiest), "stone.y"));
        assert!((force - (f - drag)).abs() <= 1e-4, "{by_force}");
    }
}

/// A rod that turns at 10 rad/s about its end, without gravity: the pivot pulls with m ω² r along it.
#[test]
fn analytic_strain_of_a_turning_rod_is_its_pivot() {
    let scene = cranks::Swing::default();
    let run = simulation(&scene).method(Method::rk4(1e-7)).max_steps(1).run().unwrap();
    let Outcome::Stopped { strain: Some(strain), .. } = run.outcome else { panic!("{}", run.outcome) };
    let StrainSource::Applied { coordinate, force, effect } = &strain.source else { panic!("{strain}") };
    assert_eq!((&**coordinate, *effect), ("bar.y", None));
    assert!((force + 98.1).abs() <= 1e-9, "{strain}");
    let scene = pendulum::Swing::default();
    let order = simulation(&scene).method(Method::rk4(1e-9)).max_steps(1);
    let run = order.start("bob.phi", FRAC_PI_6).start("bob.omega", 100.0).run().unwrap();
    let Outcome::Stopped { strain: Some(strain), .. } = run.outcome else { panic!("{}", run.outcome) };
    let StrainSource::Reaction { row, force } = &strain.source else { panic!("{strain}") };
    let expected = 2.0 * strain.acceleration;
    assert_eq!((&**row, &*strain.coordinate), ("pivot.x", "bob.x"));
    assert!((force - expected).abs() <= 1e-9 * expected.abs() && strain.acceleration < -6000.0, "{strain}");
}

/// What shares its scene lives as long as it likes, in a struct without lifetimes and in another thread. Its numbers are those of what borrows
/// the scene, to the last bit.
#[test]
fn invariant_a_scene_is_borrowed_or_shared() {
    struct Owner(Stepper<'static, Arc<dyn Scene>>);
    let shared = || -> Arc<dyn Scene> { Arc::from(Box::new(pendulum::Swing::default()) as Box<dyn Scene>) };
    let mut owner = Owner(Simulation::new(shared()).method(Method::rk4(1e-3)).stepper().unwrap());
    let owned = thread::spawn(move || owner.0.step(500).map(|()| owner.0.state().clone())).join().unwrap().unwrap();
    let scene = pendulum::Swing::default();
    let mut stepper = simulation(&scene).method(Method::rk4(1e-3)).stepper().unwrap();
    stepper.step(500).unwrap();
    assert!(owned.t == 0.5 && owned == *stepper.state());
    for method in [Method::dop853(1e-9), Method::taylor(1e-9), Method::gauss(1e-9), Method::radau(1e-6)] {
        let owned = Simulation::new(shared()).method(method).until(1.0).work().estimate_error().run().unwrap();
        let borrowed = simulation(&scene).method(method).until(1.0).work().estimate_error().run().unwrap();
        let numbers = |run: &Run| run.last().numbers().map(f64::to_bits).collect::<Vec<_>>();
        assert_eq!(numbers(&owned), numbers(&borrowed), "{method:?}");
        let error = |run: Run| run.error_estimate.map(|estimate| estimate.unwrap());
        assert_eq!(error(owned), error(borrowed), "{method:?}");
    }
}
