//! Sparse LU with partial pivoting, of real or complex numbers.

use super::SparseKktError;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::lu::{LuRef, LuSymbolicParams, NumericLu, SymbolicLu, factorize_symbolic_lu};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::traits::ComplexField;
use faer::{Conj, MatMut, Par, Spec};

/// Numbers that sparse factors take.
pub(crate) trait SparseNumber: ComplexField + Copy {}

impl<T: ComplexField + Copy> SparseNumber for T {}

/// A square matrix by rows, and factors in an order of its pattern that is found once.
pub(crate) struct SparseLu<T> {
    /// Columns of the transposed matrix.
    pattern: SymbolicSparseColMat<usize>,
    values: Vec<T>,
    symbolic: SymbolicLu<usize>,
    numeric: NumericLu<usize, T>,
    scratch: MemBuffer,
}

impl<T: ComplexField> SparseLu<T> {
    /// For entries in `columns`, ascending in each row; row i begins at `row_starts[i]` and ends where the next one begins.
    ///
    /// # Errors
    /// [`SparseKktError`] when the analysis fails, for want of memory.
    pub(crate) fn new(row_starts: &[usize], columns: &[usize]) -> Result<Self, SparseKktError> {
        let n = row_starts.len() - 1;
        let error = |cause: &dyn std::fmt::Debug| SparseKktError { n, cause: format!("{cause:?}") };
        let pattern = SymbolicSparseColMat::new_checked(n, n, row_starts.to_vec(), None, columns.to_vec());
        let params = LuSymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SIMPLICIAL,
            ..Default::default()
        };
        let symbolic = factorize_symbolic_lu(pattern.as_ref(), params).map_err(|e| error(&e))?;
        let scratch = MemBuffer::try_new(StackReq::any_of(&[
            symbolic.factorize_numeric_lu_scratch::<T>(Par::Seq, Spec::default()),
            symbolic.solve_transpose_in_place_scratch::<T>(1, Par::Seq),
        ]))
        .map_err(|e| error(&e))?;
        let values = vec![faer::traits::math_utils::zero(); columns.len()];
        Ok(Self { pattern, values, symbolic, numeric: NumericLu::new(), scratch })
    }

    /// The entries, to be written before [`SparseLu::factor`].
    pub(crate) fn values_mut(&mut self) -> &mut [T] {
        &mut self.values
    }

    /// Factors the matrix; false when a row depends on others by its pattern.
    ///
    /// # Cost
    /// Allocates where pivots need more room than ever before.
    pub(crate) fn factor(&mut self) -> bool {
        let matrix = SparseColMatRef::new(self.pattern.as_ref(), &self.values);
        let stack = MemStack::new(&mut self.scratch);
        self.symbolic.factorize_numeric_lu(&mut self.numeric, matrix, Par::Seq, stack, Spec::default()).is_ok()
    }

    /// Replaces the right side by the solution, with the factors of the last successful [`SparseLu::factor`]; not finite where
    /// a pivot vanished.
    pub(crate) fn solve(&mut self, right_side: &mut [T]) {
        let n = right_side.len();
        LuRef::new_unchecked(&self.symbolic, &self.numeric).solve_transpose_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(right_side, n, 1),
            Par::Seq,
            MemStack::new(&mut self.scratch),
        );
    }
}
