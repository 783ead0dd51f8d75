//! The part of a system that says what its rows and forces do at a state: which rows depend on each other, and what cannot go on.

use super::System;
use crate::linalg::{ConditionEstimator, Conditioning};
use crate::model::{Equations as _, SceneRef};

/// What there is to tell of a system at a state.
pub(crate) struct Diagnosis<'s, P: SceneRef> {
    pub(super) system: &'s mut System<P>,
}

impl<P: SceneRef> System<P> {
    /// What there is to tell of a state.
    pub(crate) fn diagnosis(&mut self) -> Diagnosis<'_, P> {
        Diagnosis { system: self }
    }
}

impl<P: SceneRef> Diagnosis<'_, P> {
    /// Storage for [`Diagnosis::conditioning`].
    pub(crate) fn condition_estimator(&self) -> ConditionEstimator {
        ConditionEstimator::new(&self.system.geometry.units, &self.system.info.jacobian)
    }

    /// How well K can be solved with at a state, by an estimator for this scene.
    pub(crate) fn conditioning(&mut self, t: f64, q: &[f64], estimator: &mut ConditionEstimator) -> Conditioning {
        let System { scene, info, fixed, mass, active, buffers, .. } = &mut *self.system;
        scene.velocity_jacobian(fixed, t, q, &mut buffers.jacobian);
        estimator.estimate(mass, &info.jacobian, &buffers.jacobian, active.off())
    }
}
