//! Coefficients of Radau IIA with three stages, and of the transformation that takes its equations apart.
//!
//! # Source
//! Hairer, Wanner, Solving Ordinary Differential Equations II (1996), IV.5 (table 5.6) and IV.8; digits beyond double precision
//! computed from the closed forms there.

/// Number of stages; the last one is the end of the step.
pub(super) const N_STAGES: usize = 3;

/// Numbers of three stages.
pub(super) type Triple<T = f64> = [T; N_STAGES];

/// Where the stages stand in the step: (4 ∓ √6)/10 and 1.
pub(super) const NODES: Triple = [0.155_051_025_721_682_2, 0.644_948_974_278_317_8, 1.0];

/// A, the integrals from 0 to each node; its last row integrates over the step.
pub(super) const A: Triple<Triple> = [
    [0.196_815_477_223_660_43, -0.065_535_425_850_198_39, 0.023_770_974_348_220_15],
    [0.394_424_314_739_087_3, 0.292_073_411_665_228_46, -0.041_548_752_125_997_93],
    [0.376_403_062_700_467_3, 0.512_485_826_188_421_6, 0.111_111_111_111_111_1],
];

/// A², which takes accelerations to positions; its last entry is zero.
pub(super) const A_SQUARED: Triple<Triple> = [
    [0.021_835_034_190_722_74, -0.019_857_254_098_612_273, 0.010_042_630_196_562_41],
    [0.177_190_587_431_946_08, 0.038_164_965_809_277_26, -0.007_375_963_529_895_744],
    [0.318_041_381_743_977_17, 0.181_958_618_256_022_83, 0.0],
];

/// Eigenvalues of A⁻¹: a real one, and `ALPHA ± i BETA`.
pub(super) const GAMMA: f64 = 3.637_834_252_744_496;
pub(super) const ALPHA: f64 = 2.681_082_873_627_752;
pub(super) const BETA: f64 = 3.050_430_199_247_410_6;

/// T, with T⁻¹ A⁻¹ T = [γ 0 0; 0 α −β; 0 β α].
pub(super) const T: Triple<Triple> = [
    [0.091_232_394_870_892_94, -0.141_255_295_020_954_2, -0.030_029_194_105_147_424],
    [0.241_717_932_707_107, 0.204_129_352_293_799_93, 0.382_942_112_757_261_9],
    [0.966_048_182_615_093, 1.0, 0.0],
];

/// T⁻¹.
pub(super) const T_INVERSE: Triple<Triple> = [
    [4.325_579_890_063_155, 0.339_199_251_815_809_87, 0.541_770_539_935_874_9],
    [-4.178_718_591_551_905, -0.327_682_820_761_062_4, 0.476_623_554_500_550_45],
    [-0.502_872_634_945_786_9, 2.571_926_949_855_605, -0.596_039_204_828_224_9],
];

/// Minus the slope at the start of the polynomial through the start and the stages, as sum of the stages' increments over h.
pub(super) const START_SLOPE: Triple = [-10.048_809_399_827_416, 1.382_142_733_160_749, -0.333_333_333_333_333_3];

/// Where (x − c₁)(x − c₂)(x − 1) is largest between the first two stages, (6 − √6)/10, with the weights of the stages' accelerations
/// there: of their polynomial, of its integral from 0, and of the integral of that.
pub(super) const UNSEEN: f64 = 0.355_051_025_721_682_2;
pub(super) const UNSEEN_SLOPES: Triple = [0.451_683_675_240_560_74, 0.741_581_623_797_196_4, -0.193_265_299_037_757_08];
pub(super) const UNSEEN_INTEGRALS: Triple = [0.338_762_756_430_420_55, 0.016_288_269_291_261_643, 0.0];
pub(super) const UNSEEN_SECOND_INTEGRALS: Triple =
    [0.071_761_820_090_981_62, -0.014_263_177_305_394_11, 0.005_531_972_647_421_808];
/// Minus that product over what it is at the start.
pub(super) const UNSEEN_REMAINDER: f64 = 0.373_938_769_133_981_4;

/// Values at `s`, in parts of the step, of the polynomials of degree 2 that are one at a node and zero at the others.
pub(super) fn through_nodes(s: f64) -> Triple {
    std::array::from_fn(|i| {
        let others = (0..N_STAGES).filter(|&k| k != i);
        others.fold(1.0, |product, k| product * (s - NODES[k]) / (NODES[i] - NODES[k]))
    })
}

/// As [`through_nodes`], of the polynomials of degree 3 that are zero at the start besides.
pub(super) fn through_start_and_nodes(s: f64) -> Triple {
    let values = through_nodes(s);
    std::array::from_fn(|i| values[i] * s / NODES[i])
}

/// What the collocation polynomial leaves at `s`, over what it leaves in the quadrature that takes the slope at the start with
/// the weight 1/γ: the integral of (x − c₁)(x − c₂)(x − 1), zero at both ends.
pub(super) fn remainder(s: f64) -> f64 {
    -10.0 * GAMMA * s * (-0.1 + s * (0.45 + s * (-0.6 + 0.25 * s)))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Rounding of sums of three products of numbers up to ten.
    const ROUNDING: f64 = 1e-14;

    fn product(a: &Triple<Triple>, b: &Triple<Triple>) -> Triple<Triple> {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
    }

    fn assert_equal(a: &Triple<Triple>, b: &Triple<Triple>) {
        for (a, b) in a.as_flattened().iter().zip(b.as_flattened()) {
            assert!((a - b).abs() <= ROUNDING, "{a} against {b}");
        }
    }

    #[test]
    fn analytic_collocation_integrates_quadratic_polynomials_and_the_end_all_up_to_degree_four() {
        for degree in 0..5 {
            let integral = |row: &Triple| -> f64 { (0..3).map(|j| row[j] * NODES[j].powi(degree)).sum() };
            let exact = |end: f64| end.powi(degree + 1) / f64::from(degree + 1);
            let rows = if degree < 3 { 0..3 } else { 2..3 };
            for i in rows {
                assert!((integral(&A[i]) - exact(NODES[i])).abs() <= ROUNDING, "degree {degree}, stage {i}");
            }
        }
        assert_equal(&product(&A, &A), &A_SQUARED);
    }

    #[test]
    fn analytic_transformation_takes_stages_apart() {
        let eigenvalues = [[GAMMA, 0.0, 0.0], [0.0, ALPHA, -BETA], [0.0, BETA, ALPHA]];
        assert_equal(&product(&A, &product(&T, &eigenvalues)), &T);
        assert_equal(&product(&T, &T_INVERSE), &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    }

    #[test]
    fn analytic_weights_where_no_stage_is_are_exact_for_quadratic_polynomials() {
        let tables = [UNSEEN_SLOPES, UNSEEN_INTEGRALS, UNSEEN_SECOND_INTEGRALS];
        for degree in 0..3 {
            let d = f64::from(degree);
            let exact = [1.0, UNSEEN / (d + 1.0), UNSEEN.powi(2) / ((d + 1.0) * (d + 2.0))];
            for (weights, exact) in tables.iter().zip(exact) {
                let sum: f64 = weights.iter().zip(NODES).map(|(weight, c)| weight * c.powi(degree)).sum();
                assert!((sum - exact * UNSEEN.powi(degree)).abs() <= ROUNDING, "degree {degree}");
            }
        }
        let slope = |x: f64| (x - NODES[0]) * (x - NODES[1]) + (x - 1.0) * (2.0 * x - NODES[0] - NODES[1]);
        assert!(slope(UNSEEN).abs() <= ROUNDING);
        let product = |x: f64| NODES.iter().map(|c| x - c).product::<f64>();
        assert!((product(UNSEEN) + UNSEEN_REMAINDER * product(0.0)).abs() <= ROUNDING);
    }

    #[test]
    fn analytic_values_between_are_exact_for_cubic_polynomials() {
        let cubic = |s: f64| s * (1.0 + s * (2.0 - 5.0 * s));
        for s in [0.0, 0.3, 0.7, 1.0, 2.5] {
            let value: f64 = through_start_and_nodes(s).iter().zip(NODES).map(|(weight, c)| weight * cubic(c)).sum();
            assert!((value - cubic(s)).abs() <= ROUNDING * (1.0 + 100.0 * s), "at {s}");
        }
        let slope: f64 = START_SLOPE.iter().zip(NODES).map(|(weight, c)| weight * cubic(c)).sum();
        assert!((slope + 1.0).abs() <= ROUNDING);
        assert!(remainder(1.0).abs() <= ROUNDING);
    }
}
