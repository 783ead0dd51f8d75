//! Recorded operations as expressions of a language.

use crate::scalar::{Function, Operand, Operation, Operator, Pair};

/// How a language writes what is not the same in all.
pub(super) trait Syntax {
    /// A finite number that is not negative.
    fn number(&self, x: f64) -> String;

    /// Infinity, or what is no number: constants that a parameter of zero makes so.
    fn not_finite(&self, is_nan: bool) -> String {
        if is_nan { "NaN" } else { "Inf" }.to_owned()
    }

    fn pi(&self) -> String {
        "pi".to_owned()
    }

    /// Name of a function of one number.
    fn function(&self, function: Function) -> String {
        let names = ["sin", "cos", "tan", "asin", "acos", "sqrt", "exp", "log", "tanh", "abs", "sign"];
        names[function as usize].to_owned()
    }

    /// A function of two numbers.
    fn pair(&self, pair: Pair, first: &str, second: &str) -> String;

    /// Element `i`, counted from zero, of a vector.
    fn element(&self, vector: &str, i: usize) -> String;
}

/// How strongly the last operation of a text binds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Whole,
}

/// The text of an expression.
#[derive(Debug, Clone)]
pub(super) struct Expression {
    text: String,
    binding: Binding,
    /// A sign in front of a text that binds as a product or more.
    is_negative: bool,
    /// Names and numbers in it.
    pub size: usize,
}

impl Expression {
    pub(super) fn name(text: String) -> Self {
        Self { text, binding: Binding::Whole, is_negative: false, size: 1 }
    }

    pub(super) fn number(syntax: &dyn Syntax, x: f64) -> Self {
        let text = if x.is_finite() { syntax.number(x.abs()) } else { syntax.not_finite(x.is_nan()) };
        Self { is_negative: x.is_sign_negative() && !x.is_nan(), ..Self::name(text) }
    }

    pub(super) fn is_name(&self) -> bool {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        !self.is_negative && self.text.chars().all(is_word) && self.text.starts_with(char::is_alphabetic)
    }

    /// The whole text.
    pub(super) fn text(&self) -> String {
        if self.is_negative { format!("-{}", self.text) } else { self.text.clone() }
    }

    /// The text where something stands in front of it, or an operator behind it.
    fn within(&self, least: Binding) -> String {
        if self.is_negative || self.binding < least { format!("({})", self.text()) } else { self.text.clone() }
    }

    /// The text of one operation with those of its operands.
    pub(super) fn of(syntax: &dyn Syntax, operation: Operation, operand: impl Fn(Operand) -> Self) -> Self {
        match operation {
            // a variable has got a name before
            Operation::Variable(i) => Self::name(format!("x{i}")),
            Operation::Negative(a) => operand(a).negated(),
            Operation::Unary(function, a) => {
                let a = operand(a);
                Self { size: a.size, ..Self::name(format!("{}({})", syntax.function(function), a.text())) }
            }
            Operation::Pair(pair, a, b) => {
                let (a, b) = (operand(a), operand(b));
                Self { size: a.size + b.size, ..Self::name(syntax.pair(pair, &a.text(), &b.text())) }
            }
            Operation::Binary(operator, a, b) => Self::binary(operator, &operand(a), &operand(b)),
        }
    }

    fn negated(self) -> Self {
        if self.is_negative {
            return Self { is_negative: false, ..self };
        }
        let text = self.within(Binding::Product);
        let binding = self.binding.max(Binding::Product);
        Self { text, binding, is_negative: true, size: self.size }
    }

    /// Operations are kept in their order, so that rounding is that of a run.
    fn binary(operator: Operator, a: &Self, b: &Self) -> Self {
        let (sign, binding) = match operator {
            Operator::Plus => ("+", Binding::Sum),
            Operator::Minus => ("-", Binding::Sum),
            Operator::Times => ("*", Binding::Product),
            Operator::Over => ("/", Binding::Product),
        };
        let size = a.size + b.size;
        if binding == Binding::Sum {
            // a + (-b) is a - b, and a - (-b) is a + b, to the last bit
            let sign = match (sign, b.is_negative) {
                (sign, false) => sign,
                ("+", true) => "-",
                (_, true) => "+",
            };
            let second = if b.binding == Binding::Sum { format!("({})", b.text) } else { b.text.clone() };
            return Self { text: format!("{} {sign} {second}", a.text()), binding, is_negative: false, size };
        }
        // (-a) * b is -(a * b), to the last bit
        let first = Self { is_negative: false, ..a.clone() }.within(Binding::Product);
        Self { text: format!("{first} {sign} {}", b.within(Binding::Whole)), binding, is_negative: a.is_negative, size }
    }
}
