//! Closed loops of bodies whose masses are far apart: small pivots everywhere, and no position that is singular.

use ezy_core::prelude::*;
use ezy_models::four_bar;

/// Errors over the tolerance after 4 s, in which cranks turn several times under bodies up to 50,000 times as heavy.
const GROWTH: f64 = 1e5;

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
#[test]
fn cross_projected_loops_of_unequal_masses_keep_to_the_tolerance() {
    for (scene, least) in four_bars() {
        let run = |method, projection| {
            let run = Simulation::new(&scene).method(method).project(projection).until(4.0).run().unwrap();
            assert!(run.outcome.reached_end(), "{scene:?}, {method:?}: {}", run.outcome);
            run.last().coordinates.to_vec()
        };
        let expected = run(Method::dop853(1e-13), Projection::Velocities);
        let explicit = [1e-8, 1e-10, 1e-12].map(|rtol| [(Method::dop853(rtol), rtol), (Method::taylor(rtol), rtol)]);
        for (method, tolerance) in explicit.into_iter().flatten().chain([(Method::radau(1e-8), 1e-8)]) {
            let off = crate::scenes::distance(&expected, &run(method, Projection::Both));
            assert!(off <= GROWTH * tolerance.max(least), "{scene:?}, {method:?}: {off:.1e}");
        }
    }
}
