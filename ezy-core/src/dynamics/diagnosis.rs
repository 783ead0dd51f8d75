//! The part of a system that says what its rows and forces do at a state: which rows depend on each other, and what cannot go on.

use super::tolerances::geometry::TOLERANCE;
use super::{Rows, System, max_abs};
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
        let System { scene, fixed, mass, active, factors, sines, .. } = &mut *self.system;
        estimator.estimate(mass, factors.jacobian_at(scene, fixed, sines, t, q), active.off())
    }

    /// What rounding makes of multipliers that the elimination of the scene finds at a state (`n_q`, `n_v`), relative to one more than each: their difference
    /// from a solution to the last digits by an estimator that has the factors of this state. Zero where there is no such elimination, or it does not solve.
    pub(crate) fn rounding_of_multipliers(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        (a, lambda): (&mut [f64], &mut [f64]),
        estimator: &mut ConditionEstimator,
    ) -> f64 {
        if !self.system.at_with(t, q, Rows::Projected).may_eliminate() {
            return 0.0;
        }
        let System { scene, fixed, .. } = &mut *self.system;
        if !scene.accelerations(fixed, t, q, v, a, lambda).all_keep() {
            return 0.0;
        }
        let mut right_side = vec![0.0; a.len() + lambda.len()];
        let (r, s) = right_side.split_at_mut(a.len());
        self.system.at(t, q).write_right_side(v, r, s);
        let exact = &estimator.solution(&right_side)[a.len()..];
        let relative = |(exact, found): (&f64, &mut f64)| (exact - *found).abs() / (1.0 + exact.abs());
        let largest = exact.iter().zip(lambda).map(relative).fold(0.0, f64::max);
        if largest.is_finite() { largest } else { 0.0 }
    }

    /// Work of the largest multiplier over the tolerance of positions, J: a body that is held gains or loses as much by rounding.
    /// Test: `monitors.rs`, a plate that cannot move.
    pub(crate) fn work_of_rounding(&self, multipliers: &[f64]) -> f64 {
        TOLERANCE * self.system.geometry.length * max_abs(multipliers)
    }
}
