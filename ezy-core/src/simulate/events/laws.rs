//! The laws of rows that can be switched, where they are numbers that a run can go by.

use crate::dynamics::{MotionError, System};
use crate::model::{Derived as _, SceneRef, StickSlipInfo, StopInfo};

/// What the skate with a limit holds up to, N, and the velocity across it, m/s.
///
/// # Errors
/// [`MotionError::SkateLimit`] where the skate can neither hold nor slide.
pub(in crate::simulate) fn stick_slip<P: SceneRef>(
    system: &System<P>,
    info: &StickSlipInfo,
    t: f64,
    q: &[f64],
    v: &[f64],
) -> Result<[f64; 2], MotionError> {
    let mut values = [0.0; 2];
    system.scene().stick_slip(system.fixed(), t, q, v, &mut values);
    match values {
        [limit, _] if limit > 0.0 => Ok(values),
        [limit, _] => Err(MotionError::SkateLimit { t, skate: info.name, value: limit }),
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
