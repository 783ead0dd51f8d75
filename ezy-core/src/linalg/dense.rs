//! Dense K with partial pivoting.

use super::scaled::{Entry, assemble, scale};
use super::{KktFactorization, VanishedPivot};
use crate::model::{PIVOT_TOLERANCE, SparsityPattern};
use nalgebra::{DMatrix, DVectorViewMut, linalg};

/// Largest n_q + n_c for which a dense K is made: 70 MB and some seconds a factorisation.
pub const LARGEST_DENSE: usize = 3_000;

/// LU factors of the scaled K. M may be singular as long as K is not: massless bodies that are held by rows.
///
/// K is scaled on both sides by one diagonal, so that pivots of heavy and light bodies, of metres and radians,
/// compare with one tolerance.
pub struct DenseKkt {
    entries: Vec<Entry>,
    factors: DMatrix<f64>,
    scale: Vec<f64>,
    largest: Vec<f64>,
    pivot_rows: Vec<usize>,
}

impl DenseKkt {
    /// Storage for `n_q` coordinates and the first `n_rows` rows of `pattern`; everything is allocated here.
    pub fn new(n_q: usize, pattern: &SparsityPattern, n_rows: usize) -> Self {
        let n = n_q + n_rows;
        Self {
            entries: pattern.entries().filter(|(_, row, _)| *row < n_rows).collect(),
            factors: DMatrix::zeros(n, n),
            scale: vec![1.0; n],
            largest: vec![0.0; n],
            pivot_rows: vec![0; n],
        }
    }
}

impl KktFactorization for DenseKkt {
    fn factor(&mut self, mass: &[f64], jacobian: &[f64]) -> Result<(), VanishedPivot> {
        scale(&self.entries, mass, jacobian, &mut self.scale, &mut self.largest);
        assemble(&self.entries, mass, jacobian, &self.scale, &mut self.factors);
        let n = self.scale.len();
        for i in 0..n {
            let i_pivot = i + self.factors.view((i, i), (n - i, 1)).column(0).icamax();
            let pivot = self.factors[(i_pivot, i)];
            if pivot.is_nan() || pivot.abs() <= PIVOT_TOLERANCE {
                return Err(VanishedPivot { relative: pivot.abs(), row: None });
            }
            self.pivot_rows[i] = i_pivot;
            if i_pivot != i {
                self.factors.columns_mut(0, i).swap_rows(i, i_pivot);
                linalg::gauss_step_swap(&mut self.factors, pivot, i, i_pivot);
            } else {
                linalg::gauss_step(&mut self.factors, pivot, i);
            }
        }
        Ok(())
    }

    fn solve(&mut self, right_side: &mut [f64]) {
        for (x, d) in right_side.iter_mut().zip(&self.scale) {
            *x *= d;
        }
        for (i, &i_pivot) in self.pivot_rows.iter().enumerate() {
            right_side.swap(i, i_pivot);
        }
        let n = right_side.len();
        let mut x = DVectorViewMut::from_slice(right_side, n);
        self.factors.solve_lower_triangular_with_diag_mut(&mut x, 1.0);
        // every pivot is non-zero after a successful factor
        self.factors.solve_upper_triangular_mut(&mut x);
        for (x, d) in right_side.iter_mut().zip(&self.scale) {
            *x *= d;
        }
    }
}
