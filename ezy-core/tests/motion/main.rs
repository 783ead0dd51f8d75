//! Motions with closed forms, of small mechanisms. They need nothing but this crate, so that `cargo test -p ezy-core` and mutation tests
//! find faults of the solver without the other packages (docs/mutation.md).

mod accelerations;
mod energy;
mod events;
mod methods;
mod projection;
mod redundant;
mod skates;
mod stops;
