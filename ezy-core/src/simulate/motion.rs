//! A scene in motion: where it is, and how it gets one step further. What runs and steppers share.

use super::instantaneous::Instantaneous;
use crate::dynamics::{Metric, MotionError, Projection, State, System};
use crate::integrate::Rk4;
use crate::model::Scene;

/// The state `now`, and `next` where the step under way ends.
pub(super) struct Motion<'s, S: Scene + ?Sized> {
    pub system: System<'s, S>,
    method: Rk4,
    projection: Projection,
    metric: Metric,
    /// Whether works are integrated.
    pub work: bool,
    pub now: Instantaneous,
    pub next: Instantaneous,
}

impl<'s, S: Scene + ?Sized> Motion<'s, S> {
    pub fn new(system: System<'s, S>, projection: Projection, metric: Metric, work: bool) -> Self {
        let info = system.info();
        let [now, next] = std::array::from_fn(|_| Instantaneous::zero(info, work));
        let method = Rk4::new(info.n_coordinates(), info.n_rows(), now.power.len());
        Self { system, method, projection, metric, work, now, next }
    }

    /// Goes to a state without history; what belongs to it is not evaluated.
    pub fn place(&mut self, state: &State) {
        let now = &mut self.now.state;
        now.t = state.t;
        now.q.copy_from_slice(&state.q);
        now.v.copy_from_slice(&state.v);
        now.work.fill(0.0);
        self.method.restart();
    }

    /// A step of length `h` from `now`, which is evaluated, to `next`, which is projected but not evaluated.
    pub fn advance(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        let (system, next) = (&mut self.system, &mut self.next);
        self.method.step(system, self.now.knot(), h, t_next, &mut next.state)?;
        check_finite(system, self.now.state.t, &next.state)?;
        let State { q, v, .. } = &mut next.state;
        system.project(t_next, q, v, self.projection, self.metric)
    }

    pub fn evaluate_now(&mut self) -> Result<(), MotionError> {
        self.now.evaluate(&mut self.system)
    }

    pub fn evaluate_next(&mut self) -> Result<(), MotionError> {
        self.next.evaluate(&mut self.system)
    }

    /// `next` becomes `now`.
    pub fn accept(&mut self) {
        std::mem::swap(&mut self.now, &mut self.next);
    }
}

pub(super) fn first_not_finite(x: &[f64]) -> Option<usize> {
    x.iter().position(|x| !x.is_finite())
}

fn check_finite<S: Scene + ?Sized>(system: &System<'_, S>, t: f64, state: &State) -> Result<(), MotionError> {
    let coordinates = system.info().coordinates;
    let quantity = match (first_not_finite(&state.q), first_not_finite(&state.v)) {
        (Some(i), _) => coordinates[i].name,
        (None, Some(i)) => coordinates[i].velocity_name,
        (None, None) => match first_not_finite(&state.work) {
            Some(i) => system.info().effects[i].name,
            // squares overflow from 1e154 m/s on
            None if !system.kinetic_energy(&state.v).is_finite() => "kinetic energy",
            None => return Ok(()),
        },
    };
    Err(MotionError::NotFinite { t, quantity })
}
