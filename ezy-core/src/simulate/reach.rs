//! Where a step ends whose length a method chooses.

/// A step shorter than this part of the time, or of a second, moves nothing any more.
const SHORTEST: f64 = 1e-14;

/// The last step may be longer by this part, so that no splinter of a step is left.
const STRETCH: f64 = 1e-3;

/// Length and end of a step, s.
pub(super) struct Reach {
    pub step_s: f64,
    pub t_next: f64,
}

/// A step of about `length` from `t` on the way to `end`; the last two share what is left.
pub(super) fn reach(t: f64, end: f64, length: f64) -> Reach {
    let left = end - t;
    let n_left = left / length;
    if n_left <= 1.0 + STRETCH {
        return Reach { step_s: left, t_next: end };
    }
    let wanted = if n_left < 2.0 { 0.5 * left } else { length };
    // the length that the clock can show, so that times carry no rounding
    let t_next = t + wanted;
    Reach { step_s: t_next - t, t_next }
}

/// Whether a step of this length from `t` would move nothing.
pub(super) fn is_too_short(t: f64, length: f64) -> bool {
    length <= SHORTEST * t.abs().max(1.0)
}
