//! The motion of a scene in numbers `T`, step by step, with both projections.

use crate::dynamics::{MotionError, Projecting, State, state_not_finite};
use crate::integrate::{Clock, Integrator, Method, Node, Sizes, Smooth, Tolerance};
use crate::model::SceneInfo;
use crate::scalar::Scalar;
use crate::simulate::SetupError;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

pub(in crate::simulate) struct Trajectory<D, T> {
    pub system: D,
    info: Arc<SceneInfo>,
    integrator: Box<dyn Integrator<D, T>>,
    method: Method,
    pub now: State<T>,
    next: State<T>,
    q_rate: Vec<T>,
    a: Vec<T>,
    rate: Vec<T>,
    lambda: Vec<T>,
}

impl<D: Projecting<T>, T: Scalar> Trajectory<D, T> {
    /// From `start`, which meets the rows.
    pub(in crate::simulate) fn new(
        system: D,
        info: Arc<SceneInfo>,
        start: State<T>,
        method: Method,
    ) -> Result<Self, SetupError> {
        let sizes = Sizes::new(&info, 0);
        let method = checked(&info, method)?;
        let integrator = method.kind().in_any_number(sizes, method.tolerance().unwrap_or(Tolerance::ANY));
        let integrator = integrator.ok_or(SetupError::SingleNumbers { method: method.name() })?;
        let Sizes { n_q, n_v, n_c, n_z, .. } = sizes;
        let zeros = |n: usize| vec![T::from_f64(0.0); n];
        let next = State::zeros([n_q, n_v], n_z, 0);
        Ok(Self {
            system,
            info,
            integrator,
            method,
            now: start,
            next,
            q_rate: zeros(n_q),
            a: zeros(n_v),
            rate: zeros(n_z),
            lambda: zeros(n_c),
        })
    }

    /// Steps to `until_s`; after an error `now` is the last good state.
    pub(in crate::simulate) fn advance(&mut self, until_s: f64) -> Result<(), MotionError> {
        self.advance_unless(until_s, &AtomicBool::new(false))
    }

    /// The same, unless `is_over` is set on the way.
    pub(in crate::simulate) fn advance_unless(
        &mut self,
        until_s: f64,
        is_over: &AtomicBool,
    ) -> Result<(), MotionError> {
        let start = self.now.t;
        check_end(start, until_s)?;
        let goes_on = || !is_over.load(Ordering::Relaxed);
        if let Some(step_s) = self.method.step_s() {
            let clock = Clock::new(start, until_s, step_s);
            let mut steps = (0..clock.n_steps()).take_while(|_| goes_on());
            return steps.try_for_each(|n| self.step(clock.step(n), clock.time(n + 1)));
        }
        while self.now.t < until_s && goes_on() {
            self.step(until_s - self.now.t, until_s)?;
        }
        Ok(())
    }

    /// Forgets the steps taken so far.
    pub(in crate::simulate) fn restart(&mut self) {
        self.integrator.restart();
    }

    /// A step of length `h` to `t_next`; a method that chooses its steps may stop before.
    pub(in crate::simulate) fn step(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        let Self { system, info, integrator, method, now, next, q_rate, a, rate, lambda } = self;
        system.place_states(&now.z);
        system.accelerations(now.t, &now.q, &now.v, a, lambda)?;
        system.state_rates(now.t, &now.q, &now.v, rate);
        system.position_rates(&now.q, &now.v, q_rate);
        let from = Node { state: now, q_rate, a, rate, power: &[] };
        integrator.step(system, from, h, t_next, &mut Smooth, next)?;
        if let Some(quantity) = state_not_finite(info, next) {
            return Err(MotionError::NotFinite { t: now.t, quantity });
        }
        system.project(next.t, &mut next.q, &mut next.v)?;
        if let Some(tolerance) = method.tolerance() {
            tolerance.check_angles(info, next.t, &next.q)?;
        }
        std::mem::swap(now, next);
        Ok(())
    }
}

/// The method, where it can be used on this scene.
///
/// # Errors
/// [`SetupError`].
pub(in crate::simulate) fn checked(info: &SceneInfo, method: Method) -> Result<Method, SetupError> {
    SetupError::refuse_modes(info)?;
    SetupError::refuse_angles(info, method.tolerance())?;
    crate::simulate::checked::checked(method)
}

/// That a run from `t` has an end.
///
/// # Errors
/// [`MotionError::NotFinite`].
pub(in crate::simulate) fn check_end(t: f64, until_s: f64) -> Result<(), MotionError> {
    if until_s.is_finite() { Ok(()) } else { Err(MotionError::NotFinite { t, quantity: "the end of the run".into() }) }
}
