//! Instructions of the machine at hand, in a build for any machine of its kind.

/// What `f` returns, compiled for vector registers of four numbers where this machine has them. Only what is inlined into `f` is compiled so: its loops over lanes, and functions
/// that are `#[inline(always)]`.
///
/// No two operations are fused that the base build keeps apart, so that the result has the same bits on every machine.
#[inline(always)]
pub(crate) fn in_wide<F: FnOnce() -> R, R>(f: F) -> R {
    #[cfg(target_arch = "x86_64")]
    if has_avx2() {
        // SAFETY: `in_avx2` needs a processor with AVX2, and this one has it
        return unsafe { in_avx2(f) };
    }
    f()
}

/// As [`in_wide`], or for registers of eight numbers where this machine has them. Runs in lanes gain a quarter; sweeps of collocation, which wait for their own results, nothing.
#[inline(always)]
pub(crate) fn in_widest<F: FnOnce() -> R, R>(f: F) -> R {
    #[cfg(target_arch = "x86_64")]
    if has_avx512() {
        // SAFETY: `in_avx512` needs a processor with these instructions, and this one has them
        return unsafe { in_avx512(f) };
    }
    in_wide(f)
}

/// What `wide` returns, compiled as by [`in_wide`] and for no other registers; on an x86-64 processor without these, what `narrow` returns. Kernels in lanes take the compiler
/// longer than all else in a crate of models, and few processors need them twice.
#[inline(always)]
pub(crate) fn in_wide_or<R>(wide: impl FnOnce() -> R, narrow: impl FnOnce() -> R) -> R {
    #[cfg(target_arch = "x86_64")]
    {
        if has_avx2() {
            // SAFETY: `in_avx2` needs a processor with AVX2, and this one has it
            unsafe { in_avx2(wide) }
        } else {
            narrow()
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        let _ = narrow;
        wide()
    }
}

/// As [`in_wide_or`], with registers as for [`in_widest`].
#[inline(always)]
pub(crate) fn in_widest_or<R>(wide: impl FnOnce() -> R, narrow: impl FnOnce() -> R) -> R {
    #[cfg(target_arch = "x86_64")]
    if has_avx512() {
        // SAFETY: `in_avx512` needs a processor with these instructions, and this one has them
        return unsafe { in_avx512(wide) };
    }
    in_wide_or(wide, narrow)
}

#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn has_avx512() -> bool {
    #[cfg(test)]
    if narrow::WIDEST.get() < 8 {
        return false;
    }
    use std::arch::is_x86_feature_detected as has;
    has!("avx512f") && has!("avx512dq") && has!("avx512vl")
}

#[cfg(target_arch = "x86_64")]
#[inline(always)]
fn has_avx2() -> bool {
    #[cfg(test)]
    if narrow::WIDEST.get() < 4 {
        return false;
    }
    std::arch::is_x86_feature_detected!("avx2")
}

/// Another processor, for tests.
#[cfg(test)]
pub(crate) mod narrow {
    use std::cell::Cell;

    thread_local! {
        /// Numbers in the widest registers that are used.
        pub(super) static WIDEST: Cell<usize> = const { Cell::new(8) };
    }

    /// Fails unless `f` returns the same on this processor, and on those whose widest registers have four numbers and two.
    pub(crate) fn assert_same_on_each_processor<R: PartialEq + std::fmt::Debug>(f: impl Fn() -> R) {
        let [eight, four, two] = [8, 4, 2].map(|n| {
            WIDEST.set(n);
            f()
        });
        WIDEST.set(8);
        assert_eq!(eight, four);
        assert_eq!(four, two);
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl")]
fn in_avx512<F: FnOnce() -> R, R>(f: F) -> R {
    f()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn in_avx2<F: FnOnce() -> R, R>(f: F) -> R {
    f()
}

/// What `f` returns, a part of what [`in_wide_or`] calls, as a function of its own.
#[inline(never)]
pub(crate) fn part_in_wide<F: FnOnce() -> R, R>(f: F) -> R {
    in_wide_or(f, || panic!("a long kernel in lanes needs a processor with AVX2: take one of f64"))
}

/// Two numbers that go through the same operations, as the instructions of the machine have them: of arrays the compiler would make vectors of its own choice.
#[cfg(all(feature = "sparse", target_arch = "x86_64"))]
pub(crate) mod register {
    use std::arch::x86_64::{
        __m128d, _mm_add_pd, _mm_and_pd, _mm_cmpnlt_pd, _mm_cvtsd_f64, _mm_div_pd, _mm_min_pd, _mm_mul_pd, _mm_set_pd,
        _mm_sub_pd, _mm_unpackhi_pd,
    };

    pub(crate) type Register = __m128d;

    macro_rules! operations {
        ($($name:ident: $instruction:ident($($of:ident: $kind:ty),*) -> $result:ty;)*) => {
            $(#[inline(always)]
            pub(crate) fn $name($($of: $kind),*) -> $result {
                // SAFETY: every x86-64 processor has SSE2, and these instructions touch no memory
                unsafe { $instruction($($of),*) }
            })*
        };
    }
    operations!(
        add: _mm_add_pd(a: Register, b: Register) -> Register;
        sub: _mm_sub_pd(a: Register, b: Register) -> Register;
        mul: _mm_mul_pd(a: Register, b: Register) -> Register;
        div: _mm_div_pd(a: Register, b: Register) -> Register;
        min: _mm_min_pd(a: Register, b: Register) -> Register;
        and: _mm_and_pd(a: Register, b: Register) -> Register;
        not_below: _mm_cmpnlt_pd(a: Register, b: Register) -> Register;
        of_second_and_first: _mm_set_pd(second: f64, first: f64) -> Register;
        first: _mm_cvtsd_f64(a: Register) -> f64;
        seconds: _mm_unpackhi_pd(a: Register, b: Register) -> Register;
    );

    #[inline(always)]
    pub(crate) fn of([first, second]: [f64; 2]) -> Register {
        of_second_and_first(second, first)
    }

    #[inline(always)]
    pub(crate) fn lanes(register: Register) -> [f64; 2] {
        [register, seconds(register, register)].map(first)
    }

    /// Zero in place of numbers whose size is below `least`.
    #[inline(always)]
    pub(crate) fn or_zero_below(a: Register, least: Register) -> Register {
        let size = and(a, of([f64::from_bits(!(1 << 63)); 2]));
        and(a, not_below(size, least))
    }
}

#[cfg(all(feature = "sparse", not(target_arch = "x86_64")))]
pub(crate) mod register {
    pub(crate) type Register = [f64; 2];

    #[inline(always)]
    pub(crate) fn of(lanes: [f64; 2]) -> Register {
        lanes
    }

    #[inline(always)]
    pub(crate) fn lanes(register: Register) -> [f64; 2] {
        register
    }

    macro_rules! operations {
        ($($name:ident: |$a:ident, $b:ident| $result:expr;)*) => {
            $(#[inline(always)]
            pub(crate) fn $name(a: Register, b: Register) -> Register {
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
        or_zero_below: |a, least| if a.abs() < least { 0.0 } else { a };
    );
}
