//! A stop: bounds that a quantity of the scene cannot pass.

use super::{EventInfo, Formula};

/// The stop of a scene.
///
/// Where the quantity reaches a bound, the rate at which it does is turned round, and multiplied by the restitution, by an
/// impulse that keeps all rows. Where it would stay there, the stop is a row of the scene, `quantity - bound`, for as long as it
/// pushes: its multiplier is negative on the lower end and positive on the upper one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StopInfo {
    /// Its name, and that of its row.
    pub name: &'static str,
    /// The place of its row where it holds, in [`SceneInfo::rows`](super::SceneInfo::rows) of the scene then.
    pub row: usize,
    /// For each end 1 where it is the lower one, -1 where it is the upper one.
    pub sides: &'static [i8],
    /// Rate after an impact over the rate before it.
    pub restitution: Formula,
    /// The quantity reaches an end; for each one.
    pub hits: &'static [EventInfo],
    /// The stop begins to hold.
    pub holds: EventInfo,
    /// It would have to pull.
    pub lets_go: EventInfo,
}

impl StopInfo {
    /// What an end is called: `lower` or `upper`.
    pub const fn end(&self, i: usize) -> &'static str {
        if self.sides[i] > 0 { "lower" } else { "upper" }
    }
}
