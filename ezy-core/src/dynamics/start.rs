//! A start that fulfils the constraints, from values that are given only in part.

use super::projection::{ROUNDING_OF_ROWS, position_tolerance};
use super::{StartError, State, System, max_abs};
use crate::linalg::{KktFactorization, SparseKkt};
use crate::model::{Scene, Start};
use nalgebra::{DMatrix, DVector};

/// Gauss–Newton passes: far guesses need some tens, with a step that is halved when it overshoots.
const MAX_PASSES: usize = 100;

/// Halvings of one step before the search counts as stuck.
const MAX_HALVINGS: usize = 20;

/// Directions whose singular value is below this fraction of the largest are left alone.
const RANK_TOLERANCE: f64 = 1e-10;

/// Beyond this a coordinate keeps less than a micrometre, and the geometry of a body drowns in its rounding.
const LARGEST_VALUE: f64 = 1e9;

/// Coordinates beyond which corrections come from a sparse factorisation instead of singular values.
const LARGEST_DENSE_START: usize = 150;

/// Share of the diagonal of G M⁻¹ Gᵀ that is added to it in sparse corrections, so that rows which repeat others, or
/// that given values alone decide, leave it regular. Rounding is 1e-4 of it; directions with a singular value of
/// 1e-4 of the largest still converge by four digits a pass.
const DAMPING: f64 = 1e-12;

/// Passes over the velocity rows, which are linear: one solve and one that removes its rounding; with damping, some
/// more for directions of small singular values.
const VELOCITY_PASSES: usize = 2;
const DAMPED_VELOCITY_PASSES: usize = 10;

/// Residual of the velocity rows that counts as zero at moderate speeds, m/s and rad/s.
const VELOCITY_TOLERANCE: f64 = 1e-12;

impl<S: Scene + ?Sized> System<'_, S> {
    /// The start values of the scene.
    pub fn scene_start(&self) -> Start {
        let mut start = Start::free(self.info.n_coordinates());
        self.scene.start(&self.fixed, &mut start);
        start
    }

    /// A state that fulfils all rows: given values stay to the last bit, the others move as little as possible in
    /// the mass matrix, positions by Gauss–Newton to |C| ≤ 1e-12, then velocities by a linear solve. A start that
    /// is consistent already is not touched.
    ///
    /// Coordinates without mass count with the smallest positive mass or inertia.
    ///
    /// # Errors
    /// [`StartError`] when a value is not finite, or when the rows cannot be met with the given values held.
    /// # Cost
    /// A dense singular value decomposition a pass; beyond 150 coordinates a sparse factorisation.
    pub fn consistent_start(&mut self, start: &Start) -> Result<State, StartError> {
        self.check_finite(start)?;
        let mut state = State::zero(self.info.n_coordinates(), self.info.n_effects());
        state.t = start.t;
        state.q.copy_from_slice(&start.q);
        state.v.copy_from_slice(&start.v);
        self.assemble_positions(start, &mut state.q)?;
        self.assemble_velocities(start, &state.q, &mut state.v)?;
        Ok(state)
    }

    fn check_finite(&self, start: &Start) -> Result<(), StartError> {
        let positions = self.info.coordinates.iter().map(|c| c.name).zip(&start.q);
        let velocities = self.info.coordinates.iter().map(|c| c.velocity_name).zip(&start.v);
        for (name, &value) in positions.chain(velocities) {
            if !value.is_finite() {
                return Err(StartError::NotFinite { name, value });
            }
            if value.abs() > LARGEST_VALUE {
                return Err(StartError::TooLarge { name, value, largest: LARGEST_VALUE });
            }
        }
        Ok(())
    }

    fn assemble_positions(&mut self, start: &Start, q: &mut [f64]) -> Result<(), StartError> {
        let (t, n_h, tolerance) = (start.t, self.info.n_position_rows, position_tolerance(q));
        let mut trial = q.to_vec();
        let mut norm = self.position_residual(t, q);
        let mut length = self.residual_length(n_h);
        for _ in 0..MAX_PASSES {
            if norm <= tolerance {
                return Ok(());
            }
            let Some(step) = self.free_correction(t, q, n_h, &start.q_given) else { break };
            // a least-squares step shortens the vector of residuals, not always the largest of them
            let mut fraction = 1.0;
            let mut improved = false;
            for _ in 0..MAX_HALVINGS {
                trial.iter_mut().zip(q.iter()).zip(&step).for_each(|((x, q), s)| *x = q + fraction * s);
                let trial_norm = self.position_residual(t, &trial);
                let trial_length = self.residual_length(n_h);
                if trial_length < length {
                    q.copy_from_slice(&trial);
                    (norm, length) = (trial_norm, trial_length);
                    improved = true;
                    break;
                }
                fraction *= 0.5;
            }
            if !improved {
                break;
            }
        }
        if norm <= tolerance {
            return Ok(());
        }
        self.position_residual(t, q);
        let held = start.q_given.iter().zip(self.info.coordinates).filter(|(given, _)| **given).map(|(_, c)| c.name);
        Err(self.contradiction("position", n_h, tolerance, held.collect()))
    }

    fn assemble_velocities(&mut self, start: &Start, q: &[f64], v: &mut [f64]) -> Result<(), StartError> {
        let (t, n_c) = (start.t, self.info.n_rows());
        let mut norm = self.velocity_residual(t, q, v);
        let mut length = self.residual_length(n_c);
        let mut trial = v.to_vec();
        let passes = if self.starts_sparse() { DAMPED_VELOCITY_PASSES } else { VELOCITY_PASSES };
        for _ in 0..passes {
            if norm <= velocity_tolerance(v) {
                return Ok(());
            }
            let Some(step) = self.free_correction(t, q, n_c, &start.v_given) else { break };
            trial.iter_mut().zip(v.iter()).zip(&step).for_each(|((x, v), s)| *x = v + s);
            let trial_norm = self.velocity_residual(t, q, &trial);
            let trial_length = self.residual_length(n_c);
            if trial_length.is_nan() || trial_length >= length {
                break;
            }
            v.copy_from_slice(&trial);
            (norm, length) = (trial_norm, trial_length);
        }
        let tolerance = velocity_tolerance(v);
        if norm <= tolerance {
            return Ok(());
        }
        self.velocity_residual(t, q, v);
        let names = self.info.coordinates.iter().map(|c| c.velocity_name);
        let held = start.v_given.iter().zip(names).filter(|(given, _)| **given).map(|(_, name)| name);
        Err(self.contradiction("velocity", n_c, tolerance, held.collect()))
    }

    /// Change of the coordinates (or velocities) that are not given, smallest in the mass matrix, that removes the
    /// residual of the first `n_rows` rows in the buffer to first order, in the least-squares sense.
    fn free_correction(&mut self, t: f64, q: &[f64], n_rows: usize, given: &[bool]) -> Option<Vec<f64>> {
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        let finite = self.buffers.residual[..n_rows].iter().chain(&self.buffers.jacobian).all(|x| x.is_finite());
        if !finite || given.iter().all(|given| *given) {
            return None;
        }
        if self.starts_sparse() { self.sparse_correction(n_rows, given) } else { self.dense_correction(n_rows, given) }
    }

    fn starts_sparse(&self) -> bool {
        self.info.n_coordinates() > LARGEST_DENSE_START
    }

    /// By `[W Gᵀ; G −D] [δ; μ] = [0; −r]` over the free coordinates, with D a small share of `G W⁻¹ Gᵀ`.
    fn sparse_correction(&self, n_rows: usize, given: &[bool]) -> Option<Vec<f64>> {
        let free: Vec<usize> = (0..given.len()).filter(|&i| !given[i]).collect();
        let mut place = vec![None; given.len()];
        free.iter().enumerate().for_each(|(i, &column)| place[column] = Some(i));
        let root_weight = root_weights(&self.mass);
        let weight: Vec<f64> = free.iter().map(|&i| root_weight[i] * root_weight[i]).collect();
        let (mut entries, mut jacobian) = (Vec::new(), Vec::new());
        for (k, row, column) in self.info.jacobian.entries().filter(|e| e.1 < n_rows) {
            if let Some(i) = place[column] {
                entries.push((row, i));
                jacobian.push(self.buffers.jacobian[k]);
            }
        }
        let mut kkt = SparseKkt::from_entries(free.len(), n_rows, entries).ok()?;
        kkt.factor_damped(&weight, &jacobian, DAMPING).ok()?;
        let mut solution = vec![0.0; free.len()];
        solution.extend(self.buffers.residual[..n_rows].iter().map(|r| -r));
        kkt.solve(&mut solution);
        let mut step = vec![0.0; given.len()];
        free.iter().zip(&solution).for_each(|(&column, x)| step[column] = *x);
        Some(step)
    }

    /// By the singular values of `G W^(−1/2)` over the free coordinates.
    fn dense_correction(&self, n_rows: usize, given: &[bool]) -> Option<Vec<f64>> {
        let info = self.info;
        let free: Vec<usize> = (0..given.len()).filter(|&i| !given[i]).collect();
        let residual = DVector::from_column_slice(&self.buffers.residual[..n_rows]);
        let jacobian = &self.buffers.jacobian;
        let root_weight = root_weights(&self.mass);
        let mut G = DMatrix::<f64>::zeros(n_rows, free.len());
        for (k, row, column) in info.jacobian.entries().filter(|e| e.1 < n_rows) {
            if let Ok(i) = free.binary_search(&column) {
                G[(row, i)] += jacobian[k] / root_weight[column];
            }
        }
        let svd = G.try_svd(true, true, f64::EPSILON, 0)?;
        let cutoff = (RANK_TOLERANCE * svd.singular_values.max()).max(f64::MIN_POSITIVE);
        let scaled = svd.solve(&residual, cutoff).ok()?;
        let mut step = vec![0.0; given.len()];
        for (&column, x) in free.iter().zip(scaled.iter()) {
            step[column] = -x / root_weight[column];
        }
        Some(step)
    }

    /// Euclidean length of the first residuals in the buffer.
    fn residual_length(&self, n_rows: usize) -> f64 {
        self.buffers.residual[..n_rows].iter().map(|r| r * r).sum::<f64>().sqrt()
    }

    /// Names the rows whose residual in the buffer exceeds the tolerance.
    fn contradiction(&self, level: &'static str, n_rows: usize, tolerance: f64, held: Vec<&'static str>) -> StartError {
        let residual = &self.buffers.residual[..n_rows];
        let mut rows: Vec<usize> =
            (0..n_rows).filter(|&i| residual[i].is_nan() || residual[i].abs() > tolerance).collect();
        rows.sort_by(|&i, &j| residual[j].abs().total_cmp(&residual[i].abs()));
        let rows = rows.into_iter().map(|i| self.info.rows[i].name).collect();
        StartError::Contradiction { level, rows, residual: max_abs(residual), tolerance, held }
    }
}

fn velocity_tolerance(v: &[f64]) -> f64 {
    VELOCITY_TOLERANCE.max(ROUNDING_OF_ROWS * max_abs(v))
}

/// Square roots of M; a coordinate without mass takes the smallest positive entry of its kind, or one.
fn root_weights(mass: &[f64]) -> Vec<f64> {
    let substitute = |angle: bool| {
        let of_kind = mass.iter().enumerate().filter(|(i, m)| (i % 3 == 2) == angle && **m > 0.0).map(|(_, m)| *m);
        of_kind.min_by(f64::total_cmp).unwrap_or(1.0)
    };
    let (length, angle) = (substitute(false), substitute(true));
    let weight = |(i, m): (usize, &f64)| match (*m > 0.0, i % 3 == 2) {
        (true, _) => *m,
        (false, false) => length,
        (false, true) => angle,
    };
    mass.iter().enumerate().map(weight).map(f64::sqrt).collect()
}
