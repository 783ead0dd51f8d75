//! What the tests of EZY share: scenes written by hand, and the reference trajectories.

pub mod count_table;
pub mod crank;
mod described;
pub mod estimates;
pub mod fuzz;
pub mod garage;
pub mod hand_roller;
pub mod hard;
pub mod page;
pub mod parallel_cranks;
pub mod piloted;
#[rustfmt::skip]
pub mod random_models;
pub mod reference;
pub mod shapes;
pub mod tables;
pub mod top;

/// The programs of the README, of the manual and of the guide, run as documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
#[doc = include_str!("../../docs/language.md")]
#[doc = include_str!("../../docs/guide/src/tricycle.md")]
#[doc = include_str!("../../docs/guide/src/accuracy.md")]
#[doc = include_str!("../../docs/guide/src/trouble.md")]
#[doc = include_str!("../../docs/guide/src/controllers.md")]
#[doc = include_str!("../../docs/guide/src/sweeps.md")]
#[doc = include_str!("../../docs/guide/src/wrong-models.md")]
pub mod readme {}
