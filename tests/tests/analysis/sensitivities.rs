//! Derivatives of runs of any scene, by differences of runs.

use super::gradients::{Difference, all, name};
use ezy_core::dynamics::State;
use ezy_core::model::{CoordinateInfo, Scene, Start};
use ezy_core::prelude::*;
use ezy_core::simulate::{SetupError, Tangent};

/// Steps of a run, and its length: seconds, or a share of the scene.
const N_STEPS: u32 = 100;
const LENGTH_S: f64 = 0.1;
const SHARE: f64 = 0.1;

/// A run rounds some ten times in each of its steps, one way as often as the other; the differences divide it by their shortest step.
const ROUNDING: f64 = 100.0 * f64::EPSILON / super::gradients::STEP;

/// Least share of the comparisons in which steps and differences are below rounding.
const SHARP: f64 = 0.95;

/// Names that a run of the scene may be differentiated by: parameters, and what the start gives.
fn quantities(scene: &dyn Scene, start: &Start) -> Vec<String> {
    let info = scene.info();
    let positions = info.coordinates.iter().zip(&start.q_given).zip(&start.q_near);
    let velocities = info.velocities.iter().zip(&start.v_given).zip(&start.v_near);
    let given = positions.chain(velocities).filter(|((_, given), near)| **given && !**near);
    let given = given.map(|((of, _), _)| of.name.to_string());
    info.parameters.iter().map(|of| of.name.to_owned()).chain(given).collect()
}

fn value_of(scene: &dyn Scene, start: &Start, name: &str) -> f64 {
    let info = scene.info();
    let place = |all: &[CoordinateInfo]| all.iter().position(|of| &*of.name == name);
    match (place(&info.coordinates), place(&info.velocities)) {
        (Some(i), _) => start.q[i],
        (_, Some(i)) => start.v[i],
        _ => scene.parameter(info.parameters.iter().position(|of| of.name == name).unwrap()),
    }
}

/// The end of a run from `start` with another value of one quantity; `None` where it cannot run.
fn end(
    scene: &mut dyn Scene,
    start: &Start,
    changed: &str,
    value: f64,
    method: Method,
    until_s: f64,
) -> Option<Vec<f64>> {
    let info = scene.info();
    let parameter = info.parameters.iter().position(|of| of.name == changed);
    let kept = parameter.map(|i| scene.parameter(i));
    if let Some(i) = parameter {
        scene.set_parameter(i, value);
    }
    let place = |all: &[CoordinateInfo]| all.iter().position(|of| &*of.name == changed);
    let mut start = start.clone();
    if let Some(i) = place(&info.coordinates) {
        start.q[i] = value;
    }
    if let Some(i) = place(&info.velocities) {
        start.v[i] = value;
    }
    let begin = System::new(&*scene, Backend::Auto).ok().and_then(|mut system| system.consistent_start(&start).ok());
    let run = begin.and_then(|State { q, v, .. }| {
        let names = info.coordinates.iter().chain(&*info.velocities).map(|of| &*of.name);
        let order = Simulation::new(&*scene).method(method).until(until_s).without_events();
        names.zip(q.iter().chain(&v)).fold(order, |order, (name, value)| order.start(name, *value)).run().ok()
    });
    if let (Some(i), Some(value)) = (parameter, kept) {
        scene.set_parameter(i, value);
    }
    let last = run.as_ref()?.last();
    (last.t == until_s).then(|| [last.coordinates, last.velocities, last.states].concat())
}

/// All shapes of scenes, planar and in space, with counts, closed loops, redundant rows and first-order states.
#[test]
fn fd_derivatives_of_runs_by_everything_that_is_given() {
    let (mut n_scenes, mut n_held, mut n_compared, mut n_sharp, mut worst) = (0, 0, 0, 0, 0.0_f64);
    for scene in &mut all() {
        let scene = &mut **scene;
        let until_s = LENGTH_S.min(SHARE * scene.info().until_s);
        let [coarse, method] = [2.0, 1.0].map(|steps| Method::rk4(steps * until_s / f64::from(N_STEPS)));
        let mut system = System::new(&*scene, Backend::Auto).unwrap();
        let mut start = system.scene_start();
        // what is neither given nor determined changes from there as little as it can, in derivatives and differences
        let State { q, v, .. } = system.consistent_start(&start).unwrap();
        (start.q, start.v) = (q, v);
        let names = quantities(scene, &start);
        let [mut tangents, mut coarser] = [const { Vec::new() }; 2];
        let sensitivities = |by: &[&str], method: Method| {
            let system = System::new(&*scene, Backend::Auto).unwrap();
            Sensitivities::of_scene(system, &start, by, method)
        };
        if let Some(error @ SetupError::Modes { .. }) = sensitivities(&[], method).err() {
            println!("{}: {error}", name(scene));
            continue;
        }
        let (held, names): (Vec<_>, Vec<_>) = names
            .into_iter()
            .partition(|by| matches!(sensitivities(&[by], method), Err(SetupError::HeldByStart { .. })));
        for group in names.chunks(8) {
            let group: Vec<&str> = group.iter().map(String::as_str).collect();
            for (tangents, method) in [(&mut tangents, method), (&mut coarser, coarse)] {
                let mut run = sensitivities(&group, method).unwrap();
                run.advance(until_s).unwrap();
                tangents.extend(run.tangents().into_iter().take(group.len()));
            }
        }
        n_scenes += 1;
        for held in &held {
            let value = value_of(scene, &start, held);
            let h = 1e-3 * value.abs().max(1.0);
            let runs = [h, -h].map(|h| end(scene, &start, held, value + h, method, until_s).is_some());
            assert_eq!(runs, [false; 2], "{} by {held} is refused", name(scene));
        }
        n_held += held.len();
        let numbers = |Tangent { q, v, z }: Tangent| [q, v, z].concat();
        for (changed, (found, coarser)) in names.iter().zip(tangents.into_iter().zip(coarser)) {
            let (found, coarser) = (numbers(found), numbers(coarser));
            let value = value_of(scene, &start, changed);
            let unit = if value == 0.0 { 1.0 } else { value.abs() };
            let mut ran = true;
            let difference = Difference::of(|e| {
                let end = end(scene, &start, changed, value + e * unit, method, until_s);
                ran &= end.is_some();
                let end = end.unwrap_or_else(|| vec![0.0; found.len()]);
                let size = end.iter().fold(1.0_f64, |size, x| size.max(x.abs()));
                (end, size)
            });
            if !ran {
                println!("{} by {changed}: a changed scene does not run", name(scene));
                continue;
            }
            for (i, exact) in found.iter().enumerate() {
                let slope = exact * unit;
                let rounding = ROUNDING * difference.size;
                // derivatives do not follow the way of a projection: an error of a step, of any order less than what steps of two lengths differ by
                let truncation = difference.truncations[i] + (slope - coarser[i] * unit).abs();
                let error = (slope - difference.slopes[i]).abs();
                let at = format!("{} by {changed}, {i}: {slope:e} {:e}", name(scene), difference.slopes[i]);
                assert!(error <= rounding + truncation, "{at}, {truncation:e}, {rounding:e}");
                worst = worst.max((error - truncation) / rounding);
                n_compared += 1;
                n_sharp += usize::from(truncation <= rounding);
            }
        }
    }
    println!(
        "{n_scenes} scenes, {n_held} quantities are held, {n_sharp} of {n_compared} are sharp, {worst:.4} of the bound at most"
    );
    assert!(n_scenes > 70 && n_held > 0 && n_sharp as f64 >= SHARP * n_compared as f64, "{n_sharp} of {n_compared}");
}
