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

#[cfg(test)]
mod tests {
    use super::*;

    /// A hundred thousand increments of 1e-9: each alone would lose up to 1e-16.
    #[test]
    fn analytic_sums_of_many_small_increments_keep_their_last_digit() {
        let (mut sum, mut rest) = (1.0, 0.0);
        for _ in 0..100_000 {
            sum = add(sum, 1e-9, &mut rest);
        }
        assert!((sum - 1.0001).abs() <= f64::EPSILON, "{sum}");
        // what is cut off is known exactly: 1 + 2^-60 is 1 and the rest
        let mut rest = 0.0;
        assert_eq!((add(1.0, 2.0_f64.powi(-60), &mut rest), rest), (1.0, 2.0_f64.powi(-60)));
        // and of a small number with a large increment, too: 2^54 + 3 is 2^54 + 4
        let (mut rest, large) = (0.0, 2.0_f64.powi(54));
        assert_eq!((add(3.0, large, &mut rest), rest), (large + 4.0, -1.0));
        let mut rest = [0.0, 2.0_f64.powi(-53)];
        let mut to = [0.0; 2];
        add_each(&mut to, &[1.0, 1.0], &[2.0_f64.powi(-53), 2.0_f64.powi(-53)], &mut rest);
        assert_eq!((to, rest), ([1.0, 1.0 + f64::EPSILON], [2.0_f64.powi(-53), 0.0]));
    }
}
