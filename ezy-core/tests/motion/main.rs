//! Motions with closed forms, of small mechanisms. They need nothing but this crate, so that `cargo test -p ezy-core` and mutation tests
//! find faults of the solver without the other packages (docs/mutation.md).

mod accelerations;
mod assembly_modes;
mod energy;
mod events;
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
mod stops;
mod systems;
