//! Vehicles, one model a file.

pub mod ezy_roller;
