//! Motions with closed forms, of small mechanisms. They need nothing but `ezy-core`, so that mutation tests find faults of the solver without the other
//! packages (docs/mutation.md).

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
