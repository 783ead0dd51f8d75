//! Start values by their names.

use crate::model::{SceneInfo, Start};
use crate::record::{UnknownName, find_name};

/// Holds a start value by its name.
pub(super) fn give(info: &SceneInfo, start: &mut Start, name: &str, value: f64) -> Result<(), UnknownName> {
    let positions = info.coordinates.iter().map(|c| &*c.name);
    let velocities = info.coordinates.iter().map(|c| &*c.velocity_name);
    let i = find_name("start value", name, positions.chain(velocities))?;
    match i.checked_sub(info.n_coordinates()) {
        None => start.give_position(i, value),
        Some(i) => start.give_velocity(i, value),
    }
    Ok(())
}
