//! A sign change of a function of one variable, and interpolation.

/// Where a singular place is interpolated from, in offsets from its middle: odd ones, so that none is beside it.
pub(super) const BETWEEN: [f64; 6] = [-1.0, -0.6, -0.2, 0.2, 0.6, 1.0];

/// Weights of the values at `places` in the polynomial through them, at `x`: Lagrange's.
pub(super) fn lagrange<const N: usize>(places: &[f64; N], x: f64) -> [f64; N] {
    let weight = |i: usize| {
        let others = (0..N).filter(|j| *j != i);
        others.map(|j| (x - places[j]) / (places[i] - places[j])).product::<f64>()
    };
    std::array::from_fn(weight)
}

/// Interpolation of the ITP method: κ₁ times the width, κ₂, and the steps that may be lost against bisection.
const KAPPA_1: f64 = 0.2;
const KAPPA_2: i32 = 2;
const LOST: i32 = 1;

/// Where `f` changes its sign between `a` < `b`, as an interval of at most `width`, or narrower where rounding allows no less; values of `f` at
/// the ends are `f_a` and `f_b`, of opposite sign. Where `f` is exactly zero over an interval, the end and the begin of that: rounding hides
/// the sign there, and the middle is the best that is known.
///
/// # Errors
/// Those of `f`.
///
/// # Cost
/// At most one evaluation more than bisection takes.
///
/// # Source
/// Oliveira, Takahashi (2020), An enhancement of the bisection method average performance preserving minmax optimality.
pub(super) fn sign_change<E>(
    [mut a, mut b]: [f64; 2],
    [mut f_a, mut f_b]: [f64; 2],
    width: f64,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<[f64; 2], E> {
    let halvings = ((b - a) / width).log2().ceil().max(0.0) as i32 + LOST;
    let first_width = b - a;
    for step in 0..=halvings {
        let middle = 0.5 * (a + b);
        if b - a <= width || !(a < middle && middle < b) {
            break;
        }
        let secant = (f_b * a - f_a * b) / (f_b - f_a);
        let secant = if secant.is_finite() { secant } else { middle };
        let toward = (middle - secant).signum();
        let truncation = KAPPA_1 / first_width * (b - a).powi(KAPPA_2);
        let truncated = if truncation <= (middle - secant).abs() { secant + toward * truncation } else { middle };
        let radius = (0.5 * width * 2f64.powi(halvings - step) - 0.5 * (b - a)).max(0.0);
        let x = if (truncated - middle).abs() <= radius { truncated } else { middle - toward * radius };
        let x = if a < x && x < b { x } else { middle };
        let f_x = f(x)?;
        if f_x == 0.0 {
            return Ok([edge(x, a, width, &mut f)?, edge(x, b, width, &mut f)?]);
        }
        if f_x.is_sign_positive() == f_b.is_sign_positive() {
            (b, f_b) = (x, f_x);
        } else {
            (a, f_a) = (x, f_x);
        }
    }
    Ok([a, b])
}

/// Where the zeros of `f` at `zero` end on the way to `other`, by bisection.
fn edge<E>(mut zero: f64, mut other: f64, width: f64, f: &mut impl FnMut(f64) -> Result<f64, E>) -> Result<f64, E> {
    while (other - zero).abs() > width {
        let middle = 0.5 * (zero + other);
        if middle == zero || middle == other {
            break;
        }
        *(if f(middle)? == 0.0 { &mut zero } else { &mut other }) = middle;
    }
    Ok(zero)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(ends: [f64; 2], f: impl Fn(f64) -> f64) -> [f64; 2] {
        sign_change(ends, ends.map(&f), 1e-12, |x| Ok::<_, ()>(f(x))).unwrap()
    }

    #[test]
    fn analytic_sign_change_is_found_whatever_the_slope() {
        type Case = (fn(f64) -> f64, f64);
        let cases: [Case; 4] = [
            (|x| x * x - 2.0, std::f64::consts::SQRT_2),
            (|x| (x - 1.3).powi(9), 1.3),
            (|x| if x < 0.7 { 1.0 } else { -1e-9 }, 0.7),
            (|x| x.exp() - 1e3, 1e3f64.ln()),
        ];
        for (f, exact) in cases {
            let [a, b] = found([0.0, 10.0], f);
            assert!(a <= exact + 1e-15 && exact <= b + 1e-15 && b - a <= 1e-12, "[{a}, {b}] for {exact}");
        }
    }

    /// Zero is hidden by rounding from 2.5 to 3.5: the middle is 3.
    #[test]
    fn analytic_interval_of_zeros_is_told_by_its_ends() {
        let [a, b] = found([0.0, 10.0], |x: f64| if (x - 3.0).abs() <= 0.5 { 0.0 } else { x - 3.0 });
        assert!((a - 2.5).abs() <= 1e-12 && (b - 3.5).abs() <= 1e-12, "[{a}, {b}]");
    }

    #[test]
    fn invariant_no_more_evaluations_than_bisection_and_one() {
        let mut n = 0;
        let f = |x: f64| (x - 1.3).powi(9);
        let counted = |x: f64| {
            n += 1;
            Ok::<_, ()>(f(x))
        };
        sign_change([0.0, 10.0], [0.0, 10.0].map(f), 1e-12, counted).unwrap();
        assert!(n <= 46, "{n} evaluations, 44 by bisection");
    }
}
