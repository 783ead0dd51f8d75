//! Central differences.

/// Of fourth order: the error of five points is STEP⁴/30 times a fifth derivative, that of rounding 1e-16/STEP.
const STEP: f64 = 1e-3;
/// Fifth and sixth derivatives of order 1e3 over all mechanisms; for second differences 1e-16/STEP² of rounding.
pub const DIFFERENCE: f64 = 1e-8;

pub fn slope(f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    combined(f, &[(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)], 12.0 * STEP)
}

pub fn curvature(f: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let weights = [(-2.0, -1.0), (-1.0, 16.0), (0.0, -30.0), (1.0, 16.0), (2.0, -1.0)];
    combined(f, &weights, 12.0 * STEP * STEP)
}

fn combined(f: impl Fn(f64) -> Vec<f64>, weights: &[(f64, f64)], over: f64) -> Vec<f64> {
    let mut total = vec![0.0; f(0.0).len()];
    for &(at, weight) in weights {
        total.iter_mut().zip(f(at * STEP)).for_each(|(sum, value)| *sum += weight * value / over);
    }
    total
}
