//! Start values by their names.

use crate::dynamics::System;
use crate::model::{SceneInfo, SceneRef, Start};
use crate::record::{UnknownName, find_name};
use std::collections::HashMap;

/// What is given of a start, in place of what the scene says.
#[derive(Debug, Clone, Default)]
pub(in crate::simulate) struct GivenStart {
    /// By the names of coordinates, velocities and first-order states.
    pub values: Vec<(String, f64)>,
    /// Whether values that contradict the constraints are projected onto them.
    pub gives_way: bool,
    /// What the consistent start is moved by, of the sizes of its numbers.
    pub moved_by: f64,
}

impl GivenStart {
    /// The start of the scene with what is given in its place.
    pub(in crate::simulate) fn of_scene<P: SceneRef>(&self, system: &System<P>) -> Result<Start, UnknownName> {
        let mut start = system.scene_start();
        if !self.values.is_empty() {
            let info = system.info();
            // of a chain there may be ten thousand
            let places: HashMap<&str, usize> = names(info).zip(0..).collect();
            for (name, value) in &self.values {
                let known = places.get(&**name).copied();
                place(info, &mut start, known.map_or_else(|| find(info, name), Ok)?, *value);
            }
        }
        if self.gives_way {
            start.give_way();
        }
        Ok(start)
    }
}

/// Holds a start value by its name.
pub(in crate::simulate) fn give(
    info: &SceneInfo,
    start: &mut Start,
    name: &str,
    value: f64,
) -> Result<(), UnknownName> {
    place(info, start, find(info, name)?, value);
    Ok(())
}

/// Of coordinates, velocities and first-order states.
fn names(info: &SceneInfo) -> impl Iterator<Item = &str> + Clone {
    let positions = info.coordinates.iter().map(|c| &*c.name);
    let velocities = info.velocities.iter().map(|c| &*c.name);
    let states = info.states.iter().map(|state| state.name);
    positions.chain(velocities).chain(states)
}

fn find(info: &SceneInfo, name: &str) -> Result<usize, UnknownName> {
    find_name("start value", name, names(info))
}

/// Holds the start value of a place among the names.
fn place(info: &SceneInfo, start: &mut Start, i: usize, value: f64) {
    let (n_q, n_v) = (info.n_coordinates(), info.n_velocities());
    match i {
        _ if i < n_q => start.give_position(i, value),
        _ if i < n_q + n_v => start.give_velocity(i - n_q, value),
        _ => start.give_state(info, i - n_q - n_v, value),
    }
}
