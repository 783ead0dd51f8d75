//! What is done with values at all nodes of a step, in wide vector registers.

use super::tableau::{N, NODES, RECURRENCE, TO_COEFFICIENTS, TO_INTEGRALS};
use crate::model::Eight;
use crate::model::in_lanes::{largest_change, times};
use crate::scalar::{Lanes, Scalar, in_wide};

/// `out = start + h · integrals of the slopes`, at each node.
pub(super) fn integrate(h: f64, start: &[f64], slopes: &[Eight], out: &mut [Eight]) {
    in_wide(
        #[inline(always)]
        || {
            for ((out, start), slope) in out.iter_mut().zip(start).zip(slopes) {
                *out = times(&TO_INTEGRALS, slope).fused(Eight::from_f64(h), Eight::from_f64(*start));
            }
        },
    );
}

/// The same of some numbers, each with the place of its slope; the others are left alone.
pub(super) fn integrate_some(h: f64, start: &[f64], slopes: &[Eight], which: &[(usize, usize)], out: &mut [Eight]) {
    in_wide(
        #[inline(always)]
        || {
            for &(i, slope) in which {
                out[i] = times(&TO_INTEGRALS, &slopes[slope]).fused(Eight::from_f64(h), Eight::from_f64(start[i]));
            }
        },
    );
}

/// Legendre coefficients of each number, from P_0 on.
pub(super) fn coefficients(values: &[Eight], out: &mut [Eight]) {
    in_wide(
        #[inline(always)]
        || {
            for (values, out) in values.iter().zip(out) {
                *out = times(&TO_COEFFICIENTS, values);
            }
        },
    );
}

/// Legendre coefficients of each number, and the largest one of each degree, each number with its weight.
pub(super) fn coefficients_and_sizes(values: &[Eight], weights: &[f64], out: &mut [Eight]) -> [f64; N] {
    in_wide(
        #[inline(always)]
        || {
            let mut largest = Lanes([0.0; N]);
            for ((values, weight), out) in values.iter().zip(weights).zip(out) {
                *out = times(&TO_COEFFICIENTS, values);
                largest = largest.max(out.abs() * Eight::from_f64(*weight));
            }
            largest.0
        },
    )
}

/// Values, by the coefficients up to a degree, at the nodes of a step that begins at `start` and is `length` long, in units of the step that
/// the coefficients belong to.
pub(super) fn evaluate(coefficients: &[Eight], degree: usize, start: f64, length: f64, out: &mut [Eight]) {
    in_wide(
        #[inline(always)]
        || {
            let x = NODES.fused(Eight::from_f64(2.0 * length), Eight::from_f64(2.0 * start - 1.0));
            let mut polynomials = [Eight::from_f64(1.0); N];
            polynomials[1] = x;
            for k in 1..N - 1 {
                let [last, before] = RECURRENCE[k];
                let of_before = Eight::from_f64(-before) * polynomials[k - 1];
                polynomials[k + 1] = (Eight::from_f64(last) * x).fused(polynomials[k], of_before);
            }
            polynomials[degree + 1..].fill(Eight::from_f64(0.0));
            for (out, coefficients) in out.iter_mut().zip(coefficients) {
                *out = times(&polynomials, coefficients);
            }
        },
    );
}

/// The largest change of a number between two sweeps, each with its weight.
pub(super) fn change(one: &[Eight], other: &[Eight], weights: &[f64]) -> f64 {
    in_wide(
        #[inline(always)]
        || largest_change(one, other, weights),
    )
}

/// The largest value of a number, each with its weight.
pub(super) fn size(values: &[Eight], weights: &[f64]) -> f64 {
    in_wide(
        #[inline(always)]
        || {
            let mut size = 0.0_f64;
            for (values, weight) in values.iter().zip(weights) {
                size = size.max(values.magnitude() * weight);
            }
            size
        },
    )
}

/// The largest coefficient of each degree, each number with its weight.
pub(super) fn sizes(coefficients: &[Eight], weights: &[f64]) -> [f64; N] {
    in_wide(
        #[inline(always)]
        || {
            let mut largest = Lanes([0.0; N]);
            for (coefficients, weight) in coefficients.iter().zip(weights) {
                largest = largest.max(coefficients.abs() * Eight::from_f64(*weight));
            }
            largest.0
        },
    )
}

/// `Σ weights · values` over the nodes.
#[inline(always)]
pub(super) fn sum(weights: &Eight, values: &Eight) -> f64 {
    let x = (*weights * *values).0;
    ((x[0] + x[1]) + (x[2] + x[3])) + ((x[4] + x[5]) + (x[6] + x[7]))
}
