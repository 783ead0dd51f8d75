//! Large matrices by sparse factors, beside singular values.

use crate::analysis::row_space::RowSpace;
use crate::analysis::tolerances::search::FREE;
use crate::linalg::HAS_SPARSE;
use nalgebra::{DMatrix, DVector};

/// What rounding and the last pass leave.
const LEFT: f64 = 1e-9;

/// Differences of neighbours on a ring of `n`, which leave their mean free, of which `n_cut` are left out, with one row twice and one whose direction
/// differs from another by `angle`.
fn ring(n: usize, n_cut: usize, angle: f64) -> DMatrix<f64> {
    let mut rows = DMatrix::zeros(n - n_cut + 2, n);
    for i in 0..n - n_cut {
        rows[(i, i)] = -0.6;
        rows[(i, (i + 1) % n)] = 0.8;
    }
    for (row, of) in [(n - n_cut, 5), (n - n_cut + 1, 9)] {
        rows.set_row(row, &rows.row(of).clone_owned());
    }
    rows[(n - n_cut + 1, n - 2)] += angle;
    rows
}

#[test]
fn cross_sparse_rows_leave_the_same_free() {
    // with as many rows as columns, too
    for (n_cut, angle) in [(2, 0.0), (3, 0.0), (3, 1e-9), (7, 1e-5), (20, 1e-9)] {
        let rows = ring(230, n_cut, angle);
        let mut sparse = RowSpace::of(&rows, FREE).unwrap();
        assert_eq!(matches!(sparse, RowSpace::Sparse(_)), HAS_SPARSE);
        let null = sparse.null_space();

        let svd = rows.clone().resize_vertically(230, 0.0).svd(true, true);
        let (singular, v_t) = (&svd.singular_values, svd.v_t.as_ref().unwrap());
        let held: Vec<usize> = (0..230).filter(|&i| singular[i] > FREE * singular.max()).collect();
        let range = v_t.select_rows(&held);
        assert_eq!(null.ncols(), 230 - held.len(), "{n_cut} {angle}");
        assert!((null.tr_mul(&null) - DMatrix::identity(null.ncols(), null.ncols())).amax() <= LEFT);
        for (row, &i) in (&range * &null).row_iter().zip(&held) {
            // where rows hardly hold, directions are found to rounding over their singular value
            let bound = LEFT.max(f64::EPSILON * singular.max() / singular[i]);
            assert!(row.amax() <= bound, "{n_cut} {angle}: {} in direction {i}", row.amax());
        }

        // of what the rows can do
        let x = range.tr_mul(&DVector::from_fn(held.len(), |i, _| (1.0 + i as f64).sin()));
        let nearest = sparse.shortest(&(&rows * &x)).unwrap();
        let weak = held.iter().filter(|&&i| singular[i] < 1e-4).count();
        let mut apart = nearest - &x;
        // a direction that rows hardly hold takes more Newton steps than one
        held.iter().filter(|&&i| singular[i] < 1e-4).for_each(|&i| {
            let of = v_t.row(i).transpose();
            apart -= &of * of.dot(&apart);
        });
        assert!(weak <= 1 && apart.amax() <= LEFT, "{n_cut} {angle}: {}", apart.amax());
    }
}
