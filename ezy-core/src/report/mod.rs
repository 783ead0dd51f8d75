//! Equations, tables, figures and pages. Knows names and numbers, no solver.

pub mod equations;
#[cfg(feature = "figures")]
pub mod figure;
mod matrix;
pub mod page;
pub mod table;
pub(crate) mod templates;
