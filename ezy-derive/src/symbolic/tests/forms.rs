//! What an expression becomes in normal form, and the operations of its cheapest program.

use super::super::lower::{ConstantPool, Lowering};
use super::super::program::Count;
use super::super::sum::Atom;
use super::super::{Algebra, SumId, Symbol};
use super::Sample;
use crate::function::Function;

/// Three symbols and a parameter.
fn letters(a: &mut Algebra) -> [SumId; 4] {
    let p = a.coefficients.parameter(0);
    [a.symbol(Symbol(1)), a.symbol(Symbol(2)), a.symbol(Symbol(3)), a.constant(p)]
}

fn count(a: &Algebra, sum: SumId) -> Count {
    let mut pool = ConstantPool::default();
    let mut lowering = Lowering::new(a, &mut pool);
    let value = lowering.lower(sum);
    lowering.program.push_output(value);
    lowering.program.count()
}

/// (additions, multiplications, divisions)
fn operations(a: &Algebra, sum: SumId) -> (usize, usize, usize) {
    let Count { add, mul, div, .. } = count(a, sum);
    (add, mul, div)
}

#[test]
fn analytic_common_factors_are_taken_out() {
    let mut a = Algebra::new();
    let [x, y, z, p] = letters(&mut a);
    let (px, py, xy, xz, yz) = (a.mul(p, x), a.mul(p, y), a.mul(x, y), a.mul(x, z), a.mul(y, z));
    let of = |a: &mut Algebra, parts: &[SumId]| {
        let sum = a.total(parts);
        operations(a, sum)
    };
    // p (x + y)
    assert_eq!(of(&mut a, &[px, py]), (1, 1, 0));
    // x (y + z), and with the parameter inside: x (y + p)
    assert_eq!(of(&mut a, &[xy, xz]), (1, 1, 0));
    assert_eq!(of(&mut a, &[xy, px]), (1, 1, 0));
    // x (y + z) + y z, by any two of the three
    assert_eq!(of(&mut a, &[xy, xz, yz]), (2, 2, 0));
    // x (y + z) + y, not x y + x z + y
    assert_eq!(of(&mut a, &[xy, xz, y]), (2, 1, 0));
    // x y + x, as x (y + 1)
    assert_eq!(of(&mut a, &[xy, x]), (1, 1, 0));
    // x³ + x² y = (x + y) x²
    let (cube, square) = (a.power(x, 3), a.power(x, 2));
    let square_y = a.mul(square, y);
    assert_eq!(of(&mut a, &[cube, square_y]), (1, 2, 0));
    // x/z + y/z = (x + y)/z
    let (over_z, y_over_z) = (a.div(x, z), a.div(y, z));
    assert_eq!(of(&mut a, &[over_z, y_over_z]), (1, 0, 1));
    // −p x + p y = p (y − x)
    let minus = a.neg(px);
    assert_eq!(of(&mut a, &[minus, py]), (1, 1, 0));
    // nothing in common
    assert_eq!(of(&mut a, &[x, y, z, p]), (3, 0, 0));
}

#[test]
fn analytic_long_sums_are_planned_without_a_search() {
    let mut a = Algebra::new();
    let [_, _, _, p] = letters(&mut a);
    let (mut squares, mut total) = (Vec::new(), Vec::new());
    for i in 0..30 {
        let x = a.symbol(Symbol(1 + i));
        let (square, scaled) = (a.power(x, 2), a.mul(p, x));
        squares.push(square);
        total.extend([square, scaled]);
    }
    // Σ x² and Σ x² + p Σ x
    let (squares, total) = (a.total(&squares), a.total(&total));
    assert_eq!(operations(&a, squares), (29, 30, 0));
    assert_eq!(operations(&a, total), (59, 31, 0));
}

#[test]
fn analytic_products_of_lengths_stay_factored_and_of_cosines_do_not() {
    let mut a = Algebra::new();
    let [x, y, z, p] = letters(&mut a);
    let (sum, difference) = (a.add(x, y), a.sub(x, y));
    let product = a.mul(sum, difference);
    assert_eq!(a.terms(product).len(), 1, "(x + y)(x − y)");
    let single = a.mul(z, sum);
    assert_eq!(a.terms(single).len(), 2, "z x + z y");
    let (sin, cos) = a.sin_cos(x);
    let rotated = a.add(sin, cos);
    let (other_sin, other_cos) = a.sin_cos(y);
    let other = a.sub(other_sin, other_cos);
    let product = a.mul(rotated, other);
    assert_eq!(a.terms(product).len(), 4, "sines and cosines");
    let mixed = a.mul(rotated, sum);
    assert_eq!(a.terms(mixed).len(), 4, "a factor of sines and cosines");
    let square = a.power(rotated, 2);
    // sin² + 2 sin cos + cos² = 1 + 2 sin cos
    assert_eq!(a.terms(square).len(), 2);
    let square = a.power(sum, 2);
    assert_eq!(a.terms(square).len(), 1, "(x + y)²");
    let grown = a.add(sum, p);
    let power = a.power(grown, -3);
    assert!(matches!(a.terms(power).as_slice(), [(monomial, k)] if k.is_unit() && a.monomial(*monomial)[0].1 == -3));
    assert_eq!((a.power(x, 0), a.power(x, 1)), (SumId::ONE, x));
    let (cube, inverse) = (a.power(x, 3), a.power(x, -2));
    assert_eq!(a.mul(cube, inverse), x);
    // the sine of an exponent below one is left
    let over = a.div(SumId::ONE, sin);
    assert!(!a.is_trigonometric(over) && a.is_trigonometric(cos) && !a.is_trigonometric(x));
}

/// cos⁴ + sin⁴ = 1 − 2 sin² cos²
#[test]
fn analytic_powers_of_sines_are_reduced() {
    let mut a = Algebra::new();
    let [x, ..] = letters(&mut a);
    let (sin, cos) = a.sin_cos(x);
    let [s2, c2, s4, c4] = [(sin, 2), (cos, 2), (sin, 4), (cos, 4)].map(|(base, n)| a.power(base, n));
    let (fourth, product) = (a.add(s4, c4), a.mul(s2, c2));
    let two = a.number(2.0);
    let twice = a.mul(two, product);
    let expected = a.sub(SumId::ONE, twice);
    assert_eq!(fourth, expected);
    let s5 = a.power(sin, 5);
    let (left, right) = (a.mul(s4, sin), a.mul(s2, s2));
    assert_eq!((left, right), (s5, s4));
}

#[test]
fn analytic_whole_and_half_powers_have_their_own_forms() {
    let mut a = Algebra::new();
    let [x, y, ..] = letters(&mut a);
    let mut pow = |n: f64| {
        let n = a.number(n);
        a.pow(x, n)
    };
    let [two, minus_two, eight, nine, half, third] = [2.0, -2.0, 8.0, 9.0, 0.5, 1.5].map(&mut pow);
    assert_eq!([two, minus_two, eight], [2, -2, 8].map(|n| a.power(x, n)));
    let root = a.call(Function::Sqrt, vec![x]);
    assert_eq!(half, root);
    let is_call = |a: &Algebra, sum: SumId| {
        let (monomial, _) = a.terms(sum)[0];
        matches!(a.atom(a.monomial(monomial)[0].0), Atom::Call(Function::Pow, _))
    };
    let of_symbol = a.pow(x, y);
    assert!([nine, third, of_symbol].iter().all(|sum| is_call(&a, *sum)));
}

/// Angles of bodies are split, time and multiples of an angle are not; the sign of an angle is taken out.
#[test]
fn analytic_sines_need_one_angle_a_body() {
    let mut a = Algebra::new();
    let [x, y, _, p] = letters(&mut a);
    let t = a.symbol(Symbol::TIME);
    let two = a.number(2.0);
    let (xy, xp, twice, xt) = (a.sub(x, y), a.add(x, p), a.mul(two, x), a.add(x, t));
    let n_terms = |a: &mut Algebra, angle: SumId| {
        let (sin, cos) = a.sin_cos(angle);
        (a.terms(sin).len(), a.terms(cos).len())
    };
    assert_eq!(n_terms(&mut a, x), (1, 1));
    assert_eq!(n_terms(&mut a, xy), (2, 2));
    assert_eq!(n_terms(&mut a, xp), (2, 2));
    assert_eq!(n_terms(&mut a, twice), (1, 1));
    assert_eq!(n_terms(&mut a, xt), (1, 1));
    let minus = a.neg(x);
    let ((sin, cos), (of_minus, cos_of_minus)) = (a.sin_cos(x), a.sin_cos(minus));
    assert_eq!((a.neg(of_minus), cos_of_minus), (sin, cos));
    let called = [Function::Sin, Function::Cos].map(|function| a.call(function, vec![xy]));
    assert_eq!((called[0], called[1]), a.sin_cos(xy));
    let of_number = a.call(Function::Sin, vec![two]);
    assert_eq!(a.as_coefficient(of_number).and_then(|k| a.coefficients.as_number(k)), Some(2.0_f64.sin()));
}

/// A division by zero is kept: it shows at run time.
#[test]
fn analytic_divisions_by_zero_are_no_numbers() {
    let mut a = Algebra::new();
    let [x, ..] = letters(&mut a);
    for (top, is_nan) in [(SumId::ZERO, true), (SumId::ONE, false), (x, false)] {
        let quotient = a.div(top, SumId::ZERO);
        let value = a.evaluate(quotient, &Sample(0.0));
        assert!(!value.is_finite() && value.is_nan() == is_nan, "{value}");
    }
    let inverse = a.power(SumId::ZERO, -1);
    assert_eq!(a.evaluate(inverse, &Sample(0.0)), f64::INFINITY);
}

/// A row of velocities where the velocities vanish is its part in time.
#[test]
fn analytic_what_is_left_where_symbols_vanish() {
    let mut a = Algebra::new();
    let [x, y, z, p] = letters(&mut a);
    // (x + p) z + (y + z)(x − y) + p y², at z = 0
    let (xp, yz, xy) = (a.add(x, p), a.add(y, z), a.sub(x, y));
    let (first, second, square) = (a.mul(xp, z), a.mul(yz, xy), a.power(y, 2));
    let third = a.mul(p, square);
    let sum = a.total(&[first, second, third]);
    let left = a.at_zero(sum, &|symbol| symbol == Symbol(3));
    let group = a.mul(y, xy);
    let expected = a.add(group, third);
    let at = Sample(0.0);
    assert!((a.evaluate(left, &at) - a.evaluate(expected, &at)).abs() <= super::ROUNDING);
    assert!(!a.symbols_of(left).contains(&Symbol(3)));
    assert_eq!(a.symbols_of(sum), [Symbol(1), Symbol(2), Symbol(3)]);
    assert_eq!(a.at_zero(sum, &|_| false), sum);
    assert!(a.at_zero(sum, &|_| true).is_zero());
}
