//! Several `f64` side by side.

#![allow(
    clippy::needless_range_loop,
    reason = "counted loops become vector instructions, iterators of this length do not"
)]

/// `$step` for each of `L` lanes `$i`. Eight are written out, without a loop and without calls: a kernel has hundreds of operations, and the compiler would have to remove
/// these from each.
macro_rules! each {
    ($i:ident: $step:expr) => {{
        if L == 8 {
            each!($i: $step; 0, 1, 2, 3, 4, 5, 6, 7);
        } else {
            for $i in 0..L {
                $step;
            }
        }
    }};
    ($i:ident: $step:expr; $($lane:literal),*) => {
        $({
            let $i = $lane;
            $step;
        })*
    };
}

mod sin_cos;
#[cfg(test)]
mod tests;

use super::{Scalar, part_in_wide};
use std::ops::Neg;

/// `L` numbers that go through the same operations, one a trajectory; 4 and 8 fill vector registers.
///
/// Each lane has the result that `f64` alone would have, but for sine and cosine: those are computed in lanes, to 1 unit in
/// the last place, and may differ from the system's in that.
///
/// Vector registers of four or eight numbers need `-C target-cpu=x86-64-v3` or better, or a caller that asks the processor, as
/// [`Ensemble`](crate::simulate::Ensemble) does. On an x86-64 processor without AVX2 no other caller can compute a kernel of more than some 400 operations in lanes.
// eight numbers are one line of the cache
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(align(64))]
pub struct Lanes<const L: usize>(pub [f64; L]);

impl<const L: usize> Lanes<L> {
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        self.zip(self, |x, _| f(x))
    }

    /// One number of all lanes, by that of two: by halves, so that lanes are compared together.
    #[inline(always)]
    fn of_all(self, of_two: impl Fn(f64, f64) -> f64) -> f64 {
        let (mut x, mut n) = (self.0, L);
        while n > 1 {
            let half = n.div_ceil(2);
            for i in 0..n - half {
                x[i] = of_two(x[i], x[half + i]);
            }
            n = half;
        }
        x[0]
    }

    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        let mut x = self.0;
        for i in 0..L {
            x[i] = f(x[i], other.0[i]);
        }
        Self(x)
    }
}

/// Numbers of several runs side by side.
pub(crate) fn packed<const L: usize>(runs: [&[f64]; L]) -> Vec<Lanes<L>> {
    (0..runs[0].len()).map(|i| Lanes(runs.map(|run| run[i]))).collect()
}

/// An operator, in each lane that of `f64`.
macro_rules! in_lanes {
    ($operator:ident::$method:ident, $with:tt) => {
        operator!([const L: usize] Lanes<L>, $operator::$method, inline(always), |a, b| {
            let mut x = a.0;
            each!(i: x[i] $with b.0[i]);
            Self(x)
        });
    };
}
in_lanes!(Add::add, +=);
in_lanes!(Sub::sub, -=);
in_lanes!(Mul::mul, *=);
in_lanes!(Div::div, /=);

impl<const L: usize> Neg for Lanes<L> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        let mut x = self.0;
        each!(i: x[i] = -x[i]);
        Self(x)
    }
}

/// Functions of one or two numbers, in each lane those of `f64`.
macro_rules! in_each_lane {
    ($inline:meta: $($name:ident)*; $($of_two:ident)*) => {
        $(#[$inline]
        fn $name(self) -> Self {
            self.map(f64::$name)
        })*
        $(#[$inline]
        fn $of_two(self, other: Self) -> Self {
            self.zip(other, f64::$of_two)
        })*
    };
}

impl<const L: usize> Scalar for Lanes<L> {
    const PI: Self = Self([std::f64::consts::PI; L]);

    in_each_lane!(inline(always): sqrt abs; min max);
    in_each_lane!(inline: asin acos exp ln tanh; atan2 powf);

    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self([x; L])
    }

    #[inline(always)]
    fn in_part<R>(f: impl FnOnce() -> R) -> R {
        part_in_wide(f)
    }

    #[inline(always)]
    fn fused(self, factor: Self, summand: Self) -> Self {
        let mut x = self.0;
        for i in 0..L {
            x[i] = x[i].fused(factor.0[i], summand.0[i]);
        }
        Self(x)
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = sin_cos::sin_cos(&self.0);
        (Self(sin), Self(cos))
    }

    #[inline(always)]
    fn sign(self) -> Self {
        self.map(Scalar::sign)
    }

    #[inline(always)]
    fn least_ratio(self, divisor: Self) -> f64 {
        // what is no number stays
        (self / divisor).of_all(|x, y| if (x < y) | x.is_nan() { x } else { y })
    }

    #[inline(always)]
    fn magnitude(self) -> f64 {
        // what is no number stays
        self.abs().of_all(|x, y| if (x > y) | x.is_nan() { x } else { y })
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        self.0.iter().fold(true, |all, x| all & x.is_finite())
    }
}
