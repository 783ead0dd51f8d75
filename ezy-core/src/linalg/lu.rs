//! Dense LU with partial pivoting, of real or complex numbers.

use nalgebra::{ComplexField, DMatrix, DVectorViewMut, linalg};

/// A square matrix and its factors, in one storage.
pub(crate) struct Lu<T: ComplexField<RealField = f64>> {
    matrix: DMatrix<T>,
    pivot_rows: Vec<usize>,
}

impl<T: ComplexField<RealField = f64>> Lu<T> {
    /// Storage for a matrix with `n` rows; everything is allocated here.
    pub(crate) fn new(n: usize) -> Self {
        Self { matrix: DMatrix::zeros(n, n), pivot_rows: vec![0; n] }
    }

    /// The matrix, to be written before [`Lu::factor`].
    pub(crate) fn matrix_mut(&mut self) -> &mut DMatrix<T> {
        &mut self.matrix
    }

    /// Puts the factors in place of the matrix; false when a pivot is zero or not finite.
    pub(crate) fn factor(&mut self) -> bool {
        let n = self.pivot_rows.len();
        for i in 0..n {
            let i_pivot = i + self.matrix.view((i, i), (n - i, 1)).column(0).icamax();
            let pivot = self.matrix[(i_pivot, i)].clone();
            let size = pivot.clone().modulus();
            if !(size.is_finite() && size > 0.0) {
                return false;
            }
            self.pivot_rows[i] = i_pivot;
            if i_pivot != i {
                self.matrix.columns_mut(0, i).swap_rows(i, i_pivot);
                linalg::gauss_step_swap(&mut self.matrix, pivot, i, i_pivot);
            } else {
                linalg::gauss_step(&mut self.matrix, pivot, i);
            }
        }
        true
    }

    /// Whether the determinant is negative, after a successful [`Lu::factor`] of a real matrix.
    pub(crate) fn has_negative_determinant(&self) -> bool {
        let exchanged = self.pivot_rows.iter().enumerate().filter(|&(i, &i_pivot)| i_pivot != i).count();
        let negative = (0..self.pivot_rows.len()).filter(|&i| self.matrix[(i, i)].clone().real() < 0.0).count();
        (exchanged + negative) % 2 == 1
    }

    /// Replaces the right side by the solution, with the factors of the last successful [`Lu::factor`].
    pub(crate) fn solve(&self, right_side: &mut [T]) {
        for (i, &i_pivot) in self.pivot_rows.iter().enumerate() {
            right_side.swap(i, i_pivot);
        }
        let n = right_side.len();
        let mut x = DVectorViewMut::from_slice(right_side, n);
        self.matrix.solve_lower_triangular_with_diag_mut(&mut x, T::one());
        // every pivot is non-zero after a successful factor
        self.matrix.solve_upper_triangular_mut(&mut x);
    }
}
