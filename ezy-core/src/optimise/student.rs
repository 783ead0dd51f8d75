//! Quantiles of Student's t distribution for whole degrees of freedom.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// Halvings of an interval of angles: more than the digits of a number.
const HALVINGS: usize = 60;
/// Terms below this part of the sum do not change it.
const NEGLIGIBLE: f64 = 1e-17;

/// The t for which `P(|T| ≤ t)` is `probability`.
///
/// The distribution function is a finite sum in θ = atan(t/√ν), which grows with θ, so θ is found by halving (0, π/2).
pub(super) fn two_sided_quantile(probability: f64, degrees_of_freedom: usize) -> f64 {
    let (mut below, mut above) = (0.0, FRAC_PI_2);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (below + above);
        if within(middle, degrees_of_freedom) < probability { below = middle } else { above = middle }
    }
    (0.5 * (below + above)).tan() * (degrees_of_freedom as f64).sqrt()
}

/// `P(|T| ≤ √ν tan θ)`: Abramowitz and Stegun, "Handbook of Mathematical Functions" (1964), 26.7.3 and 26.7.4.
fn within(theta: f64, degrees_of_freedom: usize) -> f64 {
    let (sin, cos) = theta.sin_cos();
    let is_odd = degrees_of_freedom % 2 == 1;
    let mut term = if is_odd { cos } else { 1.0 };
    let mut sum = if degrees_of_freedom > 1 { term } else { 0.0 };
    // factors 2/3, 4/5, … of odd ν; 1/2, 3/4, … of even ν
    let mut k = if is_odd { 2 } else { 1 };
    while k + 3 <= degrees_of_freedom && term > NEGLIGIBLE * sum {
        term *= k as f64 / (k + 1) as f64 * cos * cos;
        sum += term;
        k += 2;
    }
    if is_odd { FRAC_2_PI * (theta + sin * sum) } else { sin * sum }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table has three decimals.
    const OF_THE_TABLE: f64 = 6e-4;
    /// Rounding of a sum of ν/2 terms and of a tangent near its pole.
    const ROUNDING: f64 = 1e-9;

    /// Fisher and Yates, "Statistical Tables" (1963), table III; ∞ is 1.95996.
    #[test]
    fn reference_quantiles_of_student_are_those_of_the_table() {
        let table = [(1, 12.706), (2, 4.303), (3, 3.182), (4, 2.776), (5, 2.571), (6, 2.447), (7, 2.365), (10, 2.228)];
        let table = table.into_iter().chain([(15, 2.131), (20, 2.086), (30, 2.042), (60, 2.000), (120, 1.980)]);
        for (degrees_of_freedom, expected) in table.chain([(1_000_000, 1.960)]) {
            let found = two_sided_quantile(0.95, degrees_of_freedom);
            assert!((found - expected).abs() <= OF_THE_TABLE, "{degrees_of_freedom}: {found} for {expected}");
        }
    }

    /// ν = 1: t = tan(π p/2); ν = 2: t = p √(2/(1 − p²)).
    #[test]
    fn analytic_quantiles_of_student_with_one_and_two_degrees_of_freedom() {
        for p in [0.5, 0.9, 0.95, 0.99] {
            let (one, two) = ((FRAC_PI_2 * p).tan(), p * (2.0 / (1.0 - p * p)).sqrt());
            assert!((two_sided_quantile(p, 1) / one - 1.0).abs() <= ROUNDING);
            assert!((two_sided_quantile(p, 2) / two - 1.0).abs() <= ROUNDING);
        }
    }
}
