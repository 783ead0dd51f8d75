//! The motion of one scene at one state: accelerations, reactions, projections, energies, a consistent start.
//! Knows no integration method and no files.

// matrices keep the capital letters of the notation
#![allow(non_snake_case)]

mod acceleration;
mod energy;
mod error;
mod free_correction;
mod projection;
mod start;
mod system;

pub use error::{MotionError, StartError, SystemError};
pub use projection::{Metric, Projection};
pub use system::{Counters, System};

/// The state that is integrated.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Time, s.
    pub t: f64,
    /// Coordinates, `n_q`.
    pub q: Vec<f64>,
    /// Velocities, `n_q`.
    pub v: Vec<f64>,
    /// Work of each effect since the start, J, `n_e`.
    pub work: Vec<f64>,
}

impl State {
    /// Everything zero.
    pub fn zero(n_coordinates: usize, n_effects: usize) -> Self {
        Self { t: 0.0, q: vec![0.0; n_coordinates], v: vec![0.0; n_coordinates], work: vec![0.0; n_effects] }
    }

    /// Takes the numbers of a state of the same scene, without allocation.
    pub fn copy_from(&mut self, other: &Self) {
        self.t = other.t;
        self.q.copy_from_slice(&other.q);
        self.v.copy_from_slice(&other.v);
        self.work.copy_from_slice(&other.work);
    }
}

/// Largest magnitude; NaN when there is one.
pub(crate) fn max_abs(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |m: f64, x| if x.abs() > m || x.is_nan() { x.abs() } else { m })
}
