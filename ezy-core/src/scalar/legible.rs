//! Numbers in messages.

use std::ops::Range;

/// Magnitudes that are written without an exponent: zeros of others say less than they take.
const PLAIN: Range<f64> = 1e-6..1e15;

/// All digits of a number, with an exponent where it is very small or very large.
pub(crate) fn legible(x: f64) -> String {
    if x == 0.0 || !x.is_finite() || PLAIN.contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

/// A number rounded to so many significant digits.
#[cfg(any(test, feature = "cli"))]
pub(crate) fn rounded(x: f64, n_digits: usize) -> String {
    let digits = n_digits.saturating_sub(1);
    format!("{x:.digits$e}").parse().map_or_else(|_| legible(x), legible)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_numbers_have_an_exponent_where_they_are_very_small() {
        assert_eq!([0.001, -2.0, 1e-300].map(legible), ["0.001", "-2", "1e-300"]);
        assert_eq!([12.3456, 0.000_123_456, 1.5e-9].map(|x| rounded(x, 4)), ["12.35", "0.0001235", "1.5e-9"]);
    }
}
