//! Dense K with partial pivoting.

use super::{KktFactorization, VanishedPivot};
use crate::model::{PIVOT_TOLERANCE, SparsityPattern};
use nalgebra::{DMatrix, DVectorViewMut, linalg};

/// LU factors of the scaled K. M may be singular as long as K is not: massless bodies that are held by rows.
///
/// K is scaled on both sides by one diagonal D (see [`scale`]), so that pivots of heavy and light bodies, of
/// metres and radians, compare with one tolerance.
pub struct DenseKkt {
    n_q: usize,
    entries: Vec<(usize, usize, usize)>,
    factors: DMatrix<f64>,
    scale: Vec<f64>,
    pivot_rows: Vec<usize>,
}

impl DenseKkt {
    /// Storage for `n_q` coordinates and the first `n_rows` rows of `pattern`; everything is allocated here.
    pub fn new(n_q: usize, pattern: &SparsityPattern, n_rows: usize) -> Self {
        let n = n_q + n_rows;
        Self {
            n_q,
            entries: pattern.entries().filter(|(_, row, _)| *row < n_rows).collect(),
            factors: DMatrix::zeros(n, n),
            scale: vec![1.0; n],
            pivot_rows: vec![0; n],
        }
    }

    fn assemble(&mut self, mass: &[f64], jacobian: &[f64]) {
        let (n_q, K, d) = (self.n_q, &mut self.factors, &self.scale);
        K.fill(0.0);
        for i in 0..n_q {
            K[(i, i)] = d[i] * mass[i] * d[i];
        }
        for &(k, row, column) in &self.entries {
            let g = d[n_q + row] * jacobian[k] * d[column];
            K[(n_q + row, column)] = g;
            K[(column, n_q + row)] = g;
        }
    }
}

impl KktFactorization for DenseKkt {
    fn factor(&mut self, mass: &[f64], jacobian: &[f64]) -> Result<(), VanishedPivot> {
        scale(self.n_q, &self.entries, mass, jacobian, &mut self.scale);
        self.assemble(mass, jacobian);
        let n = self.scale.len();
        for i in 0..n {
            let i_pivot = i + self.factors.view((i, i), (n - i, 1)).column(0).icamax();
            let pivot = self.factors[(i_pivot, i)];
            if pivot.is_nan() || pivot.abs() <= PIVOT_TOLERANCE {
                return Err(VanishedPivot { relative: pivot.abs() });
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

/// D such that D K D has entries near one: `1/√m` for a coordinate with mass; `1/√(g M⁻¹ gᵀ)` for a row g, over
/// the coordinates with mass (without any, `1/|g|`); `1/|D Gᵀ|` for a coordinate without mass.
pub(super) fn scale(n_q: usize, entries: &[(usize, usize, usize)], mass: &[f64], jacobian: &[f64], d: &mut [f64]) {
    let (d_q, d_rows) = d.split_at_mut(n_q);
    for (d, m) in d_q.iter_mut().zip(mass) {
        *d = if *m > 0.0 { 1.0 / m.sqrt() } else { 0.0 };
    }
    d_rows.fill(0.0);
    for &(k, row, column) in entries {
        d_rows[row] += (jacobian[k] * d_q[column]).powi(2);
    }
    for (row, d) in d_rows.iter_mut().enumerate() {
        if *d == 0.0 {
            *d = entries.iter().filter(|e| e.1 == row).map(|e| jacobian[e.0].powi(2)).sum();
        }
        *d = if *d == 0.0 { 1.0 } else { 1.0 / d.sqrt() };
    }
    if d_q.contains(&0.0) {
        for (column, d) in d_q.iter_mut().enumerate().filter(|(_, d)| **d == 0.0) {
            let s: f64 = entries.iter().filter(|e| e.2 == column).map(|e| (jacobian[e.0] * d_rows[e.1]).powi(2)).sum();
            *d = if s == 0.0 { 1.0 } else { 1.0 / s.sqrt() };
        }
    }
}
