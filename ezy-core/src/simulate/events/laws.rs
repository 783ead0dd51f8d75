//! The laws of rows that can be switched, where they are numbers that a run can go by.

use crate::dynamics::{MotionError, System};
use crate::model::{Derived as _, SceneRef, StopInfo};

/// What a skate with a limit holds up to, N, and the velocity across it, m/s; by its place in
/// [`SceneInfo::limited_skates`](crate::model::SceneInfo::limited_skates). Writes what `Derived::limited_skates` does into the buffer.
///
/// # Errors
/// [`MotionError::SkateLimit`] where the skate can neither hold nor slide.
pub(in crate::simulate) fn limited_skate<P: SceneRef>(
    system: &System<P>,
    skate: usize,
    t: f64,
    q: &[f64],
    v: &[f64],
    values: &mut Vec<f64>,
) -> Result<[f64; 2], MotionError> {
    let skates = system.info().limited_skates;
    values.resize(2 * skates.len(), 0.0);
    system.scene().limited_skates(system.fixed(), t, q, v, values);
    match [values[2 * skate], values[2 * skate + 1]] {
        [limit, velocity] if limit > 0.0 => Ok([limit, velocity]),
        [limit, _] => Err(MotionError::SkateLimit { t, skate: skates[skate].name, value: limit }),
    }
}

/// Distances to the ends of the stop with their rates, and the restitution; writes what `Derived::stop` does.
///
/// # Errors
/// [`MotionError::StopNotFinite`] where a distance is no number.
pub(in crate::simulate) fn stop<P: SceneRef>(
    system: &System<P>,
    info: &StopInfo,
    t: f64,
    q: &[f64],
    v: &[f64],
    out: &mut [f64],
) -> Result<(), MotionError> {
    system.scene().stop(system.fixed(), t, q, v, out);
    for (end, &value) in out.iter().step_by(2).take(info.hits.len()).enumerate() {
        if !value.is_finite() {
            return Err(MotionError::StopNotFinite { t, stop: info.name, end: info.end(end), what: "distance", value });
        }
    }
    Ok(())
}
