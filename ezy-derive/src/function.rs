//! Functions that an expression can call: of the model language, of the engine, and of the emitted code; and its operators.

/// A function of one or two scalars.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Function {
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan2,
    Sqrt,
    Exp,
    Ln,
    Tanh,
    Abs,
    Min,
    Max,
    Sign,
    /// A power that is not a small whole number.
    Pow,
}

/// Names of the functions of the model language: those of scalars, and those that are written out.
pub const FUNCTIONS: [&str; 19] = [
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan2",
    "sqrt",
    "exp",
    "ln",
    "tanh",
    "abs",
    "min",
    "max",
    "sign",
    "dot",
    "cross",
    "norm",
    "slip_angle",
    "smooth_step",
];

/// Where emitted code finds a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Path {
    /// A method of the number.
    OfNumber(&'static str),
    /// In `ezy_core::__private` for `f64`, else a method of the number.
    OfKernel(&'static str),
}

/// Its value for numbers, used to fold literals: the same functions as the emitted code calls.
#[derive(Clone, Copy)]
enum Value {
    One(fn(f64) -> f64),
    Two(fn(f64, f64) -> f64),
}

use Value::{One, Two};

impl Function {
    /// Name in the model language, and value.
    fn row(self) -> (&'static str, Value) {
        match self {
            Self::Sin => ("sin", One(f64::sin)),
            Self::Cos => ("cos", One(f64::cos)),
            Self::Tan => ("tan", One(f64::tan)),
            Self::Asin => ("asin", One(f64::asin)),
            Self::Acos => ("acos", One(f64::acos)),
            Self::Atan2 => ("atan2", Two(f64::atan2)),
            Self::Sqrt => ("sqrt", One(f64::sqrt)),
            Self::Exp => ("exp", One(f64::exp)),
            Self::Ln => ("ln", One(f64::ln)),
            Self::Tanh => ("tanh", One(f64::tanh)),
            Self::Abs => ("abs", One(f64::abs)),
            Self::Min => ("min", Two(f64::min)),
            Self::Max => ("max", Two(f64::max)),
            Self::Sign => ("sign", One(|x| if x == 0.0 { 0.0 } else { x.signum() })),
            Self::Pow => ("pow", Two(f64::powf)),
        }
    }

    /// Name in the model language.
    pub fn name(self) -> &'static str {
        self.row().0
    }

    /// Number of arguments.
    pub fn arity(self) -> usize {
        match self.row().1 {
            One(_) => 1,
            Two(_) => 2,
        }
    }

    /// What emitted code calls.
    pub fn path(self) -> Path {
        match self {
            Self::Sign => Path::OfKernel("sign"),
            Self::Pow => Path::OfNumber("powf"),
            _ => Path::OfNumber(self.name()),
        }
    }

    pub fn evaluate(self, x: &[f64]) -> f64 {
        match (self.row().1, x) {
            (One(value), [x]) => value(*x),
            (Two(value), [x, y]) => value(*x, *y),
            _ => f64::NAN,
        }
    }
}

/// What stands between two expressions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

impl Operator {
    pub const fn sign(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Power => "^",
        }
    }

    pub fn evaluate(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Add => a + b,
            Self::Subtract => a - b,
            Self::Multiply => a * b,
            Self::Divide => a / b,
            Self::Power => a.powf(b),
        }
    }
}
