//! A method at work: its storage and its step control.

use super::SetupError;
use super::adaptive::Adaptive;
use super::events::Kinks;
use super::implicit::Implicit;
use super::instantaneous::Instantaneous;
use super::reach::{Reach, is_too_short, reach};
use crate::dynamics::{MotionError, State, System};
use crate::integrate::{Knot, Method, Radau, Rk4, Taylor, Tolerance, interpolate, taylor_order};
use crate::model::Scene;

pub(super) enum Integrator<'s> {
    Rk4(Box<Rk4>),
    Dop853(Box<Adaptive>),
    Taylor(Box<Taylor<'s>>, Tolerance),
    Radau(Box<Implicit>),
}

impl<'s> Integrator<'s> {
    pub fn new<S: Scene + ?Sized>(method: Method, scene: &'s S, n_works: usize) -> Result<Self, SetupError> {
        let info = scene.info();
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        Ok(match method {
            Method::Rk4 { .. } => Self::Rk4(Box::new(Rk4::new(n_q, n_c, n_works))),
            Method::Dop853(tolerance) => Self::Dop853(Box::new(Adaptive::new(n_q, n_c, n_works, tolerance))),
            Method::Taylor(tolerance) => match Taylor::new(scene, taylor_order(tolerance), n_works) {
                Some(taylor) => Self::Taylor(Box::new(taylor), tolerance),
                None => return Err(SetupError::NoSeries { scene: info.name, series: info.series }),
            },
            Method::Radau(tolerance) => match Radau::new(scene, n_works) {
                Some(radau) => Self::Radau(Box::new(Implicit::new(radau, tolerance))),
                None => return Err(SetupError::NoSlopes { scene: info.name }),
            },
        })
    }

    /// Forgets the steps taken so far.
    pub fn restart(&mut self) {
        match self {
            Self::Rk4(rk4) => rk4.restart(),
            Self::Dop853(adaptive) => adaptive.restart(),
            Self::Taylor(taylor, _) => taylor.restart(),
            Self::Radau(implicit) => implicit.restart(),
        }
    }

    /// Whether it keeps to a tolerance by steps of its own length.
    pub const fn chooses_steps(&self) -> bool {
        !matches!(self, Self::Rk4(_))
    }

    /// Steps that were tried and not taken.
    pub fn n_rejected(&self) -> u64 {
        match self {
            Self::Rk4(_) | Self::Taylor(..) => 0,
            Self::Dop853(adaptive) => adaptive.n_rejected(),
            Self::Radau(implicit) => implicit.n_rejected(),
        }
    }

    /// Since when stability holds the steps of an explicit method that can tell, s.
    pub fn stiff_since(&self) -> Option<f64> {
        match self {
            Self::Dop853(adaptive) => adaptive.stiff_since(),
            _ => None,
        }
    }

    /// Accelerations, multipliers and powers at a state, and what the next step from there needs besides.
    pub fn evaluate<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        at: &mut Instantaneous,
    ) -> Result<(), MotionError> {
        match self {
            Self::Taylor(taylor, _) => {
                let Instantaneous { state, a, lambda, power } = at;
                taylor.expand(system, state, a, lambda)?;
                system.power(state.t, &state.q, &state.v, lambda, power);
                Ok(())
            }
            _ => at.evaluate(system),
        }
    }

    /// The next step starts at the state that was evaluated last.
    pub fn accept(&mut self) {
        if let Self::Taylor(taylor, _) = self {
            taylor.accept();
        }
    }

    /// A step of length `h` from `from` to `t_next`, not yet projected; a method that chooses its steps may stop before.
    pub fn step<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Knot<'_>,
        h: f64,
        t_next: f64,
        kinks: &mut Kinks,
        to: &mut State,
    ) -> Result<(), MotionError> {
        match self {
            Self::Rk4(rk4) => rk4.step(system, from, h, t_next, to),
            Self::Dop853(adaptive) => {
                adaptive.step(system, from, t_next, to, |system, end| kinks.up_to(system, from, end))
            }
            Self::Radau(implicit) => implicit.step(system, from, t_next, to),
            Self::Taylor(taylor, tolerance) => {
                let (t, length) = (from.state.t, taylor.longest_step(*tolerance));
                if is_too_short(t, length) && length < t_next - t {
                    return Err(MotionError::StepCollapsed { t, step_s: length });
                }
                let Reach { step_s, t_next } = reach(t, t_next, length);
                taylor.advance(system, from.state, step_s, to);
                to.t = t_next;
                Ok(())
            }
        }
    }

    /// The state at `t` between the ends of the last step, not projected.
    pub fn between<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Knot<'_>,
        to: Knot<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<(), MotionError> {
        match self {
            Self::Rk4(_) => interpolate(from, to, t, out),
            Self::Dop853(adaptive) => {
                adaptive.between(system, from, to, t, out)?;
                out.t = t;
            }
            Self::Taylor(taylor, _) => {
                taylor.dense_at(system, from.state, t - from.state.t, out);
                out.t = t;
            }
            Self::Radau(implicit) => {
                implicit.between(from.state, to.state, t, out);
                out.t = t;
            }
        }
        Ok(())
    }
}
