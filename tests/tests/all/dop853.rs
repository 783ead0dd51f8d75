//! DOP853: its order, its dense output, its steps, and what keeps them from going on.

use crate::scenes::{Case, coast, distance, driven};
use ezy_core::dynamics::State;
use ezy_core::integrate::{Dop853, Node, Tolerance};
use ezy_core::model;
use ezy_core::prelude::*;
use ezy_core::simulate::{Outcome, SetupError, StopReason};
use ezy_models::ezy_roller;
use ezy_tests::reference::load;

/// The driven roller over 60 s in full coordinates at 1e-14: the method leaves 2e-12, rounding of 1.4e3 steps with a
/// sensitivity of 2e3 another 1e-12.
const DRIVEN: f64 = 1e-11;
/// Steps for the order: above them the motion is not resolved, below them rounding is met.
const STEPS: [f64; 4] = [0.1, 0.08, 0.06, 0.05];
/// Orders are slopes over steps that are not infinitely small.
const ORDER_TOLERANCE: f64 = 0.5;

/// Any error will do: the step is given.
const ANY: Tolerance = Tolerance { relative: 1.0, absolute: 1.0 };

/// States of the coasting roller after a fixed step each, without projection, and in the middle of the last one.
fn fixed_steps(h: f64) -> (State, State) {
    let scene = ezy_roller::Coast::default();
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let mut now = system.consistent_start(&system.scene_start()).unwrap();
    now.work.clear();
    let (mut next, mut middle) = (now.clone(), now.clone());
    let mut method = Dop853::new(6, 4, 0);
    let [mut a, mut a_next, mut lambda] = [vec![0.0; 6], vec![0.0; 6], vec![0.0; 4]];
    // the middle of a step right at 0.4 s, whatever the step
    let n = (0.4 / h).round();
    let last = 2.0 * (0.4 - (n - 1.0) * h);
    for i in 0..n as usize {
        let h = if i + 1 == n as usize { last } else { h };
        system.accelerations(now.t, &now.q, &now.v, &mut a, &mut lambda).unwrap();
        let from = Node { state: &now, a: &a, power: &[] };
        method.attempt(&mut system, from, h, ANY, &mut next).unwrap();
        method.accept();
        if i + 1 == n as usize {
            system.accelerations(next.t, &next.q, &next.v, &mut a_next, &mut lambda).unwrap();
            let to = Node { state: &next, a: &a_next, power: &[] };
            method.prepare_dense(&mut system, from, to).unwrap();
            method.dense_at(0.5, &mut middle);
        }
        std::mem::swap(&mut now, &mut next);
    }
    (now, middle)
}

fn slope(errors: &[f64]) -> f64 {
    let (first, last) = (0, errors.len() - 1);
    (errors[first] / errors[last]).ln() / (STEPS[first] / STEPS[last]).ln()
}

#[test]
fn order_dop853_is_eight_and_its_dense_output_seven() {
    let reference = load("ezyroller_coast");
    let at = |t: f64| reference.iter().find(|r| (r.t - t).abs() < 1e-9).expect("a reference at this time");
    let dense = slope(&STEPS.map(|h| distance(&fixed_steps(h).1.q, &at(0.4).q)));
    // one step of order 8 has an error of order 9, its dense output one of order 8
    assert!(dense >= 7.0 - ORDER_TOLERANCE, "dense output: order {dense:.2}");
    let steps = [0.1, 0.05];
    let error = |h: f64| {
        let scene = ezy_roller::Coast::default();
        let mut system = System::new(&scene, Backend::Auto).unwrap();
        let mut now = system.consistent_start(&system.scene_start()).unwrap();
        let mut next = now.clone();
        let mut method = Dop853::new(6, 4, 0);
        let (mut a, mut lambda) = (vec![0.0; 6], vec![0.0; 4]);
        for _ in 0..(1.0 / h).round() as usize {
            system.accelerations(now.t, &now.q, &now.v, &mut a, &mut lambda).unwrap();
            method.attempt(&mut system, Node { state: &now, a: &a, power: &[] }, h, ANY, &mut next).unwrap();
            method.accept();
            std::mem::swap(&mut now, &mut next);
        }
        distance(&now.q, &at(1.0).q)
    };
    let order = (error(steps[0]) / error(steps[1])).ln() / (steps[0] / steps[1]).ln();
    assert!((order - 8.0).abs() <= ORDER_TOLERANCE, "order {order:.2}");
}

#[test]
fn reference_dop853_driven_at_all_samples() {
    let reference = load("ezyroller_driven");
    for Case { route, scene } in driven() {
        let run = Simulation::new(&*scene).method(Method::dop853(1e-14)).every(0.5).run().unwrap();
        for r in &reference {
            let s = run.samples().find(|s| (s.t - r.t).abs() < 1e-9).expect("a sample at the time of the reference");
            let error = distance(s.coordinates, &r.q).max(distance(s.velocities, &r.v));
            assert!(error <= DRIVEN, "{route}: {error:.1e} at {} s", r.t);
        }
    }
}

/// A tolerance is kept per step: over a run the error follows it, times the growth of errors with the motion.
#[test]
fn order_error_follows_the_tolerance() {
    let end = load("ezyroller_driven").pop().expect("a reference at the end");
    let scene = ezy_roller::Driven::default();
    let error = |tolerance: f64| {
        let run = Simulation::new(&scene).method(Method::dop853(tolerance)).run().unwrap();
        distance(run.last().coordinates, &end.q)
    };
    let [loose, tight] = [1e-7, 1e-11].map(error);
    let order = (loose / tight).log10() / 4.0;
    // an error estimate of order 8 and steps chosen from it: between 7/8 and 9/8, as in Hairer, Nørsett, Wanner, II.10
    assert!((0.8..=1.2).contains(&order), "error goes with the tolerance to the power {order:.2}");
}

#[test]
fn invariant_samples_do_not_change_the_motion() {
    for Case { route, scene } in coast() {
        let order = || Simulation::new(&*scene).method(Method::dop853(1e-10));
        let [bare, sampled] = [order().run().unwrap(), order().every(0.013).run().unwrap()];
        assert_eq!(bare.last().coordinates, sampled.last().coordinates, "{route}");
        assert_eq!((bare.last().t, bare.cost.steps), (1.0, sampled.cost.steps), "{route}");
    }
}

#[test]
fn invariant_samples_meet_the_constraints() {
    let scene = ezy_roller::Driven::default();
    let run = Simulation::new(&scene).method(Method::dop853(1e-6)).until(10.0).every(0.1).run().unwrap();
    assert_eq!(run.samples().len(), 101);
    for s in run.samples() {
        // the projection's promise
        assert!(s.position_residual <= 1e-12 && s.velocity_residual <= 1e-12, "at {} s", s.t);
    }
}

#[test]
fn analytic_steps_grow_where_nothing_happens() {
    let scene = ezy_roller::Driven::default();
    let at_rest = Simulation::new(&scene).method(Method::dop853(1e-9)).until(60.0);
    let still = ezy_roller::Driven { m0: 0.0, ..Default::default() };
    let straight = Simulation::new(&still).method(Method::dop853(1e-9)).until(60.0).run().unwrap();
    assert!(straight.cost.steps < 20, "{} steps at rest", straight.cost.steps);
    assert!(at_rest.run().unwrap().cost.steps > 100);
}

model! {
    /// A cart that falls into a centre of attraction.
    pub model Falling {
        body cart { mass: 1, inertia: 1 }
        force at cart(0, 0): (1/(1 - cart.x)^2, 0);
        start left { cart at (0, 0) angle 0; at rest; }
        scene fall { start left; until 10 s; }
    }
}

/// Fall from rest over a distance of 1 in the potential −1/r: π/(2√2).
pub const FALL_S: f64 = 1.110_720_734_539_591_6;

#[test]
fn analytic_singular_force_ends_the_run_with_what_was_computed() {
    let scene = falling::Fall::default();
    let run = Simulation::new(&scene).method(Method::dop853(1e-9)).every(0.1).run().unwrap();
    let Outcome::Stopped { t, reason: StopReason::Motion(_), .. } = run.outcome else { panic!("{}", run.outcome) };
    // the last steps cannot resolve the last 1e-9 of the way, which takes 1e-13 s
    assert!((t - FALL_S).abs() <= 1e-6, "stopped at {t} s");
    assert_eq!((run.samples().len(), run.last().t), (13, t));
}

#[test]
fn analytic_tolerances_out_of_range_are_refused() {
    let scene = ezy_roller::Coast::default();
    for tolerance in [0.0, -1e-9, 1e-17, 10.0, f64::NAN, f64::INFINITY] {
        let outcome = Simulation::new(&scene).method(Method::dop853(tolerance)).run();
        assert!(matches!(outcome, Err(SetupError::Tolerance { .. })), "{tolerance}");
    }
}

#[test]
fn analytic_stepper_needs_a_fixed_step() {
    let scene = ezy_roller::Coast::default();
    let outcome = Simulation::new(&scene).method(Method::dop853(1e-9)).stepper();
    assert!(matches!(outcome, Err(SetupError::NeedsFixedStep { method: "dop853" })));
}
