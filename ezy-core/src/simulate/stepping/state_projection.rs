//! Projection of the states of a run, and what it found.

use crate::dynamics::{Metric, MotionError, Projected, Projection, State, System};
use crate::model::SceneRef;

/// How states are projected.
pub(in crate::simulate) struct StateProjection {
    projection: Projection,
    metric: Metric,
    /// What the last projection of a state found and left.
    pub projected: Projected,
}

impl StateProjection {
    pub(super) fn new(projection: Projection, metric: Metric) -> Self {
        Self { projection, metric, projected: Projected::default() }
    }

    /// Whether positions and velocities are projected in the metric of the masses, as crossing steps are.
    pub(super) fn is_complete(&self) -> bool {
        self.projection == Projection::Both && self.metric == Metric::Mass
    }

    /// Projects a state as the ends of steps are.
    pub(super) fn project<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        state: &mut State,
    ) -> Result<(), MotionError> {
        self.projected = self.project_unseen(system, state)?;
        Ok(())
    }

    /// Projects the end of a step, at which accelerations are asked for next, with these inputs.
    #[inline]
    pub(super) fn project_end<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        state: &mut State,
    ) -> Result<(), MotionError> {
        let State { t, q, v, .. } = state;
        self.projected = system.projector().project_end(*t, q, v, self.projection, self.metric)?;
        Ok(())
    }

    /// Sees the end of a step that needs no projection.
    pub(super) fn see_kept<P: SceneRef>(&mut self, system: &mut System<P>, state: &State) {
        let positions_after = system.projector().worst_position(state.t, &state.q);
        self.projected = Projected { positions_after, ..Projected::default() };
    }

    /// Projects a state that is no end of a step: monitors do not see by how much.
    pub(super) fn project_unseen<P: SceneRef>(
        &self,
        system: &mut System<P>,
        state: &mut State,
    ) -> Result<Projected, MotionError> {
        let State { t, q, v, .. } = state;
        system.project(*t, q, v, self.projection, self.metric)
    }
}
