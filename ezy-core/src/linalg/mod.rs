//! Solvers of `K [x; y] = [r; s]` with `K = [M Gᵀ; G 0]`. Knows no bodies, only M, G and their pattern.
//!
//! | backend | needs | method |
//! |---|---|---|
//! | generated | M > 0 | the scene's own straight-line elimination, [`crate::model::Equations::accelerations`] |
//! | dense | K regular | LU of the scaled K with partial, at need complete pivoting ([`DenseKkt`]) |
//! | sparse | M > 0 | LDLᵀ in an order known beforehand ([`SparseKkt`]) |
//!
//! Where rows of G depend on each other, dense and sparse factor K with these rows damped ([`DampedKkt`]).

// matrices keep the capital letters of the notation
#![allow(non_snake_case)]

mod complete;
mod conditioning;
mod damped;
mod dense;
mod lower;
mod lu;
mod order;
mod rank;
mod refinement;
mod scaled;
mod singular;
mod sparse;
mod sparse_lu;

pub(crate) use conditioning::{ConditionEstimator, Conditioning};
pub(crate) use damped::{COARSE, DampedKkt, FINE, Left, weights, write_diagonal};
pub(crate) use dense::{DenseKkt, LARGEST_DENSE};
pub(crate) use lu::Lu;
pub(crate) use rank::{Dependencies, LARGEST_DIAGNOSED, dependencies, undetermined_coordinates};
pub(crate) use singular::singular_values;
#[doc(hidden)]
pub use sparse::{SparseKkt, SparseKktError};
pub(crate) use sparse_lu::SparseLu;

/// Which solver of K a run uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Backend {
    /// [`Backend::Generated`], in scenes with counts [`Backend::Sparse`]; [`Backend::Dense`] when a mass or inertia is
    /// zero or, in a scene without counts or with at most 100 equations, less than 1e-4 of the largest; inertias count by
    /// the mass that their longest lever feels.
    #[default]
    Auto,
    /// Straight-line elimination of the scene; needs positive masses and inertias, and a scene without counts.
    Generated,
    /// Pivoted dense LU; the only one for massless bodies. Up to [`LARGEST_DENSE`] equations.
    Dense,
    /// Sparse LDLᵀ; needs positive masses and inertias.
    Sparse,
}

/// A factorisation of K, made again at each state.
#[doc(hidden)]
pub trait KktFactorization: Send {
    /// Factors K for the diagonal `mass` (`n_q`) and the entries `jacobian` of G in the order of the pattern.
    ///
    /// # Errors
    /// [`VanishedPivot`] when K is singular to working precision; [`dependencies`] and
    /// [`undetermined_coordinates`] tell why.
    fn factor(&mut self, mass: &[f64], jacobian: &[f64]) -> Result<(), VanishedPivot>;

    /// As [`Self::factor`], of `[M Gᵀ; G −Δ]` with the positive diagonal `damping` (`n_c`) of Δ; regular whatever the rank
    /// of G.
    ///
    /// # Errors
    /// [`VanishedPivot`] when a number is not finite, or a coordinate has neither mass nor a row that holds it.
    fn factor_damped(&mut self, mass: &[f64], jacobian: &[f64], damping: &[f64]) -> Result<(), VanishedPivot>;

    /// Smallest pivot of a row after a successful [`Self::factor`], or of any unknown where the method does not keep them apart;
    /// relative to what it started from, or of the scaled K.
    fn smallest_pivot(&self) -> f64;

    /// Replaces `[r; s]` (`n_q + n_c`) by `[x; y]`, with the factors of the last successful [`Self::factor`].
    fn solve(&mut self, right_side: &mut [f64]);
}

/// A pivot is zero to working precision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VanishedPivot {
    /// Size of the pivot, relative to the entry that it started from.
    pub relative: f64,
    /// The row whose pivot it is, where the method knows.
    pub row: Option<usize>,
}
