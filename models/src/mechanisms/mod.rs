//! Mechanisms, one model a file.

pub mod andrews;
pub mod chain;
pub mod double_pendulum;
pub mod four_bar;
pub mod hanging_net;
pub mod n_four_bar;
pub mod pendulum;
pub mod slider_crank;
