//! Functions to the length of the number.
//!
//! An argument is reduced until its power series ends within [`INVERSE_FACTORIALS`]; an inverse function is one step of
//! Newton's method from the `f64` value, which doubles the digits.

use super::tables::{HALF_PI, INVERSE_FACTORIALS, LN_2, PI};
use super::{DoubleDouble, product, sum, two_product};
use crate::scalar::Scalar;

/// Exponents up to which the result is in the range.
const LARGEST_EXPONENT: f64 = 709.7;

/// tanh is 1 to the last bit from here on.
const SATURATED: f64 = 40.0;

/// Whole exponents up to here are powers by multiplication.
const LARGEST_POWER: f64 = 1024.0;

impl DoubleDouble {
    /// `self − n · constant` for a whole number `n`, where the constant is known in parts.
    fn less_multiples(self, n: f64, parts: [f64; 3]) -> Self {
        parts.into_iter().fold(self, |rest, part| rest - two_product(n, part))
    }

    /// `1/f! + s x/(f + d)! + s² x²/(f + 2 d)! + …` with f = `first`, d = `stride`, s = `sign`.
    fn series(self, first: usize, stride: usize, sign: f64) -> Self {
        let coefficients = INVERSE_FACTORIALS[first - 2..].iter().step_by(stride).rev();
        let argument = self.scaled(sign);
        coefficients.fold(Self::from(0.0), |sum, &coefficient| sum * argument + coefficient)
    }

    /// Sine and cosine of an angle up to π/4.
    fn sin_cos_reduced(self) -> (Self, Self) {
        let square = self * self;
        let sin = self - self * square * square.series(3, 2, -1.0);
        let cos = Self::from(1.0) - square * square.series(2, 2, -1.0);
        (sin, cos)
    }

    /// exp(x) − 1 without loss near zero.
    fn exp_m1(self) -> Self {
        if self.high.abs() > 0.5 * LN_2[0] {
            return self.exp() - Self::from(1.0);
        }
        self + self * self * self.series(2, 1, 1.0)
    }

    /// A whole power by squaring.
    fn whole_power(self, exponent: f64) -> Self {
        let (mut n, mut square, mut power) = (exponent.abs() as u32, self, Self::from(1.0));
        while n > 0 {
            if n % 2 == 1 {
                power = power * square;
            }
            square = square * square;
            n /= 2;
        }
        if exponent < 0.0 { Self::from(1.0) / power } else { power }
    }

    /// √(1 − x²)
    fn complement(self) -> Self {
        let one = Self::from(1.0);
        ((one - self) * (one + self)).sqrt()
    }
}

impl Scalar for DoubleDouble {
    const PI: Self = PI;

    #[inline]
    fn from_f64(x: f64) -> Self {
        x.into()
    }

    #[inline(never)]
    fn fused(self, factor: Self, summand: Self) -> Self {
        sum(product(self, factor), summand)
    }

    #[inline(always)]
    fn fused_in_loop(self, factor: Self, summand: Self) -> Self {
        sum(product(self, factor), summand)
    }

    /// Reduction by multiples of π/2 of 159 bits: for arguments up to 1e6 as accurate as the argument itself.
    fn sin_cos(self) -> (Self, Self) {
        let quarters = (self.high / HALF_PI[0]).round();
        let (sin, cos) = self.less_multiples(quarters, HALF_PI).sin_cos_reduced();
        match quarters.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    fn asin(self) -> Self {
        self.atan2(self.complement())
    }

    fn acos(self) -> Self {
        self.complement().atan2(self)
    }

    /// One step of Newton's method: the angle that is left has the tangent (y cos θ − x sin θ) / (x cos θ + y sin θ).
    fn atan2(self, x: Self) -> Self {
        let near = Self::from(self.high.atan2(x.high));
        if self.high == 0.0 && x.high >= 0.0 || !near.is_finite() {
            return near;
        }
        let (sin, cos) = near.sin_cos();
        near + (self * cos - x * sin) / (x * cos + self * sin)
    }

    fn sqrt(self) -> Self {
        let near = self.high.sqrt();
        if near == 0.0 || !near.is_finite() {
            return near.into();
        }
        let rest = self - two_product(near, near);
        Self::new(near, 0.5 * rest.high / near)
    }

    fn exp(self) -> Self {
        if self.high.is_nan() || self.high.abs() > LARGEST_EXPONENT {
            return self.high.exp().into();
        }
        let doublings = (self.high / LN_2[0]).round();
        let power = Self::from(1.0) + self.less_multiples(doublings, LN_2).exp_m1();
        // in two factors, since 2ⁿ itself may be out of range
        let half = (0.5 * doublings).trunc();
        power.scaled(half.exp2()).scaled((doublings - half).exp2())
    }

    /// Accurate to 1e-31 of the larger of 1 and the result.
    fn ln(self) -> Self {
        let near = Self::from(self.high.ln());
        if !near.is_finite() {
            return near;
        }
        near + (self * (-near).exp() - Self::from(1.0))
    }

    fn tanh(self) -> Self {
        if self.high.abs() > SATURATED {
            return self.sign();
        }
        let grown = self.scaled(2.0).exp_m1();
        grown / (grown + Self::from(2.0))
    }

    fn abs(self) -> Self {
        if self.is_negative() { -self } else { self }
    }

    fn min(self, other: Self) -> Self {
        if self <= other || other.high.is_nan() { self } else { other }
    }

    fn max(self, other: Self) -> Self {
        if self >= other || other.high.is_nan() { self } else { other }
    }

    fn sign(self) -> Self {
        Scalar::sign(self.high).into()
    }

    fn powf(self, exponent: Self) -> Self {
        let (base, n) = (self.high, exponent.high);
        if exponent.low == 0.0 && n.fract() == 0.0 && n.abs() <= LARGEST_POWER {
            return self.whole_power(n);
        }
        if base > 0.0 { (self.ln() * exponent).exp() } else { base.powf(n).into() }
    }

    fn least_ratio(self, divisor: Self) -> f64 {
        (self / divisor).high()
    }

    fn magnitude(self) -> f64 {
        self.high.abs()
    }

    fn is_finite(self) -> bool {
        self.high.is_finite()
    }
}
