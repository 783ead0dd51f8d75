//! `f64` itself.

use super::Scalar;

impl Scalar for f64 {
    const PI: Self = std::f64::consts::PI;

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn fused(self, factor: Self, summand: Self) -> Self {
        // without the instruction `mul_add` is a call that costs ten times the two operations
        if cfg!(target_feature = "fma") { self.mul_add(factor, summand) } else { self * factor + summand }
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        self.sin_cos()
    }

    #[inline(always)]
    fn sin(self) -> Self {
        self.sin()
    }

    #[inline(always)]
    fn cos(self) -> Self {
        self.cos()
    }

    #[inline(always)]
    fn tan(self) -> Self {
        self.tan()
    }

    #[inline(always)]
    fn asin(self) -> Self {
        self.asin()
    }

    #[inline(always)]
    fn acos(self) -> Self {
        self.acos()
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        self.atan2(x)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn exp(self) -> Self {
        self.exp()
    }

    #[inline(always)]
    fn ln(self) -> Self {
        self.ln()
    }

    #[inline(always)]
    fn tanh(self) -> Self {
        self.tanh()
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.min(other)
    }

    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.max(other)
    }

    #[inline(always)]
    fn sign(self) -> Self {
        if self == 0.0 { 0.0 } else { self.signum() }
    }

    #[inline(always)]
    fn powf(self, exponent: Self) -> Self {
        self.powf(exponent)
    }

    #[inline(always)]
    fn least_ratio(self, divisor: Self) -> f64 {
        self / divisor
    }

    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.abs()
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.is_finite()
    }
}
