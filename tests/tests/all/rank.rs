//! Lost rank is reported with the rows, by every backend, and never solved as if nothing were wrong.

use crate::scenes::{Case, coast, set};
use ezy_core::dynamics::MotionError;
use ezy_core::model::Scene;
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;

const BACKENDS: [Backend; 3] = [Backend::Generated, Backend::Dense, Backend::Sparse];

/// Both wheels at the hinge, the bar at an angle to the seat.
fn wheels_at_the_hinge(scene: &dyn Scene, psi: f64, phi: f64, backend: Backend) -> Result<Run, SetupError> {
    Simulation::new(scene)
        .backend(backend)
        .until(0.01)
        .give("seat.phi", phi)
        .give("bar.phi", phi + psi)
        .give("seat.vx", 0.0)
        .run()
}

fn dependent_rows(result: Result<Run, SetupError>) -> Vec<&'static str> {
    match result {
        Err(SetupError::Motion(MotionError::DependentRows { rows, .. })) => rows,
        Err(other) => panic!("{other}"),
        Ok(run) => panic!("ran to {} s", run.last().t),
    }
}

#[test]
fn analytic_rank_loss_names_the_rows() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("b", -0.2), ("d", -0.1)]);
        for backend in BACKENDS {
            // along x the hinge row in x has no part in it; turned, both have
            let rows = dependent_rows(wheels_at_the_hinge(&*scene, 0.0, 0.0, backend));
            assert_eq!(rows, ["B.y", "rear", "front"], "{route} {backend:?}");
            let rows = dependent_rows(wheels_at_the_hinge(&*scene, 0.0, 0.7, backend));
            assert_eq!(rows, ["B.x", "B.y", "rear", "front"], "{route} {backend:?}");
        }
    }
}

#[test]
fn analytic_rank_loss_is_seen_within_rounding() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("b", -0.2), ("d", -0.1)]);
        for backend in BACKENDS {
            let rows = dependent_rows(wheels_at_the_hinge(&*scene, 1e-6, 0.0, backend));
            assert!(rows.contains(&"rear") && rows.contains(&"front"), "{route} {backend:?}: {rows:?}");
        }
    }
}

#[test]
fn analytic_rank_is_full_away_from_alignment() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("b", -0.2), ("d", -0.1)]);
        for backend in BACKENDS {
            let run = wheels_at_the_hinge(&*scene, 0.01, 0.0, backend);
            assert!(run.is_ok_and(|run| run.outcome.reached_end()), "{route} {backend:?}");
        }
    }
}

#[test]
fn invariant_rank_loss_is_an_error_of_the_projections_too() {
    for Case { route, mut scene } in coast() {
        set(&mut *scene, &[("b", -0.2), ("d", -0.1)]);
        for backend in BACKENDS {
            for metric in [Metric::Mass, Metric::Euclidean] {
                let mut system = System::new(&*scene, backend).unwrap();
                let mut v = [0.1; 6];
                let result = system.project_velocities(0.0, &[0.0; 6], &mut v, metric);
                assert!(matches!(result, Err(MotionError::DependentRows { .. })), "{route} {backend:?} {metric:?}");
            }
        }
    }
}
