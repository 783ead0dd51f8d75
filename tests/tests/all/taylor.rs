//! Taylor's method: its order, its dense output, its steps, and what keeps them from going on.

use crate::scenes::{distance, set};
use ezy_core::dynamics::State;
use ezy_core::integrate::Taylor;
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_tests::chain::Chain;
use ezy_tests::hand_roller::HandRoller;
use ezy_tests::reference::load;

/// The driven roller over 60 s in full coordinates at 1e-15: π as a double, in the start and in the drive, moves the end by
/// 3e-13, and rounding of 3e2 steps with a sensitivity of 2e3 as much again.
const DRIVEN: f64 = 2e-12;
/// Energies of 10 J over 6e2 steps, with rounding of each.
const BALANCE: f64 = 1e-12;
/// Solvers of K differ in rounding alone, which 5 s make ten times as large.
const SOLVERS: f64 = 1e-12;
/// Orders are slopes over steps that are not infinitely small.
const ORDER_TOLERANCE: f64 = 0.5;

/// The coasting roller after `n` steps of a fixed order to `t`, without projection, and in the middle of the last step.
fn fixed_steps(order: usize, n: u32, t: f64) -> (State, State) {
    let scene = HandRoller::coast();
    let mut system = System::new(&scene, Backend::Auto).unwrap();
    let mut now = system.consistent_start(&system.scene_start()).unwrap();
    now.work.clear();
    let (mut next, mut middle) = (now.clone(), now.clone());
    let mut method = Taylor::new(&scene, order, 0).expect("a series");
    let (mut a, mut lambda) = (vec![0.0; 6], vec![0.0; 4]);
    let h = t / f64::from(n);
    for _ in 0..n {
        method.expand(&mut system, &now, &mut a, &mut lambda).unwrap();
        method.accept();
        method.advance(&system, &now, h, &mut next);
        method.dense_at(&system, &now, 0.5 * h, &mut middle);
        std::mem::swap(&mut now, &mut next);
    }
    (now, middle)
}

#[test]
fn order_taylor_is_the_one_that_is_asked_for() {
    let end = load("ezyroller_coast").pop().expect("a reference at the end");
    for order in [6, 9, 12] {
        let [coarse, fine] = [10, 20].map(|n| distance(&fixed_steps(order, n, 1.0).0.v, &end.v));
        let slope = (coarse / fine).log2();
        assert!(slope >= order as f64 - ORDER_TOLERANCE, "order {order}: {slope:.2}");
    }
}

#[test]
fn order_values_between_are_as_good_as_a_step() {
    let reference = load("ezyroller_coast");
    let at = |t: f64| reference.iter().find(|r| (r.t - t).abs() < 1e-9).expect("a reference at this time");
    for order in [6, 9] {
        // in the middle of the first step
        let [late, early] = [0.2, 0.1].map(|t| distance(&fixed_steps(order, 1, 2.0 * t).1.v, &at(t).v));
        let slope = (late / early).log2();
        assert!(slope >= order as f64 + 1.0 - ORDER_TOLERANCE, "order {order}: {slope:.2}");
    }
}

#[test]
fn reference_taylor_driven_at_all_samples() {
    let reference = load("ezyroller_driven");
    let run = Simulation::new(&HandRoller::driven()).method(Method::taylor(1e-15)).every(0.5).run().unwrap();
    for r in &reference {
        let s = run.samples().find(|s| (s.t - r.t).abs() < 1e-9).expect("a sample at the time of the reference");
        let error = distance(s.coordinates, &r.q).max(distance(s.velocities, &r.v));
        assert!(error <= DRIVEN, "{error:.1e} at {} s", r.t);
    }
}

#[test]
fn order_error_follows_the_tolerance() {
    let end = load("ezyroller_driven").pop().expect("a reference at the end");
    let error = |tolerance: f64| {
        let run = Simulation::new(&HandRoller::driven()).method(Method::taylor(tolerance)).run().unwrap();
        distance(run.last().coordinates, &end.q)
    };
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        // the sensitivity of the motion to a disturbance, of which every step makes one
        let error = error(tolerance);
        assert!(error <= 2e3 * tolerance, "{error:.1e} at {tolerance:.0e}");
    }
}

#[test]
fn analytic_series_without_odd_orders_does_not_fool_the_step() {
    // from rest every second coefficient vanishes; the first steps are as long as the others
    let run = Simulation::new(&HandRoller::driven()).method(Method::taylor(1e-12)).until(1.0).run().unwrap();
    assert!((4..=12).contains(&run.cost.steps), "{} steps", run.cost.steps);
    assert_eq!((run.last().t, run.cost.rejected), (1.0, 0));
}

#[test]
fn analytic_rest_takes_one_step() {
    let mut still = HandRoller::driven();
    set(&mut still, &[("m0", 0.0)]);
    let run = Simulation::new(&still).method(Method::taylor(1e-9)).until(1e6).run().unwrap();
    assert_eq!((run.cost.steps, run.last().t), (1, 1e6));
    assert_eq!(run.last().coordinates, run.first().coordinates);
}

#[test]
fn invariant_samples_do_not_change_the_motion() {
    let scene = HandRoller::coast();
    let order = || Simulation::new(&scene).method(Method::taylor(1e-10));
    let [bare, sampled] = [order().run().unwrap(), order().every(0.013).run().unwrap()];
    assert_eq!(bare.last().coordinates, sampled.last().coordinates);
    assert_eq!((bare.last().t, bare.cost.steps), (1.0, sampled.cost.steps));
    for s in sampled.samples() {
        // the projection's promise
        assert!(s.position_residual <= 1e-12 && s.velocity_residual <= 1e-12, "at {} s", s.t);
    }
}

#[test]
fn invariant_works_along_the_polynomials_balance_the_energy() {
    let scene = HandRoller::driven();
    let order = || Simulation::new(&scene).method(Method::taylor(1e-14)).until(20.0).every(0.37);
    let [without, with] = [order().run().unwrap(), order().work().run().unwrap()];
    assert_eq!(without.last().coordinates, with.last().coordinates);
    for s in with.samples() {
        assert!(s.energy.balance.abs() <= BALANCE, "{:.1e} J at {} s", s.energy.balance, s.t);
    }
}

#[test]
fn cross_taylor_solves_by_every_backend() {
    let scene = HandRoller::driven();
    let end = |backend| {
        let order = Simulation::new(&scene).method(Method::taylor(1e-13)).backend(backend).until(5.0);
        order.run().unwrap().last().coordinates.to_vec()
    };
    let generated = end(Backend::Generated);
    for backend in [Backend::Dense, Backend::Sparse] {
        assert!(distance(&end(backend), &generated) <= SOLVERS, "{backend:?}");
    }
}

#[test]
fn analytic_scene_without_a_series_is_refused() {
    let outcome = Simulation::new(&Chain::new(2)).method(Method::taylor(1e-9)).run();
    assert!(matches!(outcome, Err(SetupError::NoSeries { scene: "swing" })));
}

#[test]
fn analytic_stepper_needs_a_fixed_step() {
    let scene = HandRoller::coast();
    let outcome = Simulation::new(&scene).method(Method::taylor(1e-9)).stepper();
    assert!(matches!(outcome, Err(SetupError::NeedsFixedStep { method: "taylor" })));
}
