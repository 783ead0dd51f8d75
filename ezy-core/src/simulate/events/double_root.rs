//! Double roots: an event function that passes zero and comes back between two samples.

use crate::simulate::tolerances::events::{MAX_PARABOLAS, SHALLOW};

/// A point between `a` and `b` where `f` is negative. At `a`, `b` and the `others` beyond them it is positive.
pub(super) fn double_root<E>(
    a: (f64, f64),
    b: (f64, f64),
    others: impl Iterator<Item = (f64, f64)>,
    mut f: impl FnMut(f64) -> Result<f64, E>,
) -> Result<Option<f64>, E> {
    let foreseen = |third| {
        let inside = |&(x, y): &(f64, f64)| a.0 < x && x < b.0 && y <= SHALLOW * a.1.min(b.1);
        least([a, b, third]).filter(inside)
    };
    let mut next = others.filter_map(foreseen).min_by(|x, y| x.1.total_cmp(&y.1));
    for _ in 0..MAX_PARABOLAS {
        let Some((x, _)) = next else { return Ok(None) };
        let y = f(x)?;
        if y < 0.0 {
            return Ok(Some(x));
        }
        next = foreseen((x, y));
    }
    Ok(None)
}

/// Minimum of the parabola through three points, and its value.
fn least([(x0, f0), (x1, f1), (x2, f2)]: [(f64, f64); 3]) -> Option<(f64, f64)> {
    let (rise, other_rise) = ((f1 - f0) / (x1 - x0), (f2 - f1) / (x2 - x1));
    let bend = (other_rise - rise) / (x2 - x0);
    if bend.is_nan() || bend <= 0.0 {
        return None;
    }
    let x = 0.5 * (x0 + x1 - rise / bend);
    Some((x, f0 + rise * (x - x0) + bend * (x - x0) * (x - x1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(f: fn(f64) -> f64) -> (Option<f64>, usize) {
        let mut n = 0;
        let counted = |x: f64| {
            n += 1;
            Ok::<f64, std::convert::Infallible>(f(x))
        };
        let Ok(x) = double_root((0.0, f(0.0)), (1.0, f(1.0)), [(2.0, f(2.0))].into_iter(), counted);
        (x, n)
    }

    #[test]
    fn analytic_dip_of_a_parabola_is_found_at_once() {
        let (x, n) = found(|x| (x - 0.4) * (x - 0.4) - 1e-6);
        assert!((x.unwrap() - 0.4).abs() <= 1e-12 && n == 1);
    }

    #[test]
    fn analytic_dip_of_another_curve_is_followed() {
        // least at 0.4, as flat as a fourth power on top of a parabola
        let (x, n) = found(|x| (x - 0.4).powi(4) + 0.3 * (x - 0.4).powi(2) - 1e-3);
        assert!((x.unwrap() - 0.4).abs() <= 0.05 && n <= MAX_PARABOLAS, "{x:?} after {n}");
    }

    #[test]
    fn analytic_value_that_stays_away_from_zero_costs_nothing() {
        assert_eq!(found(|x| 3.0 + (x - 0.4) * (x - 0.4)), (None, 0));
        assert_eq!(found(|x| 1.0 + x), (None, 0));
    }

    /// 2 (x − 0.3)² + 0.1 through any three points; none that opens downwards, or a line.
    #[test]
    fn analytic_least_value_of_a_parabola() {
        let through = |f: fn(f64) -> f64| least([-0.4, 0.9, 2.5].map(|x| (x, f(x))));
        let (x, y) = through(|x| 2.0 * (x - 0.3) * (x - 0.3) + 0.1).unwrap();
        assert!((x - 0.3).abs() <= 1e-15 && (y - 0.1).abs() <= 1e-15, "{x} {y}");
        assert_eq!((through(|x| -x * x), through(|x| 8.0 * x)), (None, None));
    }
}
