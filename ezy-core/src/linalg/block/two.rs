//! The numbers that blocks consist of.

use crate::machine::register;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, or two of them in one vector register.
pub(super) trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    fn from_f64(x: f64) -> Self;
}

impl Number for f64 {
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        x
    }
}

/// Two numbers in one register.
#[derive(Debug, Clone, Copy)]
pub(super) struct Two(register::Register);

impl Two {
    #[inline(always)]
    pub(super) fn new(lanes: [f64; 2]) -> Self {
        Self(register::of(lanes))
    }

    #[inline(always)]
    pub(super) fn lanes(self) -> [f64; 2] {
        register::lanes(self.0)
    }

    /// Zero in place of numbers whose size is below this.
    #[inline(always)]
    pub(super) fn or_zero_below(self, least: Self) -> Self {
        Self(register::or_zero_below(self.0, least.0))
    }

    /// The smaller numbers; those of `other` where one is not a number.
    #[inline(always)]
    pub(super) fn min(self, other: Self) -> Self {
        Self(register::min(self.0, other.0))
    }
}

macro_rules! operators {
    ($($operator:ident::$method:ident)*) => {
        $(impl $operator for Two {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(register::$method(self.0, other.0))
            }
        })*
    };
}

operators!(Add::add Sub::sub Mul::mul Div::div);

impl Neg for Two {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self::new([-0.0; 2]) - self
    }
}

impl Number for Two {
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self::new([x; 2])
    }
}
