//! The numbers that kernels run on.

/// An operator of a number: what it gives for two of them.
macro_rules! operator {
    ([$($generics:tt)*] $number:ty, $operator:ident::$method:ident, $inline:meta, |$a:ident, $b:ident| $result:expr) => {
        impl<$($generics)*> std::ops::$operator for $number {
            type Output = Self;

            #[$inline]
            fn $method(self, other: Self) -> Self {
                let ($a, $b) = (self, other);
                $result
            }
        }
    };
}

mod double_double;
mod dual;
mod lanes;
mod plain;
mod random;
#[cfg(feature = "export")]
mod recorded;

pub(crate) use crate::machine::{in_wide, in_wide_or, in_widest, in_widest_or, part_in_wide};
pub use double_double::DoubleDouble;
pub use dual::Dual;
pub use lanes::Lanes;
pub(crate) use lanes::packed;
pub use plain::{legible, legible_time, rounded};
pub(crate) use random::SplitMix64;
#[cfg(feature = "export")]
pub use recorded::Recorded;
#[cfg(feature = "export")]
pub(crate) use recorded::{Function, Operand, Operation, Operator, Pair, Tape, record, tangents};

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Its multiples without their whole parts fill an interval evenly.
pub(crate) const GOLDEN_RATIO: f64 = 1.618_033_988_749_895;

/// A number that a kernel can compute with: `f64`, or several `f64` that travel together.
///
/// Functions mean what those of `f64` mean, in the precision of the number.
pub trait Scalar:
    Copy
    + Debug
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// π, to the precision of the number.
    const PI: Self;

    /// A constant.
    fn from_f64(x: f64) -> Self;

    /// `self · factor + summand`, with one rounding where the target has an instruction for it.
    #[must_use]
    fn fused(self, factor: Self, summand: Self) -> Self;

    /// The same for the body of a loop, where it is always inlined.
    #[must_use]
    #[inline(always)]
    fn fused_in_loop(self, factor: Self, summand: Self) -> Self {
        self.fused(factor, summand)
    }

    /// What `f` returns, a part of a long kernel, as a function of its own: what is always inlined would be one function again.
    ///
    /// # Panics
    /// For [`Lanes`] on an x86-64 processor without AVX2.
    #[inline(never)]
    fn in_part<R>(f: impl FnOnce() -> R) -> R {
        f()
    }

    /// Sine and cosine.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);

    /// Sine and cosine of up to four angles. Those of `f64` are computed together, as by [`Self::sin_cos_of_each`].
    #[must_use]
    #[inline(always)]
    fn sin_cos_of<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
        const { assert!(N <= 4, "up to four angles") };
        let mut found = [(angles[0], angles[0]); N];
        // written out: a loop would keep them in memory
        if N > 0 {
            found[0] = angles[0].sin_cos();
        }
        if N > 1 {
            found[1] = angles[1].sin_cos();
        }
        if N > 2 {
            found[2] = angles[2].sin_cos();
        }
        if N > 3 {
            found[3] = angles[3].sin_cos();
        }
        found
    }

    /// Writes [sin, cos] of each number. Those of `f64` are computed in lanes, and differ from [`Self::sin_cos`] by up to two units in the last place.
    #[inline(always)]
    fn sin_cos_of_each(x: &[Self], out: &mut [[Self; 2]]) {
        x.iter().zip(out).for_each(|(x, out)| *out = x.sin_cos().into());
    }

    /// Sine.
    #[must_use]
    #[inline(always)]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// Cosine.
    #[must_use]
    #[inline(always)]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// Tangent.
    #[must_use]
    #[inline(always)]
    fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }

    /// Inverse sine.
    #[must_use]
    fn asin(self) -> Self;

    /// Inverse cosine.
    #[must_use]
    fn acos(self) -> Self;

    /// The angle of the vector (`x`, `self`).
    #[must_use]
    fn atan2(self, x: Self) -> Self;

    /// Square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Exponential function.
    #[must_use]
    fn exp(self) -> Self;

    /// Natural logarithm.
    #[must_use]
    fn ln(self) -> Self;

    /// Hyperbolic tangent.
    #[must_use]
    fn tanh(self) -> Self;

    /// Absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// The smaller one.
    #[must_use]
    fn min(self, other: Self) -> Self;

    /// The larger one.
    #[must_use]
    fn max(self, other: Self) -> Self;

    /// −1, 0 or 1; not a number stays so.
    #[must_use]
    fn sign(self) -> Self;

    /// A power.
    #[must_use]
    fn powf(self, exponent: Self) -> Self;

    /// Its ratio to `divisor` as one `f64`: the smallest where several numbers travel together, without derivatives; not a
    /// number where one of them is not.
    fn least_ratio(self, divisor: Self) -> f64;

    /// Its size as one `f64`: the largest where several numbers travel together, without derivatives.
    fn magnitude(self) -> f64;

    /// The largest of its size and those of its derivatives, where it carries any.
    fn extent(self) -> f64 {
        self.magnitude()
    }

    /// Whether it is a number, all of it.
    fn is_finite(self) -> bool;
}
