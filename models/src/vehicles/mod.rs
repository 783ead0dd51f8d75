//! Vehicles.

mod ezy_roller;

pub use ezy_roller::ezy_roller;
