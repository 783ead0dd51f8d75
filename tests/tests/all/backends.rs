//! The three solvers on whole runs; the same bits twice.

use crate::scenes::{Case, all, distance};
use ezy_core::prelude::*;
use ezy_core_tests::simulation;

/// Rounding of 1e3 steps, amplified by at most 10.
const SAME_MOTION: f64 = 1e-12;

fn end(case: &Case, backend: Backend) -> Vec<f64> {
    let run = simulation(&*case.scene).method(Method::rk4(1e-3)).backend(backend).until(1.0).run().unwrap();
    assert!(run.outcome.reached_end(), "{}: {}", case.route, run.outcome);
    run.last().numbers().collect()
}

#[test]
fn cross_runs_by_all_backends_agree() {
    for case in all() {
        let dense = end(&case, Backend::Dense);
        for backend in [Backend::Generated, Backend::Sparse] {
            let n = 1 + 2 * case.scene.info().n_coordinates();
            let error = distance(&end(&case, backend)[..n], &dense[..n]);
            assert!(error <= SAME_MOTION, "{} {backend:?}: {error:.1e}", case.route);
        }
    }
}

#[test]
fn invariant_same_run_twice_gives_the_same_bits() {
    for case in all() {
        for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
            let bits = |x: Vec<f64>| x.into_iter().map(f64::to_bits).collect::<Vec<_>>();
            assert_eq!(bits(end(&case, backend)), bits(end(&case, backend)), "{} {backend:?}", case.route);
        }
    }
}

#[test]
fn invariant_auto_takes_the_generated_elimination() {
    for case in all() {
        assert_eq!(end(&case, Backend::Auto), end(&case, Backend::Generated), "{}", case.route);
    }
}
