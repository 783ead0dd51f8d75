//! Sparse LDLᵀ of K in an order known beforehand. Every call of faer is in this file.

use super::{KktFactorization, VanishedPivot};
use crate::model::{PIVOT_TOLERANCE, SparsityPattern};
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::perm::Perm;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{Conj, MatMut, Par, Side, Spec};

/// LDLᵀ factors of K, without pivoting: every row of G comes after all coordinates that it touches, so that the
/// pivots are the masses and, for rows, minus the part of `g M⁻¹ gᵀ` that earlier rows leave. They vanish only
/// with a mass or with the rank of G.
pub struct SparseKkt {
    n_q: usize,
    pattern: SymbolicSparseColMat<usize>,
    values: Vec<f64>,
    /// Where the masses and the entries of G stand in `values`.
    mass_places: Vec<usize>,
    jacobian_places: Vec<usize>,
    /// (row, column) of each entry of G.
    entries: Vec<(usize, usize)>,
    symbolic: SymbolicCholesky<usize>,
    /// Where the pivot of each row of G stands in `factors`.
    pivot_places: Vec<usize>,
    pivot_starts: Vec<f64>,
    factors: Vec<f64>,
    scratch: MemBuffer,
}

/// The symbolic factorisation failed.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the sparse factorisation of a system of {n} equations could not be prepared: {cause}; use the dense backend")]
pub struct SparseKktError {
    /// Size of K.
    pub n: usize,
    /// What faer answered.
    pub cause: String,
}

impl SparseKkt {
    /// Analyses the pattern and allocates everything.
    ///
    /// # Errors
    /// [`SparseKktError`] when the analysis fails, for want of memory.
    pub fn new(n_q: usize, jacobian: &SparsityPattern) -> Result<Self, SparseKktError> {
        let n = n_q + jacobian.n_rows();
        let error = |cause: &dyn std::fmt::Debug| SparseKktError { n, cause: format!("{cause:?}") };
        let lower = LowerTriangle::new(n_q, jacobian);
        let (forward, inverse) = bodies_before_rows(n_q, jacobian);
        let pattern = SymbolicSparseColMat::new_checked(n, n, lower.column_starts, None, lower.row_indices);
        let order = Perm::new_checked(forward.into(), inverse.clone().into(), n);
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SIMPLICIAL,
            ..Default::default()
        };
        let symbolic = factorize_symbolic_cholesky(
            pattern.as_ref(),
            Side::Lower,
            SymmetricOrdering::Custom(order.as_ref()),
            params,
        )
        .map_err(|e| error(&e))?;
        let SymbolicCholeskyRaw::Simplicial(simplicial) = symbolic.raw() else {
            return Err(error(&"supernodal factors where simplicial ones were asked for"));
        };
        let pivot_places = inverse[n_q..].iter().map(|&position| simplicial.col_ptr()[position]).collect();
        let scratch = MemBuffer::new(StackReq::any_of(&[
            symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Spec::default()),
            symbolic.solve_in_place_scratch::<f64>(1, Par::Seq),
        ]));
        Ok(Self {
            n_q,
            values: vec![0.0; pattern.as_ref().compute_nnz()],
            mass_places: lower.mass_places,
            jacobian_places: lower.jacobian_places,
            entries: jacobian.entries().map(|(_, row, column)| (row, column)).collect(),
            pivot_places,
            pivot_starts: vec![0.0; n - n_q],
            factors: vec![0.0; symbolic.len_val()],
            pattern,
            symbolic,
            scratch,
        })
    }
}

impl KktFactorization for SparseKkt {
    fn factor(&mut self, mass: &[f64], jacobian: &[f64]) -> Result<(), VanishedPivot> {
        for (place, m) in self.mass_places.iter().zip(mass) {
            self.values[*place] = *m;
        }
        self.pivot_starts.fill(0.0);
        for ((place, g), (row, column)) in self.jacobian_places.iter().zip(jacobian).zip(&self.entries) {
            self.values[*place] = *g;
            self.pivot_starts[*row] += g * g / mass[*column];
        }
        self.symbolic
            .factorize_numeric_ldlt(
                &mut self.factors,
                SparseColMatRef::new(self.pattern.as_ref(), &self.values),
                Side::Lower,
                LdltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut self.scratch),
                Spec::default(),
            )
            .map_err(|_| VanishedPivot { relative: 0.0 })?;
        for (place, start) in self.pivot_places.iter().zip(&self.pivot_starts) {
            let relative = -self.factors[*place] / start;
            if relative.is_nan() || relative <= PIVOT_TOLERANCE {
                return Err(VanishedPivot { relative });
            }
        }
        Ok(())
    }

    fn solve(&mut self, right_side: &mut [f64]) {
        debug_assert_eq!(right_side.len(), self.n_q + self.pivot_starts.len());
        let n = right_side.len();
        LdltRef::new(&self.symbolic, &self.factors).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(right_side, n, 1),
            Par::Seq,
            MemStack::new(&mut self.scratch),
        );
    }
}

/// Compressed columns of the lower triangle of K, with an explicit zero on the diagonal of each row of G.
struct LowerTriangle {
    column_starts: Vec<usize>,
    row_indices: Vec<usize>,
    mass_places: Vec<usize>,
    jacobian_places: Vec<usize>,
}

impl LowerTriangle {
    fn new(n_q: usize, jacobian: &SparsityPattern) -> Self {
        let mut column_starts = vec![0];
        let mut row_indices = Vec::new();
        let mut mass_places = Vec::with_capacity(n_q);
        let mut jacobian_places = vec![0; jacobian.n_nonzeros()];
        let mut by_column = vec![Vec::new(); n_q];
        for (k, row, column) in jacobian.entries() {
            by_column[column].push((k, row));
        }
        for (column, entries) in by_column.iter().enumerate() {
            mass_places.push(row_indices.len());
            row_indices.push(column);
            for &(k, row) in entries {
                jacobian_places[k] = row_indices.len();
                row_indices.push(n_q + row);
            }
            column_starts.push(row_indices.len());
        }
        for row in 0..jacobian.n_rows() {
            row_indices.push(n_q + row);
            column_starts.push(row_indices.len());
        }
        Self { column_starts, row_indices, mass_places, jacobian_places }
    }
}

/// Elimination order and its inverse: rows in declared order, each right after the last coordinate it touches;
/// coordinates that no row touches at the end.
fn bodies_before_rows(n_q: usize, jacobian: &SparsityPattern) -> (Vec<usize>, Vec<usize>) {
    let n = n_q + jacobian.n_rows();
    let mut forward = Vec::with_capacity(n);
    let mut placed = vec![false; n_q];
    for row in 0..jacobian.n_rows() {
        for &column in &jacobian.columns[jacobian.starts[row]..jacobian.starts[row + 1]] {
            if !std::mem::replace(&mut placed[column], true) {
                forward.push(column);
            }
        }
        forward.push(n_q + row);
    }
    forward.extend((0..n_q).filter(|&i| !placed[i]));
    let mut inverse = vec![0; n];
    for (position, &i) in forward.iter().enumerate() {
        inverse[i] = position;
    }
    (forward, inverse)
}
