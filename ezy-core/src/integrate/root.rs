//! Where a function passes zero.

use super::tolerances::roots::{MAX_EVALUATIONS, RESOLUTION_S};

/// Where `f` passes zero between `a` and `b`, to `resolution`; its values there, `f_a` and `f_b`, have different signs,
/// or one of them is zero.
///
/// # Source
/// Chandrupatla, Advances in Engineering Software 28 (1997): inverse quadratic interpolation where it can be trusted,
/// otherwise bisection.
pub(crate) fn root<E>(
    (a, f_a): (f64, f64),
    (b, f_b): (f64, f64),
    resolution: f64,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<f64, E> {
    // the last point, the other end of the bracket, and the point before
    let (mut now, mut f_now, mut other, mut f_other) = (b, f_b, a, f_a);
    let mut part = 0.5;
    for _ in 0..MAX_EVALUATIONS {
        let best = if f_now.abs() < f_other.abs() { now } else { other };
        if f_now == 0.0 || f_other == 0.0 || (now - other).abs() <= resolution {
            return Ok(best);
        }
        let x = now + part * (other - now);
        let f_x = f(x)?;
        let (last, f_last);
        if (f_x > 0.0) == (f_now > 0.0) {
            (last, f_last) = (now, f_now);
        } else {
            (last, f_last) = (other, f_other);
            (other, f_other) = (now, f_now);
        }
        (now, f_now) = (x, f_x);
        part = next_part([now, other, last], [f_now, f_other, f_last]);
        // a step of half the resolution beyond the estimate closes the bracket from the other side
        let least = (0.5 * resolution / (now - other).abs()).min(0.5);
        part = part.clamp(least, 1.0 - least);
    }
    Ok(now)
}

/// Part of the way from the last point to the other end of the bracket.
fn next_part([x1, x2, x3]: [f64; 3], [f1, f2, f3]: [f64; 3]) -> f64 {
    let (xi, phi) = ((x1 - x2) / (x3 - x2), (f1 - f2) / (f3 - f2));
    if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
        f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2)
    } else {
        0.5
    }
}

/// Resolution of an event time near `t`, s.
pub(crate) fn resolution_at(t: f64) -> f64 {
    RESOLUTION_S.max(2.0 * f64::EPSILON * t.abs())
}

/// -1, 0 or 1; 0 for a value that is not a number.
pub(crate) fn side_of(x: f64) -> f64 {
    match x.partial_cmp(&0.0) {
        Some(std::cmp::Ordering::Greater) => 1.0,
        Some(std::cmp::Ordering::Less) => -1.0,
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(a: f64, b: f64, f: fn(f64) -> f64) -> (f64, usize) {
        let mut n = 0;
        let counted = |x: f64| {
            n += 1;
            Ok::<f64, std::convert::Infallible>(f(x))
        };
        let Ok(x) = root((a, f(a)), (b, f(b)), 1e-12, counted);
        (x, n)
    }

    #[test]
    fn analytic_root_of_a_cosine_takes_few_evaluations() {
        let (x, n) = found(1.0, 2.0, f64::cos);
        assert!((x - std::f64::consts::FRAC_PI_2).abs() <= 1e-12 && n <= 9, "{x} after {n}");
    }

    #[test]
    fn analytic_root_of_a_flat_function_is_bracketed() {
        let (x, n) = found(-0.7, 1.0, |x| x.powi(9));
        // the function vanishes to 1e-108 at the resolution
        assert!(x.abs() <= 1e-12 && n <= 90, "{x} after {n}");
    }

    #[test]
    fn analytic_root_at_an_end_needs_no_evaluation() {
        assert_eq!(found(0.0, 1.0, |x| x), (0.0, 0));
        assert_eq!(found(-1.0, 0.0, |x| x), (0.0, 0));
    }

    #[test]
    fn invariant_root_of_a_jump_is_the_jump() {
        let (x, n) = found(0.0, 1.0, |x| if x < 0.3 { -1.0 } else { 5.0 });
        assert!((x - 0.3).abs() <= 1e-12 && n <= 90, "{x} after {n}");
    }

    /// Through the three points, x over f is u + c u (u − 1) in units of their ranges. It is followed where it rises all the way, for |c| < 1;
    /// elsewhere the bracket is halved.
    #[test]
    fn analytic_interpolation_is_taken_where_the_inverse_parabola_rises() {
        for c in [-1.9, -1.01, -0.99, -0.3, 0.0, 0.6, 0.99, 1.01, 1.9] {
            for u in [0.2_f64, 0.5, 0.7] {
                let x = |u: f64| u + c * u * (u - 1.0);
                if x(u) <= 0.0 || x(u) >= 1.0 {
                    continue;
                }
                // the root is half way between the first two values
                let found = next_part([x(u), 0.0, 1.0], [0.5 * u, -0.5 * u, 1.0 - 0.5 * u]);
                let expected = if c.abs() < 1.0 { (x(u) - x(0.5 * u)) / x(u) } else { 0.5 };
                assert!((found - expected).abs() <= 1e-14, "{c} {u}: {found} {expected}");
            }
        }
    }
}
