//! Nodes, weights and integrals of Gauss–Legendre collocation with eight nodes.
//!
//! A function on a step is the sum `Σ f_m P_m(2s − 1)` of Legendre polynomials over s from 0 to 1. What follows from its values at the nodes is
//! a linear combination of them. A *matrix* here holds one column a node, each with eight numbers in lanes.
//!
//! # Source
//! Hairer, Lubich, Wanner, Geometric Numerical Integration (2006), II.1; nodes and weights: Abramowitz, Stegun, Handbook of
//! Mathematical Functions (1964), table 25.4.

use crate::model::Eight;
use crate::scalar::Lanes;

/// Nodes of a step.
pub(super) const N: usize = 8;

/// Positive nodes on [−1, 1] with their weights; the others are their mirror images.
const HALF: [(f64, f64); N / 2] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_47),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_26),
];

/// Node and weight `i` on [−1, 1], ascending.
const fn on_both_sides(i: usize) -> (f64, f64) {
    if i < N / 2 {
        let (x, w) = HALF[N / 2 - 1 - i];
        (-x, w)
    } else {
        HALF[i - N / 2]
    }
}

/// (2n + 1)/(n + 1) and n/(n + 1), by which P_{n+1} follows from P_n and P_{n−1}.
pub(super) const RECURRENCE: [[f64; 2]; N + 1] = {
    let mut quotients = [[0.0; 2]; N + 1];
    let mut k = 0;
    while k <= N {
        let n = k as f64;
        quotients[k] = [(2.0 * n + 1.0) / (n + 1.0), n / (n + 1.0)];
        k += 1;
    }
    quotients
};

/// P_0 … P_9 at `x`.
pub(super) const fn legendre(x: f64) -> [f64; N + 2] {
    let mut p = [1.0; N + 2];
    p[1] = x;
    let mut k = 1;
    while k <= N {
        let [last, before] = RECURRENCE[k];
        p[k + 1] = last * x * p[k] - before * p[k - 1];
        k += 1;
    }
    p
}

/// ∫ P_m(2s − 1) ds from 0 to s, where x = 2 s − 1, for m = 0 … 8.
const fn integrals(x: f64) -> [f64; N + 1] {
    let p = legendre(x);
    let mut out = [0.5 * (x + 1.0); N + 1];
    let mut m = 1;
    while m <= N {
        out[m] = (p[m + 1] - p[m - 1]) / (2.0 * (2.0 * m as f64 + 1.0));
        m += 1;
    }
    out
}

/// Nodes on [0, 1].
pub(super) const NODES: Eight = Lanes({
    let mut c = [0.0; N];
    let mut i = 0;
    while i < N {
        c[i] = 0.5 * (1.0 + on_both_sides(i).0);
        i += 1;
    }
    c
});

/// Weights on [0, 1]: the integral over the step.
pub(super) const WEIGHTS: Eight = Lanes({
    let mut b = [0.0; N];
    let mut i = 0;
    while i < N {
        b[i] = 0.5 * on_both_sides(i).1;
        i += 1;
    }
    b
});

/// From values at the nodes to Legendre coefficients: f_m = (2m + 1) Σ b_j P_m(x_j) f(c_j).
pub(super) static TO_COEFFICIENTS: [Eight; N] = {
    let mut columns = [Lanes([0.0; N]); N];
    let mut j = 0;
    while j < N {
        let p = legendre(on_both_sides(j).0);
        let mut m = 0;
        while m < N {
            columns[j].0[m] = (2.0 * m as f64 + 1.0) * WEIGHTS.0[j] * p[m];
            m += 1;
        }
        j += 1;
    }
    columns
};

/// Mean over the step of the integral up to each time, in units of the step, by the first two Legendre coefficients: the mean of (1 − s) f.
#[inline(always)]
pub(super) fn mean_of_integral(mean: f64, slope: f64) -> f64 {
    0.5 * mean - slope / 6.0
}

/// From values at the nodes to the integrals up to each node: the Runge–Kutta matrix of the method.
pub(super) static TO_INTEGRALS: [Eight; N] = {
    let mut columns = [Lanes([0.0; N]); N];
    let mut i = 0;
    while i < N {
        let integrals = integrals(on_both_sides(i).0);
        let mut j = 0;
        while j < N {
            let mut m = 0;
            while m < N {
                columns[j].0[i] += TO_COEFFICIENTS[j].0[m] * integrals[m];
                m += 1;
            }
            j += 1;
        }
        i += 1;
    }
    columns
};

/// Weights of the values at the nodes in the integral from 0 to `s`.
pub(super) fn weights_up_to(s: f64) -> Eight {
    // what is zero at a start stays zero there: polynomials at −1 are ±1 but for rounding
    if s == 0.0 {
        return Lanes([0.0; N]);
    }
    let integrals = integrals(2.0 * s - 1.0);
    Lanes(std::array::from_fn(|j| (0..N).map(|m| TO_COEFFICIENTS[j].0[m] * integrals[m]).sum()))
}

/// Largest |∫ P_8(2s − 1) ds| between 0 and 1.
pub(super) const LARGEST_INTEGRAL: f64 = 0.0160;

#[cfg(test)]
mod tests {
    use super::*;

    /// A number that is zero at the start is zero there to the last bit: an event function that begins at zero has no sign.
    #[test]
    fn invariant_weights_up_to_the_start_are_zero() {
        assert_eq!(weights_up_to(0.0).0, [0.0; N]);
        let whole = weights_up_to(1.0).0;
        let left = whole.into_iter().zip(WEIGHTS.0).map(|(x, weight)| (x - weight).abs());
        assert!(left.fold(0.0, f64::max) <= 1e-15);
    }

    /// Row `i` and column `j` of the Runge–Kutta matrix.
    fn entry(i: usize, j: usize) -> f64 {
        TO_INTEGRALS[j].0[i]
    }

    /// Rounding of sums of eight products.
    const ROUNDING: f64 = 4e-16;

    /// The rule of n nodes integrates s^k to 1/(k + 1) up to k = 15; it is off by (8!)⁴/(17 · (16!)²) · 16!/… for k = 16.
    #[test]
    fn analytic_weights_are_exact_for_polynomials_of_degree_fifteen() {
        let moment = |k: i32| (0..N).map(|i| WEIGHTS.0[i] * NODES.0[i].powi(k)).sum::<f64>();
        for k in 0..16 {
            assert!((moment(k) - 1.0 / f64::from(k + 1)).abs() <= ROUNDING, "{k}");
        }
        // 16! times the error constant (8!)⁴ / (17 (16!)³)
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        let missing = factorial(8).powi(4) / (17.0 * factorial(16).powi(2));
        assert!((1.0 / 17.0 - moment(16) - missing).abs() <= ROUNDING, "{missing:e}");
    }

    /// ∫ (1 − s) s^k, of the acceleration that is as s^k: 1/(k + 1) − 1/(k + 2), up to k = 14; and as the integral of integrals.
    #[test]
    fn cross_integrals_of_integrals_are_exact_for_polynomials_of_degree_fourteen() {
        for k in 0..15 {
            let [mean, slope] =
                [0, 1].map(|m| (0..N).map(|i| TO_COEFFICIENTS[i].0[m] * NODES.0[i].powi(k)).sum::<f64>());
            let moment = mean_of_integral(mean, slope);
            assert!((moment - 1.0 / f64::from((k + 1) * (k + 2))).abs() <= ROUNDING, "{k}");
        }
        for (j, Lanes([mean, slope, ..])) in TO_COEFFICIENTS.iter().enumerate() {
            let twice = (0..N).map(|i| WEIGHTS.0[i] * entry(i, j)).sum::<f64>();
            assert!((twice - mean_of_integral(*mean, *slope)).abs() <= ROUNDING, "{j}");
        }
    }

    /// ∫ s^k up to the nodes, and up to other points, is exact for k below 8.
    #[test]
    fn analytic_integrals_up_to_a_point_are_exact_for_polynomials_of_degree_seven() {
        for k in 0..8 {
            let values = NODES.0.map(|c| c.powi(k));
            for i in 0..N {
                let integral: f64 = (0..N).map(|j| entry(i, j) * values[j]).sum();
                assert!((integral - NODES.0[i].powi(k + 1) / f64::from(k + 1)).abs() <= ROUNDING, "{k} {i}");
            }
            for s in [0.0, 0.3, 0.77, 1.0] {
                let integral: f64 = (0..N).map(|j| weights_up_to(s).0[j] * values[j]).sum();
                assert!((integral - s.powi(k + 1) / f64::from(k + 1)).abs() <= ROUNDING, "{k} {s}");
            }
        }
    }

    /// b_i a_ij + b_j a_ji = b_i b_j: quadratic invariants, such as the energy of a spring, are kept.
    #[test]
    fn analytic_method_is_symplectic() {
        for i in 0..N {
            for j in 0..N {
                let [of_i, of_j] = [WEIGHTS.0[i], WEIGHTS.0[j]];
                let sum = of_i * entry(i, j) + of_j * entry(j, i);
                assert!((sum - of_i * of_j).abs() <= ROUNDING, "{i} {j}");
            }
        }
    }

    /// The coefficients of P_m alone are one at m.
    #[test]
    fn analytic_coefficients_of_a_legendre_polynomial() {
        for m in 0..N {
            let values = NODES.0.map(|c| legendre(2.0 * c - 1.0)[m]);
            for k in 0..N {
                let found: f64 = (0..N).map(|j| TO_COEFFICIENTS[j].0[k] * values[j]).sum();
                assert!((found - f64::from(u8::from(k == m))).abs() <= 10.0 * ROUNDING, "{m} {k}");
            }
        }
    }

    #[test]
    fn analytic_largest_integral_of_the_first_missing_polynomial() {
        let largest = (0..=1000).map(|i| integrals(f64::from(i) / 500.0 - 1.0)[N].abs()).fold(0.0, f64::max);
        assert!((largest / LARGEST_INTEGRAL - 1.0).abs() <= 0.01, "{largest}");
    }
}
