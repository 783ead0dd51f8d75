//! What accuracy costs in time: every method, a ladder of tolerances and steps, every projection, against a reference.
//!
//! [`Accuracy`] describes a measurement as [`Simulation`](ezy_core::simulate::Simulation) describes a run:
//!
//! ```no_run
//! # use ezy_core::prelude::*;
//! # fn of(scene: &dyn Scene) -> Result<(), Box<dyn std::error::Error>> {
//! use ezy_study::accuracy::Accuracy;
//!
//! let measured = Accuracy::new(scene).until(10.0).budget(30.0).measure(|_, _| ())?;
//! for advice in measured.advice() {
//!     println!("{advice}");
//! }
//! # Ok(())
//! # }
//! ```
//!
//! How it is measured and why: `docs/accuracy.md`.

mod advice;
mod csv;
mod error;
mod errors;
#[cfg(feature = "figures")]
mod figures;
mod ladder;
mod measured;
mod order;
#[cfg(feature = "figures")]
mod page;
#[cfg(feature = "figures")]
mod page_tables;
mod point;
mod reference;
mod runs;
mod save;
mod tables;
mod trajectory;
mod variant;

pub use advice::{Advice, Candidate};
pub use error::AccuracyError;
pub use errors::{Comparison, Errors, Size};
pub use ladder::Ladder;
pub use measured::{IS_UNOPTIMISED, Missing, WorkPrecision};
pub use order::Accuracy;
pub use point::{Measured, Point, PointResult};
pub use reference::{Reference, Second};
pub use variant::Variant;
