//! Which rows depend on each other, which coordinates nothing moves or holds.

use super::damped::write_diagonal;
use crate::model::SparsityPattern;
use nalgebra::{DMatrix, SymmetricEigen};

/// Dependencies between rows: the null space of the scaled `D^(−1/2) G W⁻¹ Gᵀ D^(−1/2)`, `D` its diagonal before.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Dependencies {
    /// Rows that take part in one, in declared order.
    pub rows: Vec<usize>,
    /// How many there are: rows beyond the rank of G.
    pub n: usize,
    /// The smallest eigenvalue: the smallest pivot that an elimination of rows scaled to one could meet.
    pub smallest_pivot: f64,
}

/// A row or coordinate takes part when its share of a null vector exceeds this; rounding leaves 1e-10 at most.
const PARTICIPATION: f64 = 1e-4;

/// Columns of massless coordinates scaled to one keep this part of what they are when rows hold them.
const HELD: f64 = 1e-9;

/// Largest n_q + n_c that is diagnosed: beyond it the decomposition takes longer than anyone waits for a message.
pub(crate) const LARGEST_DIAGNOSED: usize = 500;

/// Eigenvalues up to `tolerance` count as dependencies, with the positive diagonal `weight` of W; up to [`super::COARSE`], and with
/// [`super::weights`], solutions pass over what the rows say. Slow: for up to [`LARGEST_DIAGNOSED`] unknowns only. `None` when W or G is
/// not finite or the decomposition does not converge.
pub(crate) fn dependencies(
    weight: &[f64],
    pattern: &SparsityPattern,
    jacobian: &[f64],
    tolerance: f64,
) -> Option<Dependencies> {
    if !weight.iter().chain(jacobian).all(|x| x.is_finite()) {
        return None;
    }
    let n_rows = pattern.n_rows();
    let mut diagonal = vec![0.0; n_rows];
    write_diagonal(pattern.entries(), weight, jacobian, &mut diagonal);
    let mut rows = DMatrix::<f64>::zeros(n_rows, weight.len());
    for (k, row, column) in pattern.entries() {
        rows[(row, column)] += jacobian[k] / (diagonal[row] * weight[column]).sqrt();
    }
    let eigen = null_space(&rows * rows.transpose(), tolerance)?;
    Some(Dependencies { rows: eigen.takes_part, n: eigen.n, smallest_pivot: eigen.smallest })
}

/// Massless coordinates that take part in a motion which no row sees. `None` as for [`dependencies`].
pub(crate) fn undetermined_coordinates(
    mass: &[f64],
    pattern: &SparsityPattern,
    jacobian: &[f64],
) -> Option<Vec<usize>> {
    if !jacobian.iter().all(|x| x.is_finite()) {
        return None;
    }
    let massless: Vec<usize> = (0..mass.len()).filter(|&i| mass[i] == 0.0).collect();
    let mut columns = DMatrix::<f64>::zeros(pattern.n_rows(), massless.len());
    for (k, row, column) in pattern.entries() {
        if let Ok(i) = massless.binary_search(&column) {
            columns[(row, i)] += jacobian[k];
        }
    }
    for mut column in columns.column_iter_mut() {
        let length = column.norm();
        if length > 0.0 {
            column /= length;
        }
    }
    let eigen = null_space(columns.transpose() * &columns, HELD)?;
    Some(eigen.takes_part.into_iter().map(|i| massless[i]).collect())
}

struct NullSpace {
    takes_part: Vec<usize>,
    n: usize,
    smallest: f64,
}

/// What belongs to eigenvalues up to a tolerance.
fn null_space(symmetric: DMatrix<f64>, tolerance: f64) -> Option<NullSpace> {
    if !symmetric.iter().all(|x| x.is_finite()) {
        return None;
    }
    let size = symmetric.nrows();
    if size == 0 {
        return Some(NullSpace { takes_part: Vec::new(), n: 0, smallest: 1.0 });
    }
    let eigen = SymmetricEigen::try_new(symmetric, f64::EPSILON, 0)?;
    let mut takes_part = vec![false; size];
    let mut n = 0;
    for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
        if *value <= tolerance {
            n += 1;
            takes_part.iter_mut().zip(vector.iter()).for_each(|(p, x)| *p |= x.abs() > PARTICIPATION);
        }
    }
    Some(NullSpace {
        takes_part: (0..size).filter(|&i| takes_part[i]).collect(),
        n,
        smallest: eigen.eigenvalues.min().max(0.0),
    })
}
