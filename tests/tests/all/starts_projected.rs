//! Starts that contradict the constraints: refused, or projected when asked.

use crate::massless_links::pure_coupler;
use ezy_core::dynamics::StartError;
use ezy_core::model::Start;
use ezy_core::prelude::*;
use ezy_core_tests::{simulation, system_of};
use ezy_models::mechanisms::{four_bar::four_bar, n_four_bar::n_four_bar};

ezy_core::model! {
    /// Three equal cranks under one coupler: a row too many, at every position.
    model ThreeCranks {
        body left { mass: 1, inertia: 1/12 }
        body middle { mass: 3, inertia: 3/12 }
        body right { mass: 2, inertia: 2/12 }
        body coupler { mass: 4, inertia: 2 }
        hinge A: ground(0, 0) ~ left(-0.5, 0);
        hinge B: ground(1, 0) ~ middle(-0.5, 0);
        hinge C: ground(2, 0) ~ right(-0.5, 0);
        hinge D: coupler(-1, 0) ~ left(0.5, 0);
        hinge E: coupler(0, 0) ~ middle(0.5, 0);
        hinge F: coupler(1, 0) ~ right(0.5, 0);
        start slanted {
            left at (0.25, 0.25*sqrt(3)) angle pi/3;
            middle at (1.25, 0.25*sqrt(3)) angle pi/3;
            right at (2.25, 0.25*sqrt(3)) angle pi/3;
            coupler at (1.5, 0.5*sqrt(3)) angle 0;
        }
        scene swing { start slanted; until 1 s; }
    }
}

/// Rounding of a solution in numbers of one.
const ROUNDING: f64 = 1e-12;

/// The state from `start`, of which everything gives way.
fn projected(scene: &impl Scene, mut start: Start) -> State {
    start.give_way();
    system_of(scene, Backend::Auto).unwrap().consistent_start(&start).unwrap()
}

/// A consistent start with all positions given, and all velocities as in `v`.
fn with_velocities(scene: &impl Scene, v: &[f64]) -> Start {
    let mut system = system_of(scene, Backend::Auto).unwrap();
    let consistent = system.consistent_start(&system.scene_start()).unwrap();
    let mut start = Start::free(v.len());
    for (i, (q, v)) in consistent.q.iter().zip(v).enumerate() {
        start.give_position(i, *q);
        start.give_velocity(i, *v);
    }
    start
}

/// `inconsistent_velocities` of `torture.json`: cranks, then couplers, each vx, vy, ω.
const INCONSISTENT: [f64; 15] = [0.0, 0.0, -1.0, 0.6, 0.1, -1.4, 0.3, -0.2, -0.7, 0.8, 0.2, 0.1, 1.3, -0.1, -0.3];
/// Its rate of the cranks in the metric of the masses; in plain numbers it would be 0.98261.
const RATE: f64 = 0.936_111_111_111_111_1;

#[test]
fn reference_contradicting_velocities_are_projected_in_the_mass_metric() {
    let scene = n_four_bar::Fall::default();
    let state = projected(&scene, with_velocities(&scene, &INCONSISTENT));
    let crank = [RATE / 2.0, 0.0, -RATE];
    let coupler = [RATE, 0.0, 0.0];
    let expected = [crank, crank, crank, coupler, coupler].concat();
    let error = crate::scenes::distance(&state.v, &expected);
    assert!(error <= ROUNDING, "{error:.1e}");
}

#[test]
fn invariant_contradicting_velocities_are_refused_with_the_hinge_and_the_remedy() {
    let scene = n_four_bar::Fall::default();
    let start = with_velocities(&scene, &INCONSISTENT);
    let error = system_of(&scene, Backend::Auto).unwrap().consistent_start(&start).unwrap_err().to_string();
    assert!(error.starts_with("the start contradicts the constraints: velocity of "), "{error}");
    assert!(error.contains("foot[1].x") && error.contains("`--project-start`"), "{error}");
}

/// All cranks turn alike: the projected rate is the mean of the given velocities along that motion, weighted by masses.
#[test]
fn analytic_projection_with_a_row_too_many() {
    let scene = three_cranks::Swing::default();
    let v: Vec<f64> = (0..12).map(|i| ((i * i) as f64 * 0.7).sin()).collect();
    let start = with_velocities(&scene, &v);
    let state = projected(&scene, start);
    let (s, c) = std::f64::consts::FRAC_PI_3.sin_cos();
    let (crank, coupler) = ([-0.5 * s, 0.5 * c, 1.0], [-s, c, 0.0]);
    let motion = [crank, crank, crank, coupler].concat();
    let mass = system_of(&scene, Backend::Auto).unwrap().mass_matrix().to_vec();
    let product = |x: &[f64]| (0..12).map(|i| mass[i] * motion[i] * x[i]).sum::<f64>();
    let rate = product(&v) / product(&motion);
    let expected: Vec<f64> = motion.iter().map(|u| rate * u).collect();
    let error = crate::scenes::distance(&state.v, &expected);
    assert!(error <= ROUNDING, "{error:.1e}");
}

/// A coupler without mass has no say in the projected rate.
#[test]
fn analytic_massless_coordinates_follow_at_no_cost() {
    let scene = pure_coupler::Swing::default();
    let mut turning = with_velocities(&scene, &[0.0; 9]);
    turning.v_given.fill(false);
    turning.give_velocity(2, 1.0);
    let motion = system_of(&scene, Backend::Auto).unwrap().consistent_start(&turning).unwrap().v;
    let v = [0.3, -0.2, 1.0, 40.0, -70.0, 90.0, -0.5, 0.8, 0.6];
    let state = projected(&scene, with_velocities(&scene, &v));
    let mass = system_of(&scene, Backend::Auto).unwrap().mass_matrix().to_vec();
    let product = |x: &[f64]| (0..9).map(|i| mass[i] * motion[i] * x[i]).sum::<f64>();
    let rate = product(&v) / product(&motion);
    let expected: Vec<f64> = motion.iter().map(|u| rate * u).collect();
    let error = crate::scenes::distance(&state.v, &expected);
    assert!(error <= ROUNDING, "{error:.1e}");
}

#[test]
fn invariant_order_that_projects_its_start_runs() {
    let scene = four_bar::Turning::default();
    let order = || simulation(&scene).until(0.0).start("crank.omega", -1.0).start("rocker.omega", -0.5);
    assert!(order().run().is_err());
    let run = order().project_start().run().unwrap();
    let rate = |name: &str| run.first().get(name).unwrap();
    assert!((rate("crank.omega") - rate("rocker.omega")).abs() <= ROUNDING);
    assert!(rate("crank.omega") < -0.5 && rate("crank.omega") > -1.0, "{}", rate("crank.omega"));
}

#[test]
fn invariant_given_values_that_fit_are_held_by_a_projected_start() {
    let scene = four_bar::Turning::default();
    let run = simulation(&scene).until(0.0).start("crank.omega", -0.7).project_start().run().unwrap();
    assert_eq!(run.first().get("crank.omega"), Ok(-0.7));
}

#[test]
fn invariant_lengths_that_do_not_reach_are_an_error_with_rows_and_gap() {
    let scene = four_bar::Turning { base: 4.0, ..Default::default() };
    let error = simulation(&scene).until(0.0).project_start().run().unwrap_err();
    let ezy_core::simulate::SetupError::Start(StartError::Contradiction { level, rows, residual, held, .. }) = &error
    else {
        panic!("{error}")
    };
    assert_eq!((*level, held.len()), ("position", 0));
    assert!(!rows.is_empty() && *residual > 0.1 && *residual < 1.0, "{error}");
    assert!(error.to_string().contains("their lengths do not reach"), "{error}");
}
