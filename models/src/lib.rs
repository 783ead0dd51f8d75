//! The models of EZY, one a file, and the studies made with them.

pub mod registry;
pub mod study;
pub mod vehicles;

pub use vehicles::ezy_roller::ezy_roller;
