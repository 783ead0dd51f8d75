//! Motions with closed forms, of small mechanisms. They need nothing but this crate, so that `cargo test -p ezy-core` and mutation tests
//! find faults of the solver without the other packages (docs/mutation.md).

use ezy_core::dynamics::SystemError;
use ezy_core::prelude::*;

mod accelerations;
mod assembly_modes;

mod counts;
mod energy;
mod events;
mod inputs;
mod lanes;
mod laws;
mod methods;
mod orders;
mod projection;
mod ranks;
mod redundant;
mod runs;
mod singular;
mod skates;
mod starts;
mod states;
mod stops;
mod systems;

/// A run of any scene. It goes through `dyn Scene`, so that the solver is compiled once for all mechanisms.
fn simulation<'s>(scene: &'s (dyn Scene + 's)) -> Simulation<'s, &'s dyn Scene> {
    Simulation::new(scene)
}

/// A system of any scene, in the same way.
fn system_of<'s>(scene: &'s (dyn Scene + 's), backend: Backend) -> Result<System<&'s dyn Scene>, SystemError> {
    System::new(scene, backend)
}
