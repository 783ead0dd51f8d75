//! Collocation at Gauss's nodes where its long steps could pass something over.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::{ezy_roller, four_bar, roller_racer};
use ezy_tests::garage::worse;

/// Samples of a run.
const N_SAMPLES: u32 = 32;

/// What errors of some hundred steps add up to, in tolerances.
const ADDED_UP: f64 = 100.0;

/// The largest difference of a number in the samples to that of DOP853 at a far smaller tolerance, in tolerances.
fn excess(scene: &dyn Scene, until_s: f64, tolerance: f64, given: &[(&str, f64)]) -> f64 {
    let samples = |method| {
        let order = simulation(scene).method(method).until(until_s).every(until_s / f64::from(N_SAMPLES));
        let run =
            given.iter().fold(order, |order, (name, value)| order.start(*name, *value)).project_start().run().unwrap();
        assert!(run.outcome.reached_end() && run.samples().len() == N_SAMPLES as usize + 1, "{}", run.outcome);
        run.samples().map(|sample| [sample.coordinates, sample.velocities].concat()).collect::<Vec<_>>()
    };
    let (run, reference) = (samples(Method::gauss(tolerance)), samples(Method::dop853(1e-12)));
    let excess_of = |i: usize| {
        let size = reference.iter().fold(1.0, |size: f64, sample| size.max(sample[i].abs()));
        run.iter().zip(&reference).fold(0.0, |most: f64, (a, b)| worse(most, a[i] - b[i])) / (size * tolerance)
    };
    (0..reference[0].len()).map(excess_of).fold(0.0, f64::max)
}

/// Where the wheels come to rest within a step and roll on, the small force of friction changes in a part of it, beside forces that are smooth over
/// all of it and far larger: their Legendre coefficients hide those of friction.
#[test]
fn cross_gauss_samples_of_slow_wheels_keep_to_the_tolerance() {
    let scene = roller_racer::RowedOnTarmac { m0: 0.0995, omega: 16.14, resistance: 0.00528, ..Default::default() };
    let excess = excess(&scene, 27.4, 5.7e-11, &[]);
    assert!(excess <= ADDED_UP, "{excess:.1e} tolerances");
}

/// The links become straight within a step whose nodes pass that position by; nodes of a part of it, for a sample, do not.
#[test]
fn cross_gauss_samples_beside_singular_positions_are_of_the_motion() {
    // a sample at 0.7755 s stands in the step that goes over the singular position
    let given = [("coupler.phi", 0.347_428_017_704_738_47)];
    let excess = excess(&four_bar::Turning::default(), 12.408_458_395_905_315, 2.264_681_055_598_149e-6, &given);
    assert!(excess <= ADDED_UP, "{excess:.1e} tolerances");
}

/// The drive swings once in a step of 17 ms and overcomes the ice for 5 ms and less.
#[test]
fn cross_gauss_slides_shorter_than_a_third_of_a_step_are_followed() {
    let scene =
        ezy_roller::Skid { c: 0.154, d: 0.132, i1: 9924.0, m2: 0.568, omega: 336.0, hold: 4.12, ..Default::default() };
    let events = |method| {
        let run = simulation(&scene).method(method).until(2.0).start("seat.omega", 1.0).project_start().run().unwrap();
        run.events().len()
    };
    let n_expected = events(Method::dop853(1e-9));
    assert!(n_expected > 50, "{n_expected} events");
    assert_eq!(events(Method::gauss(1e-9)), n_expected);
}
