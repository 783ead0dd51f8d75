//! Taylor coefficients of the motion at one state.

use super::sums::sum_products;
use crate::model::{Series, SeriesStore};
use crate::scalar::Scalar;

/// Solves for `a` and `lambda` of each order from `force` and `row`, where the scene's own elimination does not.
pub(super) trait OrderSolver<T: Scalar> {
    /// Inputs and constants.
    fn fixed(&self) -> &[T];

    /// Writes `a`, and `lambda` of order `k`.
    fn solve(&mut self, k: usize, store: &mut SeriesStore<T>);
}

/// Coefficients of q up to `order + 1`, of z up to `order` and of the multipliers up to `order - 1`, behind [`Series::begin`], with the
/// scene's own factors.
pub(super) fn expand<T: Scalar>(series: &dyn Series<T>, c: &[T], order: usize, store: &mut SeriesStore<T>) {
    series.solve(c, 0, store);
    sum_products(store, 2);
    series.finish(c, 0, store);
    for k in 1..order {
        sum_products(store, k + 2);
        series.advance(c, k, store);
    }
}

/// As [`expand`], by another solver.
pub(super) fn expand_with<T: Scalar>(
    series: &dyn Series<T>,
    solver: &mut dyn OrderSolver<T>,
    order: usize,
    store: &mut SeriesStore<T>,
) {
    solver.solve(0, store);
    sum_products(store, 2);
    series.finish(solver.fixed(), 0, store);
    for k in 1..order {
        sum_products(store, k + 2);
        series.right_side(solver.fixed(), k, store);
        solver.solve(k, store);
        series.finish(solver.fixed(), k, store);
    }
}

/// Coordinates that are computed at a time: those of two bodies.
const TWO_BODIES: usize = 6;

/// What q and v gain over `s`, from coefficients of q up to `order + 1`.
pub(super) fn increment<T: Scalar>(store: &SeriesStore<T>, order: usize, s: T, q: &mut [T], v: &mut [T]) {
    let n_q = q.len();
    let (pairs_q, single_q) = q.as_chunks_mut::<TWO_BODIES>();
    let (pairs_v, single_v) = v.as_chunks_mut::<TWO_BODIES>();
    let n_paired = n_q - single_q.len();
    for (i, (q, v)) in pairs_q.iter_mut().zip(pairs_v).enumerate() {
        (*q, *v) = increment_columns(&store.q[i * TWO_BODIES..], n_q, order, s);
    }
    for (i, (q, v)) in single_q.iter_mut().zip(single_v).enumerate() {
        ([*q], [*v]) = increment_columns(&store.q[n_paired + i..], n_q, order, s);
    }
}

/// As [`increment`], for the first columns of coefficients in rows of `n_q`.
fn increment_columns<T: Scalar, const N: usize>(
    coefficients: &[T],
    n_q: usize,
    order: usize,
    s: T,
) -> ([T; N], [T; N]) {
    let mut r = [T::from_f64(0.0); N];
    let mut slope = r;
    // with q = q₀ + s (v₀ + s r): Horner's scheme of r, and of its derivative
    for k in (2..=order + 1).rev() {
        let row = &coefficients[k * n_q..][..N];
        for i in 0..N {
            slope[i] = slope[i].fused(s, r[i]);
            r[i] = r[i].fused(s, row[i]);
        }
    }
    let start = &coefficients[n_q..][..N];
    (std::array::from_fn(|i| r[i].fused(s, start[i]) * s), std::array::from_fn(|i| slope[i].fused(s, r[i] + r[i]) * s))
}

/// The second derivative of q after `s`, from coefficients of q up to `order + 1`.
pub(super) fn second_derivative(store: &SeriesStore<f64>, order: usize, s: f64, out: &mut [f64]) {
    let n_q = out.len();
    let (pairs, single) = out.as_chunks_mut::<TWO_BODIES>();
    let n_paired = n_q - single.len();
    for (i, out) in pairs.iter_mut().enumerate() {
        *out = second_derivative_columns(&store.q[i * TWO_BODIES..], n_q, order, s);
    }
    for (i, out) in single.iter_mut().enumerate() {
        [*out] = second_derivative_columns(&store.q[n_paired + i..], n_q, order, s);
    }
}

/// As [`second_derivative`], for the first columns of coefficients in rows of `n_q`.
fn second_derivative_columns<const N: usize>(coefficients: &[f64], n_q: usize, order: usize, s: f64) -> [f64; N] {
    let mut sums = [0.0; N];
    for k in (2..=order + 1).rev() {
        let (factor, row) = ((k * (k - 1)) as f64, &coefficients[k * n_q..][..N]);
        for i in 0..N {
            sums[i] = sums[i] * s + factor * row[i];
        }
    }
    sums
}
