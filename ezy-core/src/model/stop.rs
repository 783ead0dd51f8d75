//! A stop (unilateral contact): bounds that a quantity of the scene cannot pass.

use super::{EventInfo, Formula};

/// The stop of a scene.
///
/// When the quantity reaches a bound, an impact reverses its rate and multiplies it by the restitution; all constraints are
/// satisfied after it. When the quantity would stay there, the contact closes: the stop is a constraint, `quantity - bound`, as
/// long as it pushes. Its multiplier is negative on the lower end and positive on the upper one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StopInfo {
    /// Its name, and that of its constraint.
    pub name: &'static str,
    /// Index of its constraint in the [`SceneInfo::rows`](super::SceneInfo::rows) of the closed modes.
    pub row: usize,
    /// For each end 1 where it is the lower one, -1 where it is the upper one.
    pub sides: &'static [i8],
    /// Rate after an impact over the rate before it.
    pub restitution: Formula,
    /// The quantity reaches an end; for each one.
    pub hits: &'static [EventInfo],
    /// The contact closes.
    pub holds: EventInfo,
    /// The contact opens: it would have to pull.
    pub lets_go: EventInfo,
}

impl StopInfo {
    /// Name of an end: `lower` or `upper`.
    pub const fn end(&self, i: usize) -> &'static str {
        if self.sides[i] > 0 { "lower" } else { "upper" }
    }
}
