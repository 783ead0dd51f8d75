//! Equations, tables, figures and pages. Knows names and numbers, no solver.

pub mod equations;
#[cfg(feature = "figures")]
pub mod figure;
mod matrix;
pub mod page;
pub mod table;
#[cfg(feature = "cli")]
pub(crate) mod templates;
