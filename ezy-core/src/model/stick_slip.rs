//! Stick–slip friction: a skate that holds up to a limit and slides beyond it.

use super::{EventInfo, Formula};

/// The skate with a limit. It holds while its multiplier is within the limit.
///
/// Beyond the limit the skate slides: a force of the size of the limit opposes the velocity across it, until that velocity
/// returns to zero. Then it holds again, or slides to the other side if its reaction still exceeds the limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StickSlipInfo {
    /// Its name, and that of its constraint.
    pub name: &'static str,
    /// Index of its constraint in [`SceneInfo::rows`](super::SceneInfo::rows).
    pub row: usize,
    /// The limit, N.
    pub limit: Formula,
    /// It begins to slide.
    pub slides: EventInfo,
    /// It stops sliding to one side.
    pub stops: EventInfo,
}
