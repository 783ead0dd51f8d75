//! About how long the steps of a run are, where some are cut short.

/// Part of a step by which the usual length comes nearer to it where it is shorter.
const FADING: f64 = 0.1;

/// Part of the usual length that is tried before shorter steps next to rank loss: a mechanism that passes a singular position in
/// one such step is farther from it, and from the noise there, than one that creeps up to it.
pub(super) const SHORTEST: f64 = 1.0 / 16.0;

/// The usual length of steps after one of `length`, which the run took `taken` of, s.
pub(super) fn follow(usual_s: f64, length: f64, taken: f64) -> f64 {
    taken.max(usual_s - FADING * length)
}
