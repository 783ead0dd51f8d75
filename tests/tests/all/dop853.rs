//! DOP853: its order, its dense output, its steps.

use crate::scenes::{distance, stepped};
use ezy_core::prelude::*;
use ezy_core::testing::StepsBy;
use ezy_models::ezy_roller;
use ezy_tests::reference::load;

/// Steps for the order: above them the motion is not resolved, below them rounding is met.
const STEPS: [f64; 4] = [0.1, 0.08, 0.06, 0.05];
/// Orders are slopes over steps that are not infinitely small.
const ORDER_TOLERANCE: f64 = 0.5;

fn slope(errors: &[f64]) -> f64 {
    let (first, last) = (0, errors.len() - 1);
    (errors[first] / errors[last]).ln() / (STEPS[first] / STEPS[last]).ln()
}

#[test]
fn order_dop853_is_eight_and_its_dense_output_seven() {
    let reference = load("ezyroller_coast");
    let at = |t: f64| reference.iter().find(|r| (r.t - t).abs() < 1e-9).expect("a reference at this time");
    let scene = ezy_roller::Coast::default();
    // the middle of a step right at 0.4 s, whatever the step
    let middle = |h: f64| {
        let n = (0.4 / h).round() as usize - 1;
        let lengths = std::iter::repeat_n(h, n).chain([2.0 * (0.4 - n as f64 * h)]);
        stepped(&scene, StepsBy::Dop853, lengths)[1].q.clone()
    };
    let dense = slope(&STEPS.map(|h| distance(&middle(h), &at(0.4).q)));
    // one step of order 8 has an error of order 9, its dense output one of order 8
    assert!(dense >= 7.0 - ORDER_TOLERANCE, "dense output: order {dense:.2}");
    let steps = [0.1, 0.05];
    let end =
        |h: f64| stepped(&scene, StepsBy::Dop853, std::iter::repeat_n(h, (1.0 / h).round() as usize))[0].q.clone();
    let error = |h: f64| distance(&end(h), &at(1.0).q);
    let order = (error(steps[0]) / error(steps[1])).ln() / (steps[0] / steps[1]).ln();
    assert!((order - 8.0).abs() <= ORDER_TOLERANCE, "order {order:.2}");
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
