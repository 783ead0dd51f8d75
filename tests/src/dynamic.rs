//! Runs and systems of any scene: through `dyn Scene`, so that the solver is compiled once and not for each of a hundred types.

use ezy_core::dynamics::SystemError;
use ezy_core::linalg::Backend;
use ezy_core::model::Scene;
use ezy_core::prelude::{Simulation, System};

/// A run of any scene.
pub fn simulation<'s>(scene: &'s (dyn Scene + 's)) -> Simulation<'s, &'s dyn Scene> {
    Simulation::new(scene)
}

/// A system of any scene.
///
/// # Errors
/// As of [`System::new`].
pub fn system_of<'s>(scene: &'s (dyn Scene + 's), backend: Backend) -> Result<System<&'s dyn Scene>, SystemError> {
    System::new(scene, backend)
}
