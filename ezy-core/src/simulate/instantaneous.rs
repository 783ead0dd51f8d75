//! One state of a run with its accelerations.

use crate::dynamics::{MotionError, State, System};
use crate::integrate::Knot;
use crate::model::{Scene, SceneInfo};

/// A state with its accelerations, multipliers and powers.
pub(super) struct Instantaneous {
    pub state: State,
    pub a: Vec<f64>,
    pub lambda: Vec<f64>,
    /// As many as the state has works.
    pub power: Vec<f64>,
    /// Whether rows depend on each other there.
    pub lost_rank: bool,
    /// Smallest pivot there, as the projection saw it.
    pub pivot: f64,
}

impl Instantaneous {
    /// Everything zero; without room for works and powers unless they are wanted.
    pub fn zero(info: &SceneInfo, work: bool) -> Self {
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        let n_works = if work { info.n_effects() } else { 0 };
        Self {
            state: State::zero(n_q, n_works),
            a: vec![0.0; n_q],
            lambda: vec![0.0; n_c],
            power: vec![0.0; n_works],
            lost_rank: false,
            pivot: 0.0,
        }
    }

    /// Accelerations, multipliers and powers at the state.
    pub fn evaluate<S: Scene + ?Sized>(&mut self, system: &mut System<'_, S>) -> Result<(), MotionError> {
        let State { t, q, v, .. } = &self.state;
        system.accelerations_in_passing(*t, q, v, &mut self.a, &mut self.lambda)?;
        self.complete(system)
    }

    /// Checks the accelerations that were computed last, and computes the powers.
    ///
    /// # Errors
    /// [`MotionError::ContradictoryRows`].
    pub fn complete<S: Scene + ?Sized>(&mut self, system: &mut System<'_, S>) -> Result<(), MotionError> {
        let State { t, q, v, .. } = &self.state;
        self.lost_rank = system.lost_rank();
        system.check_accelerations(*t, q)?;
        system.power(*t, q, v, &self.lambda, &mut self.power);
        Ok(())
    }

    pub fn knot(&self) -> Knot<'_> {
        Knot { state: &self.state, a: &self.a, power: &self.power }
    }
}
