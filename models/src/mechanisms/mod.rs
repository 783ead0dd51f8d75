//! Mechanisms, one model a file.

pub mod andrews;
pub mod double_pendulum;
pub mod four_bar;
pub mod pendulum;
pub mod slider_crank;
