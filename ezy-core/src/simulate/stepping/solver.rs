//! How a scene is stepped.

use super::stepper_state::StepperState;
use crate::dynamics::{Metric, Projection, System};
use crate::integrate::Method;
use crate::linalg::Backend;
use crate::model::SceneRef;
use crate::simulate::SetupError;
use crate::simulate::checked::check_step;

/// Integration method, projection, and solver of the equations of motion.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::simulate) struct Solver {
    pub method: Method,
    pub projection: Projection,
    pub metric: Metric,
    pub backend: Backend,
}

impl Solver {
    pub(in crate::simulate) fn system<P: SceneRef>(&self, scene: P) -> Result<System<P>, SetupError> {
        Ok(System::new(scene, self.backend)?)
    }

    /// `work`: whether works are integrated.
    pub(in crate::simulate) fn stepper<P: SceneRef>(
        &self,
        system: System<P>,
        work: bool,
    ) -> Result<StepperState<P>, SetupError> {
        StepperState::new(system, self.method, self.projection, self.metric, work)
    }

    /// The fixed step of a method that has one, s.
    pub(in crate::simulate) fn fixed_step(&self) -> Result<f64, SetupError> {
        let needed = SetupError::NeedsFixedStep { method: self.method.name() };
        self.method.step_s().map_or(Err(needed), check_step)
    }

    /// By name what the steps of a stepper depend on.
    pub(in crate::simulate) fn named(&self, step_s: f64, work: bool) -> [(&'static str, String); 6] {
        let Self { method, projection, metric, backend } = self;
        [
            ("method", method.name().to_owned()),
            ("step", format!("{step_s:?} s")),
            ("projection", format!("{projection:?}")),
            ("metric", format!("{metric:?}")),
            ("backend", format!("{backend:?}")),
            ("works", work.to_string()),
        ]
    }
}
