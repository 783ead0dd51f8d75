//! The end of a step whose length a method chooses.

use super::tolerances::steps::SHORTEST;

/// Length and end of a step, s.
pub(crate) struct StepLimit {
    pub step_s: f64,
    pub t_next: f64,
    /// Whether the end decides the length, and not what was asked for, which times round.
    pub nears_end: bool,
}

/// A step of about `length` from `t` towards `end`. The last two steps share the rest equally.
pub(crate) fn limited_step(t: f64, end: f64, length: f64) -> StepLimit {
    let left = end - t;
    let n_left = left / length;
    if n_left <= 1.0 {
        return StepLimit { step_s: left, t_next: end, nears_end: true };
    }
    let nears_end = n_left < 2.0;
    let wanted = if nears_end { 0.5 * left } else { length };
    // the difference of two doubles, so that times carry no rounding
    let t_next = t + wanted;
    StepLimit { step_s: t_next - t, t_next, nears_end }
}

/// Whether a step of this length from `t` would change nothing.
pub(crate) fn is_too_short(t: f64, length: f64) -> bool {
    length <= SHORTEST * t.abs().max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1 s from 2 s on: a step longer than that ends with it, one that leaves less than itself halves it.
    #[test]
    fn analytic_last_two_steps_share_the_rest() {
        for (length, step_s, t_next) in
            [(1.5, 1.0, 3.0), (1.0, 1.0, 3.0), (0.75, 0.5, 2.5), (0.5, 0.5, 2.5), (0.25, 0.25, 2.25)]
        {
            let found = limited_step(2.0, 3.0, length);
            assert_eq!((found.step_s, found.t_next), (step_s, t_next), "{length}");
            assert_eq!(found.nears_end, length > 0.5, "{length}");
        }
        // the length is that of the times: 1e9 s + 1e-7 s is rounded to 1.19e-7 s
        let found = limited_step(1e9, 2e9, 1e-7);
        assert!(found.t_next - 1e9 == found.step_s && found.step_s == 2.0_f64.powi(-23), "{}", found.step_s);
        // rounded down to 0: shorter, but not for the end
        let found = limited_step(1e9, 2e9, 5e-8);
        assert!(found.step_s < 5e-8 && !found.nears_end);
    }

    /// Steps below 45 roundings of the time, or of one second, lead nowhere.
    #[test]
    fn analytic_steps_are_too_short_beside_their_time() {
        for (t, shortest) in [(0.0, 1e-14), (-100.0, 1e-12), (100.0, 1e-12)] {
            assert!(is_too_short(t, 0.99 * shortest) && !is_too_short(t, 1.01 * shortest), "{t}");
        }
    }
}
