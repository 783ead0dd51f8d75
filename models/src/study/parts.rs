//! Small measures that several parts take.

/// Largest magnitude.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().map(f64::abs).fold(0.0, f64::max)
}

/// Half of the difference between the largest and the smallest value.
pub fn half_swing(values: &[f64]) -> f64 {
    let (low, high) = values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
    0.5 * (high - low)
}

/// Slope of the least-squares line through (ln x, ln y).
pub fn log_slope(x: &[f64], y: &[f64]) -> f64 {
    let n = x.len() as f64;
    let (x, y): (Vec<f64>, Vec<f64>) = x.iter().zip(y).map(|(x, y)| (x.ln(), y.ln())).unzip();
    let (mean_x, mean_y) = (x.iter().sum::<f64>() / n, y.iter().sum::<f64>() / n);
    let covariance: f64 = x.iter().zip(&y).map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    let variance: f64 = x.iter().map(|x| (x - mean_x).powi(2)).sum();
    covariance / variance
}

/// Values in one, `factor`, `factor²`, … times `first`, `n` of them.
pub fn geometric(first: f64, factor: f64, n: usize) -> Vec<f64> {
    std::iter::successors(Some(first), |x| Some(x * factor)).take(n).collect()
}

/// A unit as it is printed: `kg*m^2` as kg·m².
pub fn typeset_unit(unit: &str) -> String {
    unit.replace('*', "·").replace("^2", "²").replace("^3", "³")
}

/// A row of the list of claims: part, claim and finding as written, then what was measured.
pub fn row([part, claim, finding]: [&str; 3], measured: String) -> [String; 4] {
    [part.to_owned(), claim.to_owned(), finding.to_owned(), measured]
}
