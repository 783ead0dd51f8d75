//! Work as a state of the integration; works and outputs cost nothing unless a run is asked for them.

use crate::scenes::{Case, coast, driven};
use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_tests::crank::Crank;
use std::sync::atomic::Ordering::Relaxed;

/// RK4 at 10 ms over 60 s: 7.4e-8 J by the order of the method.
const COARSE_BALANCE: f64 = 2e-7;
/// Halving the step divides an error of order four by sixteen; higher terms take or give a tenth.
const RATIO: std::ops::RangeInclusive<f64> = 14.5..=17.5;

#[test]
fn order_work_equals_kinetic_energy_to_fourth_order() {
    for Case { route, scene } in driven() {
        let gap = |h: f64| {
            let run = simulation(&*scene).work().method(Method::rk4(h)).run().unwrap();
            run.last().energy.balance.abs()
        };
        let (coarse, fine) = (gap(0.02), gap(0.01));
        assert!(fine <= COARSE_BALANCE, "{route}: {fine:.1e}");
        assert!(RATIO.contains(&(coarse / fine)), "{route}: {coarse:.2e} / {fine:.2e} = {:.2}", coarse / fine);
    }
}

#[test]
fn invariant_work_of_effects_adds_up() {
    for Case { route, scene } in driven() {
        let run = simulation(&*scene).method(Method::rk4(1e-3)).work().until(5.0).every(1.0).run().unwrap();
        assert_eq!(run.first().energy.work, 0.0, "{route}");
        for s in run.samples() {
            assert_eq!(s.work.iter().sum::<f64>(), s.energy.work, "{route}");
            assert_eq!(s.get("work.pump"), Ok(s.energy.work), "{route}");
        }
    }
}

#[test]
fn invariant_coast_has_no_effects_and_no_work() {
    for Case { route, scene } in coast() {
        let run = simulation(&*scene).method(Method::rk4(1e-3)).work().run().unwrap();
        assert!(run.last().work.is_empty(), "{route}");
        assert_eq!(run.last().energy.work, 0.0, "{route}");
    }
}

const N_STEPS: u64 = 100;

/// Evaluations of powers and outputs in a run of a hundred steps with eleven samples.
fn evaluations(change: impl for<'s> Fn(Simulation<'s, &'s dyn Scene>) -> Simulation<'s, &'s dyn Scene>) -> [u64; 2] {
    let scene = Crank::default();
    let order = simulation(&scene).method(Method::rk4(1e-3)).until(N_STEPS as f64 * 1e-3).every(0.01);
    let run = change(order).run().unwrap();
    assert_eq!((run.cost.steps, run.samples().len()), (N_STEPS, 11));
    [scene.powers.load(Relaxed), scene.outputs.load(Relaxed)]
}

#[test]
fn invariant_run_that_asks_for_nothing_evaluates_no_power_and_no_output() {
    assert_eq!(evaluations(|order| order), [0, 0]);
}

#[test]
fn invariant_outputs_are_evaluated_once_a_sample() {
    assert_eq!(evaluations(|order| order.outputs()), [0, 11]);
}

#[test]
fn invariant_work_takes_a_power_at_every_stage() {
    // the last stage of a step is not the first of the next: projections lie between
    assert_eq!(evaluations(|order| order.work()), [4 * N_STEPS + 1, 0]);
}

#[test]
fn invariant_stepper_that_is_not_looked_at_evaluates_neither() {
    let scene = Crank::default();
    let mut stepper = simulation(&scene).method(Method::rk4(1e-3)).stepper().unwrap();
    stepper.step(N_STEPS).unwrap();
    assert_eq!([scene.powers.load(Relaxed), scene.outputs.load(Relaxed)], [0, 0]);
    stepper.outputs();
    assert_eq!(scene.outputs.load(Relaxed), 1);
}

#[test]
fn invariant_sample_on_the_end_of_a_step_costs_nothing() {
    // three steps of 0.1 s end at 0.30000000000000004 s
    let scene = Crank::default();
    let order = || simulation(&scene).method(Method::rk4(0.1)).until(3.0);
    let (sampled, plain) = (order().every(0.3).run().unwrap(), order().run().unwrap());
    assert_eq!(sampled.samples().len(), 11);
    assert_eq!(sampled.cost.evaluations, plain.cost.evaluations);
    // within 1e-9 of a step a sample is its end, and farther away it is not
    let apart = |share: f64| {
        let order = || simulation(&scene).method(Method::rk4(0.1)).until(0.3);
        let sampled = order().every(0.1 * (1.0 + share)).run().unwrap();
        sampled.cost.evaluations - order().run().unwrap().cost.evaluations
    };
    assert_eq!(apart(3e-10), 0);
    assert!(apart(3e-8) > 0);
}
