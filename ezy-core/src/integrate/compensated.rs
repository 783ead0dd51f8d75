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
