//! Models that are singular, stiff, badly scaled or inconsistent on purpose, each with a reference and bounds:
//! `answers/torture.json` and the classical problems beside it. `docs/hard-cases.md` shows what is reached.

pub mod block;
pub mod case;
pub mod families;
pub mod methods;
pub mod models;
pub mod naive;
pub mod page;
pub mod subject;
pub mod trial;
