//! What a solution of K [x; y] = [r; s] leaves of each equation, measured by the terms of that equation.

use super::scaled::Entry;
use crate::model::SparsityPattern;

/// K itself and a right side, beside factors that replaced both.
///
/// One correction by the factors makes each equation as exact as the rounding of its own terms, in numbers of the same
/// precision, whatever the other equations are scaled like.
///
/// # Source
/// Skeel, Iterative refinement implies numerical stability for Gaussian elimination (1980); the measure is that of Oettli
/// and Prager (1964).
pub(super) struct Refinement {
    mass: Vec<f64>,
    jacobian: Vec<f64>,
    right_side: Vec<f64>,
    size: Vec<f64>,
    /// What [`Self::residual`] found, `n_q + n_c`.
    pub residual: Vec<f64>,
}

impl Refinement {
    /// Storage for `n_q` coordinates and the first `n_rows` rows of `pattern`.
    pub(super) fn new(n_q: usize, n_rows: usize, pattern: &SparsityPattern) -> Self {
        let zeros = || vec![0.0; n_q + n_rows];
        Self {
            mass: vec![0.0; n_q],
            jacobian: vec![0.0; pattern.n_nonzeros()],
            right_side: zeros(),
            size: zeros(),
            residual: zeros(),
        }
    }

    /// Keeps the matrix that is factored.
    pub(super) fn keep(&mut self, mass: &[f64], jacobian: &[f64]) {
        self.mass.copy_from_slice(mass);
        self.jacobian[..jacobian.len()].copy_from_slice(jacobian);
    }

    /// Keeps the right side that is solved for.
    pub(super) fn begin(&mut self, right_side: &[f64]) {
        self.right_side.copy_from_slice(right_side);
    }

    /// Writes `[r; s] − K x` and returns its largest share of the sum of the magnitudes of the terms of an equation.
    pub(super) fn residual(&mut self, entries: &[Entry], x: &[f64]) -> f64 {
        let Self { mass, jacobian, right_side, size, residual } = self;
        let n_q = mass.len();
        residual.copy_from_slice(right_side);
        size.iter_mut().zip(&*right_side).for_each(|(size, b)| *size = b.abs());
        let mut subtract = |i: usize, term: f64| {
            residual[i] -= term;
            size[i] += term.abs();
        };
        for (i, (m, x)) in mass.iter().zip(x).enumerate() {
            subtract(i, m * x);
        }
        for &(k, row, column) in entries {
            subtract(n_q + row, jacobian[k] * x[column]);
            subtract(column, jacobian[k] * x[n_q + row]);
        }
        let shares = residual.iter().zip(&*size).filter(|(r, _)| **r != 0.0).map(|(r, size)| r.abs() / size);
        shares.fold(0.0, f64::max)
    }
}
