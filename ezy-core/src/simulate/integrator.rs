//! A method at work: its storage and its step control.

use crate::dynamics::{MotionError, State, System};
use crate::integrate::{DOP853_ERROR_ORDER, Dop853, Knot, Method, Rk4, StepControl, Tolerance, interpolate};
use crate::model::{Scene, SceneInfo};

/// A step shorter than this part of the time, or of a second, moves nothing any more.
const SHORTEST: f64 = 1e-14;

/// The last step may be longer by this part, so that no splinter of a step is left.
const STRETCH: f64 = 1e-3;

pub(super) enum Integrator {
    Rk4(Box<Rk4>),
    Dop853(Box<Adaptive>),
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

impl Integrator {
    pub fn new(method: Method, info: &SceneInfo, n_works: usize) -> Self {
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        match method {
            Method::Rk4 { .. } => Self::Rk4(Box::new(Rk4::new(n_q, n_c, n_works))),
            Method::Dop853(tolerance) => Self::Dop853(Box::new(Adaptive {
                method: Dop853::new(n_q, n_c, n_works),
                control: StepControl::new(DOP853_ERROR_ORDER),
                tolerance,
                step_s: None,
                rejected: 0,
                dense: false,
            })),
        }
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
        }
    }

    /// Whether it keeps to a tolerance by steps of its own length.
    pub const fn chooses_steps(&self) -> bool {
        matches!(self, Self::Dop853(_))
    }

    /// Steps that were tried and not taken.
    pub fn n_rejected(&self) -> u64 {
        match self {
            Self::Rk4(_) => 0,
            Self::Dop853(adaptive) => adaptive.rejected,
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
            // the last two steps share what is left
            let n_left = left / length;
            let (h, t_next) = if n_left <= 1.0 + STRETCH {
                (left, end)
            } else {
                let wanted = if n_left < 2.0 { 0.5 * left } else { length };
                // the length that the clock can show, so that times carry no rounding
                let t_next = t + wanted;
                (t_next - t, t_next)
            };
            if h <= SHORTEST * t.abs().max(1.0) && h < left {
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
                    if length <= SHORTEST * t.abs().max(1.0) {
                        return Err(error);
                    }
                }
            }
            self.rejected += 1;
        }
    }
}
