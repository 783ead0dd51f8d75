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

/// Where emitted code finds a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Path {
    /// A method of the number.
    OfNumber(&'static str),
    /// In `ezy_core::__private` for `f64`, else a method of the number.
    OfKernel(&'static str),
}

impl Function {
    /// Name in the model language.
    pub fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Tan => "tan",
            Self::Asin => "asin",
            Self::Acos => "acos",
            Self::Atan2 => "atan2",
            Self::Sqrt => "sqrt",
            Self::Exp => "exp",
            Self::Ln => "ln",
            Self::Tanh => "tanh",
            Self::Abs => "abs",
            Self::Min => "min",
            Self::Max => "max",
            Self::Sign => "sign",
            Self::Pow => "pow",
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

    /// Value for numbers, used to fold literals: the same functions as the emitted code calls.
    pub fn evaluate(self, x: &[f64]) -> f64 {
        match (self, x) {
            (Self::Sin, [x]) => x.sin(),
            (Self::Cos, [x]) => x.cos(),
            (Self::Tan, [x]) => x.tan(),
            (Self::Asin, [x]) => x.asin(),
            (Self::Acos, [x]) => x.acos(),
            (Self::Atan2, [y, x]) => y.atan2(*x),
            (Self::Sqrt, [x]) => x.sqrt(),
            (Self::Exp, [x]) => x.exp(),
            (Self::Ln, [x]) => x.ln(),
            (Self::Tanh, [x]) => x.tanh(),
            (Self::Abs, [x]) => x.abs(),
            (Self::Min, [x, y]) => x.min(*y),
            (Self::Max, [x, y]) => x.max(*y),
            (Self::Sign, [x]) => {
                if *x == 0.0 {
                    0.0
                } else {
                    x.signum()
                }
            }
            (Self::Pow, [x, y]) => x.powf(*y),
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
}
