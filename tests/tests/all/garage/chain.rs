//! Chains of any length: references, the double pendulum written out, cost by length; and the hanging net, with many loops and two
//! indices.

use ezy_core::dynamics::SystemError;
use ezy_core::linalg::SparseKkt;
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};
use ezy_models::{chain, double_pendulum, hanging_net};
use ezy_tests::garage::{at_times, case, load, number, worse};

/// Of the reference, times the amplification of errors that it states.
const ANGLE: f64 = 1e-9;

/// A chain of `n` rods of total length and mass one.
fn unit_chain(n: usize) -> chain::Swing {
    chain::Swing { n, l: 1.0 / n as f64, m: 1.0 / n as f64, ..Default::default() }
}

#[test]
fn reference_chain_of_ten_rods() {
    let file = load("chain_pendulum");
    let states = case(&file, "chain10")["states"].as_array().unwrap();
    let states: Vec<_> = states.iter().filter(|state| number(&state["t"]) <= 0.25).collect();
    let scene = unit_chain(10);
    let order = || simulation(&scene).method(Method::rk4(1e-4));
    at_times(order, 0.25, states.iter().map(|state| number(&state["t"])), |i, s| {
        let state = states[i];
        let mut error = 0.0;
        for k in 0..scene.n {
            error = worse(error, s.coordinates[3 * k + 2] - number(&state["angles"][k]));
            error = worse(error, s.velocities[3 * k + 2] - number(&state["rates"][k]));
        }
        let bar = ANGLE * number(&state["error_amplification"]);
        assert!(error <= bar, "{error:.1e} > {bar:.1e} at {} s", s.t);
    });
}

#[test]
fn cross_chain_of_two_is_the_double_pendulum() {
    let (loops, written_out) = (chain::Swing { n: 2, ..Default::default() }, double_pendulum::Swing::default());
    let loops = simulation(&loops).method(Method::rk4(1e-3)).until(0.5).run().unwrap();
    let written_out = simulation(&written_out).method(Method::rk4(1e-3)).until(0.5).run().unwrap();
    for (a, b) in loops.last().coordinates.iter().zip(written_out.last().coordinates) {
        // rounding of 500 steps
        assert!((a - b).abs() <= 1e-12, "{a} and {b}");
    }
}

#[test]
fn invariant_friction_takes_what_the_chain_loses() {
    let scene = chain::Settle { n: 4, ..Default::default() };
    let run = simulation(&scene).method(Method::rk4(1e-3)).work().until(0.5).run().unwrap();
    let energy = run.last().energy;
    assert!(energy.work < -0.1 && energy.balance.abs() <= 1e-8, "{energy:?}");
}

#[test]
fn invariant_factors_of_the_chain_grow_with_its_length() {
    let entries = |n: usize| {
        let info = chain::Swing { n, ..Default::default() }.info();
        SparseKkt::new(&vec![1.0; info.n_coordinates()], &info.jacobian, info.n_rows()).unwrap().n_factor_entries()
    };
    let per_rod = [10, 100, 1_000, 10_000].map(|n| entries(n) as f64 / n as f64);
    assert!(per_rod.iter().all(|entries| *entries <= 18.0), "{per_rod:?}");
}

#[test]
fn invariant_massless_rods_are_refused_where_only_the_sparse_backend_fits() {
    let refused = system_of(&chain::Swing { n: 1_000, m: 0.0, ..Default::default() }, Backend::Auto).err();
    assert!(
        matches!(&refused, Some(SystemError::MasslessInLargeScene { body, .. }) if body == "link[0]"),
        "{refused:?}"
    );
}

#[test]
fn invariant_ten_thousand_rods_keep_their_constraints() {
    let scene = unit_chain(10_000);
    let run = simulation(&scene).method(Method::rk4(1e-6)).until(2e-6).run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    let last = run.last();
    assert!(last.position_residual <= 1e-12 && last.velocity_residual <= 1e-12, "{:.1e}", last.position_residual);
    // all rods but those near the pin fall freely
    let fall = last.get("link[5000].vy").unwrap();
    assert!((fall + 9.81 * 2e-6).abs() <= 1e-9 * 9.81 * 2e-6, "{fall:e}");
}

#[test]
fn invariant_net_keeps_its_energy_and_its_threads() {
    let scene = hanging_net::Swing { rows: 4, columns: 4, ..Default::default() };
    let run = simulation(&scene).work().method(Method::rk4(1e-3)).until(0.1).run().unwrap();
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
        let kkt = SparseKkt::new(&vec![1.0; info.n_coordinates()], &info.jacobian, info.n_rows()).unwrap();
        kkt.n_factor_entries() as f64 / (side * side) as f64
    };
    let per_knot = [10, 20, 40, 80].map(entries);
    println!("entries of L for each knot: {per_knot:.1?}");
    // n log n: a constant more for each doubling of the side
    for pair in per_knot.windows(2) {
        assert!(pair[1] <= 1.35 * pair[0], "{per_knot:?}");
    }
}
