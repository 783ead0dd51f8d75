//! Order and length of a step, from the tolerance and the coefficients.

use crate::integrate::Tolerance;
use crate::model::SeriesStore;
use crate::scalar::Scalar;

/// Range of orders. Lower ones gain nothing over other methods; higher ones serve tolerances below double precision.
const ORDERS: std::ops::RangeInclusive<usize> = 6..=24;

/// Orders above the optimum for a cost proportional to the square of the order: factorisations and projections cost the same
/// at any order, and longer steps need fewer of them.
const MORE_ORDERS: f64 = 2.0;

/// The order that takes about the least time for a tolerance: over the driven EzyRoller one that is lower or higher by 2
/// takes 2 to 10 % more.
///
/// # Source
/// Jorba, Zou, Exp. Math. 14 (2005), sec. 3.
pub(crate) fn order_for(tolerance: Tolerance) -> usize {
    let order = 1.0 - 0.5 * tolerance.relative.max(tolerance.absolute).max(f64::EPSILON).ln() + MORE_ORDERS;
    (order.ceil() as usize).clamp(*ORDERS.start(), *ORDERS.end())
}

/// Number of last orders that are examined: a symmetric motion lacks every second one.
const N_LAST: usize = 4;

/// Steps stay below this part of the radius of convergence, as a power of two, however small the terms are.
const LOG_WITHIN_RADIUS: f64 = -1.0;

/// The remainder counts at least as this part of the last term, as a power of two.
const LOG_LEAST_REST: f64 = -4.0;

/// Logarithm that represents zero.
const LOG_NOTHING: f64 = -1023.0;

/// The longest step whose truncation keeps to a tolerance, s; infinite where all high orders vanish.
///
/// The order of a step is that of v, so that y_k holds q_k and v_k = (k + 1) q_{k+1}, each over its tolerance. The last four
/// orders give a radius of convergence and, each carried on to the last order with it, the size of the last term; the
/// step is such that all terms after it, as a geometric series, make the tolerance.
pub(super) fn longest_step<T: Scalar>(store: &SeriesStore<T>, order: usize, weights: &[f64]) -> f64 {
    let size = |k: usize| log2(norm(store, k, weights));
    let mut sizes = [LOG_NOTHING; N_LAST];
    sizes.iter_mut().enumerate().for_each(|(i, last)| *last = size(order + 1 + i - N_LAST));
    let [earlier, later] = [sizes[0].max(sizes[1]), sizes[2].max(sizes[3])];
    if later <= LOG_NOTHING {
        // a polynomial, or gaps: whatever there is beyond the middle counts as the last
        let longest = |k: usize| -size(k) / k as f64;
        let nonzero = (order / 2 + 1..order).filter(|&k| size(k) > LOG_NOTHING);
        return nonzero.map(longest).fold(f64::INFINITY, f64::min).exp2();
    }
    let order = order as f64;
    if earlier <= LOG_NOTHING {
        return (LOG_WITHIN_RADIUS - later / order).exp2();
    }
    let radius = 0.5 * (earlier - later);
    let carried = sizes.iter().rev().enumerate().map(|(i, size)| size - i as f64 * radius);
    let last_term = carried.fold(LOG_NOTHING, f64::max);
    let rest = (-last_term / order - radius).clamp(LOG_LEAST_REST, LOG_WITHIN_RADIUS);
    ((-last_term - rest) / order).min(radius + LOG_WITHIN_RADIUS).exp2()
}

/// Reciprocals of the tolerances of q, then of v.
pub(super) fn write_weights<T: Scalar>(store: &SeriesStore<T>, tolerance: Tolerance, weights: &mut [f64]) {
    for (weight, x) in weights.iter_mut().zip(&store.q) {
        *weight = 1.0 / (tolerance.absolute + tolerance.relative * x.magnitude());
    }
}

/// Largest entry of y_k over its tolerance.
fn norm<T: Scalar>(store: &SeriesStore<T>, k: usize, weights: &[f64]) -> f64 {
    let (of_q, of_v) = weights.split_at(weights.len() / 2);
    let n_q = of_q.len();
    let largest = |k: usize, weights: &[f64]| {
        let sizes = store.q[k * n_q..][..n_q].iter().zip(weights).map(|(x, weight)| x.magnitude() * weight);
        sizes.fold(0.0, f64::max)
    };
    largest(k, of_q).max((k + 1) as f64 * largest(k + 1, of_v))
}

/// Logarithm to 0.09, which is 1 % of a step: exponent and mantissa as they stand.
fn log2(x: f64) -> f64 {
    x.to_bits() as i64 as f64 * f64::EPSILON + LOG_NOTHING
}
