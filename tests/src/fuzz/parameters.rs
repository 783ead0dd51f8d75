//! One set of parameters, start values and inputs of one scene.

use std::panic::{AssertUnwindSafe, catch_unwind};

use ezy_core::model::SceneEntry;
use ezy_core::prelude::*;
use ezy_models::registry::MODELS;

use super::accelerations;
use super::draw::Draw;
use super::motion::{self, Order};
use super::tally::{Tally, Verdict};
use crate::{random_models, shapes};
use ezy_core_tests::system_of;

/// Most members of a scene, the product of its counts: beyond it the oracle, and a net at singular positions in a build without
/// optimisation, are too slow.
const MOST_MEMBERS: usize = 6;

/// States anywhere of a scene with given parameters.
const N_STATES: usize = 2;

/// The scenes that are tried: of the registry, of random mechanisms, of shapes that these do not have.
pub struct Scenes(Vec<(&'static ModelInfo, &'static SceneEntry)>);

impl Scenes {
    /// All of them.
    pub fn all() -> Self {
        let models = MODELS.iter().chain(&random_models::MODELS).chain(&shapes::MODELS);
        Self(models.flat_map(|model| model.scenes.iter().map(move |scene| (*model, scene))).collect())
    }

    /// One of them.
    pub(super) fn pick(&self, draw: &mut Draw) -> (&'static ModelInfo, &'static SceneEntry) {
        self.0[draw.below(self.n_scenes())]
    }

    /// How many there are.
    pub fn n_scenes(&self) -> usize {
        self.0.len()
    }
}

/// Trial `i` of a seed: sets a scene up, compares accelerations at its start and at a state anywhere, and runs it.
pub fn trial(scenes: &Scenes, seed: u64, i: u64, tally: &mut Tally) {
    let mut draw = Draw::new(seed, i);
    let (model, entry) = scenes.pick(&mut draw);
    let wild = draw.once_in(2);
    let mut scene = (entry.new)();
    let changed = change(&mut *scene, &mut draw, wild);
    let order = order(&*scene, &mut draw, wild);
    let faults = tally.faults.len();
    let guarded = AssertUnwindSafe(|| attempt(&*scene, &order, &mut draw, tally));
    if catch_unwind(guarded).is_err() {
        tally.faults.push("panic".to_owned());
    }
    for fault in &mut tally.faults[faults..] {
        *fault = format!("trial {i}: {}/{}: {fault}; {changed:?}, {order:?}", model.name, entry.name);
    }
}

/// A scene, `Model/scene`, with these parameters: compares accelerations at its start and at some states anywhere.
///
/// # Panics
/// When there is no such scene or parameter.
pub fn compare(scenes: &Scenes, name: &str, parameters: &[(&str, f64)], tally: &mut Tally) {
    let named = |(model, entry): &&(&ModelInfo, &SceneEntry)| name == format!("{}/{}", model.name, entry.name);
    let (_, entry) = scenes.0.iter().find(named).expect("a scene of this name");
    let mut scene = (entry.new)();
    for (name, value) in parameters {
        let i = scene.info().parameters.iter().position(|parameter| parameter.name == *name);
        scene.set_parameter(i.expect("a parameter of this name"), *value);
    }
    let mut draw = Draw::new(0, 0);
    let Ok(mut system) = system_of(&*scene, Backend::Auto) else {
        return tally.count(Verdict::ParametersRefused);
    };
    let start = system.consistent_start(&system.scene_start());
    let anywhere: Vec<State> = (0..N_STATES).map(|_| anywhere(&system, &mut draw)).collect();
    for state in start.iter().chain(&anywhere) {
        match accelerations::check(&mut system, state, &mut draw) {
            Ok(verdict) => tally.count(verdict),
            Err(fault) => tally.faults.push(format!("{name}: {fault}; {parameters:?}")),
        }
    }
}

/// What the scene makes of it.
fn attempt(scene: &dyn Scene, order: &Order, draw: &mut Draw, tally: &mut Tally) {
    let mut keep = |outcome: Result<Verdict, String>| match outcome {
        Ok(verdict) => tally.count(verdict),
        Err(fault) => tally.faults.push(fault),
    };
    let Ok(mut system) = system_of(scene, Backend::Auto) else {
        return keep(Ok(Verdict::ParametersRefused));
    };
    set_inputs(&mut system, order);
    match system.consistent_start(&start(&system, order)) {
        Err(_) => keep(Ok(Verdict::StartRefused)),
        Ok(state) => keep(accelerations::check(&mut system, &state, draw)),
    }
    let anywhere = anywhere(&system, draw);
    keep(accelerations::check(&mut system, &anywhere, draw));
    keep(motion::check(scene, order));
}

/// Changes parameters and counts; gives back those that it changed.
pub(super) fn change(scene: &mut dyn Scene, draw: &mut Draw, wild: bool) -> Vec<(&'static str, f64)> {
    let (mut changed, mut most) = (Vec::new(), MOST_MEMBERS);
    for i in 0..scene.info().counts().len() {
        let count = 1 + draw.below(most);
        scene.set_count(i, count);
        changed.push((scene.info().counts()[i].name, count as f64));
        most /= count;
    }
    for i in 0..scene.info().parameters.len() {
        if draw.once_in(2) {
            let value = draw.instead_of(scene.parameter(i), wild);
            scene.set_parameter(i, value);
            changed.push((scene.info().parameters[i].name, value));
        }
    }
    changed
}

/// Some start values and inputs.
fn order(scene: &dyn Scene, draw: &mut Draw, wild: bool) -> Order {
    let mut order = Order::new(draw, wild);
    let info = scene.info();
    for (coordinate, velocity) in info.coordinates.iter().zip(&*info.velocities) {
        for name in [&coordinate.name, &velocity.name] {
            if draw.once_in(12) {
                order.given.push((name.to_string(), draw.instead_of(1.0, wild)));
            }
        }
    }
    for input in scene.info().inputs {
        if draw.once_in(2) {
            order.inputs.push((input.name.to_owned(), draw.instead_of(input.default, wild)));
        }
    }
    order
}

fn set_inputs(system: &mut System<&(dyn Scene + '_)>, order: &Order) {
    for (name, value) in &order.inputs {
        let i = system.info().inputs.iter().position(|input| input.name == name);
        i.into_iter().for_each(|i| system.inputs_mut()[i] = *value);
    }
}

/// The start of the scene with what is given.
fn start(system: &System<&(dyn Scene + '_)>, order: &Order) -> ezy_core::model::Start {
    let mut start = system.scene_start();
    let info = system.info();
    for (i, (coordinate, velocity)) in info.coordinates.iter().zip(&*info.velocities).enumerate() {
        for (name, value) in &order.given {
            if *name == coordinate.name {
                start.give_position(i, *value);
            } else if *name == velocity.name {
                start.give_velocity(i, *value);
            }
        }
    }
    start
}

/// A state that need not fulfil the rows: the equations hold everywhere.
fn anywhere(system: &System<&(dyn Scene + '_)>, draw: &mut Draw) -> State {
    let n = system.info().n_coordinates();
    let q = (0..n).map(|_| draw.between(-2.0, 2.0)).collect();
    State {
        t: draw.between(0.0, 2.0),
        q,
        v: (0..n).map(|_| draw.between(-2.0, 2.0)).collect(),
        z: Vec::new(),
        work: Vec::new(),
    }
}
