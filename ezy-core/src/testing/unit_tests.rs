//! Runs and systems of any scene, through `dyn Scene`, so that unit tests do not compile the solver for each of fifty types.

use crate::dynamics::{System, SystemError};
use crate::linalg::Backend;
use crate::model::Scene;
use crate::simulate::Simulation;

pub(crate) fn simulation<'s>(scene: &'s (dyn Scene + 's)) -> Simulation<'s, &'s dyn Scene> {
    Simulation::new(scene)
}

pub(crate) fn system_of<'s>(
    scene: &'s (dyn Scene + 's),
    backend: Backend,
) -> Result<System<&'s dyn Scene>, SystemError> {
    System::new(scene, backend)
}
