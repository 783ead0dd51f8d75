//! `f64` itself, as a number that kernels run on and as text in messages.

use std::ops::Range;

use super::{Lanes, Scalar, in_wide};

/// Methods of [`Scalar`] that are those of `f64` by the same names.
macro_rules! as_in_std {
    ($($name:ident($($argument:ident)?) -> $result:ty;)*) => {$(
        #[inline(always)]
        fn $name(self $(, $argument: Self)?) -> $result {
            f64::$name(self $(, $argument)?)
        }
    )*};
}

impl Scalar for f64 {
    const PI: Self = std::f64::consts::PI;

    as_in_std! {
        sin_cos() -> (Self, Self);
        sin() -> Self;
        cos() -> Self;
        tan() -> Self;
        asin() -> Self;
        acos() -> Self;
        atan2(x) -> Self;
        sqrt() -> Self;
        exp() -> Self;
        ln() -> Self;
        tanh() -> Self;
        abs() -> Self;
        min(other) -> Self;
        max(other) -> Self;
        powf(exponent) -> Self;
        is_finite() -> bool;
    }

    #[inline(always)]
    fn sin_cos_of<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
        const { assert!(N <= 4, "up to four angles") };
        let mut four = [0.0; 4];
        four[..N].copy_from_slice(&angles);
        let [a, b, c, d] = four;
        if N <= 2 { of_each(of_two(a, b)) } else { of_each(of_four(a, b, c, d)) }
    }

    #[inline(always)]
    fn sin_cos_of_each(x: &[Self], out: &mut [[Self; 2]]) {
        let (eights, more) = x.as_chunks::<8>();
        let (first, last) = out.split_at_mut(x.len() - more.len());
        for (x, out) in eights.iter().zip(first.as_chunks_mut::<8>().0) {
            *out = table_of(x);
        }
        if !more.is_empty() {
            let mut padded = [0.0; 8];
            padded[..more.len()].copy_from_slice(more);
            last.copy_from_slice(&table_of(&padded)[..more.len()]);
        }
    }

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
    fn sign(self) -> Self {
        if self == 0.0 { 0.0 } else { self.signum() }
    }

    #[inline(always)]
    fn least_ratio(self, divisor: Self) -> f64 {
        self / divisor
    }

    #[inline(always)]
    fn magnitude(self) -> f64 {
        self.abs()
    }
}

/// [sin, cos] of each of eight numbers, in lanes.
#[inline(always)]
fn table_of(x: &[f64; 8]) -> [[f64; 2]; 8] {
    let (Lanes(sin), Lanes(cos)) = Lanes(*x).sin_cos();
    let mut table = [[0.0; 2]; 8];
    for i in 0..8 {
        table[i] = [sin[i], cos[i]];
    }
    table
}

/// The first lanes.
#[inline(always)]
fn of_each<const N: usize, const L: usize>((Lanes(sin), Lanes(cos)): (Lanes<L>, Lanes<L>)) -> [(f64, f64); N] {
    let mut found = [(0.0, 0.0); N];
    for i in 0..N.min(L) {
        found[i] = (sin[i], cos[i]);
    }
    found
}

// These are compiled here, and not with the kernels that ask for them, which are not optimised in a development build. Angles come in registers: what was stored one by one, and
// is read as a vector, waits for the memory.

#[inline(never)]
fn of_two(a: f64, b: f64) -> (Lanes<2>, Lanes<2>) {
    Lanes([a, b]).sin_cos()
}

#[inline(never)]
fn of_four(a: f64, b: f64, c: f64, d: f64) -> (Lanes<4>, Lanes<4>) {
    in_wide(
        #[inline(always)]
        || Lanes([a, b, c, d]).sin_cos(),
    )
}

/// Magnitudes that are written without an exponent: zeros of others say less than they take.
const PLAIN: Range<f64> = 1e-6..1e15;

/// All digits of a number, with an exponent where it is very small or very large.
pub fn legible(x: f64) -> String {
    if x == 0.0 || !x.is_finite() || PLAIN.contains(&x.abs()) { format!("{x}") } else { format!("{x:e}") }
}

/// A number rounded to so many significant digits.
pub fn rounded(x: f64, n_digits: usize) -> String {
    let digits = n_digits.saturating_sub(1);
    format!("{x:.digits$e}").parse().map_or_else(|_| legible(x), legible)
}

/// A time in seconds as people write it, to 12 digits: without the rounding of the sum of its steps, 0.30000000000000004.
pub fn legible_time(t: f64) -> String {
    const N_DIGITS: usize = 12;
    rounded(t, N_DIGITS)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As by the lanes, whose polynomials are compared with other digits there; beyond 1e6 rad those of the C library.
    #[test]
    fn cross_sines_of_several_angles_are_those_of_lanes() {
        let mut numbers = crate::scalar::random::SplitMix64(3);
        let mut angle = |size: f64| size * numbers.symmetric();
        for _ in 0..1_000 {
            let [a, b, c] = [1.0, 10.0, 1e5].map(&mut angle);
            let large = 1e9 + angle(1e8);
            let mut each = [[0.0; 2]; 3];
            f64::sin_cos_of_each(&[a, b, c], &mut each);
            let expected = each.map(|[sin, cos]| (sin, cos));
            assert_eq!(f64::sin_cos_of([a, b, c]), expected);
            assert_eq!(f64::sin_cos_of([a, b])[..], expected[..2]);
            for ((sin, cos), angle) in expected.into_iter().zip([a, b, c]) {
                let (of_library, other) = angle.sin_cos();
                assert!((sin - of_library).abs().max((cos - other).abs()) <= 2.0 * f64::EPSILON, "{angle}");
            }
            assert_eq!(f64::sin_cos_of([a, large]), [a.sin_cos(), large.sin_cos()]);
        }
    }

    #[test]
    fn analytic_numbers_have_an_exponent_where_they_are_very_small() {
        assert_eq!([0.001, -2.0, 1e-300].map(legible), ["0.001", "-2", "1e-300"]);
        assert_eq!([12.3456, 0.000_123_456, 1.5e-9].map(|x| rounded(x, 4)), ["12.35", "0.0001235", "1.5e-9"]);
        assert_eq!([0.1 + 0.2, 1e-7, 60.0, 0.0].map(legible_time), ["0.3", "1e-7", "60", "0"]);
    }
}
