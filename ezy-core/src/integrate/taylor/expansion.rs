//! Taylor coefficients of the motion at one state.

use super::sums::sum_products;
use crate::model::{Series, SeriesStore};
use crate::scalar::Scalar;

/// Solves for `a` and `lambda` of each order from `force` and `row`, where the scene's own elimination does not.
pub trait OrderSolver<T: Scalar> {
    /// Inputs and constants.
    fn fixed(&self) -> &[T];

    /// Writes `a`, and `lambda` of order `k`.
    fn solve(&mut self, k: usize, store: &mut SeriesStore<T>);
}

/// Coefficients of q up to `order + 1` and of the multipliers up to `order - 1`, behind [`Series::begin`], with the
/// scene's own factors.
pub fn expand<T: Scalar>(series: &dyn Series<T>, c: &[T], order: usize, store: &mut SeriesStore<T>) {
    series.solve(c, 0, store);
    sum_products(store, 2);
    series.finish(c, 0, store);
    for k in 1..order {
        sum_products(store, k + 2);
        series.advance(c, k, store);
    }
}

/// As [`expand`], by another solver.
pub fn expand_with<T: Scalar>(
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

/// What q and v gain over `s`, from coefficients of q up to `order + 1`.
pub fn increment<T: Scalar>(store: &SeriesStore<T>, order: usize, s: T, q: &mut [T], v: &mut [T]) {
    let n_q = q.len();
    let coefficients = |k: usize| &store.q[k * n_q..][..n_q];
    q.fill(T::from_f64(0.0));
    v.fill(T::from_f64(0.0));
    // with q = q₀ + s (v₀ + s r): Horner's scheme of r in `q`, of its derivative r′ in `v`
    for k in (2..=order + 1).rev() {
        for ((r, slope), x) in q.iter_mut().zip(v.iter_mut()).zip(coefficients(k)) {
            *slope = slope.fused(s, *r);
            *r = r.fused(s, *x);
        }
    }
    for ((q, v), start) in q.iter_mut().zip(v.iter_mut()).zip(coefficients(1)) {
        let (r, slope) = (*q, *v);
        *q = r.fused(s, *start) * s;
        *v = slope.fused(s, r + r) * s;
    }
}
