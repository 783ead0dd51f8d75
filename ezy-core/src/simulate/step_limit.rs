//! The end of a step whose length a method chooses.

use super::tolerances::steps::SHORTEST;

/// Length and end of a step, s.
pub(super) struct StepLimit {
    pub step_s: f64,
    pub t_next: f64,
}

/// A step of about `length` from `t` towards `end`. The last two steps share the rest equally.
pub(super) fn limited_step(t: f64, end: f64, length: f64) -> StepLimit {
    let left = end - t;
    let n_left = left / length;
    if n_left <= 1.0 {
        return StepLimit { step_s: left, t_next: end };
    }
    let wanted = if n_left < 2.0 { 0.5 * left } else { length };
    // the difference of two doubles, so that times carry no rounding
    let t_next = t + wanted;
    StepLimit { step_s: t_next - t, t_next }
}

/// Whether a step of this length from `t` would change nothing.
pub(super) fn is_too_short(t: f64, length: f64) -> bool {
    length <= SHORTEST * t.abs().max(1.0)
}
