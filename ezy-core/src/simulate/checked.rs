//! Steps and tolerances that can be used.

use super::SetupError;
use super::tolerances::orders::LARGEST_TOLERANCE;
use crate::integrate::{Method, Tolerance};

/// The method that a run takes, whose step or tolerance can be used.
pub(super) fn checked(method: Method) -> Result<Method, SetupError> {
    let method = method.lifted();
    method.step_s().map(check_step).transpose()?;
    method.tolerance().map(check_tolerance).transpose()?;
    Ok(method)
}

/// That a fixed step is a positive length of time, s.
pub(super) fn check_step(step_s: f64) -> Result<f64, SetupError> {
    if step_s.is_finite() && step_s > 0.0 { Ok(step_s) } else { Err(SetupError::Step { step_s }) }
}

/// That tolerances are positive and no larger than any motion needs.
pub(super) fn check_tolerance(tolerance: Tolerance) -> Result<(), SetupError> {
    let Tolerance { relative, absolute, angle } = tolerance;
    let usable = |x: f64| x > 0.0 && x <= LARGEST_TOLERANCE;
    if let Some(rad) = angle.filter(|rad| !usable(*rad)) {
        return Err(SetupError::AngleTolerance { rad, largest: LARGEST_TOLERANCE });
    }
    if usable(relative) && usable(absolute) {
        return Ok(());
    }
    Err(SetupError::Tolerance { relative, absolute, largest: LARGEST_TOLERANCE })
}
