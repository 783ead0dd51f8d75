//! The measured order of the method.

use crate::scenes::{Case, coast, distance, driven};
use ezy_core::model::Scene;
use ezy_core::prelude::*;
use ezy_tests::reference::load;

const STEPS: [f64; 5] = [0.04, 0.02, 0.01, 0.005, 0.0025];
const ORDER: f64 = 4.0;
/// What the higher terms of the error bend the line over four halvings.
const ORDER_TOLERANCE: f64 = 0.1;

/// A change to an order.
type Change = for<'s> fn(Simulation<'s, dyn Scene + 's>) -> Simulation<'s, dyn Scene + 's>;

/// Least-squares slope of log error over log step.
fn slope(errors: &[f64]) -> f64 {
    let (x, y): (Vec<f64>, Vec<f64>) = STEPS.iter().zip(errors).map(|(h, e)| (h.ln(), e.ln())).unzip();
    let mean = |z: &[f64]| z.iter().sum::<f64>() / z.len() as f64;
    let (mx, my) = (mean(&x), mean(&y));
    let covariance: f64 = x.iter().zip(&y).map(|(x, y)| (x - mx) * (y - my)).sum();
    covariance / x.iter().map(|x| (x - mx).powi(2)).sum::<f64>()
}

fn order_at_end(scene: &dyn Scene, answer: &str, until_s: f64, change: Change) -> f64 {
    let reference = load(answer);
    let end = reference.iter().find(|r| r.t == until_s).expect("a reference at the end");
    let error = |h: &f64| {
        let order = Simulation::new(scene).until(until_s).method(Method::rk4(*h));
        distance(change(order).run().unwrap().last().coordinates, &end.q)
    };
    slope(&STEPS.each_ref().map(error))
}

fn assert_order(route: &str, what: &str, order: f64) {
    assert!((order - ORDER).abs() <= ORDER_TOLERANCE, "{route}, {what}: order {order:.3}");
}

#[test]
fn order_rk4_coast_is_four() {
    for Case { route, scene } in coast() {
        assert_order(route, "coast", order_at_end(&*scene, "ezyroller_coast", 1.0, |s| s));
    }
}

#[test]
fn order_rk4_driven_is_four() {
    for Case { route, scene } in driven() {
        assert_order(route, "driven", order_at_end(&*scene, "ezyroller_driven", 60.0, |s| s));
    }
}

#[test]
fn order_is_kept_by_every_projection() {
    for Case { route, scene } in driven() {
        for (what, change) in [
            ("none", (|s| s.project(Projection::None)) as Change),
            ("velocities", |s| s.project(Projection::Velocities)),
            ("positions", |s| s.project(Projection::Positions)),
            ("both, euclidean", |s| s.metric(Metric::Euclidean)),
        ] {
            assert_order(route, what, order_at_end(&*scene, "ezyroller_driven", 10.0, change));
        }
    }
}
