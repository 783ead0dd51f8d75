//! Numbers that stand for what was computed, in place of a value.

use super::Scalar;
use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number that records how it was computed: a kernel that runs on it leaves its expressions. It has no value; what kernels compare is not
/// compared, which they allow, since their branches depend on no number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Recorded(Operand);

/// What an operation is done with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Operand {
    /// A number, by its bits.
    Number(u64),
    /// π, which some languages know exactly.
    Pi,
    /// The operation of this place in the tape.
    Result(usize),
}

/// A function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Sqrt,
    Exp,
    Ln,
    Tanh,
    Abs,
    Sign,
}

/// An operation of two numbers that is written between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Operator {
    Plus,
    Minus,
    Times,
    Over,
}

/// A function of two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Pair {
    Atan2,
    Min,
    Max,
    Power,
}

/// One operation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Operation {
    /// The variable of this number.
    Variable(usize),
    Negative(Operand),
    Binary(Operator, Operand, Operand),
    Unary(Function, Operand),
    Pair(Pair, Operand, Operand),
}

impl Operation {
    /// What it is done with.
    pub(crate) fn operands(self) -> impl Iterator<Item = Operand> {
        let (first, second) = match self {
            Self::Variable(_) => (None, None),
            Self::Negative(a) | Self::Unary(_, a) => (Some(a), None),
            Self::Binary(_, a, b) | Self::Pair(_, a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }
}

/// The operations of a recording, each once, and each before those that use its result.
#[derive(Debug, Default)]
pub(crate) struct Tape {
    pub operations: Vec<Operation>,
    places: HashMap<Operation, usize>,
    /// Pivots of eliminations with what they are compared with.
    pivots: Vec<[Operand; 2]>,
}

impl Tape {
    /// Each pivot over what it is compared with, as operations behind all others.
    pub(crate) fn ratios(&mut self) -> Vec<Operand> {
        let first = self.operations.len();
        self.operations.extend(self.pivots.iter().map(|&[a, b]| Operation::Binary(Operator::Over, a, b)));
        (first..self.operations.len()).map(Operand::Result).collect()
    }
}

thread_local! {
    static TAPE: RefCell<Tape> = RefCell::default();
}

/// What `compute` returns, with the operations that it recorded.
pub(crate) fn record<R>(compute: impl FnOnce() -> R) -> (R, Tape) {
    TAPE.take();
    let results = compute();
    (results, TAPE.take())
}

/// Derivatives of all operations of the present recording along a direction, as further operations: `seed` gives that of each variable. `None` where
/// nothing varies. At a discontinuity of a law a derivative is the mean of those on both sides.
pub(crate) fn tangents(seed: impl Fn(usize) -> Option<Recorded>) -> Vec<Option<Recorded>> {
    let operations = TAPE.with_borrow(|tape| tape.operations.clone());
    let mut tangents: Vec<Option<Recorded>> = Vec::with_capacity(operations.len());
    for (place, &operation) in operations.iter().enumerate() {
        let of = |operand: Operand| match operand {
            Operand::Result(place) => tangents[place],
            Operand::Number(_) | Operand::Pi => None,
        };
        let tangent = match operation {
            Operation::Variable(i) => seed(i),
            Operation::Negative(a) => of(a).map(Neg::neg),
            Operation::Unary(function, a) => {
                of(a).map(|d| slope(function, Recorded(a), Recorded(Operand::Result(place))) * d)
            }
            Operation::Binary(operator, a, b) => {
                of_operator(operator, [Recorded(a), Recorded(b), Recorded(Operand::Result(place))], [of(a), of(b)])
            }
            Operation::Pair(pair, a, b) => {
                of_pair(pair, [Recorded(a), Recorded(b), Recorded(Operand::Result(place))], [of(a), of(b)])
            }
        };
        tangents.push(tangent);
    }
    tangents
}

/// Slope of a function at `x`, where it is `y`.
fn slope(function: Function, x: Recorded, y: Recorded) -> Recorded {
    let one = Recorded::number(1.0);
    match function {
        Function::Sin => x.cos(),
        Function::Cos => -x.sin(),
        Function::Tan => one + y * y,
        Function::Asin => one / ((one - x) * (one + x)).sqrt(),
        Function::Acos => -(one / ((one - x) * (one + x)).sqrt()),
        Function::Sqrt => Recorded::number(0.5) / y,
        Function::Exp => y,
        Function::Ln => one / x,
        Function::Tanh => one - y * y,
        Function::Abs => x.sign(),
        Function::Sign => Recorded::number(0.0),
    }
}

/// The sum of what varies.
fn sum(of: [Option<Recorded>; 2]) -> Option<Recorded> {
    match of {
        [Some(a), Some(b)] => Some(a + b),
        [a, b] => a.or(b),
    }
}

/// The change of y = a ∘ b.
fn of_operator(operator: Operator, [a, b, y]: [Recorded; 3], [of_a, of_b]: [Option<Recorded>; 2]) -> Option<Recorded> {
    match operator {
        Operator::Plus => sum([of_a, of_b]),
        Operator::Minus => match (of_a, of_b) {
            (Some(of_a), Some(of_b)) => Some(of_a - of_b),
            (of_a, of_b) => of_a.or(of_b.map(Neg::neg)),
        },
        Operator::Times => sum([of_a.map(|d| d * b), of_b.map(|d| a * d)]),
        Operator::Over => sum([of_a, of_b.map(|d| -(y * d))]).map(|d| d / b),
    }
}

fn of_pair(pair: Pair, [a, b, y]: [Recorded; 3], [of_a, of_b]: [Option<Recorded>; 2]) -> Option<Recorded> {
    let half = Recorded::number(0.5);
    match pair {
        Pair::Atan2 => sum([of_a.map(|d| b * d), of_b.map(|d| -(a * d))]).map(|d| d / (a * a + b * b)),
        // the mean, and half the difference of what is on both sides
        Pair::Min | Pair::Max => {
            let share = half * (a - b).sign();
            let share = if pair == Pair::Max { share } else { -share };
            sum([of_a.map(|d| (half + share) * d), of_b.map(|d| (half - share) * d)])
        }
        Pair::Power => {
            let by_base = of_a.map(|d| b * a.powf(b - Recorded::number(1.0)) * d);
            sum([by_base, of_b.map(|d| y * a.ln() * d)])
        }
    }
}

impl Recorded {
    pub(crate) const fn number(x: f64) -> Self {
        Self(Operand::Number(x.to_bits()))
    }

    /// Variable `index`.
    pub(crate) fn variable(index: usize) -> Self {
        Self::done(Operation::Variable(index))
    }

    pub(crate) const fn operand(self) -> Operand {
        self.0
    }

    fn done(operation: Operation) -> Self {
        TAPE.with_borrow_mut(|tape| {
            let next = tape.operations.len();
            let place = *tape.places.entry(operation).or_insert(next);
            if place == next {
                tape.operations.push(operation);
            }
            Self(Operand::Result(place))
        })
    }

    const fn value(self) -> Option<f64> {
        match self.0 {
            Operand::Number(bits) => Some(f64::from_bits(bits)),
            Operand::Pi | Operand::Result(_) => None,
        }
    }

    /// A function of numbers is a number.
    fn unary(self, function: Function, of_number: fn(f64) -> f64) -> Self {
        self.value().map_or_else(|| Self::done(Operation::Unary(function, self.0)), |x| Self::number(of_number(x)))
    }

    fn pair(self, other: Self, pair: Pair, of_numbers: fn(f64, f64) -> f64) -> Self {
        match (self.value(), other.value()) {
            (Some(a), Some(b)) => Self::number(of_numbers(a, b)),
            _ => Self::done(Operation::Pair(pair, self.0, other.0)),
        }
    }

    fn binary(self, other: Self, operator: Operator, of_numbers: fn(f64, f64) -> f64) -> Self {
        match (self.value(), other.value()) {
            (Some(a), Some(b)) => Self::number(of_numbers(a, b)),
            _ => Self::done(Operation::Binary(operator, self.0, other.0)),
        }
    }
}

impl Add for Recorded {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.binary(other, Operator::Plus, f64::add)
    }
}

impl Sub for Recorded {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.binary(other, Operator::Minus, f64::sub)
    }
}

impl Mul for Recorded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.binary(other, Operator::Times, f64::mul)
    }
}

impl Div for Recorded {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        self.binary(other, Operator::Over, f64::div)
    }
}

impl Neg for Recorded {
    type Output = Self;

    fn neg(self) -> Self {
        self.value().map_or_else(|| Self::done(Operation::Negative(self.0)), |x| Self::number(-x))
    }
}

impl Scalar for Recorded {
    const PI: Self = Self(Operand::Pi);

    fn from_f64(x: f64) -> Self {
        Self::number(x)
    }

    fn fused(self, factor: Self, summand: Self) -> Self {
        self * factor + summand
    }

    fn sin_cos(self) -> (Self, Self) {
        (self.unary(Function::Sin, f64::sin), self.unary(Function::Cos, f64::cos))
    }

    fn tan(self) -> Self {
        self.unary(Function::Tan, f64::tan)
    }

    fn asin(self) -> Self {
        self.unary(Function::Asin, f64::asin)
    }

    fn acos(self) -> Self {
        self.unary(Function::Acos, f64::acos)
    }

    fn atan2(self, x: Self) -> Self {
        self.pair(x, Pair::Atan2, f64::atan2)
    }

    fn sqrt(self) -> Self {
        self.unary(Function::Sqrt, f64::sqrt)
    }

    fn exp(self) -> Self {
        self.unary(Function::Exp, f64::exp)
    }

    fn ln(self) -> Self {
        self.unary(Function::Ln, f64::ln)
    }

    fn tanh(self) -> Self {
        self.unary(Function::Tanh, f64::tanh)
    }

    fn abs(self) -> Self {
        self.unary(Function::Abs, f64::abs)
    }

    fn min(self, other: Self) -> Self {
        self.pair(other, Pair::Min, f64::min)
    }

    fn max(self, other: Self) -> Self {
        self.pair(other, Pair::Max, f64::max)
    }

    fn sign(self) -> Self {
        self.unary(Function::Sign, Scalar::sign)
    }

    fn powf(self, exponent: Self) -> Self {
        self.pair(exponent, Pair::Power, f64::powf)
    }

    /// Puts both on the tape; the ratio itself is unknown.
    fn least_ratio(self, divisor: Self) -> f64 {
        TAPE.with_borrow_mut(|tape| tape.pivots.push([self.0, divisor.0]));
        f64::NAN
    }

    fn magnitude(self) -> f64 {
        self.value().map_or(f64::NAN, f64::abs)
    }

    fn is_finite(self) -> bool {
        self.value().is_none_or(f64::is_finite)
    }
}
