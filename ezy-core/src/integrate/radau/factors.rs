//! Factors of a matrix of the simplified Newton iteration, dense or sparse.

use crate::integrate::tolerances::radau::SPARSE_FROM;
use crate::linalg::{HAS_SPARSE, Lu, SparseKktError, SparseLu, SparseNumber};
use nalgebra::ComplexField;

/// Dense for small matrices, sparse for others.
pub(super) enum Factors<T: ComplexField<RealField = f64>> {
    Dense(Lu<T>),
    Sparse(Box<SparseLu<T>>),
}

impl<T: ComplexField<RealField = f64> + SparseNumber> Factors<T> {
    /// Storage for a matrix with entries in `columns`, ascending in each row, which begin at `starts`.
    ///
    /// # Errors
    /// [`SparseKktError`] when there is no memory for an analysis.
    pub(super) fn new(starts: &[usize], columns: &[usize]) -> Result<Self, SparseKktError> {
        let n = starts.len() - 1;
        if n < SPARSE_FROM || !HAS_SPARSE {
            Ok(Self::Dense(Lu::new(n)))
        } else {
            Ok(Self::Sparse(Box::new(SparseLu::new(starts, columns)?)))
        }
    }

    /// Writes the matrix: `entry` says where an entry stands, and its value.
    pub(super) fn write(&mut self, entries: impl Iterator<Item = ((usize, usize), T)>) {
        match self {
            Self::Dense(lu) => {
                let matrix = lu.matrix_mut();
                matrix.fill(nalgebra::zero());
                entries.for_each(|(place, value)| matrix[place] = value);
            }
            Self::Sparse(lu) => lu.values_mut().iter_mut().zip(entries).for_each(|(x, (_, value))| *x = value),
        }
    }

    /// Factors the matrix; false when it is singular.
    pub(super) fn factor(&mut self) -> bool {
        match self {
            Self::Dense(lu) => lu.factor(),
            Self::Sparse(lu) => lu.factor(),
        }
    }

    /// Whether the determinant of the factored matrix is negative; none where sparse factors do not tell.
    pub(super) fn has_negative_determinant(&self) -> Option<bool> {
        match self {
            Self::Dense(lu) => Some(lu.has_negative_determinant()),
            Self::Sparse(_) => None,
        }
    }

    /// Replaces the right side by the solution.
    pub(super) fn solve(&mut self, right_side: &mut [T]) {
        match self {
            Self::Dense(lu) => lu.solve(right_side),
            Self::Sparse(lu) => lu.solve(right_side),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Dense factors of 49 equations, sparse ones of 50.
    #[test]
    fn regress_fifty_equations_have_sparse_factors() {
        let is_sparse = |n: usize| {
            let (starts, columns): (Vec<usize>, Vec<usize>) = ((0..=n).collect(), (0..n).collect());
            matches!(Factors::<f64>::new(&starts, &columns).unwrap(), Factors::Sparse(_))
        };
        assert_eq!([49, 50].map(is_sparse), [false, HAS_SPARSE]);
    }
}
