//! The models of EZY.

pub mod vehicles;
