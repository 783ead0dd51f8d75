//! The hanging net: many loops, two indices.

use ezy_core::linalg::SparseKkt;
use ezy_core::model::Scene;
use ezy_core::prelude::*;
use ezy_models::hanging_net;

#[test]
fn invariant_net_keeps_its_energy_and_its_threads() {
    let scene = hanging_net::Swing { rows: 4, columns: 4, ..Default::default() };
    let run = Simulation::new(&scene).work().method(Method::rk4(1e-3)).until(0.1).run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    let last = run.last();
    assert!(last.position_residual <= 1e-12, "{:.1e}", last.position_residual);
    // of 1e-3 J turned over
    assert!(last.energy.balance.abs() <= 1e-10, "{:.1e} J", last.energy.balance);
}

#[test]
fn invariant_factors_of_the_net_grow_little_faster_than_the_net() {
    let entries = |side: usize| {
        let info = hanging_net::Swing { rows: side, columns: side, ..Default::default() }.info();
        let kkt = SparseKkt::new(info.n_coordinates(), &info.jacobian, info.n_rows()).unwrap();
        kkt.n_factor_entries() as f64 / (side * side) as f64
    };
    let per_knot = [10, 20, 40, 80].map(entries);
    println!("entries of L for each knot: {per_knot:.1?}");
    // n log n: a constant more for each doubling of the side
    for pair in per_knot.windows(2) {
        assert!(pair[1] <= 1.35 * pair[0], "{per_knot:?}");
    }
}
