//! The measured order of the method.

use crate::scenes::{Case, coast, distance, driven};
use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::registry::MODELS;
use ezy_tests::reference::load;
use ezy_tests::shapes;

const STEPS: [f64; 5] = [0.04, 0.02, 0.01, 0.005, 0.0025];
const ORDER: f64 = 4.0;
/// What the higher terms of the error bend the line over four halvings.
const ORDER_TOLERANCE: f64 = 0.1;

/// A change to an order.
type Change = for<'s> fn(Simulation<'s, &'s dyn Scene>) -> Simulation<'s, &'s dyn Scene>;

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
        let order = simulation(scene).until(until_s).method(Method::rk4(*h));
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

/// The step is halved from here until the end no longer changes by more than rounding lets see.
const FIRST_STEP: f64 = 0.01;
const N_HALVINGS: usize = 5;
const SEEN_CHANGE: f64 = 1e-11;
const SELF_HORIZON: f64 = 1.0;
/// The last halving that is seen, where the next term of the error is a few per cent.
const SELF_TOLERANCE: f64 = 0.3;

/// Without projections, whose own fourth-order errors take longer to settle; their order is measured above.
#[test]
fn order_rk4_is_four_in_every_scene() {
    let mut n_measured = 0;
    for entry in MODELS.iter().chain(&shapes::MODELS).flat_map(|model| model.scenes) {
        let scene = (entry.new)();
        // the motion that the scene declares: behind it may lie a singular position
        let horizon = SELF_HORIZON.min(scene.info().until_s);
        let end = |h: f64| {
            let order = simulation(&*scene).until(horizon).method(Method::rk4(h)).project(Projection::None);
            order.run().unwrap().last().coordinates.to_vec()
        };
        let mut changes = Vec::new();
        let first_step = FIRST_STEP * horizon / SELF_HORIZON;
        let (mut h, mut coarse) = (first_step, end(first_step));
        for _ in 0..N_HALVINGS {
            h /= 2.0;
            let fine = end(h);
            let change = distance(&coarse, &fine);
            coarse = fine;
            if change < SEEN_CHANGE {
                break;
            }
            changes.push(change);
        }
        // a scene that RK4 integrates exactly, or nearly so, shows no order
        let [.., before, last] = changes[..] else { continue };
        let order = (before / last).log2();
        let name = format!("{}/{}", (entry.info)().model, entry.name);
        assert!(order >= ORDER - SELF_TOLERANCE, "{name}: order {order:.3}, changes {changes:?}");
        // of a linear mode that decays, such as a current, RK4 finds the way exactly: its terms of order four cancel
        n_measured += u32::from(order <= ORDER + SELF_TOLERANCE);
    }
    assert!(n_measured >= 6, "only {n_measured} scenes show an order");
}
