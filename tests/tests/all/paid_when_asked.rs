//! Works and outputs are evaluated when a run is asked for them, and not otherwise.

use ezy_core::prelude::*;
use ezy_tests::counted::Counted;
use ezy_tests::piloted::piloted::Ridden;
use std::sync::atomic::Ordering::Relaxed;

const N_STEPS: u64 = 100;

/// Evaluations of powers and outputs in a run of a hundred steps with eleven samples.
fn evaluations(
    change: impl for<'s> Fn(Simulation<'s, Counted<Ridden>>) -> Simulation<'s, Counted<Ridden>>,
) -> [u64; 2] {
    let scene = Counted::<Ridden>::default();
    let order = Simulation::new(&scene).method(Method::rk4(1e-3)).until(N_STEPS as f64 * 1e-3).every(0.01);
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
    let scene = Counted::<Ridden>::default();
    let mut stepper = Simulation::new(&scene).stepper().unwrap();
    stepper.step(N_STEPS).unwrap();
    assert_eq!([scene.powers.load(Relaxed), scene.outputs.load(Relaxed)], [0, 0]);
    stepper.outputs();
    assert_eq!(scene.outputs.load(Relaxed), 1);
}

#[test]
fn invariant_sample_on_the_end_of_a_step_costs_nothing() {
    // three steps of 0.1 s end at 0.30000000000000004 s
    let scene = Ridden::default();
    let order = || Simulation::new(&scene).method(Method::rk4(0.1)).until(3.0);
    let (sampled, plain) = (order().every(0.3).run().unwrap(), order().run().unwrap());
    assert_eq!(sampled.samples().len(), 11);
    assert_eq!(sampled.cost.evaluations, plain.cost.evaluations);
}
