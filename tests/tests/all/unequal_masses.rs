//! Closed loops of bodies whose masses are far apart: small pivots everywhere, and no position that is singular.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::four_bar;
use std::f64::consts::FRAC_PI_2;

/// What a start is moved by, rad and rad/s: well above the tolerance of the reference.
const MOVED: f64 = 1e-7;

/// Cranks turn several times in this time, s, under bodies up to 50,000 times as heavy.
const UNTIL_S: f64 = 4.0;

/// What steps next to rank loss keep to: rounding of positions comes back in forces there.
const NEXT_TO_RANK_LOSS: f64 = 1e-10;

/// Four-bars that turn and swing far from flat positions, and two that pass them at a distance of 1 mm and 1 cm.
fn four_bars() -> [(four_bar::Turning, f64); 7] {
    let bars = |[base, l1, l2, l3]: [f64; 4], [m1, m2, m3]: [f64; 3]| {
        (four_bar::Turning { base, l1, l2, l3, m1, m2, m3, ..Default::default() }, 0.0)
    };
    let nearly_flat = |lengths, masses| (bars(lengths, masses).0, NEXT_TO_RANK_LOSS);
    [
        bars([1.33, 1.89, 1.0, 1.79], [0.5, 0.04, 50.0]),
        bars([0.56, 0.95, 0.82, 1.73], [0.04, 0.0126, 63.0]),
        bars([1.24, 0.43, 1.1, 0.69], [0.01, 16.0, 0.05]),
        bars([1.95, 1.03, 1.04, 1.91], [20.0, 0.01, 0.006]),
        bars([1.21, 0.46, 1.09, 0.51], [0.003, 0.3, 100.0]),
        nearly_flat([1.0, 0.6, 1.001, 0.6], [0.1, 10.0, 1.0]),
        nearly_flat([1.0, 0.6, 0.99, 0.6], [10.0, 0.1, 0.5]),
    ]
}

/// The states that are projected are those that only velocities are projected of, from steps that know of no singular positions.
/// A step adds its tolerance, relative to the size of the numbers, and the motion makes it larger until the end.
#[test]
fn cross_projected_loops_of_unequal_masses_keep_to_the_tolerance() {
    for (scene, least) in four_bars() {
        let order = |method, projection| simulation(&scene).method(method).project(projection).until(UNTIL_S);
        let reference = || order(Method::dop853(1e-13), Projection::Velocities);
        let exact = reference().run().unwrap();
        let states = samples(reference());
        let growth = ["crank.phi", "crank.omega"].map(|name| growth(&states, &samples(moved(reference(), name))));
        let growth = growth.into_iter().fold(1.0, f64::max);
        let size = states.iter().flatten().fold(1.0, |m: f64, x| m.max(x.abs()));
        let explicit = [1e-8, 1e-10, 1e-12].map(|rtol| [(Method::dop853(rtol), rtol), (Method::taylor(rtol), rtol)]);
        for (method, tolerance) in explicit.into_iter().flatten().chain([(Method::radau(1e-8), 1e-8)]) {
            let run = order(method, Projection::Both).run().unwrap();
            assert!(run.outcome.reached_end(), "{scene:?}, {method:?}: {}", run.outcome);
            let off = crate::scenes::distance(exact.last().coordinates, run.last().coordinates);
            let allowed = run.cost.steps as f64 * tolerance.max(least) * (1.0 + size) * growth;
            assert!(off <= allowed, "{scene:?}, {method:?}: {off:.1e}, allowed {allowed:.1e}");
        }
    }
}

/// The start of the scene with a number moved.
fn moved<'s>(order: Simulation<'s, &'s dyn Scene>, name: &str) -> Simulation<'s, &'s dyn Scene> {
    let start = if name == "crank.phi" { FRAC_PI_2 } else { -1.0 };
    order.start(name, start + MOVED)
}

/// Coordinates and velocities along a run.
fn samples(order: Simulation<'_, &dyn Scene>) -> Vec<Vec<f64>> {
    let run = order.every(0.01 * UNTIL_S).run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    run.samples().map(|sample| [sample.coordinates, sample.velocities].concat()).collect()
}

/// How much larger a difference of two motions is at the end than before.
fn growth(states: &[Vec<f64>], moved: &[Vec<f64>]) -> f64 {
    let differences: Vec<f64> = states.iter().zip(moved).map(|(x, y)| crate::scenes::distance(x, y)).collect();
    let least = differences.iter().copied().fold(f64::INFINITY, f64::min);
    differences.last().map_or(f64::NAN, |last| last / least)
}
