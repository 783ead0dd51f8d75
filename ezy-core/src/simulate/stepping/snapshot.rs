//! One state of a run with its accelerations.

use crate::archive::Archive;
use crate::dynamics::{MotionError, Rows, Solved, State, System};
use crate::integrate::Node;
use crate::model::{SceneInfo, SceneRef};

/// A state with its accelerations, multipliers and powers.
#[derive(Clone)]
pub(in crate::simulate) struct Snapshot {
    pub state: State,
    /// Rates of the coordinates; empty where all bodies are planar.
    pub q_rate: Vec<f64>,
    pub a: Vec<f64>,
    pub lambda: Vec<f64>,
    /// Rates of the first-order states.
    pub rate: Vec<f64>,
    /// As many as the state has works.
    pub power: Vec<f64>,
    /// How the accelerations were solved for.
    pub solved: Solved,
    /// How the projection that led there was solved.
    pub end: Solved,
}

impl Snapshot {
    /// Everything zero; without room for works and powers unless they are wanted.
    pub(in crate::simulate) fn zero(info: &SceneInfo, work: bool) -> Self {
        let [n_q, n_v, n_c] = [info.n_coordinates(), info.n_velocities(), info.n_rows()];
        let n_works = if work { info.n_effects() } else { 0 };
        Self {
            state: State::zeros([n_q, n_v], info.n_states(), n_works),
            rate: vec![0.0; info.n_states()],
            q_rate: vec![0.0; if info.is_planar() { 0 } else { n_q }],
            a: vec![0.0; n_v],
            lambda: vec![0.0; n_c],
            power: vec![0.0; n_works],
            solved: Solved::default(),
            end: Solved::default(),
        }
    }

    /// Writes it, or reads another one over it.
    pub(in crate::simulate) fn remember(&mut self, archive: &mut Archive) {
        let Self { state, q_rate, a, lambda, rate, power, solved, end } = self;
        state.remember(archive);
        [q_rate, a, lambda, rate, power].into_iter().for_each(|numbers| archive.numbers(numbers));
        [solved, end].into_iter().for_each(|solved| solved.remember(archive));
    }

    /// Accelerations, multipliers and powers at the state.
    pub(in crate::simulate) fn evaluate<P: SceneRef>(&mut self, system: &mut System<P>) -> Result<(), MotionError> {
        let State { t, q, v, z, .. } = &self.state;
        system.place_states(z);
        let solved = system.at_with(*t, q, Rows::Projected).accelerations(v, &mut self.a, &mut self.lambda)?;
        self.complete(system, solved)
    }

    /// What belongs to the accelerations.
    ///
    /// # Errors
    /// [`MotionError::ContradictoryRows`].
    pub(in crate::simulate) fn complete<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        solved: Solved,
    ) -> Result<(), MotionError> {
        let State { t, q, v, .. } = &self.state;
        self.solved = solved;
        system.diagnosis().check_accelerations(*t, q, solved)?;
        system.state_rates(*t, q, v, &mut self.rate);
        if !self.q_rate.is_empty() {
            system.position_rates(q, v, &mut self.q_rate);
        }
        system.power(*t, q, v, &self.lambda, &mut self.power);
        Ok(())
    }

    pub(in crate::simulate) fn node(&self) -> Node<'_> {
        let q_rate = if self.q_rate.is_empty() { &self.state.v } else { &self.q_rate };
        Node { state: &self.state, q_rate, a: &self.a, rate: &self.rate, power: &self.power }
    }
}
