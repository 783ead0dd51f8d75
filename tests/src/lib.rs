//! What the tests of EZY share: scenes written by hand, and the reference trajectories.

pub mod cachegrind;
pub mod chain;
pub mod count_table;
pub mod counted;
pub mod crank;
pub mod fuzz;
pub mod garage;
pub mod hand_roller;
pub mod hard;
mod leaked;
pub mod page;
pub mod parallel_cranks;
pub mod piloted;
pub mod plain_rollers;
#[cfg(doctest)]
pub mod readme;
#[rustfmt::skip]
pub mod random_models;
pub mod reference;
pub mod shapes;
