//! Gauss elimination with complete pivoting: n³/3 comparisons, and pivots that tell the rank.

use nalgebra::{DMatrixViewMut, linalg};

/// Row and column that were exchanged with those of a pivot's place.
#[derive(Clone, Copy, Default)]
pub(super) struct Swap {
    row: usize,
    column: usize,
}

/// Puts the factors in place of a matrix that has no more rows than columns, and returns the smallest pivot as a share of
/// the largest; where it is zero or not a number, or a pivot overflows, the factors are not complete.
pub(super) fn eliminate(mut matrix: DMatrixViewMut<'_, f64>, swaps: &mut [Swap]) -> f64 {
    let (n_rows, n_columns) = matrix.shape();
    let (mut smallest, mut largest) = (f64::INFINITY, 0.0_f64);
    for i in 0..n_rows {
        let (row, column) = matrix.view((i, i), (n_rows - i, n_columns - i)).icamax_full();
        let swap = Swap { row: i + row, column: i + column };
        matrix.swap_rows(i, swap.row);
        matrix.swap_columns(i, swap.column);
        swaps[i] = swap;
        let pivot = matrix[(i, i)];
        if pivot == 0.0 || !pivot.is_finite() {
            return 0.0;
        }
        (smallest, largest) = (smallest.min(pivot.abs()), largest.max(pivot.abs()));
        linalg::gauss_step(&mut matrix, pivot, i);
    }
    if n_rows == 0 { 1.0 } else { smallest / largest }
}

/// Brings a right side into the order of the pivots.
pub(super) fn swap_rows(swaps: &[Swap], x: &mut [f64]) {
    swaps.iter().enumerate().for_each(|(i, swap)| x.swap(i, swap.row));
}

/// Brings a solution back into the order of the columns.
pub(super) fn restore_columns(swaps: &[Swap], x: &mut [f64]) {
    swaps.iter().enumerate().rev().for_each(|(i, swap)| x.swap(i, swap.column));
}

/// The column that the pivot at a place belongs to.
pub(super) fn original_column(swaps: &[Swap], place: usize) -> usize {
    // swaps undone from the last one on, as in `restore_columns`
    swaps.iter().enumerate().rev().fold(place, |at, (i, swap)| match (at == i, at == swap.column) {
        (true, _) => swap.column,
        (_, true) => i,
        _ => at,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVectorViewMut};

    #[test]
    fn analytic_complete_pivots_are_found_in_rows_and_columns() {
        let mut matrix = DMatrix::from_row_slice(3, 3, &[1.0, 0.0, 2.0, 0.0, 0.5, 1.0, 8.0, 0.0, 0.0]);
        let exact = [1.0, -2.0, 3.0];
        let mut x: Vec<f64> = (&matrix * DMatrix::from_column_slice(3, 1, &exact)).iter().copied().collect();
        let mut swaps = [Swap::default(); 3];
        // 8, then 2 in the last column, then 1/2
        assert_eq!(eliminate(matrix.view_mut((0, 0), (3, 3)), &mut swaps), 0.5 / 8.0);
        assert_eq!([0, 1, 2].map(|place| original_column(&swaps, place)), [0, 2, 1]);
        swap_rows(&swaps, &mut x);
        let mut view = DVectorViewMut::from_slice(&mut x, 3);
        matrix.solve_lower_triangular_with_diag_mut(&mut view, 1.0);
        matrix.solve_upper_triangular_mut(&mut view);
        restore_columns(&swaps, &mut x);
        assert_eq!(x, exact);
    }

    #[test]
    fn invariant_a_row_that_repeats_others_leaves_no_pivot() {
        let mut matrix = DMatrix::from_row_slice(2, 3, &[1.0, 2.0, 4.0, 0.5, 1.0, 2.0]);
        assert_eq!(eliminate(matrix.view_mut((0, 0), (2, 3)), &mut [Swap::default(); 2]), 0.0);
    }
}
