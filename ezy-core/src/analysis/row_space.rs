//! What the rows of a matrix hold, and what they leave free: by singular values, of large matrices by sparse factors.

use super::tolerances::row_space::{DAMPING, LARGEST_DENSE, LEFT, PASSES, SPARE};
use crate::linalg::{HAS_SPARSE, KktFactorization as _, SparseKkt, singular_values};
use crate::scalar::SplitMix64;
use nalgebra::{DMatrix, DVector, DVectorView, Dyn, SVD};

/// First state of the generator of directions: any number serves, so long as it stays.
const SEED: u64 = 0xF4EE;

/// A matrix A, `m × n`, whose rows have about length one.
pub(super) enum RowSpace {
    /// Of A, with rows of zeros below until it is square or higher.
    Dense {
        svd: SVD<f64, Dyn, Dyn>,
        tolerance: f64,
    },
    Sparse(Box<SparseRows>),
}

impl RowSpace {
    /// Directions with singular values below the share `independent` of the largest are free. None where an entry is not finite.
    pub(super) fn of(matrix: &DMatrix<f64>, independent: f64) -> Option<Self> {
        if matrix.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let n = matrix.ncols();
        let sparse = if HAS_SPARSE && n > LARGEST_DENSE { SparseRows::of(matrix, independent) } else { None };
        if let Some(sparse) = sparse {
            return Some(Self::Sparse(Box::new(sparse)));
        }
        let svd = singular_values(matrix.clone().resize_vertically(matrix.nrows().max(n), 0.0), true, true)?;
        let tolerance = independent * svd.singular_values.max();
        Some(Self::Dense { svd, tolerance })
    }

    /// The shortest x with A x = r, in the sense of least squares; none where A is not finite.
    pub(super) fn shortest(&mut self, r: &DVector<f64>) -> Option<DVector<f64>> {
        match self {
            Self::Dense { svd, tolerance } => {
                let n_rows = svd.u.as_ref()?.nrows();
                svd.solve(&r.clone().resize_vertically(n_rows, 0.0), *tolerance).ok()
            }
            Self::Sparse(sparse) => Some(sparse.solve(&DVector::zeros(sparse.n), r)),
        }
    }

    /// Orthonormal columns, `n ×` as many as directions are free.
    pub(super) fn null_space(&mut self) -> DMatrix<f64> {
        match self {
            Self::Dense { svd, tolerance } => smallest(svd, *tolerance),
            Self::Sparse(sparse) => sparse.null_space(),
        }
    }
}

/// The right singular vectors, one a column, of singular values up to `tolerance`.
fn smallest(svd: &SVD<f64, Dyn, Dyn>, tolerance: f64) -> DMatrix<f64> {
    let Some(v_t) = &svd.v_t else { return DMatrix::zeros(0, 0) };
    let free: Vec<usize> = (0..v_t.nrows()).filter(|&i| svd.singular_values[i] <= tolerance).collect();
    v_t.select_rows(&free).transpose()
}

/// A by the factors of `[1 Aᵀ; A −ε]`, which are there whatever its rank. After p passes, each for what those before have left, the share
/// (ε/(σ² + ε))^p of a direction with the singular value σ is taken for free: all of it where σ ≪ √ε.
///
/// # Source
/// The proximal method of multipliers; Carpentier, Budhiraja, Mansard, Robotics: Science and Systems (2021).
pub(super) struct SparseRows {
    n: usize,
    n_rows: usize,
    entries: Vec<(usize, usize, f64)>,
    factors: SparseKkt,
    tolerance: f64,
}

impl SparseRows {
    /// None where A is not finite.
    fn of(matrix: &DMatrix<f64>, independent: f64) -> Option<Self> {
        let (n_rows, n) = matrix.shape();
        let of_column = |j: usize| (0..n_rows).map(move |i| (i, j));
        let entries: Vec<(usize, usize, f64)> =
            (0..n).flat_map(of_column).map(|(i, j)| (i, j, matrix[(i, j)])).filter(|entry| entry.2 != 0.0).collect();
        let places = entries.iter().map(|&(row, column, _)| (row, column)).collect();
        let mut factors = SparseKkt::from_entries(&vec![1.0; n], n_rows, places).ok()?;
        let values: Vec<f64> = entries.iter().map(|entry| entry.2).collect();
        factors.factor_damped(&values, &vec![DAMPING; n_rows]).ok()?;
        Some(Self { n, n_rows, entries, factors, tolerance: independent })
    }

    /// A x.
    fn times(&self, x: &DVectorView<'_, f64>) -> DVector<f64> {
        let mut product = DVector::zeros(self.n_rows);
        self.entries.iter().for_each(|&(row, column, value)| product[row] += value * x[column]);
        product
    }

    /// The x nearest to `z` with A x = r.
    fn solve(&mut self, z: &DVector<f64>, r: &DVector<f64>) -> DVector<f64> {
        let Self { n, n_rows, entries, factors, .. } = self;
        let mut solution = vec![0.0; *n + *n_rows];
        let mut left = solution.clone();
        for _ in 0..PASSES {
            left[..*n].copy_from_slice(z.as_slice());
            left[*n..].copy_from_slice(r.as_slice());
            (0..*n).for_each(|i| left[i] -= solution[i]);
            for &(row, column, value) in entries.iter() {
                left[column] -= value * solution[*n + row];
                left[*n + row] -= value * solution[column];
            }
            let (of_x, of_rows) = left.split_at_mut(*n);
            factors.solve(of_x, of_rows);
            solution.iter_mut().zip(&left).for_each(|(x, change)| *x += change);
        }
        solution.truncate(*n);
        DVector::from_vec(solution)
    }

    /// Random directions less what the rows hold of them, and of these what no row sees.
    fn null_space(&mut self) -> DMatrix<f64> {
        let mut random = SplitMix64(SEED);
        let mut width = self.n.saturating_sub(self.n_rows) + SPARE;
        let basis = loop {
            width = width.min(self.n);
            let drawn = DMatrix::from_fn(self.n, width, |_, _| random.symmetric() / (self.n as f64).sqrt());
            // once more, for what rounding adds to short ones
            let first = self.free_of(drawn);
            let basis = self.free_of(first);
            if basis.ncols() < width || width == self.n {
                break basis;
            }
            width *= 2;
        };
        let mut seen = DMatrix::zeros(self.n_rows, basis.ncols());
        seen.column_iter_mut().zip(basis.column_iter()).for_each(|(mut seen, x)| seen.copy_from(&self.times(&x)));
        if seen.column_iter().all(|seen| seen.norm() <= self.tolerance) {
            return basis;
        }
        basis * smallest(&seen.svd(false, true), self.tolerance)
    }

    /// Orthonormal columns that span what is left of the columns of `directions` without what the rows hold.
    fn free_of(&mut self, mut directions: DMatrix<f64>) -> DMatrix<f64> {
        let zeros = DVector::zeros(self.n_rows);
        for mut column in directions.column_iter_mut() {
            let free = self.solve(&column.clone_owned(), &zeros);
            column.copy_from(&free);
        }
        let qr = directions.col_piv_qr();
        let n_left = qr.r().diagonal().iter().filter(|left| left.abs() > LEFT).count();
        qr.q().columns(0, n_left).into_owned()
    }
}
