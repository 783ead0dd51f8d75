//! Runs of DOP853 in quasi-velocities, beside those of the rows: another solver than the elimination of a scene takes the rows.

use crate::scenes::distance;
use ezy_core::model::{EventKind, Scene, SceneInfo};
use ezy_core::prelude::*;
use ezy_core::simulate::Monitors;
use ezy_core_tests::{simulation, system_of};
use ezy_models::registry::MODELS;
use ezy_models::{double_pendulum, ezy_roller, wheeled_snake};

const TOLERANCE: f64 = 1e-11;

/// What a motion of two seconds makes of a difference, at most: that of the double pendulum grows by e^2.5 a second.
const AMPLIFICATION: f64 = 150.0;

/// Scenes with equations in quasi-velocities without free bodies and first-order states, whose rows do not move, and whose forces are smooth, if the generated
/// elimination solves for their accelerations.
fn scenes() -> Vec<Box<dyn Scene>> {
    let takes = |info: &SceneInfo| {
        info.quasi_velocities.is_some_and(|of| !of.has_free_body)
            && info.states.is_empty()
            && info.effects.iter().all(|effect| effect.name != "drives")
            && info.events.iter().all(|event| !matches!(event.kind, EventKind::Discontinuity | EventKind::Layer))
    };
    let entries = MODELS.iter().flat_map(|model| model.scenes).filter(|entry| takes(&(entry.info)()));
    let scenes = entries.map(|entry| (entry.new)());
    let scenes: Vec<_> =
        scenes.filter(|scene| system_of(&**scene, Backend::Auto).unwrap().uses_elimination()).collect();
    assert!(scenes.len() >= 10, "{}", scenes.len());
    scenes
}

fn name(scene: &dyn Scene) -> String {
    let info = scene.info();
    format!("{}/{}", info.model, info.name)
}

fn order(scene: &dyn Scene) -> Simulation<'_, &dyn Scene> {
    let until = scene.info().until_s.min(2.0);
    simulation(scene).method(Method::dop853(TOLERANCE)).until(until).every(0.07)
}

/// Errors of both runs add up, each step with a tolerance of a number as large as any, and works with that of their energies.
fn tolerated(run: &Run) -> f64 {
    let size = run
        .samples()
        .flat_map(|sample| sample.numbers().collect::<Vec<_>>())
        .fold(1.0, |size: f64, x| size.max(x.abs()));
    2.0 * AMPLIFICATION * run.cost.steps as f64 * TOLERANCE * size
}

#[test]
fn cross_motions_and_works_are_those_of_rows() {
    for scene in scenes() {
        let info = scene.info();
        let [reduced, of_rows] =
            [Backend::Auto, Backend::Dense].map(|backend| order(&*scene).backend(backend).work().run().unwrap());
        let bound = tolerated(&of_rows);
        let n_numbers = 1 + 2 * info.n_coordinates();
        let samples = reduced.samples().zip(of_rows.samples());
        for (one, other) in samples {
            let [x, y] = [&one, &other].map(|sample| sample.numbers().take(n_numbers).collect::<Vec<_>>());
            let works = distance(one.work, other.work);
            let off = distance(&x, &y).max(works);
            assert!(off <= bound, "{} at {} s: {off:.1e} > {bound:.1e}", name(&*scene), one.t);
        }
    }
}

/// Rounding of a coordinate that is a sum of ten others, and of a velocity that follows from ten operations and a division by a lever of a hundredth of the
/// others: both beside numbers of one.
const ROUNDING: [f64; 2] = [10.0 * f64::EPSILON, 1e3 * f64::EPSILON];

#[test]
fn invariant_rows_are_obeyed_without_a_projection() {
    for scene in scenes() {
        let run = order(&*scene).run().unwrap();
        let size = |of: fn(&Sample<'_>) -> Vec<f64>| {
            run.samples().flat_map(|sample| of(&sample)).fold(1.0, |size: f64, x| size.max(x.abs()))
        };
        let sizes = [size(|sample| sample.coordinates.to_vec()), size(|sample| sample.velocities.to_vec())];
        let Monitors { position_residual, velocity_residual, position_drift, velocity_drift, .. } = &run.monitors;
        let levels = [(position_residual, position_drift), (velocity_residual, velocity_drift)];
        for ((residual, removed), (size, rounding)) in levels.into_iter().zip(sizes.into_iter().zip(ROUNDING)) {
            let residual = residual.as_ref().map_or(0.0, |peak| peak.value);
            assert!(residual <= rounding * size, "{}: {residual:e} > {:e}", name(&*scene), rounding * size);
            assert!(removed.as_ref().is_none_or(|peak| peak.value == 0.0), "{}: {removed:?}", name(&*scene));
        }
    }
}

#[test]
fn invariant_works_do_not_change_the_motion() {
    for scene in scenes() {
        let n = 1 + 2 * scene.info().n_coordinates();
        let bits = |run: Run| -> Vec<u64> {
            run.samples().flat_map(|sample| sample.numbers().take(n).map(f64::to_bits).collect::<Vec<_>>()).collect()
        };
        let [bare, working] = [order(&*scene), order(&*scene).work()].map(|order| bits(order.run().unwrap()));
        assert!(bare == working, "{}", name(&*scene));
    }
}

/// What is asked between the ends of steps moves none of them.
#[test]
fn invariant_samples_do_not_change_the_motion() {
    for scene in scenes() {
        let [with, without] = [true, false].map(|with| {
            let order = if with { order(&*scene) } else { order(&*scene).every(10.0) };
            order.run().unwrap().last().numbers().map(f64::to_bits).collect::<Vec<_>>()
        });
        assert!(with == without, "{}", name(&*scene));
    }
}

/// Parameters for which a pivot vanishes, the front wheel at the hinge: steps are those of the rows.
#[test]
fn invariant_runs_without_a_pivot_are_those_of_rows() {
    let scene = ezy_roller::Driven { c: -0.1, ..Default::default() };
    let run = order(&scene).until(0.1).run().unwrap();
    assert!(run.monitors.position_drift.as_ref().is_some_and(|peak| peak.value > 0.0), "{:?}", run.monitors);
}

/// A snake whose joints are prescribed, afloat and on ground that brakes it; on wheels; a racer, and pendulums on a hinge.
#[test]
fn analytic_bodies_are_free_where_no_row_holds_their_place() {
    let scenes: [&dyn Scene; 5] = [
        &wheeled_snake::Floating::default(),
        &wheeled_snake::Crawling::default(),
        &wheeled_snake::Slithering::default(),
        &ezy_roller::Driven::default(),
        &double_pendulum::Swing::default(),
    ];
    let are_free = scenes.map(|scene| scene.info().quasi_velocities.unwrap().has_free_body);
    assert_eq!(are_free, [true, true, false, false, false]);
}
