//! Sums that keep what rounding cuts off.

/// `from + (increment + rest)`; what rounding cuts off becomes the next `rest`.
///
/// # Source
/// Knuth, The Art of Computer Programming 2, 4.2.2: the error of a sum is a floating-point number.
pub fn add(from: f64, increment: f64, rest: &mut f64) -> f64 {
    let increment = increment + *rest;
    let sum = from + increment;
    let taken = sum - from;
    *rest = (from - (sum - taken)) + (increment - taken);
    sum
}
