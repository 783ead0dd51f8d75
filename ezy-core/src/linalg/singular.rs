//! Singular values, of matrices that have them.

use super::tolerances::sizes::LARGEST_ENTRY;
use nalgebra::linalg::SVD;
use nalgebra::{DMatrix, Dyn};

/// Singular values, with the left and right vectors that are asked for; `None` where an entry is beyond 1e150 or no number,
/// on which the library would panic.
pub(crate) fn singular_values(matrix: DMatrix<f64>, left: bool, right: bool) -> Option<SVD<f64, Dyn, Dyn>> {
    let sound = matrix.iter().all(|x| x.abs() < LARGEST_ENTRY);
    if sound { matrix.try_svd(left, right, f64::EPSILON, 0) } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn invariant_matrices_at_the_edge_of_numbers_have_none() {
        for entry in [f64::NAN, f64::INFINITY, f64::MAX, -1e200] {
            let matrix = DMatrix::from_row_slice(2, 2, &[1.0, entry, entry, 2.0]);
            assert!(singular_values(matrix, true, true).is_none(), "{entry}");
        }
    }
}
