//! A vehicle and its scenes.

mod my_mechanism;

pub use my_mechanism::my_mechanism::*;
