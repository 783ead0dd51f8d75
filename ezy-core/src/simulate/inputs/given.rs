//! Start values by their names.

use crate::dynamics::System;
use crate::model::{SceneInfo, SceneRef, Start};
use crate::record::{UnknownName, find_name};

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
        for (name, value) in &self.values {
            give(system.info(), &mut start, name, *value)?;
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
    let positions = info.coordinates.iter().map(|c| &*c.name);
    let velocities = info.velocities.iter().map(|c| &*c.name);
    let states = info.states.iter().map(|state| state.name);
    let i = find_name("start value", name, positions.chain(velocities).chain(states))?;
    let (n_q, n_v) = (info.n_coordinates(), info.n_velocities());
    match i {
        _ if i < n_q => start.give_position(i, value),
        _ if i < n_q + n_v => start.give_velocity(i - n_q, value),
        _ => start.give_state(info, i - n_q - n_v, value),
    }
    Ok(())
}
