//! A method at work: its storage and its step control.

use super::SetupError;
use super::instantaneous::Instantaneous;
use super::reach::{Reach, is_too_short, reach};
use crate::dynamics::{MotionError, State, System};
use crate::integrate::{
    DOP853_ERROR_ORDER, Dop853, Knot, Method, Rk4, StepControl, Taylor, Tolerance, interpolate, taylor_order,
};
use crate::model::Scene;

pub(super) enum Integrator<'s> {
    Rk4(Box<Rk4>),
    Dop853(Box<Adaptive>),
    Taylor(Box<Taylor<'s>>, Tolerance),
}

/// DOP853 with the length of its next step.
pub(super) struct Adaptive {
    method: Dop853,
    control: StepControl,
    tolerance: Tolerance,
    /// Length of the next step, s; none before the first.
    step_s: Option<f64>,
    rejected: u64,
    /// Whether values between the ends of the last step are prepared.
    dense: bool,
}

impl<'s> Integrator<'s> {
    pub fn new<S: Scene + ?Sized>(method: Method, scene: &'s S, n_works: usize) -> Result<Self, SetupError> {
        let info = scene.info();
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        Ok(match method {
            Method::Rk4 { .. } => Self::Rk4(Box::new(Rk4::new(n_q, n_c, n_works))),
            Method::Dop853(tolerance) => Self::Dop853(Box::new(Adaptive {
                method: Dop853::new(n_q, n_c, n_works),
                control: StepControl::new(DOP853_ERROR_ORDER),
                tolerance,
                step_s: None,
                rejected: 0,
                dense: false,
            })),
            Method::Taylor(tolerance) => match Taylor::new(scene, taylor_order(tolerance), n_works) {
                Some(taylor) => Self::Taylor(Box::new(taylor), tolerance),
                None => return Err(SetupError::NoSeries { scene: info.name, series: info.series }),
            },
        })
    }

    /// Forgets the steps taken so far.
    pub fn restart(&mut self) {
        match self {
            Self::Rk4(rk4) => rk4.restart(),
            Self::Dop853(adaptive) => {
                adaptive.method.restart();
                adaptive.control = StepControl::new(DOP853_ERROR_ORDER);
                adaptive.step_s = None;
            }
            Self::Taylor(taylor, _) => taylor.restart(),
        }
    }

    /// Whether it keeps to a tolerance by steps of its own length.
    pub const fn chooses_steps(&self) -> bool {
        matches!(self, Self::Dop853(_) | Self::Taylor(..))
    }

    /// Steps that were tried and not taken.
    pub fn n_rejected(&self) -> u64 {
        match self {
            Self::Rk4(_) | Self::Taylor(..) => 0,
            Self::Dop853(adaptive) => adaptive.rejected,
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
        to: &mut State,
    ) -> Result<(), MotionError> {
        match self {
            Self::Rk4(rk4) => rk4.step(system, from, h, t_next, to),
            Self::Dop853(adaptive) => adaptive.step(system, from, t_next, to),
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
                if !adaptive.dense {
                    adaptive.method.prepare_dense(system, from, to)?;
                    adaptive.dense = true;
                }
                let s = (t - from.state.t) / (to.state.t - from.state.t);
                adaptive.method.dense_at(s, out);
                out.t = t;
            }
            Self::Taylor(taylor, _) => {
                taylor.dense_at(system, from.state, t - from.state.t, out);
                out.t = t;
            }
        }
        Ok(())
    }
}

impl Adaptive {
    fn step<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Knot<'_>,
        end: f64,
        to: &mut State,
    ) -> Result<(), MotionError> {
        self.dense = false;
        let t = from.state.t;
        let left = end - t;
        let mut length = match self.step_s {
            Some(step_s) => step_s,
            None => self.method.first_step(system, from, left, self.tolerance)?,
        };
        loop {
            let Reach { step_s: h, t_next } = reach(t, end, length);
            if is_too_short(t, h) && h < left {
                return Err(MotionError::StepCollapsed { t, step_s: h });
            }
            match self.method.attempt(system, from, h, self.tolerance, to) {
                Ok(error) if error <= 1.0 => {
                    self.method.accept();
                    to.t = t_next;
                    self.step_s = Some(h * self.control.accept(error));
                    return Ok(());
                }
                Ok(error) => length = h * self.control.reject(error),
                // a stage may have left the region of the motion: a shorter step may not
                Err(error) => {
                    length = h * self.control.reject(f64::NAN);
                    if is_too_short(t, length) {
                        return Err(error);
                    }
                }
            }
            self.rejected += 1;
        }
    }
}
