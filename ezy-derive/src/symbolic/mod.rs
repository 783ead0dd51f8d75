//! Expressions in a canonical form: simplified, differentiated, shared and printed.
//!
//! Two levels. A [`coefficient`] depends on parameters alone and is evaluated once for a run. A [`sum`] is a
//! polynomial with such coefficients in *atoms* (time, coordinates, velocities, sines and cosines, function
//! calls), kept in normal form, so that two equal expressions are one id, `sin² + cos²` is 1, and whatever does
//! not depend on the motion is a coefficient by itself. [`lower`] turns sums into a straight-line [`program`].
//!
//! Nothing here knows bodies or tokens.

mod break_lines;
pub mod call;
pub mod coefficient;
mod dependence;
pub mod diff;
pub mod evaluate;
mod fingerprint;
pub mod interner;
pub mod lower;
pub mod plan;
pub mod print;
pub mod product;
pub mod program;
pub mod spelling;
mod substitute;
pub mod sum;
#[cfg(test)]
mod tests;

pub use sum::{Algebra, SumId, Symbol};
