//! The methods of a run, each with its storage and its step control.

use super::SetupError;
use super::adaptive::Adaptive;
use super::collocation::Collocation;
use super::discontinuities::{Cut, Discontinuities};
use super::implicit::Implicit;
use super::series::AlongSeries;
use super::snapshot::Snapshot;
use crate::dynamics::{MotionError, State, System, SystemError};
use crate::integrate::{Gauss, Method, Node, Radau, Rk4, Taylor, interpolate, taylor_order};
use crate::model::{Scene, SceneRef};

pub(super) enum Integrator {
    Rk4(Box<Rk4>),
    Dop853(Box<Adaptive>),
    Taylor(Box<AlongSeries>),
    Gauss(Box<Collocation>),
    Radau(Box<Implicit>),
}

impl Integrator {
    pub(super) fn new<S: Scene + ?Sized>(method: Method, scene: &S, n_works: usize) -> Result<Self, SetupError> {
        let info = scene.info();
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        Ok(match method {
            Method::Rk4 { .. } => Self::Rk4(Box::new(Rk4::new(n_q, n_c, n_works))),
            Method::Dop853(tolerance) => Self::Dop853(Box::new(Adaptive::new(n_q, n_c, n_works, tolerance))),
            Method::Taylor(tolerance) => match Taylor::new(scene, taylor_order(tolerance), n_works) {
                Some(taylor) => Self::Taylor(Box::new(AlongSeries::new(taylor, tolerance))),
                None => return Err(SetupError::NoSeries { scene: info.name, series: info.series }),
            },
            Method::Gauss(tolerance) => Self::Gauss(Box::new(Collocation::new(Gauss::new(scene, n_works), tolerance))),
            Method::Radau(tolerance) => match Radau::new(scene, n_works).map_err(SystemError::from)? {
                Some(radau) => Self::Radau(Box::new(Implicit::new(radau, n_q, tolerance))),
                None => return Err(SetupError::NoJacobians { scene: info.name }),
            },
        })
    }

    /// Forgets the steps taken so far.
    pub(super) fn restart(&mut self) {
        match self {
            Self::Rk4(rk4) => rk4.restart(),
            Self::Dop853(adaptive) => adaptive.restart(),
            Self::Taylor(series) => series.restart(),
            Self::Gauss(collocation) => collocation.restart(),
            Self::Radau(implicit) => implicit.restart(),
        }
    }

    /// Forgets the steps taken so far, and begins with this step length, s. Where states are near zero, the first step that a
    /// method would choose is too short.
    pub(super) fn restart_with(&mut self, step_s: f64) {
        match self {
            Self::Dop853(adaptive) => adaptive.restart_with(step_s),
            Self::Gauss(collocation) => collocation.restart_with(step_s),
            Self::Radau(implicit) => implicit.restart_with(step_s),
            Self::Rk4(_) | Self::Taylor(_) => self.restart(),
        }
    }

    /// Whether the method chooses its steps by a tolerance.
    pub(super) const fn chooses_steps(&self) -> bool {
        !matches!(self, Self::Rk4(_))
    }

    /// Rejected steps.
    pub(super) fn n_rejected(&self) -> u64 {
        match self {
            Self::Rk4(_) => 0,
            Self::Taylor(series) => series.n_rejected(),
            Self::Dop853(adaptive) => adaptive.n_rejected(),
            Self::Gauss(collocation) => collocation.n_rejected(),
            Self::Radau(implicit) => implicit.n_rejected(),
        }
    }

    /// Time since which stability limits the steps, s; DOP853 alone detects it.
    pub(super) fn stiff_since(&self) -> Option<f64> {
        match self {
            Self::Dop853(adaptive) => adaptive.stiff_since(),
            _ => None,
        }
    }

    /// Accelerations, multipliers and powers at a state, and the series for the next step where the method needs one.
    pub(super) fn evaluate<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        at: &mut Snapshot,
    ) -> Result<(), MotionError> {
        match self {
            Self::Taylor(series) => {
                let Snapshot { state, a, lambda, .. } = at;
                let solved = series.taylor.expand(system, state, a, lambda)?;
                at.complete(system, solved)
            }
            _ => at.evaluate(system),
        }
    }

    /// The next step starts at the state that was evaluated last, the end of the last step if there was one.
    pub(super) fn accept(&mut self) {
        match self {
            Self::Taylor(series) => series.taylor.accept(),
            Self::Gauss(collocation) => collocation.accept(),
            Self::Radau(implicit) => implicit.accept(),
            Self::Rk4(_) | Self::Dop853(_) => {}
        }
    }

    /// The smallest pivot within the last step, of a method whose steps are long enough to pass a singular position between their ends.
    pub(super) fn smallest_pivot_within(&self) -> f64 {
        match self {
            Self::Gauss(collocation) => collocation.smallest_pivot(),
            _ => f64::INFINITY,
        }
    }

    /// The length of the next try, s, where the projection changed the velocities of the last step, to `v`, by more than the tolerance
    /// explains. An explicit method takes steps so short that it does not.
    pub(super) fn shorter_for_constraints(&mut self, v: &[f64]) -> Option<f64> {
        match self {
            Self::Radau(implicit) => implicit.shorter_for_constraints(v),
            _ => None,
        }
    }

    /// A step of length `h` from `from` to `t_next`, not yet projected. A method that chooses its steps may stop before, and
    /// every method stops at a discontinuity.
    pub(super) fn step<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        t_next: f64,
        discontinuities: &mut Discontinuities,
        to: &mut State,
    ) -> Result<(), MotionError> {
        match self {
            Self::Rk4(rk4) => {
                rk4.step(system, from, h, t_next, to)?;
                let mut cut = discontinuities.cut(system, from, &[to, rk4.last_stage()], h);
                while let Some(Cut::Before(length) | Cut::Over(length)) = cut {
                    rk4.restart();
                    rk4.step(system, from, length, from.state.t + length, to)?;
                    let is_before = matches!(cut, Some(Cut::Before(_)));
                    let is_over = is_before && discontinuities.are_crossed(system, from.state, &[to, rk4.last_stage()]);
                    cut = is_over.then(|| Cut::nearer(from.state.t, length));
                }
                if to.t >= t_next {
                    discontinuities.rest();
                }
                Ok(())
            }
            Self::Dop853(adaptive) => {
                adaptive.step(system, from, t_next, to, |system, end| discontinuities.passage(system, from, end))
            }
            Self::Gauss(collocation) => {
                collocation.step(system, from, t_next, to, |system, end| discontinuities.passage(system, from, end))
            }
            Self::Radau(implicit) => implicit.step(system, from, t_next, discontinuities, to),
            Self::Taylor(series) => series.step(system, from, t_next, to),
        }
    }

    /// The state at `t` between the ends of the last step, not projected.
    pub(super) fn between<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        to: Node<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<(), MotionError> {
        match self {
            Self::Rk4(_) => interpolate(from, to, t, out),
            Self::Dop853(adaptive) => {
                adaptive.between(system, from, to, t, out)?;
                out.t = t;
            }
            Self::Taylor(series) => {
                series.taylor.dense_at(system, from.state, t - from.state.t, out);
                out.t = t;
            }
            Self::Gauss(collocation) => {
                collocation.between(system, from, to.state, t, out)?;
                out.t = t;
            }
            Self::Radau(implicit) => {
                implicit.between(from.state, to.state, t, out);
                out.t = t;
            }
        }
        Ok(())
    }

    /// Whether the projection of the state that was found last changed its velocities, to `v`, by more than the tolerance explains.
    pub(super) fn is_off_constraints(&self, v: &[f64]) -> bool {
        matches!(self, Self::Radau(implicit) if implicit.is_off_constraints(v))
    }

    /// The state at `t` between the ends of the last step, from a step of its own, not projected; `out` is left alone, and the answer is
    /// false, where the iteration of that step does not converge, and by a method that needs no such step.
    pub(super) fn step_to<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        t: f64,
        out: &mut State,
    ) -> Result<bool, MotionError> {
        match self {
            Self::Radau(implicit) => implicit.step_to(system, from, t, out),
            _ => Ok(false),
        }
    }
}
