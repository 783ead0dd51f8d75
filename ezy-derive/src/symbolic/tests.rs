//! Properties of the engine, each against evaluation at points.

mod forms;
mod notation;
mod programs;
mod trees;

use super::evaluate::Point;
use super::lower::{ConstantPool, Lowering};
use super::program::{Node, Program, Value};
use super::*;
use crate::function::Function;

/// Symbols and parameters with values of order one, none special.
struct Sample(f64);

impl Point for Sample {
    fn symbol(&self, symbol: Symbol) -> f64 {
        0.4 + 0.37 * f64::from(symbol.0) + self.0
    }
    fn parameter(&self, index: usize) -> f64 {
        1.3 + 0.21 * index as f64
    }
}

/// Central differences with step 1e-5 err by 1e-10 (second order) plus 1e-11 (rounding) for values of order ten.
const DIFFERENCE_STEP: f64 = 1e-5;
const DIFFERENCE_TOLERANCE: f64 = 2e-9;
/// A few dozen operations on values of order ten.
const ROUNDING: f64 = 1e-13;

/// One of everything that can be differentiated, in the symbols 1 and 2.
fn menagerie(a: &mut Algebra) -> Vec<SumId> {
    let (x, y) = (a.symbol(Symbol(1)), a.symbol(Symbol(2)));
    let p = a.coefficients.parameter(0);
    let p = a.constant(p);
    let (px, sum) = (a.mul(p, x), a.add(x, y));
    let small = {
        let tenth = a.number(0.1);
        a.mul(tenth, sum)
    };
    let mut all = vec![px, sum];
    for function in [Function::Sin, Function::Cos, Function::Tan, Function::Asin, Function::Acos, Function::Sqrt] {
        all.push(a.call(function, vec![small]));
    }
    for function in [Function::Exp, Function::Ln, Function::Tanh, Function::Abs, Function::Sign] {
        all.push(a.call(function, vec![sum]));
    }
    for function in [Function::Atan2, Function::Min, Function::Max, Function::Pow] {
        all.push(a.call(function, vec![px, sum]));
    }
    let difference = a.sub(x, y);
    all.extend([a.power(difference, 3), a.div(px, sum), a.mul(sum, difference), a.power(sum, -2)]);
    all
}

/// Compares the derivative by symbol 1 with differences, at the sample with this offset.
fn assert_derivative(a: &mut Algebra, f: SumId, offset: f64) {
    struct Shifted(f64, f64);
    impl Point for Shifted {
        fn symbol(&self, symbol: Symbol) -> f64 {
            Sample(self.0).symbol(symbol) + if symbol == Symbol(1) { self.1 } else { 0.0 }
        }
        fn parameter(&self, index: usize) -> f64 {
            Sample(self.0).parameter(index)
        }
    }
    let slope = a.diff(f, Symbol(1));
    let high = a.evaluate(f, &Shifted(offset, DIFFERENCE_STEP));
    let low = a.evaluate(f, &Shifted(offset, -DIFFERENCE_STEP));
    let difference = (high - low) / (2.0 * DIFFERENCE_STEP);
    let exact = a.evaluate(slope, &Sample(offset));
    assert!(
        (difference - exact).abs() < DIFFERENCE_TOLERANCE * (1.0 + exact.abs()),
        "{:?} at {offset}: {exact} {difference}",
        a.terms(f)
    );
}

#[test]
fn fd_derivatives_of_every_function_match_differences() {
    let mut a = Algebra::new();
    for f in menagerie(&mut a) {
        assert_derivative(&mut a, f, 0.0);
    }
}

/// Arguments of either sign, and the first or the second of two as the smaller one.
#[test]
fn fd_derivatives_match_differences_on_both_sides_of_a_discontinuity() {
    let mut a = Algebra::new();
    let (x, y) = (a.symbol(Symbol(1)), a.symbol(Symbol(2)));
    let p = a.coefficients.parameter(0);
    let p = a.constant(p);
    let (px, sum) = (a.mul(p, x), a.add(x, y));
    let square = a.mul(x, x);
    for offset in [0.0, -4.0] {
        for function in [Function::Abs, Function::Sign, Function::Tanh] {
            for argument in [sum, px, square] {
                let f = a.call(function, vec![argument]);
                assert_derivative(&mut a, f, offset);
            }
        }
        for function in [Function::Min, Function::Max, Function::Atan2] {
            for arguments in [[px, sum], [sum, px], [square, sum]] {
                let f = a.call(function, arguments.to_vec());
                assert_derivative(&mut a, f, offset);
            }
        }
    }
}

#[test]
fn cross_lowered_programs_have_the_value_of_their_sums() {
    let mut a = Algebra::new();
    let mut sums = menagerie(&mut a);
    let products: Vec<SumId> = sums.windows(2).map(|pair| a.mul(pair[0], pair[1])).collect();
    sums.extend(products);
    sums.push(a.total(&sums.clone()));
    let mut pool = ConstantPool::default();
    let mut lowering = Lowering::new(&a, &mut pool);
    for &sum in &sums {
        let value = lowering.lower(sum);
        lowering.program.push_output(value);
    }
    let mut program = lowering.program;
    program.settle_signs();
    let constants: Vec<f64> =
        pool.coefficients().iter().map(|&id| a.evaluate_coefficient(coefficient::unsigned(id), &Sample(0.0))).collect();
    let values = run(&program, &constants);
    for (&sum, found) in sums.iter().zip(values) {
        let expected = a.evaluate(sum, &Sample(0.0));
        assert!(
            (found - expected).abs() <= ROUNDING * (1.0 + expected.abs()),
            "{:?}: {found} {expected}",
            a.terms(sum)
        );
    }
}

#[test]
fn analytic_pythagoras_leaves_a_constant() {
    let mut a = Algebra::new();
    let angle = a.symbol(Symbol(1));
    let (sin, cos) = a.sin_cos(angle);
    let (ss, cc) = (a.mul(sin, sin), a.mul(cos, cos));
    assert_eq!(a.add(ss, cc), SumId::ONE);
}

#[test]
fn analytic_cosine_of_a_difference_needs_no_third_angle() {
    let mut a = Algebra::new();
    let (x, y) = (a.symbol(Symbol(1)), a.symbol(Symbol(2)));
    let difference = a.sub(x, y);
    let (_, cos) = a.sin_cos(difference);
    assert!(a.is_trigonometric(cos));
    let expected = (Sample(0.0).symbol(Symbol(1)) - Sample(0.0).symbol(Symbol(2))).cos();
    assert!((a.evaluate(cos, &Sample(0.0)) - expected).abs() < ROUNDING);
}

#[test]
fn invariant_squares_of_lengths_are_not_multiplied_out() {
    let mut a = Algebra::new();
    let (x, y) = (a.symbol(Symbol(1)), a.symbol(Symbol(2)));
    let difference = a.sub(x, y);
    let reversed = a.sub(y, x);
    let (square, again) = (a.mul(difference, difference), a.mul(reversed, reversed));
    assert_eq!(a.terms(square).len(), 1);
    assert_eq!(square, again);
}

/// Runs a program by the book.
fn run(program: &Program, constants: &[f64]) -> Vec<f64> {
    run_with(program, constants, &|symbol| Sample(0.0).symbol(symbol))
}

fn run_with(program: &Program, constants: &[f64], input: &dyn Fn(Symbol) -> f64) -> Vec<f64> {
    let mut values: Vec<f64> = Vec::new();
    let count = program.outputs().iter().map(|output| output.node.0 + 1).max().unwrap_or(0);
    for i in 0..count {
        let at = |id: program::NodeId| values[id.0];
        let value = match program.node(program::NodeId(i)) {
            Node::Input(symbol) => input(*symbol),
            Node::Constant(i) => constants[*i],
            Node::Literal(bits) => f64::from_bits(*bits),
            Node::Add(a, b) => at(*a) + at(*b),
            Node::Sub(a, b) => at(*a) - at(*b),
            Node::Mul(a, b) => at(*a) * at(*b),
            Node::Div(a, b) => at(*a) / at(*b),
            Node::Neg(a) => -at(*a),
            Node::Sin(a) => at(*a).sin(),
            Node::Cos(a) => at(*a).cos(),
            Node::Call(function, arguments) => function.evaluate(&arguments.iter().map(|&a| at(a)).collect::<Vec<_>>()),
        };
        values.push(value);
    }
    program
        .outputs()
        .iter()
        .map(|&Value { node, negative }| if negative { -values[node.0] } else { values[node.0] })
        .collect()
}
