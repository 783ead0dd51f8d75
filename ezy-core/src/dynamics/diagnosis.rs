//! The part of a system that says what its rows and forces do at a state: which rows depend on each other, and what cannot go on.

use super::tolerances::geometry::TOLERANCE;
use super::{System, max_abs};
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
        let System { scene, info, fixed, mass, active, buffers, sines, .. } = &mut *self.system;
        scene.velocity_jacobian_with_sines(fixed, t, q, sines.at(q), &mut buffers.jacobian);
        estimator.estimate(mass, &info.jacobian, &buffers.jacobian, active.off())
    }

    /// Work of the largest multiplier over the tolerance of positions, J: a body that is held gains or loses as much by rounding.
    /// Test: `monitors.rs`, a plate that cannot move.
    pub(crate) fn work_of_rounding(&self, multipliers: &[f64]) -> f64 {
        TOLERANCE * self.system.geometry.length * max_abs(multipliers)
    }
}
