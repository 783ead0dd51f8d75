//! Constrained planar multibody dynamics.

pub mod model;

pub use ezy_derive::model;
