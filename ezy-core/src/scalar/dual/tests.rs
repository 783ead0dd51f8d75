use super::Dual;
use crate::scalar::Scalar;

/// Step of the differences: their error is its square, and rounding over it.
const STEP: f64 = 1e-5;

/// Of central differences with that step, relative to slopes of order one.
const DIFFERENCES: f64 = 1e-9;

/// Derivatives of a function of two numbers by differences and by dual numbers, and both values.
fn check(f: impl Fn(Dual<2>, Dual<2>) -> Dual<2>, x: f64, y: f64, plain: impl Fn(f64, f64) -> f64) {
    let found = f(Dual::variable(x, 0), Dual::variable(y, 1));
    assert_eq!(found.value, plain(x, y));
    let by_x = (plain(x + STEP, y) - plain(x - STEP, y)) / (2.0 * STEP);
    let by_y = (plain(x, y + STEP) - plain(x, y - STEP)) / (2.0 * STEP);
    for (found, difference) in found.derivatives.into_iter().zip([by_x, by_y]) {
        let error = (found - difference).abs() / difference.abs().max(1.0);
        assert!(error <= DIFFERENCES, "at {x}, {y}: {found} and {difference}");
    }
}

#[test]
fn fd_operators() {
    check(|x, y| x + y, 1.3, -0.7, |x, y| x + y);
    check(|x, y| x - y, 1.3, -0.7, |x, y| x - y);
    check(|x, y| x * y, 1.3, -0.7, |x, y| x * y);
    check(|x, y| x / y, 1.3, -0.7, |x, y| x / y);
    check(|x, y| -x * y.fused(x, y), 1.3, -0.7, |x, y| -x * (y * x + y));
}

#[test]
fn fd_functions_of_one_number() {
    check(|x, _| x.sin(), 0.4, 0.0, |x, _| x.sin());
    check(|x, _| x.cos(), 0.4, 0.0, |x, _| x.cos());
    check(|x, _| x.tan(), 0.4, 0.0, |x, _| x.sin() / x.cos());
    check(|x, _| x.asin(), -0.4, 0.0, |x, _| x.asin());
    check(|x, _| x.acos(), -0.4, 0.0, |x, _| x.acos());
    check(|x, _| x.sqrt(), 2.4, 0.0, |x, _| x.sqrt());
    check(|x, _| x.exp(), 0.4, 0.0, |x, _| x.exp());
    check(|x, _| x.ln(), 2.4, 0.0, |x, _| x.ln());
    check(|x, _| x.tanh(), -0.4, 0.0, |x, _| x.tanh());
    check(|x, _| x.abs() * x, -2.4, 0.0, |x, _| x.abs() * x);
    check(|x, _| x.sign() * x, -2.4, 0.0, |x, _| x.abs());
}

#[test]
fn fd_functions_of_two_numbers() {
    check(|y, x| y.atan2(x), 0.4, -1.2, f64::atan2);
    check(|x, y| x.min(y) * x, 0.4, -1.2, |x, y| x.min(y) * x);
    check(|x, y| x.max(y) * y, 0.4, -1.2, |x, y| x.max(y) * y);
    check(|x, y| x.powf(y), 1.4, -1.2, f64::powf);
    check(|x, _| x.powf(Dual::constant(3.0)), -1.4, 0.0, |x, _| x.powf(3.0));
}

#[test]
fn analytic_root_of_a_sum_of_squares_has_no_derivative_at_zero() {
    let [x, y] = [0, 1].map(|i| Dual::<2>::variable(0.0, i));
    let drag = (x * x + y * y).sqrt() * x;
    assert_eq!((drag.value, drag.derivatives), (0.0, [0.0, 0.0]));
    let root = x.sqrt();
    assert_eq!(root.derivatives, [f64::INFINITY, 0.0]);
}
