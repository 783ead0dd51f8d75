//! Tables, figures and pages. Knows names and numbers, no solver.

pub mod drawing;
#[cfg(feature = "figures")]
pub mod figure;
pub mod page;
pub mod reactions;
pub mod table;
pub mod typeset;
