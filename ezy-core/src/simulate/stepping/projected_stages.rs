//! Steps of DOP853 with projected stages.

use super::snapshot::Snapshot;
use crate::archive::Archive;
use crate::dynamics::{MotionError, OnRows, State, System};
use crate::integrate::{Dop853, Sizes, Tolerance};
use crate::model::SceneRef;

/// DOP853 for accelerations that are evaluated on the constraints alone: they may have a pole beside them.
pub(super) struct ProjectedStages {
    dop853: Dop853,
    pub tolerance: Tolerance,
    /// The projected state of a stage; between steps a buffer.
    pub on_rows: State,
}

impl ProjectedStages {
    pub(super) fn new<P: SceneRef>(system: &System<P>, n_works: usize, tolerance: Tolerance) -> Self {
        let info = system.info();
        let on_rows = State::zeros([info.n_coordinates(), info.n_velocities()], 0, 0);
        Self { dop853: Dop853::new(Sizes::new(info, n_works)), tolerance, on_rows }
    }

    /// Writes the last step, or reads it.
    pub(super) fn remember(&mut self, archive: &mut Archive) {
        self.dop853.remember(archive);
    }

    /// A step without history of the length `h`; its error over tolerance, without the part that a projection of its end removes.
    pub(super) fn attempt<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        now: &Snapshot,
        h: f64,
        to: &mut State,
    ) -> Result<f64, MotionError> {
        self.dop853.restart();
        let mut on_rows = OnRows::new(system, &mut self.on_rows);
        let error = self.dop853.attempt(&mut on_rows, now.node(), h, self.tolerance, to)?;
        let tangential =
            if error > 1.0 { self.dop853.tangential_error(&mut on_rows, h, self.tolerance, to) } else { None };
        Ok(tangential.unwrap_or(error))
    }

    /// Prepares the interpolant of a step with this end, which is evaluated.
    pub(super) fn prepare_dense<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        now: &Snapshot,
        end: &Snapshot,
    ) -> Result<(), MotionError> {
        let mut on_rows = OnRows::new(system, &mut self.on_rows);
        self.dop853.prepare_dense(&mut on_rows, now.node(), end.node())
    }

    /// The state after a part `theta` of the step, not projected; its time is left.
    pub(super) fn dense_at(&mut self, theta: f64, out: &mut State) {
        self.dop853.dense_at(theta, out);
    }
}
