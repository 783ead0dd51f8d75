//! Against values of 32 digits from arbitrary precision (mpmath), and against identities.

#![expect(clippy::approx_constant, reason = "the first part of a known value is one")]

use super::DoubleDouble;
use crate::scalar::Scalar;

/// Of a sum, a product, a quotient: a few units of 2⁻¹⁰⁴.
const ARITHMETIC: f64 = 2e-31;

/// Of a function: the last digit of some thirty operations.
const FUNCTION: f64 = 1e-30;

fn dd(x: f64) -> DoubleDouble {
    x.into()
}

/// Largest error over all arguments, relative to the larger of the value and `least`.
fn worst(function: impl Fn(DoubleDouble) -> DoubleDouble, least: f64, known: &[(f64, (f64, f64))]) -> f64 {
    known.iter().fold(0.0, |worst, &(x, (high, low))| {
        let error = (function(dd(x)) - DoubleDouble::new(high, low)).magnitude() / high.abs().max(least);
        assert!(!error.is_nan(), "{x}");
        f64::max(worst, error)
    })
}

#[test]
fn analytic_sums_under_cancellation() {
    let small = DoubleDouble::new(1.0, 1e-17) - dd(1.0);
    assert_eq!(small, dd(1e-17));
    let third = dd(1.0) / dd(3.0);
    let rest = (third + third + third - dd(1.0)).magnitude();
    assert!(rest <= ARITHMETIC, "{rest:.1e}");
}

#[test]
fn analytic_products_and_quotients_undo_each_other() {
    for (a, b) in [(1.0, 3.0), (std::f64::consts::E, 1e-7), (-1e120, 7.0), (0.1, 1e-130)] {
        let quotient = dd(a) / dd(b);
        let error = ((quotient * dd(b) - dd(a)) / dd(a)).magnitude();
        assert!(error <= ARITHMETIC, "{a} / {b}: {error:.1e}");
    }
}

#[test]
fn analytic_square_of_a_number_of_two_parts() {
    // (1 + e)² = 1 + 2 e + e² with e = 2⁻⁶⁰, whose last term is beyond 106 bits
    let e = (-60.0_f64).exp2();
    let x = DoubleDouble::new(1.0, e);
    assert_eq!(x * x, DoubleDouble::new(1.0, 2.0 * e));
}

#[test]
fn reference_sines() {
    let known = [
        (0.5, (0.479425538604203, -5.103969860556013e-18)),
        (1.0, (0.8414709848078965, 1.776845092935536e-18)),
        (3.0, (0.1411200080598672, 8.577269787017502e-18)),
        (22.0, (-0.008851309290403876, 2.8485303089220057e-19)),
        (355.0, (-3.014435335948845e-05, 1.3012643991046347e-21)),
        (1e6, (-0.34999350217129294, -1.5952848809323968e-17)),
        (-123456.789, (0.9986640823432246, -4.3073133377883266e-17)),
        (1e-05, (9.999999999833334e-06, 6.182336062862823e-22)),
    ];
    let error = worst(Scalar::sin, 0.0, &known);
    assert!(error <= FUNCTION, "{error:.1e}");
}

#[test]
fn reference_cosines() {
    let known = [
        (0.5, (0.8775825618903728, -4.2623149864279997e-17)),
        (1.0, (0.5403023058681398, -4.760954612604417e-17)),
        (3.0, (-0.9899924966004454, -4.2060261566099734e-17)),
        (22.0, (-0.9999608263946371, -8.51603380017413e-19)),
        (355.0, (-0.999999999545659, 1.0574612846643521e-17)),
        (1e6, (0.9367521275331447, 4.637088260214747e-17)),
        (-123456.789, (0.05167253271870138, -6.512424953386242e-19)),
        (1e-05, (0.99999999995, 4.137435208440879e-18)),
    ];
    let error = worst(Scalar::cos, 0.0, &known);
    assert!(error <= FUNCTION, "{error:.1e}");
}

#[test]
fn reference_tangents() {
    let known = [
        (0.3, (0.30933624960962325, -2.7475966183811927e-17)),
        (1.5, (14.101419947171719, 6.270315165067482e-16)),
        (-2.0, (2.185039863261519, 1.0289483692188619e-16)),
    ];
    let error = worst(Scalar::tan, 0.0, &known);
    assert!(error <= FUNCTION, "{error:.1e}");
}

#[test]
fn reference_inverse_sines_and_cosines() {
    let sines = [
        (1e-09, (1e-09, 1.6666666666666669e-28)),
        (0.3, (0.3046926540153975, -2.7469740051157017e-17)),
        (-0.9, (-1.1197695149986342, -4.092642558112641e-17)),
        (0.999999, (1.5693821131146521, -1.100101637792604e-16)),
    ];
    let cosines = [
        (1e-09, (1.5707963257948967, -7.807189403102154e-17)),
        (0.3, (1.2661036727794992, -7.78313736852488e-17)),
        (-0.9, (2.6905658417935308, 1.0215876553849407e-16)),
        (0.999999, (0.0014142136802445852, -6.143951608164765e-20)),
    ];
    let error = worst(Scalar::asin, 0.0, &sines).max(worst(Scalar::acos, 0.0, &cosines));
    assert!(error <= FUNCTION, "{error:.1e}");
}

#[test]
fn reference_angles_of_vectors() {
    let known = [
        (1.0, 2.0, (0.4636476090008061, 2.2698777452961687e-17)),
        (1.0, -2.0, (2.677945044588987, 1.5527705369303147e-16)),
        (-1e-07, -3.0, (-3.1415926202564597, -2.1594180130478068e-16)),
        (-2.0, 1e-3, (-1.5702963268365633, 3.542644744518102e-18)),
        (1e-09, 5.0, (2e-10, 5.1672121617897564e-27)),
    ];
    for (y, x, angle) in known {
        let error = worst(|y| y.atan2(dd(x)), 0.0, &[(y, angle)]);
        assert!(error <= FUNCTION, "{y}, {x}: {error:.1e}");
    }
}

#[test]
fn reference_roots() {
    let known = [
        (2.0, (1.4142135623730951, -9.667293313452913e-17)),
        (1e-260, (9.999999999999999e-131, 9.488218173228798e-147)),
        (0.1, (0.31622776601683794, 8.004969469767158e-19)),
        (1e12, (1e6, 0.0)),
    ];
    let error = worst(Scalar::sqrt, 0.0, &known);
    assert!(error <= FUNCTION, "{error:.1e}");
    assert_eq!(dd(0.0).sqrt(), dd(0.0));
}

#[test]
fn reference_exponentials() {
    let known = [
        (0.5, (1.6487212707001282, -4.731568479435833e-17)),
        (-1.0, (0.36787944117144233, -1.2428753672788363e-17)),
        (1e-09, (1.000000001, -8.224037093664211e-17)),
        (30.0, (10686474581524.463, -0.0007436345313492586)),
        (-300.0, (5.148200222412013e-131, 2.962376373372979e-147)),
        (700.0, (1.0142320547350045e+304, 1.6666571920734673e+287)),
    ];
    let error = worst(Scalar::exp, 0.0, &known);
    assert!(error <= FUNCTION, "{error:.1e}");
}

#[test]
fn reference_logarithms() {
    let known = [
        (0.5, (-0.6931471805599453, -2.3190468138462996e-17)),
        (3.0, (1.0986122886681098, -9.07129723500153e-17)),
        (1e-09, (-20.72326583694641, -6.485730665985714e-16)),
        (1e12, (27.631021115928547, 9.478062107418016e-16)),
    ];
    let error = worst(Scalar::ln, 1.0, &known);
    assert!(error <= FUNCTION, "{error:.1e}");
}

#[test]
fn reference_hyperbolic_tangents() {
    let known = [
        (1e-09, (1e-09, -3.3333333333333338e-28)),
        (0.3, (0.2913126124515909, -6.4602656586469586e-18)),
        (-0.9, (-0.7162978701990245, 3.514093391268979e-17)),
        (2.5, (0.9866142981514303, -2.4529238788172874e-17)),
        (20.0, (1.0, -8.496708510583178e-18)),
        (-50.0, (-1.0, 0.0)),
    ];
    let error = worst(Scalar::tanh, 0.0, &known);
    assert!(error <= FUNCTION, "{error:.1e}");
}

#[test]
fn reference_powers() {
    let known = [
        (2.0, 0.5, (1.4142135623730951, -9.667293313452913e-17)),
        (0.3, 2.7, (0.038746045822494066, 2.3072809349773345e-18)),
        (1.7, 10.0, (201.59939004489993, 1.3253980641092517e-14)),
        (3.0, -3.0, (0.037037037037037035, 2.05596856412066e-18)),
        (-2.0, 5.0, (-32.0, 0.0)),
    ];
    for (base, exponent, power) in known {
        let error = worst(|x| x.powf(dd(exponent)), 0.0, &[(base, power)]);
        assert!(error <= FUNCTION, "{base}^{exponent}: {error:.1e}");
    }
}

#[test]
fn analytic_sine_of_pi_is_what_pi_leaves_out() {
    // π less its 106 bits, from the third part of π/2
    let rest = DoubleDouble::PI.sin().high() / (2.0 * -1.4973849048591698e-33);
    assert!((rest - 1.0).abs() < 1e-15, "{rest}");
}

#[test]
fn analytic_special_values_are_those_of_f64() {
    assert!(dd(-1.0).sqrt().high().is_nan() && dd(-1.0).ln().high().is_nan());
    assert_eq!(dd(0.0).ln().high(), f64::NEG_INFINITY);
    assert_eq!((dd(800.0).exp().high(), dd(-800.0).exp().high()), (f64::INFINITY, 0.0));
    assert_eq!((dd(0.0).atan2(dd(0.0)), dd(0.0).powf(dd(0.5)), dd(0.0).sign()), (dd(0.0), dd(0.0), dd(0.0)));
    assert_eq!((dd(-3.0).abs(), dd(-3.0).min(dd(2.0)), dd(-3.0).max(dd(2.0))), (dd(3.0), dd(-3.0), dd(2.0)));
    assert!(dd(f64::NAN).least_ratio(dd(1.0)).is_nan() && dd(3.0).least_ratio(dd(2.0)) == 1.5);
}
