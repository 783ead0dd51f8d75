//! Sparse LDLᵀ of K in an order known beforehand.

use super::lower::LowerTriangle;
use super::order::{Order, bodies_before_rows};
use super::{KktFactorization, SparseKktError, VanishedPivot};
use crate::model::{PIVOT_TOLERANCE, SparsityPattern};
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::ldlt::factor::{LdltError, LdltRegularization};
use faer::perm::Perm;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMat};
use faer::{Conj, MatMut, Par, Side, Spec};

/// LDLᵀ factors of K, without pivoting: every row of G comes after the coordinates that it touches, so that the
/// pivots are the masses and, for rows, minus the part of `g M⁻¹ gᵀ` that earlier rows leave. They vanish only
/// with a mass or with the rank of G.
///
/// A body with very many joints comes after these joints instead, so that trees cost O(n) whatever their shape. A row
/// that its other bodies alone do not support has no pivot in that order; then the first one is taken from there on.
pub struct SparseKkt {
    /// Diagonal of M.
    mass: Vec<f64>,
    /// (row, column) of each entry of G.
    entries: Vec<(usize, usize)>,
    analysis: Analysis,
    pivot_starts: Vec<f64>,
    smallest_pivot: f64,
    /// `[r; s]` and `[x; y]`.
    both: Vec<f64>,
}

/// What follows from pattern and order.
struct Analysis {
    pattern: SymbolicSparseColMat<usize>,
    values: Vec<f64>,
    /// Where the masses, the entries of G and the diagonal of its rows stand in `values`.
    mass_places: Vec<usize>,
    jacobian_places: Vec<usize>,
    row_places: Vec<usize>,
    /// Whether an entry of G supports the pivot of its row: its coordinate comes first.
    supports: Vec<bool>,
    hubs_last: bool,
    symbolic: SymbolicCholesky<usize>,
    /// Unknown at each position of the order.
    order: Vec<usize>,
    /// Where the pivot of each row of G stands in `factors`.
    pivot_places: Vec<usize>,
    factors: Vec<f64>,
    scratch: MemBuffer,
}

impl SparseKkt {
    /// Analyses the pattern of the first `n_rows` rows and allocates everything; `mass` is the diagonal of M.
    ///
    /// # Errors
    /// [`SparseKktError`] when the analysis fails, for want of memory.
    pub fn new(mass: &[f64], jacobian: &SparsityPattern, n_rows: usize) -> Result<Self, SparseKktError> {
        let entries = jacobian.entries().filter(|(_, row, _)| *row < n_rows).map(|(_, row, column)| (row, column));
        Self::from_entries(mass, n_rows, entries.collect())
    }

    /// As [`Self::new`], from the (row, column) of each entry of G, in any order.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn from_entries(mass: &[f64], n_rows: usize, entries: Vec<(usize, usize)>) -> Result<Self, SparseKktError> {
        let analysis = Analysis::new(mass.len(), n_rows, &entries, true)?;
        let (pivot_starts, both) = (vec![0.0; n_rows], vec![0.0; mass.len() + n_rows]);
        Ok(Self { mass: mass.to_vec(), entries, analysis, pivot_starts, smallest_pivot: 1.0, both })
    }

    /// Stored entries of L.
    pub fn n_factor_entries(&self) -> usize {
        self.analysis.factors.len()
    }

    /// Writes values, and for each row the part of `g M⁻¹ gᵀ` that its pivot starts from.
    fn assemble(&mut self, jacobian: &[f64]) {
        let Analysis { values, mass_places, jacobian_places, supports, .. } = &mut self.analysis;
        values.fill(0.0);
        for (place, m) in mass_places.iter().zip(&self.mass) {
            values[*place] = *m;
        }
        self.pivot_starts.fill(0.0);
        let places = jacobian_places.iter().zip(supports).zip(&self.entries);
        for (((place, supports), (row, column)), g) in places.zip(jacobian) {
            values[*place] += *g;
            if *supports {
                self.pivot_starts[*row] += g * g / self.mass[*column];
            }
        }
    }

    fn try_factor(&mut self, jacobian: &[f64]) -> Result<(), VanishedPivot> {
        self.assemble(jacobian);
        self.analysis.eliminate()?;
        let pivots = self.analysis.pivot_places.iter().map(|place| -self.analysis.factors[*place]);
        self.smallest_pivot = 1.0;
        for (row, (pivot, start)) in pivots.zip(&self.pivot_starts).enumerate() {
            let relative = pivot / start;
            if relative.is_nan() || relative <= PIVOT_TOLERANCE {
                return Err(VanishedPivot { relative, row: Some(row) });
            }
            self.smallest_pivot = self.smallest_pivot.min(relative);
        }
        Ok(())
    }
}

impl Analysis {
    fn new(n_q: usize, n_rows: usize, entries: &[(usize, usize)], hubs_last: bool) -> Result<Self, SparseKktError> {
        let n = n_q + n_rows;
        let error = |cause: &dyn std::fmt::Debug| SparseKktError { n, cause: format!("{cause:?}") };
        let lower = LowerTriangle::new(n_q, n_rows, entries);
        let Order { forward, inverse, hubs_last } = bodies_before_rows(n_q, n_rows, entries, hubs_last)?;
        let pattern = SymbolicSparseColMat::new_checked(n, n, lower.column_starts, None, lower.row_indices);
        let permutation = Perm::new_checked(forward.clone().into(), inverse.clone().into(), n);
        let params = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SIMPLICIAL,
            ..Default::default()
        };
        let symbolic = factorize_symbolic_cholesky(
            pattern.as_ref(),
            Side::Lower,
            SymmetricOrdering::Custom(permutation.as_ref()),
            params,
        )
        .map_err(|e| error(&e))?;
        let SymbolicCholeskyRaw::Simplicial(simplicial) = symbolic.raw() else {
            return Err(error(&"supernodal factors where simplicial ones were asked for"));
        };
        let pivot_places = inverse[n_q..].iter().map(|&position| simplicial.col_ptr()[position]).collect();
        let scratch = MemBuffer::try_new(StackReq::any_of(&[
            symbolic.factorize_numeric_ldlt_scratch::<f64>(Par::Seq, Spec::default()),
            symbolic.solve_in_place_scratch::<f64>(1, Par::Seq),
        ]))
        .map_err(|e| error(&e))?;
        Ok(Self {
            values: vec![0.0; pattern.as_ref().compute_nnz()],
            mass_places: lower.mass_places,
            jacobian_places: lower.jacobian_places,
            row_places: lower.row_places,
            supports: entries.iter().map(|&(row, column)| inverse[column] < inverse[n_q + row]).collect(),
            hubs_last,
            order: forward,
            pivot_places,
            factors: vec![0.0; symbolic.len_val()],
            pattern,
            symbolic,
            scratch,
        })
    }

    /// Factors what stands in `values`.
    fn eliminate(&mut self) -> Result<(), VanishedPivot> {
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
            .map(|_| ())
            .map_err(|LdltError::ZeroPivot { index }| {
                // faer counts from one
                let unknown = index.checked_sub(1).and_then(|position| self.order.get(position));
                let row = unknown.and_then(|unknown| unknown.checked_sub(self.mass_places.len()));
                VanishedPivot { relative: 0.0, row }
            })
    }
}

impl KktFactorization for SparseKkt {
    fn factor(&mut self, jacobian: &[f64]) -> Result<(), VanishedPivot> {
        let outcome = self.try_factor(jacobian);
        if outcome.is_ok() || !self.analysis.hubs_last {
            return outcome;
        }
        match Analysis::new(self.mass.len(), self.pivot_starts.len(), &self.entries, false) {
            Err(_) => outcome,
            Ok(analysis) => {
                self.analysis = analysis;
                self.try_factor(jacobian)
            }
        }
    }

    fn factor_damped(&mut self, jacobian: &[f64], damping: &[f64]) -> Result<(), VanishedPivot> {
        self.assemble(jacobian);
        let Analysis { values, row_places, .. } = &mut self.analysis;
        for (place, damping) in row_places.iter().zip(damping) {
            values[*place] = -damping;
        }
        self.analysis.eliminate()?;
        let finite = self.analysis.factors.iter().all(|x| x.is_finite());
        if finite { Ok(()) } else { Err(VanishedPivot { relative: f64::NAN, row: None }) }
    }

    fn smallest_pivot(&self) -> f64 {
        self.smallest_pivot
    }

    fn solve(&mut self, r: &mut [f64], s: &mut [f64]) {
        let (n, both) = (self.both.len(), &mut self.both);
        both[..r.len()].copy_from_slice(r);
        both[r.len()..].copy_from_slice(s);
        let Analysis { symbolic, factors, scratch, .. } = &mut self.analysis;
        LdltRef::new(symbolic, factors).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(both, n, 1),
            Par::Seq,
            MemStack::new(scratch),
        );
        r.copy_from_slice(&both[..r.len()]);
        s.copy_from_slice(&both[r.len()..]);
    }

    fn describe(&self) -> String {
        format!("factors of K, {} entries of L", self.n_factor_entries())
    }
}
