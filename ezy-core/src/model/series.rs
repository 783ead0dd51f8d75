//! The Taylor series of a motion: what a generated scene implements to give its coefficients, order by order.
//!
//! With coefficients `x_k` of `x(t₀ + s) = Σ x_k s^k`, the equations of motion are at every order k
//! `[M G₀ᵀ; G₀ 0] [a_k; λ_k] = [f_k; r_k]`: one matrix for all orders, and a right side of lower coefficients. Rows say it
//! with coefficients of their own: k + 2 of C(q(t), t) for a position constraint, k + 1 of S v + s_t for a velocity constraint. So
//! q_{k+2} = a_k / ((k + 1)(k + 2)). A first-order state is like a velocity whose acceleration is its rate: z_{k+1} = ż_k / (k + 1).
//!
//! Nearly all work is in sums `Σ x_j y_{n−j}`. A scene states them as *products*: two factors each, whose coefficients it
//! writes to one row an order of [`SeriesStore::left`] and [`SeriesStore::right`]; whoever drives it forms all sums of
//! an order at once, over j = 1 … n − 1 with n = k + 2, into [`SeriesStore::sums`]. A factor that is known later than others
//! has its coefficients stored later by as many rows.
//!
//! # Source
//! Jorba, Zou, Exp. Math. 14 (2005); constraints by their own coefficients: Pryce, Numer. Algorithms 19 (1998), Nedialkov,
//! Pryce, BIT 45 (2005).

use super::{Operations, Pivots};
use crate::scalar::Scalar;

/// Products come in groups of so many, so that their sums fill vector registers.
pub const PRODUCT_GROUP: usize = 8;

/// Whether a scene has a Taylor series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum SeriesInfo {
    /// Every law is analytic. In a scene with counts, numbers are those of one member of each item.
    Analytic {
        /// Sums of products at each order.
        n_products: usize,
        /// Operations of each order besides those sums.
        operations: Operations,
    },
    /// A law calls a function that has no Taylor series.
    NotAnalytic {
        /// Name of the function.
        function: &'static str,
    },
    /// A scene written by hand: nothing was derived.
    Absent,
}

/// Sizes of the storage of a scene's series.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SeriesSize {
    /// n_q
    pub n_coordinates: usize,
    /// n_c
    pub n_rows: usize,
    /// A multiple of [`PRODUCT_GROUP`].
    pub n_products: usize,
    /// Numbers that belong to a whole step: values at its start and the factors of K.
    pub n_base: usize,
    /// Coefficients besides products that a later order reads: those of the first-order states, then others.
    pub n_kept: usize,
}

/// Coefficients of one step and what they are computed with; what belongs to order k starts at k times the length of
/// a row.
#[derive(Debug, Clone)]
pub struct SeriesStore<T> {
    /// Coordinates, `n_q` an order. The caller writes orders 0 and 1: q and v.
    pub q: Vec<T>,
    /// Multipliers, `n_c` an order.
    pub lambda: Vec<T>,
    /// Left factors of the products.
    pub left: Vec<T>,
    /// Right factors of the products.
    pub right: Vec<T>,
    /// Sums of the present order, `n_products`.
    pub sums: Vec<T>,
    /// `n_kept` an order, of which the first `n_z` are the first-order states.
    pub kept: Vec<T>,
    /// `n_base`
    pub base: Vec<T>,
    /// f of the present order, `n_q`.
    pub force: Vec<T>,
    /// r of the present order, `n_c`.
    pub row: Vec<T>,
    /// a of the present order, `n_q`.
    pub a: Vec<T>,
}

impl<T: Scalar> SeriesStore<T> {
    /// Storage for coefficients of q up to `order`.
    pub(crate) fn new(size: SeriesSize, order: usize) -> Self {
        let SeriesSize { n_coordinates, n_rows, n_products, n_base, n_kept } = size;
        let zeros = |n: usize| vec![T::from_f64(0.0); n];
        let n_orders = order + 1;
        Self {
            q: zeros(n_orders * n_coordinates),
            lambda: zeros(n_orders * n_rows),
            left: zeros(n_orders * n_products),
            right: zeros(n_orders * n_products),
            sums: zeros(n_products),
            kept: zeros(n_orders * n_kept),
            base: zeros(n_base),
            force: zeros(n_coordinates),
            row: zeros(n_rows),
            a: zeros(n_coordinates),
        }
    }
}

/// A scene whose laws are analytic: the recurrences of its Taylor series.
///
/// For order 0: [`Series::begin`], a solution of the linear equations, the sums for n = 2, [`Series::finish`]. Then for
/// k = 1, 2, …: the sums for n = k + 2, [`Series::right_side`], a solution, [`Series::finish`].
pub trait Series<T: Scalar>: Send + Sync {
    /// Sizes of the storage.
    fn series_size(&self) -> SeriesSize;

    /// Values at the start of a step, from orders 0 and 1 of q at time `t` and the first-order states in `c`: everything of orders 0 and 1, `force` and `row` of
    /// order 0, and the factors of K where the scene has an elimination; returns what its pivots are, all vanished
    /// where it has none.
    fn begin(&self, c: &[T], t: T, store: &mut SeriesStore<T>) -> Pivots;

    /// `force` and `row` of order `k` ≥ 1 and order `k + 1` of the first-order states, from the sums for n = k + 2.
    fn right_side(&self, c: &[T], k: usize, store: &mut SeriesStore<T>);

    /// Solves for `a` and `lambda` of order `k` with the factors of the step; a scene without elimination writes nothing.
    fn solve(&self, c: &[T], k: usize, store: &mut SeriesStore<T>);

    /// Order `k + 2` of q and of everything that depends on positions and time alone, from `a`, `lambda` and the sums
    /// for n = k + 2.
    fn finish(&self, c: &[T], k: usize, store: &mut SeriesStore<T>);

    /// Order `k` ≥ 1 in one call, for a scene with elimination.
    fn advance(&self, c: &[T], k: usize, store: &mut SeriesStore<T>) {
        self.right_side(c, k, store);
        self.solve(c, k, store);
        self.finish(c, k, store);
    }
}
