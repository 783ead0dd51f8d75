//! Vehicles, one model a file.

pub mod chaplygin_sleigh;
pub mod ezy_roller;
pub mod knife_edge;
