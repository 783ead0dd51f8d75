//! Order and length of a step, from the tolerance and the coefficients.

use super::states::States;
use crate::integrate::Tolerance;
use crate::integrate::tolerances::taylor::{LOG_LEAST_REST, LOG_WITHIN_RADIUS, MORE_ORDERS};
use crate::model::SeriesStore;
use crate::scalar::Scalar;

/// Range of orders. Lower ones gain nothing over other methods; higher ones serve tolerances below double precision.
const ORDERS: std::ops::RangeInclusive<usize> = 6..=24;

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

/// Logarithm that represents zero.
const LOG_NOTHING: f64 = -1023.0;

/// The longest step whose truncation keeps to a tolerance, s; infinite where all high orders vanish.
///
/// The order of a step is that of v and z, so that y_k holds q_k, v_k = (k + 1) q_{k+1} and z_k, each over its tolerance. The last four
/// orders give a radius of convergence and, each carried on to the last order with it, the size of the last term; the
/// step is such that all terms after it, as a geometric series, make the tolerance.
pub(super) fn longest_step<T: Scalar>(store: &SeriesStore<T>, states: States, order: usize, weights: &[f64]) -> f64 {
    let size = |k: usize| log2(norm(store, states, k, weights));
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

/// Reciprocals of the tolerances of q, v, then z.
pub(super) fn write_weights<T: Scalar>(
    store: &SeriesStore<T>,
    states: States,
    tolerance: Tolerance,
    weights: &mut [f64],
) {
    let of_motion = weights.len() - states.count();
    let n_q = of_motion / 2;
    let numbers = store.q[..of_motion].iter().chain(states.of_order(store, 0));
    for (i, (weight, x)) in weights.iter_mut().zip(numbers).enumerate() {
        *weight = 1.0 / tolerance.of(i, n_q, x.magnitude());
    }
}

/// Largest entry of y_k over its tolerance.
fn norm<T: Scalar>(store: &SeriesStore<T>, states: States, k: usize, weights: &[f64]) -> f64 {
    let (of_motion, of_z) = weights.split_at(weights.len() - states.count());
    let (of_q, of_v) = of_motion.split_at(of_motion.len() / 2);
    let n_q = of_q.len();
    let largest = |numbers: &[T], weights: &[f64]| {
        let sizes = numbers.iter().zip(weights).map(|(x, weight)| x.magnitude() * weight);
        sizes.fold(0.0, f64::max)
    };
    let q = |k: usize| &store.q[k * n_q..][..n_q];
    let of_motion = largest(q(k), of_q).max((k + 1) as f64 * largest(q(k + 1), of_v));
    of_motion.max(largest(states.of_order(store, k), of_z))
}

/// Logarithm to 0.09, which is 1 % of a step: exponent and mantissa as they stand.
fn log2(x: f64) -> f64 {
    x.to_bits() as i64 as f64 * f64::EPSILON + LOG_NOTHING
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::series::SeriesSize;

    const ORDER: usize = 12;

    /// Positions with these coefficients, weighted by one; velocities do not count. Powers of two have exact logarithms.
    fn longest(coefficient: impl Fn(usize) -> f64) -> f64 {
        let size = SeriesSize { n_coordinates: 1, n_rows: 0, n_products: 0, n_base: 0, n_kept: 0 };
        let mut store = SeriesStore::<f64>::new(size, ORDER + 1);
        store.q.iter_mut().enumerate().for_each(|(k, q)| *q = coefficient(k));
        longest_step(&store, States::new(0, size), ORDER, &[1.0, 0.0])
    }

    /// Rounding of some logarithms.
    const ROUNDING: f64 = 1e-12;

    fn close(x: f64, y: f64) {
        assert!((x / y - 1.0).abs() <= ROUNDING, "{x} {y}");
    }

    /// c/ρ^k with the radius ρ: steps h with c (h/ρ)^n x = 1, where x = c^(−1/n) is about h/ρ, counts as 1/16 at least and 1/2 at most, and at most
    /// half of the radius.
    #[test]
    fn analytic_geometric_series_are_cut_off_at_the_tolerance() {
        let n = ORDER as f64;
        for radius in [0.25_f64, 1.0, 8.0] {
            for (log_c, log_x) in [(24.0_f64, -2.0), (96.0, -4.0), (6.0, -1.0)] {
                let found = longest(|k| log_c.exp2() * radius.powi(-(k as i32)));
                let expected = radius * ((-log_c - log_x) / n).exp2();
                close(found, expected.min(0.5 * radius));
            }
        }
    }

    /// A symmetric motion lacks every second coefficient: the others tell the same. One small last coefficient is carried on from those before.
    #[test]
    fn invariant_missing_coefficients_do_not_lengthen_a_step() {
        let series = |k: usize| 24.0_f64.exp2() * 2.0_f64.powi(-(k as i32));
        let all = longest(series);
        for odd in [0, 1] {
            close(longest(|k| if k % 2 == odd { series(k) } else { 0.0 }), all);
        }
        close(longest(|k| if k == ORDER { 1e-9 * series(k) } else { series(k) }), all);
    }

    /// A motion with a last power m below the order is the polynomial: it may go on for ever when m is at most half of the order, and else until
    /// its term makes the tolerance. Where only the last coefficient is there, at most half of the step at which it makes one.
    #[test]
    fn analytic_polynomials_and_gaps() {
        assert_eq!(longest(|k| if k <= 6 { 3.0 } else { 0.0 }), f64::INFINITY);
        close(longest(|k| if k == 8 { 2.0_f64.powi(16) } else { 0.0 }), 0.25);
        close(longest(|k| if k == 7 || k == 8 { 2.0_f64.powi(16) } else { 0.0 }), 2.0_f64.powf(-16.0 / 7.0));
        close(longest(|k| if k == ORDER { 2.0_f64.powi(24) } else { 0.0 }), 0.125);
    }

    /// v_k = (k + 1) q_(k+1), each over its own tolerance.
    #[test]
    fn analytic_velocities_count_with_their_own_coefficients() {
        let size = SeriesSize { n_coordinates: 2, n_rows: 0, n_products: 0, n_base: 0, n_kept: 0 };
        let mut store = SeriesStore::<f64>::new(size, 3);
        store.q = vec![2.0, -1.0, 4.0, 3.0, 1.0, -5.0, 7.0, 2.0];
        let states = States::new(0, size);
        let norm = |weights: [f64; 4], k: usize| norm(&store, states, k, &weights);
        assert_eq!(norm([1.0, 10.0, 0.0, 0.0], 1), 30.0);
        assert_eq!(norm([1.0, 0.0, 1.0, 0.0], 1), 4.0);
        assert_eq!(norm([0.0, 0.0, 2.0, 1.0], 1), 10.0);
        assert_eq!(norm([0.0, 0.0, 1.0, 1.0], 2), 21.0);
        let mut weights = [0.0; 4];
        write_weights(&store, states, Tolerance::new(0.5, 1.0), &mut weights);
        assert_eq!(weights, [0.5, 1.0 / 1.5, 1.0 / 3.0, 1.0 / 2.5]);
    }

    /// A state beside an angle that has a tolerance of its own, which is not that of the state.
    #[test]
    fn analytic_states_count_with_their_own_tolerance() {
        let size = SeriesSize { n_coordinates: 3, n_rows: 0, n_products: 0, n_base: 0, n_kept: 2 };
        let (states, mut store) = (States::new(1, size), SeriesStore::<f64>::new(size, 3));
        store.kept = vec![-4.0, 50.0, 3.0, 50.0, 7.0, 50.0, 1.0, 50.0];
        let mut weights = [0.0; 7];
        let tolerance = Tolerance { angle: Some(0.125), ..Tolerance::new(0.5, 2.0) };
        write_weights(&store, states, tolerance, &mut weights);
        assert_eq!(weights, [0.5, 0.5, 8.0, 0.5, 0.5, 0.5, 0.25]);
        assert_eq!([0, 1, 2].map(|k| norm(&store, states, k, &weights)), [1.0, 0.75, 1.75]);
        store.q[3..6].copy_from_slice(&[0.0, 0.0, 2.0]);
        assert_eq!([0, 1, 2].map(|k| norm(&store, states, k, &weights)), [1.0, 16.0, 1.75]);
    }

    /// 1 − ln(ε)/2 for the least work, two more for what does not depend on the order; between 6 and 24.
    #[test]
    fn analytic_order_grows_with_the_logarithm_of_the_tolerance() {
        let order = |relative, absolute| order_for(Tolerance::new(relative, absolute));
        // 3 + 4.605 n/4 for 10^(−2n)…
        assert_eq!([1e-1, 1e-4, 1e-8, 1e-12].map(|tolerance| order(tolerance, tolerance)), [6, 8, 13, 17]);
        assert_eq!((order(1e-12, 1e-4), order(1e-4, 1e-12)), (8, 8), "the larger one counts");
        assert_eq!(order(0.0, 0.0), 22);
    }

    #[test]
    fn analytic_logarithms_are_right_to_a_tenth() {
        for (x, expected) in [(1.0, 0.0), (8.0, 3.0), (0.25, -2.0), (0.0, -1023.0)] {
            assert_eq!(log2(x), expected);
        }
        for i in 1..100 {
            let x = 0.37 * f64::from(i);
            assert!((log2(x) - x.log2()).abs() <= 0.09, "{x}");
        }
    }
}
