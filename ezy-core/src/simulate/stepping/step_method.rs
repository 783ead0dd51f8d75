//! The method of a run, with what it keeps between steps.

use super::snapshot::Snapshot;
use crate::archive::Archive;
use crate::dynamics::{MotionError, State, System};
use crate::integrate::{EventDiscontinuities, Integrator, Method, Needs, Node, Tolerance};
use crate::model::SceneRef;
use crate::simulate::SetupError;

/// An integrator with its tolerance and the discontinuities at which its steps end.
pub(super) struct StepMethod<P: SceneRef> {
    pub integrator: Box<dyn Integrator<System<P>>>,
    /// Whether the method finds accelerations itself, and whether it judges steps by them: asked once, not at each step.
    expands: bool,
    judges_by_end: bool,
    discontinuities: EventDiscontinuities,
    /// Tolerance of a method that chooses its steps.
    tolerance: Option<Tolerance>,
}

impl<P: SceneRef> StepMethod<P> {
    /// `is_projected`: whether the ends of steps are projected, positions and velocities in the metric of the masses.
    ///
    /// # Errors
    /// [`SetupError`] where the scene lacks what the method needs.
    pub(super) fn new(
        system: &System<P>,
        method: Method,
        n_works: usize,
        is_projected: bool,
    ) -> Result<Self, SetupError> {
        let integrator = integrator(system, method, n_works, is_projected)?;
        Ok(Self {
            expands: integrator.expands(),
            judges_by_end: integrator.judges_by_end(),
            integrator,
            discontinuities: EventDiscontinuities::new(system.info()),
            tolerance: method.tolerance(),
        })
    }

    #[inline]
    pub(super) fn expands(&self) -> bool {
        self.expands
    }

    #[inline]
    pub(super) fn judges_by_end(&self) -> bool {
        self.judges_by_end
    }

    #[inline]
    pub(super) fn tolerance(&self) -> Option<Tolerance> {
        self.tolerance
    }

    /// Whether the method chooses the length of its steps.
    #[inline]
    pub(super) fn chooses_steps(&self) -> bool {
        self.tolerance.is_some()
    }

    /// Forgets the steps taken so far.
    pub(super) fn restart(&mut self) {
        self.integrator.restart();
        self.discontinuities.restart();
    }

    /// A step of length `h` from `from`, which is evaluated, to `to`, which is not projected yet.
    #[inline]
    pub(super) fn step(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        t_next: f64,
        to: &mut State,
    ) -> Result<(), MotionError> {
        self.integrator.step(system, from, h, t_next, &mut self.discontinuities, to)
    }

    /// Accelerations, multipliers and powers at a state; by the method where it expands.
    #[inline]
    pub(super) fn evaluate(&mut self, system: &mut System<P>, at: &mut Snapshot) -> Result<(), MotionError> {
        if !self.expands {
            return at.evaluate(system);
        }
        let Snapshot { state, a, lambda, .. } = at;
        match self.integrator.expand(system, state, a, lambda) {
            Some(solved) => at.complete(system, solved?),
            None => at.evaluate(system),
        }
    }

    /// Writes the discontinuities that were met, or reads them.
    pub(super) fn remember_discontinuities(&mut self, archive: &mut Archive) {
        self.discontinuities.remember(archive);
    }
}

/// The method with its storage.
fn integrator<P: SceneRef>(
    system: &System<P>,
    method: Method,
    n_works: usize,
    is_projected: bool,
) -> Result<Box<dyn Integrator<System<P>>>, SetupError> {
    SetupError::refuse_angles(system.info(), method.tolerance())?;
    let tolerance = method.tolerance().unwrap_or(Tolerance::ANY);
    let made = method.kind().of_system(system, n_works, tolerance, is_projected)?;
    let info = system.info();
    made.ok_or(match method.info().needs {
        _ if info.n_states() > 0 && !method.info().takes_states => {
            SetupError::FirstOrderStates { scene: info.name, method: method.name() }
        }
        _ if !(info.is_planar() || method.info().takes_any_body) => {
            SetupError::SpatialBodies { scene: info.name, method: method.name() }
        }
        Needs::Jacobians => SetupError::NoJacobians { scene: info.name },
        Needs::Series | Needs::Nothing => SetupError::NoSeries { scene: info.name, series: info.series },
    })
}
