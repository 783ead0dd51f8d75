//! The motion of a scene in numbers `T`, step by step, with both projections.

use super::SetupError;
use super::adaptive::Adaptive;
use super::discontinuities::Passage;
use super::stepper_state::check_angles;
use crate::dynamics::{MotionError, Projecting, State, not_finite};
use crate::integrate::{Clock, Method, Node, Rk4};
use crate::model::SceneInfo;
use crate::scalar::Scalar;
use std::sync::Arc;

pub(super) struct Trajectory<D, T> {
    pub system: D,
    info: Arc<SceneInfo>,
    method: Steps<T>,
    pub now: State<T>,
    next: State<T>,
    a: Vec<T>,
    lambda: Vec<T>,
}

enum Steps<T> {
    Rk4 { method: Box<Rk4<T>>, step_s: f64 },
    Dop853(Box<Adaptive<T>>),
}

impl<D: Projecting<T>, T: Scalar> Trajectory<D, T> {
    /// From `start`, which meets the rows.
    pub(super) fn new(system: D, info: Arc<SceneInfo>, start: State<T>, method: Method) -> Result<Self, SetupError> {
        SetupError::refuse_modes(&info)?;
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        let method = match method.lifted() {
            Method::Rk4 { step_s } if step_s.is_finite() && step_s > 0.0 => {
                Steps::Rk4 { method: Box::new(Rk4::new(n_q, n_c, 0)), step_s }
            }
            Method::Rk4 { step_s } => return Err(SetupError::Step { step_s }),
            Method::Dop853(tolerance) => {
                super::build::check_tolerance(tolerance)?;
                Steps::Dop853(Box::new(Adaptive::new(n_q, n_c, 0, tolerance)))
            }
            Method::Taylor(_) | Method::Gauss(_) | Method::Radau(_) => {
                return Err(SetupError::SingleNumbers { method: method.name() });
            }
        };
        let zeros = |n: usize| vec![T::from_f64(0.0); n];
        let next = State::zeros(n_q, 0);
        Ok(Self { system, info, method, now: start, next, a: zeros(n_q), lambda: zeros(n_c) })
    }

    /// Steps to `until_s`; after an error `now` is the last good state.
    pub(super) fn advance(&mut self, until_s: f64) -> Result<(), MotionError> {
        let start = self.now.t;
        if !until_s.is_finite() {
            return Err(MotionError::NotFinite { t: start, quantity: "the end of the run".into() });
        }
        if let Steps::Rk4 { step_s, .. } = self.method {
            let clock = Clock::new(start, until_s, step_s);
            return (0..clock.n_steps()).try_for_each(|n| self.step(clock.step(n), clock.time(n + 1)));
        }
        while self.now.t < until_s {
            self.step(until_s - self.now.t, until_s)?;
        }
        Ok(())
    }

    /// A step of length `h` to `t_next`; a method that chooses its steps may stop before.
    pub(super) fn step(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        let Self { system, info, method, now, next, a, lambda } = self;
        system.accelerations(now.t, &now.q, &now.v, a, lambda)?;
        let from = Node { state: now, a, power: &[] };
        match method {
            Steps::Rk4 { method, .. } => method.step(system, from, h, t_next, next)?,
            Steps::Dop853(adaptive) => adaptive.step(system, from, t_next, next, |_, _| Passage::Smooth)?,
        }
        if let Some(quantity) = not_finite(info, &next.q, &next.v) {
            return Err(MotionError::NotFinite { t: now.t, quantity });
        }
        system.project(next.t, &mut next.q, &mut next.v)?;
        if let Steps::Dop853(adaptive) = method {
            check_angles(info, Some(adaptive.tolerance()), next)?;
        }
        std::mem::swap(now, next);
        Ok(())
    }
}
