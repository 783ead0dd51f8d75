//! Random expressions: in normal form, as programs and as printed text they have the value of the tree that they are made from.

use super::super::coefficient::unsigned;
use super::super::lower::{ConstantPool, Lowering};
use super::super::print::{Names, Printed, print};
use super::super::{Algebra, SumId, Symbol};
use super::notation::{Latex, Text, value_of};
use super::{Sample, run};
use crate::function::{Function, Operator};
use crate::random::Random;
use crate::symbolic::evaluate::Point;

/// An expression as it was written.
#[derive(Debug)]
pub enum Tree {
    Symbol(u32),
    Parameter(usize),
    Number(f64),
    Pi,
    Negative(Box<Tree>),
    Of(Operator, Box<[Tree; 2]>),
    /// A whole power.
    Power(Box<Tree>, i32),
    Call(Function, Vec<Tree>),
}

/// A value, and how large the numbers are that it is computed from: rounding is some ε of that.
#[derive(Clone, Copy)]
struct Sized {
    value: f64,
    size: f64,
}

/// Rounding of some hundred operations in two orders.
const ROUNDING: f64 = 1e-12;

const N_TREES: u64 = 400;

impl Tree {
    fn random(random: &mut Random, depth: usize) -> Self {
        if depth == 0 {
            return match random.below(8) {
                0..=3 => Self::Symbol(1 + random.below(4) as u32),
                4 | 5 => Self::Parameter(random.below(3)),
                6 => Self::Number(*random.of(&[0.0, 1.0, -1.0, 2.0, -2.5, 0.5, 3.0, 0.1])),
                _ => Self::Pi,
            };
        }
        let inner = |random: &mut Random| {
            let depth = random.below(depth);
            Self::random(random, depth)
        };
        match random.below(10) {
            0..=2 => Self::Of(Operator::Add, Box::new([inner(random), inner(random)])),
            3 => Self::Of(Operator::Subtract, Box::new([inner(random), inner(random)])),
            4..=5 => Self::Of(Operator::Multiply, Box::new([inner(random), inner(random)])),
            6 => Self::Of(Operator::Divide, Box::new([inner(random), inner(random)])),
            7 => Self::Power(Box::new(inner(random)), random.below(6) as i32 - 2),
            8 => Self::Negative(Box::new(inner(random))),
            _ => {
                let of_one =
                    [Function::Sin, Function::Cos, Function::Exp, Function::Tanh, Function::Abs, Function::Sign];
                let of_two = [Function::Min, Function::Max, Function::Atan2];
                match random.once_in(4) {
                    true => Self::Call(*random.of(&of_two), vec![inner(random), inner(random)]),
                    false => Self::Call(*random.of(&of_one), vec![inner(random)]),
                }
            }
        }
    }

    /// None where a value is no number of usual size, or hangs on rounding.
    fn value(&self, at: &impl Point) -> Option<Sized> {
        let exact = |value: f64| Sized { value, size: value.abs().max(1.0) };
        let found = match self {
            Self::Symbol(i) => exact(at.symbol(Symbol(*i))),
            Self::Parameter(i) => exact(at.parameter(*i)),
            Self::Number(x) => exact(*x),
            Self::Pi => exact(std::f64::consts::PI),
            Self::Negative(x) => x.value(at).map(|x| Sized { value: -x.value, ..x })?,
            Self::Of(operator, of) => {
                let (a, b) = (of[0].value(at)?, of[1].value(at)?);
                let size = match operator {
                    Operator::Add | Operator::Subtract => a.size + b.size,
                    Operator::Multiply => a.size * b.size,
                    _ => a.size * b.size / (b.value * b.value),
                };
                if *operator == Operator::Divide && b.value.abs() < 1e-6 * b.size {
                    return None;
                }
                Sized { value: operator.evaluate(a.value, b.value), size }
            }
            Self::Power(x, n) => {
                let x = x.value(at)?;
                if *n < 0 && x.value.abs() < 1e-6 * x.size {
                    return None;
                }
                let base = if *n < 0 { x.size / (x.value * x.value) } else { x.size };
                Sized { value: x.value.powi(*n), size: base.max(1.0).powi(n.abs()) }
            }
            Self::Call(function, of) => {
                let of: Vec<Sized> = of.iter().map(|x| x.value(at)).collect::<Option<_>>()?;
                let numbers: Vec<f64> = of.iter().map(|x| x.value).collect();
                let size = of.iter().map(|x| x.size).sum::<f64>();
                let near_zero = |x: f64| x.abs() < 1e-6 * size;
                let hangs = match function {
                    Function::Sign => near_zero(numbers[0]),
                    Function::Atan2 => near_zero(numbers[0].hypot(numbers[1])) || near_zero(numbers[0]),
                    _ => false,
                };
                let value = function.evaluate(&numbers);
                let slope = match function {
                    Function::Exp => value,
                    Function::Atan2 => 1.0 / numbers[0].hypot(numbers[1]),
                    _ => 1.0,
                };
                if hangs {
                    return None;
                }
                Sized { value, size: (1.0 + value.abs()).max(slope * size) }
            }
        };
        (found.value.is_finite() && found.size < 1e6).then_some(found)
    }

    /// In normal form.
    fn sum(&self, a: &mut Algebra) -> SumId {
        match self {
            Self::Symbol(i) => a.symbol(Symbol(*i)),
            Self::Parameter(i) => {
                let k = a.coefficients.parameter(*i);
                a.constant(k)
            }
            Self::Number(x) => a.number(*x),
            Self::Pi => {
                let k = a.coefficients.pi();
                a.constant(k)
            }
            Self::Negative(x) => {
                let x = x.sum(a);
                a.neg(x)
            }
            Self::Of(operator, of) => {
                let (x, y) = (of[0].sum(a), of[1].sum(a));
                match operator {
                    Operator::Add => a.add(x, y),
                    Operator::Subtract => a.sub(x, y),
                    Operator::Multiply => a.mul(x, y),
                    Operator::Divide => a.div(x, y),
                    Operator::Power => a.pow(x, y),
                }
            }
            Self::Power(x, n) => {
                let (x, n) = (x.sum(a), a.number(f64::from(*n)));
                a.pow(x, n)
            }
            Self::Call(function, of) => {
                let of = of.iter().map(|x| x.sum(a)).collect();
                a.call(*function, of)
            }
        }
    }
}

/// x₁ and p₀, as they are written in each notation.
struct Indexed;

impl Names for Indexed {
    fn symbol(&self, symbol: Symbol) -> Printed {
        indexed("x", symbol.0 as usize)
    }

    fn parameter(&self, index: usize) -> Printed {
        indexed("p", index)
    }
}

fn indexed(letter: &str, i: usize) -> Printed {
    let mathml = format!("<msub><mi>{letter}</mi><mn>{i}</mn></msub>");
    Printed::atom(format!("{letter}{i}"), format!("{letter}_{{{i}}}"), mathml)
}

/// Every opened tag is closed, in order.
fn assert_balanced(mathml: &str) {
    let mut open = Vec::new();
    for tag in mathml.split('<').skip(1) {
        let name = tag.split(['>', ' ']).next().unwrap_or_default();
        let is_empty = tag.split('>').next().is_some_and(|tag| tag.ends_with('/'));
        match name.strip_prefix('/') {
            Some(name) => assert_eq!(open.pop(), Some(name), "{mathml}"),
            None if !is_empty => open.push(name),
            None => {}
        }
    }
    assert!(open.is_empty(), "{mathml}");
}

#[test]
fn cross_random_expressions_have_one_value_in_every_form() {
    let at = Sample(0.0);
    let mut n_compared = 0;
    for seed in 0..N_TREES {
        let mut random = Random::new(seed);
        let tree = Tree::random(&mut random, 5);
        let Some(Sized { value, size }) = tree.value(&at) else { continue };
        let mut a = Algebra::new();
        let sum = tree.sum(&mut a);
        let assert_close = |what: &str, found: f64| {
            assert!(
                (found - value).abs() <= ROUNDING * size,
                "{seed}, {what}: {found} for {value} of size {size}: {tree:?}"
            );
        };
        assert_close("evaluated", a.evaluate(sum, &at));
        let (zero, twice) = (a.sub(sum, sum), a.add(sum, sum));
        assert!(zero.is_zero(), "{seed}: {tree:?}");
        let two = a.number(2.0);
        assert_eq!(a.mul(two, sum), twice, "{seed}: {tree:?}");

        let mut pool = ConstantPool::default();
        let mut lowering = Lowering::new(&a, &mut pool);
        let lowered = lowering.lower(sum);
        lowering.program.push_output(lowered);
        let mut program = lowering.program;
        program.settle_signs();
        let constants: Vec<f64> =
            pool.coefficients().iter().map(|&id| a.evaluate_coefficient(unsigned(id), &at)).collect();
        assert_close("lowered", run(&program, &constants)[0]);

        let printed = print(&a, &Indexed, sum);
        let name = |letter: char, i: usize| match letter {
            'x' => at.symbol(Symbol(i as u32)),
            _ => at.parameter(i),
        };
        assert_close(&printed.text, value_of::<Text>(&printed.text, &name));
        assert_close(&printed.latex, value_of::<Latex>(&printed.latex, &name));
        assert_balanced(&printed.mathml);
        n_compared += 1;
    }
    assert!(n_compared > N_TREES / 2, "{n_compared} of {N_TREES}");
}

#[test]
fn fd_derivatives_of_random_expressions_match_differences() {
    struct Shifted(f64);
    impl Point for Shifted {
        fn symbol(&self, symbol: Symbol) -> f64 {
            Sample(0.0).symbol(symbol) + if symbol == Symbol(1) { self.0 } else { 0.0 }
        }
        fn parameter(&self, index: usize) -> f64 {
            Sample(0.0).parameter(index)
        }
    }
    // two steps: where they agree to 1e-6 there is no corner between
    let mut n_compared = 0;
    for seed in 0..N_TREES {
        let tree = Tree::random(&mut Random::new(!seed), 4);
        let slope = |h: f64| Some((tree.value(&Shifted(h))?.value - tree.value(&Shifted(-h))?.value) / (2.0 * h));
        let (Some(coarse), Some(fine), Some(at)) = (slope(2e-5), slope(1e-5), tree.value(&Sample(0.0))) else {
            continue;
        };
        let tolerance = 1e-6 * (1.0 + coarse.abs());
        if at.size > 1e3 || (coarse - fine).abs() > tolerance {
            continue;
        }
        let mut a = Algebra::new();
        let sum = tree.sum(&mut a);
        let derivative = a.diff(sum, Symbol(1));
        let found = a.evaluate(derivative, &Sample(0.0));
        assert!((found - fine).abs() <= tolerance, "{seed}: {found} for {fine}: {tree:?}");
        let depends = a.symbols_of(sum).contains(&Symbol(1));
        assert!(depends || derivative.is_zero(), "{seed}: {tree:?}");
        n_compared += 1;
    }
    assert!(n_compared > N_TREES / 3, "{n_compared} of {N_TREES}");
}
