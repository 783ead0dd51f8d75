//! The numbers that blocks consist of.

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

/// Two numbers that go through the same operations, as the instructions of the machine have them: of arrays the compiler would make vectors of its own choice.
#[cfg(target_arch = "x86_64")]
mod register {
    use pulp::core_arch::x86::Sse2;
    use std::arch::x86_64::__m128d;

    pub(super) type Register = __m128d;

    /// Known when it is compiled.
    #[inline(always)]
    fn sse2() -> Sse2 {
        Sse2::try_new().expect("every x86-64 processor has SSE2")
    }

    #[inline(always)]
    pub(super) fn of([first, second]: [f64; 2]) -> Register {
        sse2()._mm_set_pd(second, first)
    }

    #[inline(always)]
    pub(super) fn lanes(register: Register) -> [f64; 2] {
        let second = sse2()._mm_unpackhi_pd(register, register);
        [register, second].map(|register| sse2()._mm_cvtsd_f64(register))
    }

    macro_rules! operations {
        ($($name:ident: $instruction:ident)*) => {
            $(#[inline(always)]
            pub(super) fn $name(a: Register, b: Register) -> Register {
                sse2().$instruction(a, b)
            })*
        };
    }
    operations!(add: _mm_add_pd sub: _mm_sub_pd mul: _mm_mul_pd div: _mm_div_pd min: _mm_min_pd);
}

#[cfg(not(target_arch = "x86_64"))]
mod register {
    pub(super) type Register = [f64; 2];

    #[inline(always)]
    pub(super) fn of(lanes: [f64; 2]) -> Register {
        lanes
    }

    #[inline(always)]
    pub(super) fn lanes(register: Register) -> [f64; 2] {
        register
    }

    macro_rules! operations {
        ($($name:ident: |$a:ident, $b:ident| $result:expr;)*) => {
            $(#[inline(always)]
            pub(super) fn $name(a: Register, b: Register) -> Register {
                std::array::from_fn(|lane| {
                    let ($a, $b) = (a[lane], b[lane]);
                    $result
                })
            })*
        };
    }
    operations!(
        add: |a, b| a + b;
        sub: |a, b| a - b;
        mul: |a, b| a * b;
        div: |a, b| a / b;
        min: |a, b| if a < b { a } else { b };
    );
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
