//! Numbers with derivatives.

#[cfg(test)]
mod tests;

use super::Scalar;
use std::array::from_fn;
use std::ops::Neg;

/// A number and its derivatives by `N` quantities, carried through every operation (forward differentiation).
///
/// Comparisons go by the value. Where a function is not differentiable (`abs`, `min`, `max`) the derivatives are those of the side that
/// is taken.
///
/// ```
/// use ezy_core::scalar::{Dual, Scalar};
///
/// let x = Dual::<1>::variable(2.0, 0);
/// let y = x * x * x;
/// assert_eq!((y.value, y.derivatives), (8.0, [12.0]));
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual<const N: usize> {
    /// The number.
    pub value: f64,
    /// Its derivatives.
    pub derivatives: [f64; N],
}

impl<const N: usize> Dual<N> {
    /// A constant.
    #[inline]
    pub(crate) const fn constant(value: f64) -> Self {
        Self { value, derivatives: [0.0; N] }
    }

    /// The quantity `index` itself: its own derivative is 1, the others are 0; past the last it does not vary.
    #[inline]
    pub fn variable(value: f64, index: usize) -> Self {
        Self { value, derivatives: from_fn(|i| if i == index { 1.0 } else { 0.0 }) }
    }

    /// Value and slope of a function of one number. What does not vary has no derivative, even where the slope is infinite: so the
    /// root of a sum of squares has none at zero.
    #[inline(always)]
    fn chain(self, value: f64, slope: f64) -> Self {
        Self { value, derivatives: self.derivatives.map(|d| if d == 0.0 { 0.0 } else { slope * d }) }
    }

    /// Value and slopes of a function of two numbers.
    #[inline(always)]
    fn chain_two(self, other: Self, value: f64, slopes: [f64; 2]) -> Self {
        let derivatives = from_fn(|i| slopes[0] * self.derivatives[i] + slopes[1] * other.derivatives[i]);
        Self { value, derivatives }
    }

    fn is_constant(self) -> bool {
        self.derivatives == [0.0; N]
    }
}

operator!([const N: usize] Dual<N>, Add::add, inline(always), |a, b| Self {
    value: a.value + b.value,
    derivatives: from_fn(|i| a.derivatives[i] + b.derivatives[i]),
});
operator!([const N: usize] Dual<N>, Sub::sub, inline(always), |a, b| Self {
    value: a.value - b.value,
    derivatives: from_fn(|i| a.derivatives[i] - b.derivatives[i]),
});
operator!([const N: usize] Dual<N>, Mul::mul, inline(always), |a, b| {
    a.chain_two(b, a.value * b.value, [b.value, a.value])
});
operator!([const N: usize] Dual<N>, Div::div, inline(always), |a, b| {
    let quotient = a.value / b.value;
    let slope = 1.0 / b.value;
    a.chain_two(b, quotient, [slope, -quotient * slope])
});

impl<const N: usize> Neg for Dual<N> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self { value: -self.value, derivatives: self.derivatives.map(f64::neg) }
    }
}

impl<const N: usize> Scalar for Dual<N> {
    const PI: Self = Self::constant(std::f64::consts::PI);

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self::constant(x)
    }

    #[inline(always)]
    fn fused(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    #[inline]
    fn asin(self) -> Self {
        self.chain(self.value.asin(), 1.0 / ((1.0 - self.value) * (1.0 + self.value)).sqrt())
    }

    #[inline]
    fn acos(self) -> Self {
        self.chain(self.value.acos(), -1.0 / ((1.0 - self.value) * (1.0 + self.value)).sqrt())
    }

    #[inline]
    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        self.chain_two(x, self.value.atan2(x.value), [x.value / square, -self.value / square])
    }

    #[inline]
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }

    #[inline]
    fn exp(self) -> Self {
        let power = self.value.exp();
        self.chain(power, power)
    }

    #[inline]
    fn ln(self) -> Self {
        self.chain(self.value.ln(), 1.0 / self.value)
    }

    #[inline]
    fn tanh(self) -> Self {
        let tanh = self.value.tanh();
        self.chain(tanh, 1.0 - tanh * tanh)
    }

    #[inline]
    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        if self.value <= other.value || other.value.is_nan() { self } else { other }
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        if self.value >= other.value || other.value.is_nan() { self } else { other }
    }

    #[inline]
    fn sign(self) -> Self {
        Self::constant(Scalar::sign(self.value))
    }

    fn powf(self, exponent: Self) -> Self {
        let (base, n) = (self.value, exponent.value);
        let power = base.powf(n);
        let by_base = n * base.powf(n - 1.0);
        // a constant exponent may stand on a base without a logarithm
        if exponent.is_constant() {
            return self.chain(power, by_base);
        }
        self.chain_two(exponent, power, [by_base, power * base.ln()])
    }

    #[inline]
    fn least_ratio(self, divisor: Self) -> f64 {
        self.value / divisor.value
    }

    #[inline]
    fn magnitude(self) -> f64 {
        self.value.abs()
    }

    #[inline]
    fn extent(self) -> f64 {
        self.derivatives.iter().fold(self.value.abs(), |m, d| if d.abs() > m || d.is_nan() { d.abs() } else { m })
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.value.is_finite() && self.derivatives.iter().all(|d| d.is_finite())
    }
}
