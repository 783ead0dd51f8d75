//! Rows of four-bar linkages against the closed form of parallel cranks.

use ezy_core::dynamics::RankLoss;
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};
use ezy_models::n_four_bar;
use ezy_tests::garage::{at_times, load, number, worse};

/// RK4 at 1 ms over 0.5 s, for the top joint and its velocity of 3 m/s.
const TOP: f64 = 1e-9;

#[test]
fn reference_linkages_of_one_to_forty_loops() {
    let file = load("a02_n_four_bar");
    for case in file["cases"].as_array().unwrap() {
        let n = number(&case["N"]) as usize;
        let rows: Vec<_> = case["rows"].as_array().unwrap().iter().filter(|row| number(&row[0]) <= 0.5).collect();
        // long rows of linkages only at the beginning
        let rows = if n > 3 { &rows[..1] } else { &rows[..] };
        let scene = n_four_bar::Fall { n, ..Default::default() };
        let order = || simulation(&scene).method(Method::rk4(1e-3));
        at_times(order, 0.1, rows.iter().map(|row| number(&row[0])), |i, s| {
            let phi = number(&rows[i][1]);
            let rate = number(&rows[i][2]);
            let mut error = 0.0;
            for crank in 0..=n {
                error = worse(error, s.coordinates[3 * crank + 2] - (std::f64::consts::FRAC_PI_2 - phi));
                error = worse(error, s.velocities[3 * crank + 2] + rate);
            }
            assert!(error <= TOP, "{n} loops: {error:.1e} at {} s", s.t);
        });
    }
}

/// Rows that depend on each other with every rod along the x axis, where the freedom is n + 1.
fn flat(n: usize) -> RankLoss {
    let scene = n_four_bar::Fall { n, ..Default::default() };
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let (n_q, n_c) = (system.info().n_coordinates(), system.info().n_rows());
    let mut q = vec![0.0; n_q];
    for body in 0..=2 * n {
        q[3 * body] = if body <= n { body as f64 + 0.5 } else { (body - n - 1) as f64 + 1.5 };
    }
    let (mut a, mut lambda) = (vec![0.0; n_q], vec![0.0; n_c]);
    let solved = system.accelerations(0.0, &q, &vec![0.0; n_q], &mut a, &mut lambda).unwrap();
    assert!(solved.is_rank_deficient && a.iter().all(|a| a.is_finite()), "{n} loops");
    system.rank_loss(0.0, &q)
}

#[test]
fn analytic_flat_linkage_names_its_rows_or_the_first_that_fails() {
    // level rods do not turn in x: seven rows in x hold the x of five bodies
    let small = flat(2);
    assert_eq!(small.n_redundant, Some(2));
    assert!(small.rows.iter().all(|row| row.ends_with(".x")), "{small}");
    let large = flat(100);
    assert_eq!(large.n_redundant, None);
    assert!(large.rows.len() == 1 && large.rows[0].ends_with(".x"), "{large}");
}
