//! Random states at which a scene is checked.

use super::Check;
use crate::dynamics::{System, SystemError};
use crate::linalg::Backend;
use crate::model::body_kind;
use crate::model::{Scene, SceneInfo};
use crate::scalar::SplitMix64;
use std::sync::Arc;

/// Number of random states, of a scene with at most sixty unknowns.
const N_STATES: usize = 1000;

/// Least number of states: larger scenes get fewer, so that the dense oracle takes no longer than with sixty unknowns.
const FEWEST_STATES: usize = 3;

/// Scenes with more coordinates are checked along random directions instead of along each coordinate.
const MAX_UNIT_DIRECTIONS: usize = 100;

/// Number of such directions. A wrong entry is seen by each of them with probability one.
const N_DIRECTIONS: usize = 8;

/// A scene with its inputs and constants, and the states at which it is looked at. The states need not fulfil the constraints:
/// the equations hold everywhere.
pub(super) struct Probe<'s, S: Scene + ?Sized> {
    pub scene: &'s S,
    pub info: Arc<SceneInfo>,
    pub fixed: Vec<f64>,
    pub states: Vec<RandomState>,
}

pub(super) struct RandomState {
    pub t: f64,
    pub q: Vec<f64>,
    pub v: Vec<f64>,
}

impl<'s, S: Scene + ?Sized> Probe<'s, S> {
    pub(super) fn new(scene: &'s S, fixed: &[f64]) -> Self {
        let info = scene.info();
        let mut random = SplitMix64(0x9E37_79B9_7F4A_7C15);
        // lengths and speeds of the order of one, angles all around
        let size = |i: usize| if info.coordinates[i].is_angle() { std::f64::consts::PI } else { 2.0 };
        let n = info.n_unknowns().max(1) as f64;
        let n_states = ((N_STATES as f64 * (60.0 / n).powi(3)) as usize).clamp(FEWEST_STATES, N_STATES);
        let states = (0..n_states)
            .map(|_| RandomState {
                t: info.until_s * 0.5 * (1.0 + random.symmetric()),
                q: (0..info.n_coordinates()).map(|i| size(i) * random.symmetric()).collect(),
                v: info.velocities.iter().map(|_| 2.0 * random.symmetric()).collect(),
            })
            .collect();
        Self { scene, info, fixed: fixed.to_vec(), states }
    }
}

impl<'s, S: Scene + ?Sized> Probe<'s, S> {
    /// The scene with the inputs of the probe.
    pub(super) fn system(&self, backend: Backend) -> Result<System<&'s S>, SystemError> {
        let mut system = System::new(self.scene, backend)?;
        system.inputs_mut().copy_from_slice(&self.fixed[..self.info.n_inputs()]);
        system.place_states(&self.fixed[self.info.n_inputs()..][..self.info.n_states()]);
        Ok(system)
    }

    /// Directions in the space of velocities: each velocity alone or, of many, random ones.
    pub(super) fn directions(&self) -> Vec<Vec<f64>> {
        let n_v = self.info.n_velocities();
        if n_v <= MAX_UNIT_DIRECTIONS {
            return (0..n_v).map(|i| (0..n_v).map(|j| f64::from(u8::from(i == j))).collect()).collect();
        }
        let mut random = SplitMix64(0xD1B5_4A32_D192_ED03);
        (0..N_DIRECTIONS).map(|_| (0..n_v).map(|_| random.symmetric()).collect()).collect()
    }

    /// The coordinates `q` moved by `e v`.
    pub(super) fn moved(&self, q: &[f64], e: f64, v: &[f64]) -> Vec<f64> {
        let mut moved = q.to_vec();
        let by: Vec<f64> = v.iter().map(|v| e * v).collect();
        body_kind::retract(&self.info.kinds, &mut moved, &by);
        moved
    }

    /// G d from the entries of G.
    pub(super) fn product(&self, entries: &[f64], d: &[f64]) -> Vec<f64> {
        let mut rows = vec![0.0; self.info.n_rows()];
        for (k, row, column) in self.info.jacobian.entries() {
            rows[row] += entries[k] * d[column];
        }
        rows
    }
}

/// The largest error met so far; a NaN stays.
#[derive(Default)]
pub(super) struct Worst {
    pub error: f64,
    pub n_compared: usize,
    pub n_left_out: usize,
}

impl Worst {
    /// Compares one number with its oracle, relative to `size` (at least one).
    pub(super) fn compare(&mut self, value: f64, oracle: f64, size: f64) {
        let error = (value - oracle).abs() / size.max(1.0);
        if error > self.error || error.is_nan() {
            self.error = error;
        }
        self.n_compared += 1;
    }

    /// The finished check.
    pub(super) fn check(self, name: &'static str, tolerance: f64, reason: &'static str) -> Check {
        let Self { error, n_compared, n_left_out } = self;
        Check { name, n_compared, n_left_out, largest_error: error, tolerance, reason }
    }

    /// The finished check; where nothing could be compared it is a failure, not a pass.
    pub(super) fn check_of_some(mut self, name: &'static str, tolerance: f64, reason: &'static str) -> Check {
        if self.n_compared == 0 {
            self.error = f64::NAN;
        }
        self.check(name, tolerance, reason)
    }
}
