//! The usual step length of a run, of which single steps are cut short.

/// The usual length falls by this part of each shorter step.
const FADING: f64 = 0.1;

/// Next to rank loss, steps are not shorter than this part of the usual length at first. One such step across a singular position
/// stays farther from it, and from the noise there, than many short ones.
pub(super) const SHORTEST: f64 = 1.0 / 16.0;

/// The usual length after a step of `length`, of which the run took `taken`, s.
pub(super) fn follow(usual_s: f64, length: f64, taken: f64) -> f64 {
    taken.max(usual_s - FADING * length)
}
