//! Lost rank is survived, with the rows named, by every backend.

use crate::scenes::{Case, coast, set};
use ezy_core::dynamics::RankLoss;
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_core_tests::{simulation, system_of};

const BACKENDS: [Backend; 3] = [Backend::Generated, Backend::Dense, Backend::Sparse];

/// Velocities of 0.1 m/s.
const ROUNDING: f64 = 1e-15;

/// Both wheels at the hinge, the bar at an angle to the seat.
fn wheels_at_the_hinge(scene: &dyn Scene, psi: f64, phi: f64, backend: Backend) -> Result<Run, SetupError> {
    simulation(scene)
        .method(Method::rk4(1e-3))
        .backend(backend)
        .until(0.01)
        .start("seat.phi", phi)
        .start("bar.phi", phi + psi)
        .start("seat.vx", 0.0)
        .run()
}

/// What a run that reached its end tells about the rank at its start.
fn lost_at_start(result: Result<Run, SetupError>) -> RankLoss {
    let run = result.unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    assert_eq!(run.rank.intervals[0].from_s, 0.0);
    run.rank.intervals[0].loss.clone()
}

#[test]
fn analytic_rank_loss_names_the_rows() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("b", -0.2), ("d", -0.1)]);
        for backend in BACKENDS {
            // along x the hinge row in x has no part in it; turned, both have
            let loss = lost_at_start(wheels_at_the_hinge(&*scene, 0.0, 0.0, backend));
            assert_eq!(loss.n_redundant, Some(1), "{route} {backend:?}");
            assert_eq!(loss.rows, ["B.y", "rear", "front"], "{route} {backend:?}");
            let loss = lost_at_start(wheels_at_the_hinge(&*scene, 0.0, 0.7, backend));
            assert_eq!(loss.rows, ["B.x", "B.y", "rear", "front"], "{route} {backend:?}");
        }
    }
}

#[test]
fn analytic_rank_loss_is_seen_within_rounding() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("b", -0.2), ("d", -0.1)]);
        for backend in BACKENDS {
            let rows = lost_at_start(wheels_at_the_hinge(&*scene, 1e-6, 0.0, backend)).rows;
            assert!(
                ["rear", "front"].iter().all(|row| rows.iter().any(|lost| lost == row)),
                "{route} {backend:?}: {rows:?}"
            );
        }
    }
}

#[test]
fn analytic_rank_is_full_away_from_alignment() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("b", -0.2), ("d", -0.1)]);
        for backend in BACKENDS {
            let run = wheels_at_the_hinge(&*scene, 0.01, 0.0, backend);
            assert!(
                run.is_ok_and(|run| run.outcome.reached_end() && run.rank.intervals.is_empty()),
                "{route} {backend:?}"
            );
        }
    }
}

#[test]
fn invariant_projections_meet_the_rows_where_rank_is_lost() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("b", -0.2), ("d", -0.1)]);
        for backend in BACKENDS {
            for metric in [Metric::Mass, Metric::Euclidean] {
                let mut system = system_of(&*scene, backend).unwrap();
                let mut v = [0.1; 6];
                let solved = system.project_velocities(0.0, &[0.0; 6], &mut v, metric).unwrap();
                let left = system.velocity_residual(0.0, &[0.0; 6], &v);
                assert!(solved.is_rank_deficient && left <= ROUNDING, "{route} {backend:?} {metric:?}: {left:.1e}");
            }
        }
    }
}
