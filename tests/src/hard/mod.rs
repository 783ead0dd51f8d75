//! Models that are singular, stiff, badly scaled or inconsistent on purpose, each with a reference and bounds:
//! `answers/torture.json` and the classical problems beside it. `docs/hard-cases.md` shows what is reached.

pub mod block;
pub mod case;
pub mod cranks;
pub mod families;
pub mod methods;
pub mod naive;
pub mod page;
pub mod rods;
pub mod skates;
pub mod slider;
pub mod spin;
pub mod springs;
pub mod subject;
pub mod trial;
