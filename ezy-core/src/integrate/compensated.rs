//! Compensated summation.

use crate::scalar::Scalar;

/// `from + (increment + rest)`; the rounding error becomes the next `rest`.
///
/// # Source
/// Knuth, The Art of Computer Programming 2, 4.2.2: the error of a sum is a floating-point number.
#[inline(always)]
pub(super) fn add<T: Scalar>(from: T, increment: T, rest: &mut T) -> T {
    let increment = increment + *rest;
    let sum = from + increment;
    let taken = sum - from;
    *rest = (from - (sum - taken)) + (increment - taken);
    sum
}

/// `to = from + increment`, with what rounding cuts off in `rest`.
pub(super) fn add_each(to: &mut [f64], from: &[f64], increment: &[f64], rest: &mut [f64]) {
    for (((to, from), increment), rest) in to.iter_mut().zip(from).zip(increment).zip(rest) {
        *to = add(*from, *increment, rest);
    }
}
