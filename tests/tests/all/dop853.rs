//! DOP853: its order, its dense output, its steps.

use crate::scenes::distance;
use ezy_core::dynamics::State;
use ezy_core::integrate::{Dop853, Node, Tolerance};
use ezy_core::prelude::*;
use ezy_models::ezy_roller;
use ezy_tests::reference::load;

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
fn analytic_steps_grow_where_nothing_happens() {
    let scene = ezy_roller::Driven::default();
    let at_rest = Simulation::new(&scene).method(Method::dop853(1e-9)).until(60.0);
    let still = ezy_roller::Driven { m0: 0.0, ..Default::default() };
    let straight = Simulation::new(&still).method(Method::dop853(1e-9)).until(60.0).run().unwrap();
    assert!(straight.cost.steps < 20, "{} steps at rest", straight.cost.steps);
    assert!(at_rest.run().unwrap().cost.steps > 100);
}
