//! DOP853: its order, its dense output, its steps.

use crate::scenes::{distance, stepped};
use ezy_core::prelude::*;
use ezy_core::testing::StepsBy;
use ezy_core_tests::simulation;
use ezy_models::{ezy_roller, roller_racer, skateboard};
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
        stepped(&scene, StepsBy::Method(MethodKind::Dop853), lengths)[1].q.clone()
    };
    let dense = slope(&STEPS.map(|h| distance(&middle(h), &at(0.4).q)));
    // one step of order 8 has an error of order 9, its dense output one of order 8
    assert!(dense >= 7.0 - ORDER_TOLERANCE, "dense output: order {dense:.2}");
    let steps = [0.1, 0.05];
    let end = |h: f64| {
        stepped(&scene, StepsBy::Method(MethodKind::Dop853), std::iter::repeat_n(h, (1.0 / h).round() as usize))[0]
            .q
            .clone()
    };
    let error = |h: f64| distance(&end(h), &at(1.0).q);
    let order = (error(steps[0]) / error(steps[1])).ln() / (steps[0] / steps[1]).ln();
    assert!((order - 8.0).abs() <= ORDER_TOLERANCE, "order {order:.2}");
}

#[test]
fn analytic_steps_grow_where_nothing_happens() {
    let scene = ezy_roller::Driven::default();
    let at_rest = simulation(&scene).method(Method::dop853(1e-9)).until(60.0);
    let still = ezy_roller::Driven { m0: 0.0, ..Default::default() };
    let straight = simulation(&still).method(Method::dop853(1e-9)).until(60.0).run().unwrap();
    assert!(straight.cost.steps < 20, "{} steps at rest", straight.cost.steps);
    assert!(at_rest.run().unwrap().cost.steps > 100);
}

/// Samples in five seconds, so that many lie in one step.
const N_SAMPLES: f64 = 97.0;

/// What samples may be off by, in tolerances: errors of steps add up.
const SAMPLES_TOLERANCE: f64 = 10.0;

/// Evaluations that samples between steps may add, over those of the steps.
const ADDED: f64 = 1.2;

/// A wheel that slips, or rolls on soft trucks, settles fast: the polynomial between the ends of a long step is off by a thousand
/// tolerances while the ends are right.
#[test]
fn cross_dop853_samples_between_steps_keep_to_the_tolerance() {
    let scenes: [&dyn Scene; 2] = [&ezy_roller::Drift::default(), &skateboard::Ridden::default()];
    for scene in scenes {
        let sampled = |tolerance: f64, n_samples: f64| {
            let order = simulation(scene).method(Method::dop853(tolerance)).until(5.0);
            order.every(5.0 / n_samples).run().unwrap()
        };
        let exact = sampled(1e-13, N_SAMPLES);
        for tolerance in [1e-6, 1e-9] {
            let run = sampled(tolerance, N_SAMPLES);
            let error = run.samples().zip(exact.samples()).fold(0.0, |error: f64, (found, exact)| {
                let pairs = found
                    .coordinates
                    .iter()
                    .chain(found.velocities)
                    .zip(exact.coordinates.iter().chain(exact.velocities));
                pairs.fold(error, |error, (found, exact)| error.max((found - exact).abs() / (1.0 + exact.abs())))
            });
            let name = scene.info().model;
            assert!(error <= SAMPLES_TOLERANCE * tolerance, "{name}: {error:.1e} at {tolerance:.0e}");
            let alone = sampled(tolerance, 1.0).cost.evaluations as f64;
            let added = run.cost.evaluations as f64 / alone - 1.0;
            assert!(added <= ADDED, "{name} at {tolerance:.0e}: {added:.2} more evaluations");
        }
    }
}

/// Pulses of a force, 130 a second, that end where steps do: errors of steps add up to some tens of tolerances.
const OVER_PULSES: f64 = 100.0;

#[test]
fn cross_pulses_as_long_as_a_step_are_not_passed_over() {
    // the force is the square of a half wave; the estimate of order 5 of a step over 31/32 of it is 1/500 of its error
    let scene = skateboard::Ridden { nu_push: 816.0, m_rider: 51.0, m0: 6.6, ..skateboard::Ridden::default() };
    let end = |tolerance: f64| {
        let run = simulation(&scene).method(Method::dop853(tolerance)).until(0.5).run().unwrap();
        [run.last().coordinates, run.last().velocities].concat()
    };
    let reference = end(1e-13);
    for tolerance in [1e-4, 1e-6, 1e-7, 1e-8, 1e-9] {
        let error = distance(&end(tolerance), &reference);
        assert!(error <= OVER_PULSES * tolerance, "{error:.1e} at {tolerance:.0e}");
    }
}

/// Errors of steps over six layers, and what the motion makes of them.
const OVER_LAYERS: f64 = 100.0;

/// A wheel at a rim that turns at 1,200 rad/s rolls forwards and backwards; its friction is a millionth of what bends its path, and turns round
/// within 0.3 µs of a step of 200 µs.
#[test]
fn cross_dop853_steps_do_not_pass_over_a_friction_layer() {
    let scene = roller_racer::RowedOnTarmac {
        a: 6.781_170_185_218_257e-4,
        h: 2.123_750_940_099_740_5e3,
        m2: 0.149_696_165_604_858_9,
        ..roller_racer::RowedOnTarmac::default()
    };
    let end = |method: Method| {
        let order = simulation(&scene).method(method).until(0.06).project_start();
        let run = order.start("seat.vy", -0.851_538_923_310_488_2).run().unwrap();
        [run.last().coordinates, run.last().velocities].concat()
    };
    let reference = end(Method::taylor(1e-12));
    let size = reference.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    for tolerance in [1e-8, 1e-9, 1e-10] {
        let error = distance(&end(Method::dop853(tolerance)), &reference) / size;
        assert!(error <= OVER_LAYERS * tolerance, "{error:.1e} at {tolerance:.0e}");
    }
}
