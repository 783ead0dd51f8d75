//! Accelerations of states near the rows: those of the projected states.

use super::projection::Next;
use super::solved::Rows;
use super::{Dynamics, Metric, MotionError, Projection, State, System};
use crate::model::SceneRef;

/// A system whose accelerations do not depend on how far a state is off the rows.
///
/// On the rows they are those of the state itself. Off the rows, next to a position in which constraints depend on each other,
/// accelerations of the state itself have a pole; those of the projected state have none.
pub(crate) struct OnRows<'m, P: SceneRef> {
    system: &'m mut System<P>,
    /// The last projected state; without works.
    projected: &'m mut State,
}

impl<'m, P: SceneRef> OnRows<'m, P> {
    /// With a buffer for projected states.
    pub(crate) fn new(system: &'m mut System<P>, projected: &'m mut State) -> Self {
        Self { system, projected }
    }
}

impl<P: SceneRef> Dynamics<f64> for OnRows<'_, P> {
    fn accelerations(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), MotionError> {
        let State { q: on_q, v: on_v, .. } = &mut *self.projected;
        on_q.copy_from_slice(q);
        on_v.copy_from_slice(v);
        let next = Next { rows: Rows::Held, accelerates: true };
        self.system.projector().project_with(t, on_q, on_v, Projection::Both, Metric::Mass, next)?;
        self.system.at_with(t, on_q, Rows::Held).accelerations(on_v, a, lambda).map(|_| ())
    }

    fn position_rates(&self, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.system.position_rates(q, v, out);
    }

    fn place_states(&mut self, z: &[f64]) {
        self.system.place_states(z);
    }

    /// At the state whose accelerations were computed last.
    fn state_rates(&self, t: f64, _q: &[f64], _v: &[f64], out: &mut [f64]) {
        self.system.state_rates(t, &self.projected.q, &self.projected.v, out);
    }

    /// At the state whose accelerations were computed last.
    fn power(&self, t: f64, _q: &[f64], _v: &[f64], lambda: &[f64], out: &mut [f64]) {
        self.system.power(t, &self.projected.q, &self.projected.v, lambda, out);
    }

    fn project_onto_null_space(&mut self, t: f64, q: &[f64], x: &mut [f64]) -> bool {
        self.system.at_with(t, q, Rows::Projected).project_onto_null_space(x).is_ok()
    }
}
