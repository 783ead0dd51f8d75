//! Why K is singular: which rows depend on each other, which coordinates nothing moves or holds.

use super::scaled::{assemble, scale};
use super::singular::singular_values;
use crate::model::SparsityPattern;
use nalgebra::DMatrix;

/// The null space of K. Since K [z; μ] = 0 splits into M z = 0, G z = 0 and Gᵀ μ = 0, a singular K means
/// dependent rows, or coordinates without mass that no row holds, or both.
#[derive(Debug, Clone, PartialEq)]
pub struct RankDiagnosis {
    /// Rows that take part in a dependency μ, in declared order.
    pub rows: Vec<usize>,
    /// Massless coordinates that take part in a free motion z.
    pub coordinates: Vec<usize>,
    /// Smallest singular value of the scaled K relative to the largest.
    pub smallest_singular_value: f64,
}

/// Singular values below this fraction of the largest span the null space. The pivots that led here are below
/// 1e-10 of what they started from and go with the square of the angle between dependent rows, so that angle is
/// below 1e-5.
const NULL_SPACE_TOLERANCE: f64 = 1e-5;

/// A row or coordinate takes part when its share of a null vector exceeds this; rounding leaves 1e-10 at most
/// next to singular values 1e-5 apart from the rest.
const PARTICIPATION: f64 = 1e-4;

/// Largest n_q + n_c that is diagnosed: beyond it the decomposition takes longer than anyone waits for a message.
pub const LARGEST_DIAGNOSED: usize = 500;

/// Null space of K by the singular value decomposition of the scaled K. Slow: for reports on up to
/// [`LARGEST_DIAGNOSED`] unknowns only. `None` when M or G is not finite or the decomposition does not converge.
pub fn diagnose(mass: &[f64], pattern: &SparsityPattern, jacobian: &[f64]) -> Option<RankDiagnosis> {
    if !mass.iter().chain(jacobian).all(|x| x.is_finite()) {
        return None;
    }
    let (n_q, n_c) = (mass.len(), pattern.n_rows());
    let entries: Vec<_> = pattern.entries().collect();
    let mut d = vec![1.0; n_q + n_c];
    scale(&entries, mass, jacobian, &mut d, &mut vec![0.0; n_q + n_c]);
    let mut K = DMatrix::zeros(n_q + n_c, n_q + n_c);
    assemble(&entries, mass, jacobian, &d, &mut K);
    let svd = singular_values(K, false, true)?;
    let (sigma, v_t) = (&svd.singular_values, svd.v_t.as_ref()?);
    let (largest, smallest) = (sigma.max(), sigma.min());
    let mut takes_part = vec![false; n_q + n_c];
    for (i, s) in sigma.iter().enumerate() {
        if *s <= (NULL_SPACE_TOLERANCE * largest).max(smallest) {
            takes_part.iter_mut().zip(v_t.row(i).iter()).for_each(|(p, x)| *p |= x.abs() > PARTICIPATION);
        }
    }
    let (coordinates, rows) = takes_part.split_at(n_q);
    let members = |flags: &[bool]| (0..flags.len()).filter(|&i| flags[i]).collect::<Vec<_>>();
    Some(RankDiagnosis {
        rows: members(rows),
        coordinates: (0..n_q).filter(|&i| coordinates[i] && mass[i] == 0.0).collect(),
        smallest_singular_value: smallest / largest,
    })
}
