use super::Lanes;
use crate::machine::narrow::assert_same_on_each_processor;
use crate::scalar::{Scalar, in_wide};

/// In units of the last place: the two of a function that is not correctly rounded and of the one that it is compared with.
const UNITS: f64 = 2.0;

fn units_apart(x: f64, y: f64) -> f64 {
    (x - y).abs() / (y.abs() * f64::EPSILON).max(f64::MIN_POSITIVE)
}

/// Arguments of all sizes from 1e-9 to 1e6, both signs, and beside multiples of π/2.
fn arguments() -> Vec<[f64; 4]> {
    let spread = (0..40_000).map(|i| {
        let size = 10f64.powf(15.0 * (f64::from(i) * 0.618_033_988_749_895).fract() - 9.0);
        [size, -size, 3.7 * size.min(2e5), -0.2 * size]
    });
    let multiples = (1..2_000).map(|n| {
        let x = f64::from(n) * 314.0 * std::f64::consts::FRAC_PI_2;
        [x, -x, x.next_up(), f64::from(n) * std::f64::consts::FRAC_PI_2]
    });
    spread.chain(multiples).collect()
}

#[test]
fn reference_sines_and_cosines_in_lanes_are_those_of_f64() {
    let mut worst = (0.0, 0.0);
    for x in arguments() {
        let (sin, cos) = Lanes(x).sin_cos();
        for (i, x) in x.into_iter().enumerate() {
            for (found, exact) in [(sin.0[i], x.sin()), (cos.0[i], x.cos())] {
                let error = units_apart(found, exact);
                assert!(!error.is_nan());
                worst = if error > worst.0 { (error, x) } else { worst };
            }
        }
    }
    assert!(worst.0 <= UNITS, "{worst:?}");
}

#[test]
fn analytic_large_arguments_and_what_is_no_number_go_to_f64() {
    let (sin, cos) = Lanes([1e9, 0.5, -1e300, f64::INFINITY]).sin_cos();
    assert_eq!((sin.0[0], cos.0[1], sin.0[2]), (1e9_f64.sin(), 0.5_f64.cos(), (-1e300_f64).sin()));
    assert!(cos.0[3].is_nan());
}

#[test]
fn analytic_zero_keeps_its_sine() {
    let (sin, cos) = Lanes([0.0; 8]).sin_cos();
    assert_eq!((sin, cos), (Lanes([0.0; 8]), Lanes([1.0; 8])));
    assert_eq!(Lanes([-0.0]).sin_cos().0.0[0].to_bits(), (-0.0_f64).to_bits());
}

#[test]
fn analytic_operations_are_those_of_f64_in_each_lane() {
    let (x, y) = (Lanes([1.0, -2.5, 3.0, 0.1]), Lanes([0.3, 7.0, -1e-3, 4.0]));
    let z = (x * y - x / y + -y).fused(x, y).abs().sqrt().min(x.max(y));
    for i in 0..4 {
        let (x, y) = (x.0[i], y.0[i]);
        assert_eq!(z.0[i], Scalar::fused(x * y - x / y + -y, x, y).abs().sqrt().min(x.max(y)));
    }
}

#[test]
fn analytic_the_least_lane_counts_for_all() {
    let two = Lanes([2.0; 4]);
    assert_eq!(Lanes([2.0, 3.0, 4.0, 1.0]).least_ratio(two), 0.5);
    assert!(Lanes([2.0, f64::NAN, 4.0, 3.0]).least_ratio(two).is_nan());
    assert!(Lanes([2.0, f64::NAN, -4.0, 3.0]).magnitude().is_nan());
    assert_eq!(Lanes([2.0, 0.0, -4.0, 3.0]).magnitude(), 4.0);
}

#[inline(always)]
fn computed() -> [u64; 8] {
    // not to be computed by the compiler
    let mut x = Lanes(std::array::from_fn(|i| std::hint::black_box(0.1 + i as f64)));
    for _ in 0..100 {
        let (sin, cos) = x.sin_cos();
        x = (sin * x).fused(cos, x / (cos + Lanes([3.0; 8]))).abs().sqrt() - sin * cos;
    }
    x.0.map(f64::to_bits)
}

#[test]
fn invariant_wide_registers_give_the_same_bits() {
    assert_same_on_each_processor(|| in_wide(computed));
    assert_eq!(in_wide(computed), computed());
    assert_eq!(Lanes::<8>::in_part(computed), computed());
}
