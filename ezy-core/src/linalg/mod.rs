//! Solvers of `K [x; y] = [r; s]` with `K = [M Gᵀ; G 0]`. Knows no bodies, only M, G and their pattern.
//!
//! | backend | needs | method |
//! |---|---|---|
//! | generated | M > 0, G of full rank | the scene's own straight-line elimination, [`crate::model::Equations::accelerations`] |
//! | dense | the motion determined | null-space method after full pivoting of G ([`NullSpaceKkt`]) |
//! | sparse | M > 0, G of full rank | LDLᵀ of G M⁻¹ Gᵀ over blocks of joints, or of K ([`SparseKkt`]), in an order known beforehand |
//!
//! Which constraints depend on each other is asked of [`RankRevealing`] alone. Where they do, the dense solver takes the place of
//! generated and sparse ones, and in systems of more than [`LARGEST_DIAGNOSED`] equations rows are damped ([`DampedKkt`]).

// matrices keep the capital letters of the notation
#![allow(non_snake_case)]

#[cfg(feature = "sparse")]
mod block;
mod conditioning;
mod damped;
mod equation_residual;
#[cfg(feature = "sparse")]
mod joints;
#[cfg(feature = "sparse")]
mod lower;
mod lu;
mod null_space;
#[cfg(feature = "sparse")]
mod order;
mod rank;
mod singular;
#[cfg(feature = "sparse")]
mod sparse;
#[cfg(feature = "sparse")]
mod sparse_lu;
#[cfg(all(test, feature = "sparse"))]
mod tests;
mod tolerances;
#[cfg(not(feature = "sparse"))]
mod without_sparse;

#[cfg(feature = "sparse")]
pub(crate) use block::by_joints;
pub(crate) use conditioning::{ConditionEstimator, Conditioning};
pub(crate) use damped::{DampedKkt, weights, write_diagonal};
pub(crate) use equation_residual::EquationResidual;
pub(crate) use lu::Lu;
pub(crate) use null_space::NullSpaceKkt;
pub(crate) use rank::{Independent, RankRevealing, undetermined_coordinates};
pub(crate) use singular::singular_values;
#[cfg(feature = "sparse")]
#[doc(hidden)]
pub use sparse::SparseKkt;
#[cfg(feature = "sparse")]
pub(crate) use sparse_lu::{SparseLu, SparseNumber};
pub(crate) use tolerances::rank::{INDEPENDENT, INDEPENDENT_EXACTLY};
pub(crate) use tolerances::sizes::{LARGEST_DENSE, LARGEST_DIAGNOSED};
#[cfg(not(feature = "sparse"))]
#[doc(hidden)]
pub use without_sparse::SparseKkt;
#[cfg(not(feature = "sparse"))]
pub(crate) use without_sparse::{SparseLu, SparseNumber, by_joints};

/// Whether there are sparse factorisations.
pub(crate) const HAS_SPARSE: bool = cfg!(feature = "sparse");

/// Which solver of K a run uses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Backend {
    /// [`Backend::Generated`], in scenes without an elimination (with counts, or with a body in more than 24 rows)
    /// [`Backend::Sparse`], without the feature `sparse` [`Backend::Dense`]. Also [`Backend::Dense`] when a mass or inertia is zero
    /// or, in a scene with an elimination or with at most 100 equations, less than 1e-4 of the largest; inertias count by the mass that
    /// their longest lever feels.
    #[default]
    Auto,
    /// Straight-line elimination of the scene; needs positive masses and inertias, and a scene that has one.
    Generated,
    /// Null-space method; the only one for massless bodies. Up to [`LARGEST_DENSE`] equations.
    Dense,
    /// LDLᵀ over blocks of joints, or entry by entry; needs positive masses and inertias.
    Sparse,
}

/// An elimination of K with a given M, in an order known beforehand, made again at each state. It decides nothing about rank.
pub trait KktFactorization: Send {
    /// Factors K with the entries `jacobian` of G in the order of the pattern.
    ///
    /// # Errors
    /// [`VanishedPivot`] when K is singular to working precision.
    fn factor(&mut self, jacobian: &[f64]) -> Result<(), VanishedPivot>;

    /// As [`Self::factor`], of `[M Gᵀ; G −Δ]` with the positive diagonal `damping` (`n_c`) of Δ; regular whatever the rank
    /// of G.
    ///
    /// # Errors
    /// [`VanishedPivot`] when a number is not finite, or a coordinate has neither mass nor a row that holds it.
    fn factor_damped(&mut self, jacobian: &[f64], damping: &[f64]) -> Result<(), VanishedPivot>;

    /// Smallest pivot of a row after a successful [`Self::factor`], relative to what it started from.
    fn smallest_pivot(&self) -> f64;

    /// Replaces r (`n_q`) by x and s (`n_c`) by y, with the factors of the last successful [`Self::factor`].
    fn solve(&mut self, r: &mut [f64], s: &mut [f64]);

    /// [`Self::factor`], then [`Self::solve`]; where that fails r and s are left as they were.
    ///
    /// # Errors
    /// As [`Self::factor`].
    fn factor_and_solve(&mut self, jacobian: &[f64], r: &mut [f64], s: &mut [f64]) -> Result<(), VanishedPivot> {
        self.factor(jacobian)?;
        self.solve(r, s);
        Ok(())
    }

    /// What is factored, and what it costs.
    fn describe(&self) -> String;
}

/// The symbolic factorisation failed.
#[doc(hidden)]
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("the sparse factorisation of a system of {n} equations could not be prepared: {cause}; use the dense backend")]
pub struct SparseKktError {
    /// Size of K.
    pub n: usize,
    /// What faer answered.
    pub cause: String,
}

/// A pivot is zero to working precision.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VanishedPivot {
    /// Size of the pivot, relative to the entry that it started from.
    pub relative: f64,
    /// The row whose pivot it is, where the method knows.
    pub row: Option<usize>,
}

/// K is singular whatever rows are redundant: a number is not finite, or nothing moves a coordinate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct SingularKkt;

/// What a solution leaves of rows that depend on others: not small only where they contradict each other. Rows are scaled to one,
/// angles in units of their levers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Left {
    /// The largest.
    pub rows: f64,
    /// To compare with: the largest number of the solution, of `M⁻¹ r`, or of the terms of a row.
    pub scale: f64,
}
