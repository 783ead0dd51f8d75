//! A skate that holds up to a limit and slides beyond it.

use super::{EventInfo, Formula};

/// The skate of a scene that holds as long as its multiplier is not larger than a limit.
///
/// Where it would be, the skate slides: a force as large as the limit opposes the velocity across it, until that velocity
/// comes back to zero. There it holds again, or slides to the other side where it still needs more than its limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct GripInfo {
    /// Its name, and that of its row.
    pub name: &'static str,
    /// Its row, in [`SceneInfo::rows`](super::SceneInfo::rows).
    pub row: usize,
    /// The limit, N.
    pub limit: Formula,
    /// It begins to slide.
    pub slides: EventInfo,
    /// It stops sliding to one side.
    pub stops: EventInfo,
}
