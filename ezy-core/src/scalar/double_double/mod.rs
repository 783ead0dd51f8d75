//! Numbers of twice the length of `f64`: 106 bits, 31 decimal digits.

mod functions;
mod tables;
#[cfg(test)]
mod tests;

use std::ops::Neg;

/// The unevaluated sum of two `f64` that do not overlap: `low` is at most half of the last place of `high`.
///
/// Sums, products and quotients have a relative error below 1e-31, sums under cancellation included; the range is that of
/// `f64`, less the last 1e16 at its lower end.
///
/// ```
/// use ezy_core::scalar::{DoubleDouble, Scalar};
///
/// let third = DoubleDouble::from_f64(1.0) / DoubleDouble::from_f64(3.0);
/// let rest = third * DoubleDouble::from_f64(3.0) - DoubleDouble::from_f64(1.0);
/// assert!(rest.magnitude() < 1e-31);
/// ```
///
/// # Source
/// Dekker, Numer. Math. 18 (1971); Joldes, Muller, Popescu, ACM Trans. Math. Softw. 44 (2017).
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    /// `high + low`, which may overlap.
    #[inline]
    pub(crate) fn new(high: f64, low: f64) -> Self {
        two_sum(high, low)
    }

    /// The nearest `f64`.
    #[inline]
    pub fn high(self) -> f64 {
        self.high
    }

    /// What [`DoubleDouble::high`] leaves.
    #[inline]
    pub fn low(self) -> f64 {
        self.low
    }

    /// Times a power of two, so that nothing is rounded.
    #[inline]
    fn scaled(self, power_of_two: f64) -> Self {
        Self { high: self.high * power_of_two, low: self.low * power_of_two }
    }

    #[inline]
    fn is_negative(self) -> bool {
        self.high < 0.0
    }
}

impl From<f64> for DoubleDouble {
    #[inline]
    fn from(x: f64) -> Self {
        Self { high: x, low: 0.0 }
    }
}

/// a + b without error.
#[inline(always)]
fn two_sum(a: f64, b: f64) -> DoubleDouble {
    let high = a + b;
    let from_b = high - a;
    DoubleDouble { high, low: (a - (high - from_b)) + (b - from_b) }
}

/// a + b without error where |a| ≥ |b|.
#[inline(always)]
fn quick_two_sum(a: f64, b: f64) -> DoubleDouble {
    let high = a + b;
    DoubleDouble { high, low: b - (high - a) }
}

/// a b without error.
#[inline(always)]
fn two_product(a: f64, b: f64) -> DoubleDouble {
    let high = a * b;
    if cfg!(target_feature = "fma") {
        return DoubleDouble { high, low: a.mul_add(b, -high) };
    }
    let ((a, a_rest), (b, b_rest)) = (halves(a), halves(b));
    DoubleDouble { high, low: ((a * b - high) + a * b_rest + a_rest * b) + a_rest * b_rest }
}

/// The upper and lower 26 bits.
#[inline(always)]
fn halves(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = 134_217_729.0; // 2²⁷ + 1
    let scaled = SPLITTER * a;
    let upper = scaled - (scaled - a);
    (upper, a - upper)
}

/// a + b
#[inline(always)]
fn sum(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let (upper, lower) = (two_sum(a.high, b.high), two_sum(a.low, b.low));
    let sum = quick_two_sum(upper.high, upper.low + lower.high);
    quick_two_sum(sum.high, lower.low + sum.low)
}

/// a b
#[inline(always)]
fn product(a: DoubleDouble, b: DoubleDouble) -> DoubleDouble {
    let product = two_product(a.high, b.high);
    let crossed = a.low * b.low + a.high * b.low + a.low * b.high;
    quick_two_sum(product.high, product.low + crossed)
}

// Operators are calls: a kernel has hundreds of them, and inlined each is twenty instructions to be compiled for every
// scene. What runs in loops is inlined there (`fused_in_loop`).

operator!([] DoubleDouble, Add::add, inline(never), |a, b| sum(a, b));
operator!([] DoubleDouble, Sub::sub, inline(never), |a, b| sum(a, -b));
operator!([] DoubleDouble, Mul::mul, inline(never), |a, b| product(a, b));
// long division, digit by digit of 53 bits
operator!([] DoubleDouble, Div::div, inline(never), |a, b| {
    let first = a.high / b.high;
    let rest = a - b * first.into();
    let second = rest.high / b.high;
    let third = (rest - b * second.into()).high / b.high;
    let quotient = quick_two_sum(first, second);
    quick_two_sum(quotient.high, quotient.low + third)
});

impl Neg for DoubleDouble {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}
