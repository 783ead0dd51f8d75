//! A mechanism and its scenes.

mod pendulum;

pub use pendulum::pendulum::*;
