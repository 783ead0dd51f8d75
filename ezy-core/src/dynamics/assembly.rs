//! The part of a system that assembles starts.

use super::System;
use crate::model::SceneRef;

/// The search for a state that meets the rows: what is given stays, what is not follows.
pub(crate) struct Assembly<'s, P: SceneRef> {
    pub(super) system: &'s mut System<P>,
}

impl<P: SceneRef> System<P> {
    /// The search for a start.
    pub(crate) fn assembly(&mut self) -> Assembly<'_, P> {
        Assembly { system: self }
    }
}
