//! The order of every method in every scene: the error of one step against the length of it.

use crate::scenes::distance;
use ezy_core::prelude::*;
use ezy_core::testing::{GivenSteps, StepsBy};
use ezy_core_tests::{simulation, system_of};
use ezy_models::registry::MODELS;

/// Order of the series that tells where a step should lead; two fifths of its radius leave nothing to see.
const ORACLE: usize = 40;
/// Part of that radius, taken as the distance at which the last terms are 1, that the longest step has.
const LONGEST: f64 = 0.4;
/// Each step over the next one.
const RATIO: f64 = 1.2;
/// Lengths of steps: a method of order 4 needs 17 of them to come from 1e-6 to rounding, one of order 12 six.
const N_STEPS: i32 = 40;
/// Errors above it, over the size of the state, are not yet those of small steps.
const LARGE: f64 = 1e-6;
/// Rounding of a step's sums, over the size of the state, with a margin of hundreds so that it bends no slope.
const ROUNDING: f64 = 5e-14;
/// Higher terms of the error.
const ORDER_TOLERANCE: f64 = 0.5;
/// The terms of order 8 of DOP853 are so small that smaller steps meet rounding before those of higher order have died away.
const DOP853_TOLERANCE: f64 = 1.0;
/// A scene on its way, where nothing is zero by symmetry.
fn on_the_way(scene: &dyn Scene) -> State {
    let until_s = 0.3 * scene.info().until_s.min(2.0);
    let run = simulation(scene).method(Method::dop853(1e-10)).until(until_s).run().unwrap();
    let last = run.last();
    let [q, v, z] = [last.coordinates, last.velocities, last.states].map(<[f64]>::to_vec);
    State { t: last.t, q, v, z, work: Vec::new() }
}

/// Order of one step from a state over the lengths that show one; none where a method leaves no error.
fn order(scene: &dyn Scene, state: &State, by: StepsBy) -> Option<f64> {
    let [mut oracle, mut steps] = [StepsBy::Taylor(ORACLE), by].map(|by| {
        let system = system_of(scene, Backend::Auto).unwrap();
        GivenSteps::new(system, state.clone(), by).expect("a series and Jacobians")
    });
    // where the terms of the series are as large as the state
    let radius = oracle.radius().unwrap().expect("the oracle is a series");
    let longest = (LONGEST * radius).min(1.0);
    let size = state.q.iter().chain(&state.v).chain(&state.z).fold(1.0, |m: f64, x| m.max(x.abs()));
    let mut errors = Vec::new();
    for i in 0..N_STEPS {
        let h = longest / RATIO.powi(i);
        [&mut oracle, &mut steps].into_iter().for_each(|steps| steps.place(state));
        let exact = oracle.attempt(h).unwrap().expect("a series does not iterate");
        // where the iteration does not converge there is no error to be seen
        let Some(end) = steps.attempt(h).unwrap() else { continue };
        let error = distance(&exact.q, &end.q).max(distance(&exact.v, &end.v)).max(distance(&exact.z, &end.z)) / size;
        if error < ROUNDING {
            break;
        }
        if error < LARGE {
            errors.push(error);
        }
    }
    let [.., first, _, _, last] = errors[..] else { return None };
    // a step errs with one power more than the method; over three lengths, since a term may cross zero at one of them
    Some((first / last).ln() / RATIO.powi(3).ln() - 1.0)
}

/// A method that is better than its order in a scene, such as RK4 where forces do not vary, is no fault.
#[test]
fn order_of_every_method_in_every_scene() {
    let methods = [
        (StepsBy::Method(MethodKind::Midpoint), 2.0 - ORDER_TOLERANCE),
        (StepsBy::Method(MethodKind::Rk4), 4.0 - ORDER_TOLERANCE),
        (StepsBy::Method(MethodKind::Dop853), 8.0 - DOP853_TOLERANCE),
        (StepsBy::Method(MethodKind::Radau), 5.0 - ORDER_TOLERANCE),
        (StepsBy::Taylor(8), 8.0 - ORDER_TOLERANCE),
        (StepsBy::Taylor(12), 12.0 - ORDER_TOLERANCE),
    ];
    let mut n_measured = [0; 6];
    let (mut n_scenes, mut faults) = (0, Vec::new());
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        let scene = (entry.new)();
        if scene.series().is_none() {
            continue;
        }
        n_scenes += 1;
        let state = on_the_way(&*scene);
        for ((by, least), n) in methods.into_iter().zip(&mut n_measured) {
            let Some(order) = order(&*scene, &state, by) else { continue };
            *n += 1;
            if order < least {
                faults.push(format!("{}/{}, {by:?}: {order:.2}", scene.info().model, scene.info().name));
            }
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
    // what moves uniformly or as a polynomial shows none
    assert!(n_scenes >= 38 && n_measured.iter().all(|n| *n >= 15), "{n_scenes} scenes, {n_measured:?} measured");
}
