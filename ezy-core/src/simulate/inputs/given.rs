//! Start values by their names.

use crate::model::{SceneInfo, Start};
use crate::record::{UnknownName, find_name};

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
