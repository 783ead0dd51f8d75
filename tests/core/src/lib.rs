//! What the tests of `ezy-core` in this package, and those of all packages, share: runs and systems of any scene, through `dyn Scene`, so that
//! the solver is compiled once and not for each of a hundred types.
//!
//! They are a package of their own, since all of a package is optimised alike: the solver is worth it, and tests are not.

pub mod plain_rollers;
pub mod repeated;

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
