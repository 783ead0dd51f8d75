//! What accuracy costs: the errors are those that an independent comparison finds, the ladder climbs, budgets hold.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::registry::find;
use ezy_models::{chain, double_pendulum, ezy_roller};
use ezy_study::accuracy::{Accuracy, AccuracyError, Ladder, Measured, PointResult, Variant, WorkPrecision};
use ezy_tests::reference::load;

/// Two references with 31 digits from starts that differ in the last bit, and their rounding to f64.
const REFERENCE: f64 = 5e-15;
/// Positions are projected until |C| is 1e-12; levers make some times that of a position, however fine the rung.
const PROJECTED: f64 = 1e-11;
/// Seconds that are never reached: the tests must not depend on the speed of the machine.
const AMPLE_S: f64 = 1e4;

fn coarse() -> Ladder {
    Ladder { tolerances: vec![1e-4, 1e-7, 1e-10], n_steps: 3 }
}

fn measured(scene: &dyn Scene, until_s: f64) -> WorkPrecision {
    Accuracy::new(scene).until(until_s).ladder(coarse()).budget(AMPLE_S).measure(|_, _| ()).unwrap()
}

fn largest(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

fn named(path: &str) -> Box<dyn Scene> {
    (find(path).unwrap().scene.unwrap().new)()
}

#[test]
fn cross_errors_of_the_coasting_roller_are_those_against_another_reference() {
    let scene = ezy_roller::Coast::default();
    let found = measured(&scene, 1.0);
    let answer = load("ezyroller_coast").into_iter().next_back().unwrap();
    assert_eq!(found.until_s, answer.t);
    for (method, point) in found.curve("rk4", Variant::default()) {
        let run = simulation(&scene).method(method).run().unwrap();
        let last = run.last();
        let expected = [
            largest(last.coordinates, &answer.q),
            largest(last.velocities, &answer.v),
            largest(last.multipliers, &answer.lambda),
        ];
        let end = point.error.end;
        let told = [end.position.absolute, end.velocity.absolute, end.reaction.absolute];
        // multipliers reach 200 N
        for (told, (expected, size)) in told.into_iter().zip(expected.into_iter().zip([1.0, 1.0, 200.0])) {
            assert!((told - expected).abs() < REFERENCE * size, "{method:?}: {told:e} {expected:e}");
        }
        assert_eq!(point.cost.steps, run.cost.steps);
        assert_eq!(point.cost.evaluations, run.cost.evaluations);
    }
}

#[test]
fn invariant_the_finest_rung_beats_the_coarsest_in_scenes_of_every_kind() {
    // driven wheels, a massless body, a loop, a spring, counts, rows of velocities alone
    let scenes = [
        ("ezyroller/driven", 1.0),
        ("pendulum/swing", 1.0),
        ("fourbar/driven", 1.0),
        ("slidercrank/pushed", 1.0),
        ("chain/swing", 0.1),
        ("chaplyginsleigh/coast", 4.0),
    ];
    for (path, until_s) in scenes {
        let scene = named(path);
        let found = measured(scene.as_ref(), until_s);
        let second = found.reference.second.as_ref().unwrap_or_else(|why| panic!("{path}: {why}"));
        assert!(second.confirms(), "{path}: {second:?}");
        assert_eq!(found.reference.imprecise, None, "{path}");
        for method in ["dop853", "rk4"] {
            for variant in Variant::all(&scene.info()) {
                let curve: Vec<&Measured> = found.curve(method, variant).map(|(_, point)| point).collect();
                assert!(curve.len() >= 2, "{path} {method} {}: {:?}", variant.name(), found.missing());
                // neighbours may come the other way round: a few loose steps can be lucky, or rejected at dead points
                let [coarsest, finest] = [curve[0], curve[curve.len() - 1]];
                let [loose, tight] = [coarsest, finest].map(|point| point.error.grid.position.absolute);
                assert!(tight < loose.max(PROJECTED), "{path} {method} {}: {loose:e} {tight:e}", variant.name());
                assert!(coarsest.cost.evaluations < finest.cost.evaluations, "{path} {method} {}", variant.name());
            }
        }
    }
}

#[test]
fn cross_reference_of_a_scene_without_series_is_dop853_and_rk4_confirms_it() {
    // an input that is set: the motion in double-double knows declared ones alone
    let scene = named("ezyroller/ridden");
    let order = Accuracy::new(scene.as_ref()).until(1.0).input("torque", 2.0).ladder(coarse()).budget(AMPLE_S);
    let found = order.measure(|_, _| ()).unwrap();
    let reference = &found.reference;
    assert!(reference.by.starts_with("dop853") && reference.imprecise.is_some(), "{}", reference.by);
    let second = reference.second.as_ref().unwrap();
    assert!(second.by.starts_with("rk4") && second.confirms(), "{second:?}");
}

#[test]
fn invariant_projected_runs_keep_to_their_rows_and_others_drift() {
    let found = measured(&ezy_roller::Driven::default(), 2.0);
    let loosest = |variant: Variant| *found.curve("dop853", variant).next().unwrap().1;
    let [both, none] = [loosest(Variant::default()), loosest(Variant::NONE)];
    // the tolerance of the projection
    assert!(both.position_residual <= 1e-12 && none.position_residual > 1e-9, "{both:?} {none:?}");
    assert!(both.velocity_residual < 1e-12 && none.velocity_residual > 1e-9, "{both:?} {none:?}");
}

#[test]
fn invariant_a_motion_that_multiplies_rounding_is_measured_up_to_where_it_is_known() {
    // errors grow 12,000 times in 10 s, and so on
    let found = Accuracy::new(&double_pendulum::Swing::default())
        .until(60.0)
        .ladder(Ladder { tolerances: vec![1e-4], n_steps: 1 })
        .budget(AMPLE_S)
        .measure(|_, _| ())
        .unwrap();
    assert!(found.unknown.is_some_and(|difference| difference > 1e-6), "{:?}", found.unknown);
    assert!(found.until_s > 5.0 && found.until_s < 60.0 && found.asked_until_s == 60.0, "{}", found.until_s);
    assert!(found.reference_text().iter().any(|text| text.contains("multiplies rounding")));
}

#[test]
fn invariant_what_does_not_fit_into_the_budget_is_listed() {
    // no setting fits into what the reference leaves of a budget that is all but over
    let scene = ezy_roller::Coast::default();
    let told = std::cell::Cell::new(0);
    let found = Accuracy::new(&scene).until(0.01).budget(0.5).measure(|fraction, _| {
        assert!((0.0..=1.0).contains(&fraction));
        if told.replace(told.get() + 1) == 1 {
            std::thread::sleep(std::time::Duration::from_secs_f64(0.6));
        }
    });
    let found = found.unwrap();
    assert!(found.points.iter().any(|point| matches!(point.result, PointResult::NotRun)));
    assert!(found.missing_text().iter().any(|line| line.contains("not run within the budget")));
    assert_eq!(found.csv().lines().count(), 1 + found.points.len());
}

#[test]
fn invariant_orders_that_cannot_be_carried_out_are_refused() {
    let scene = ezy_roller::Coast::default();
    let refused = |order: Accuracy<'_>| order.measure(|_, _| ()).unwrap_err();
    assert!(matches!(refused(Accuracy::new(&scene).until(0.0)), AccuracyError::NoTime { .. }));
    assert!(matches!(refused(Accuracy::new(&scene).budget(0.0)), AccuracyError::Budget { .. }));
    assert!(matches!(refused(Accuracy::new(&scene).start("seat.z", 0.0)), AccuracyError::Setup(_)));
    let too_long = chain::Swing { n: 2_000_000, ..Default::default() };
    assert!(matches!(refused(Accuracy::new(&too_long)), AccuracyError::Setup(_)));
}
