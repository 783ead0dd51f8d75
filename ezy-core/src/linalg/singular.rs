//! Singular values, of matrices that have them.

use nalgebra::linalg::SVD;
use nalgebra::{DMatrix, Dyn};

/// Singular values, with the left and right vectors that are asked for, the largest first; `None` where an entry is not finite, or a value,
/// on which the library would panic. It scales the matrix by its largest entry, so that no square overflows; squares of the smallest may
/// still vanish.
pub(crate) fn singular_values(matrix: DMatrix<f64>, left: bool, right: bool) -> Option<SVD<f64, Dyn, Dyn>> {
    let sound = matrix.iter().all(|x| x.is_finite());
    let mut svd = if sound { matrix.try_svd_unordered(left, right, f64::EPSILON, 0)? } else { return None };
    let ordered = svd.singular_values.iter().all(|x| x.is_finite());
    ordered.then(|| svd.sort_by_singular_values())?;
    Some(svd)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_matrices_with_entries_that_are_not_finite_have_none() {
        for entry in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let matrix = DMatrix::from_row_slice(2, 2, &[1.0, entry, entry, 2.0]);
            assert!(singular_values(matrix, true, true).is_none(), "{entry}");
        }
    }

    #[test]
    fn analytic_singular_values_of_any_size_have_all_digits() {
        for size in [1e-300, 1e-160, 1.0, 1e160, 1e300] {
            // [2 1; 1 2] has 3 and 1
            let matrix = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 1.0, 2.0]) * size;
            let found = singular_values(matrix, true, true).unwrap().singular_values / size;
            let error = (found[0] - 3.0).abs().max((found[1] - 1.0).abs());
            assert!(error <= 4.0 * f64::EPSILON, "{size:e}: {found}");
        }
    }
}
