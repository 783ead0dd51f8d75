//! The models of EZY.

pub mod vehicles;

pub use vehicles::ezy_roller::ezy_roller;
