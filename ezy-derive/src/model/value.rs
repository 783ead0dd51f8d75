//! Scalars and vectors, and their operators.

use super::Expr;
use super::dimension::Measure;
use crate::diag::values;
use crate::function::Operator;
use proc_macro2::Span;
use syn::Result;

/// An expression with its shape and what is known of its dimension.
#[derive(Debug, Clone)]
pub struct Value {
    pub form: Form,
    pub measure: Measure,
}

#[derive(Debug, Clone)]
pub enum Form {
    Scalar(Expr),
    Vector(Expr, Expr),
}

impl Value {
    pub fn scalar(value: Expr, measure: impl Into<Measure>) -> Self {
        Self { form: Form::Scalar(value), measure: measure.into() }
    }

    pub fn vector(x: Expr, y: Expr, measure: impl Into<Measure>) -> Self {
        Self { form: Form::Vector(x, y), measure: measure.into() }
    }

    pub fn shape(&self) -> &'static str {
        match self.form {
            Form::Scalar(_) => "a scalar",
            Form::Vector(..) => "a vector",
        }
    }

    pub fn negative(self) -> Self {
        let form = match self.form {
            Form::Scalar(value) => Form::Scalar(-value),
            Form::Vector(x, y) => Form::Vector(-x, -y),
        };
        Self { form, ..self }
    }

    /// `self operator other`; the message of a fault sits on the operator.
    pub fn binary(self, operator: Operator, at: Span, other: Self) -> Result<Self> {
        let fault = values::operands(at, operator, self.shape(), other.shape());
        let measure = self.measure_with(operator, at, &other)?;
        let form = match (operator, self.form, other.form) {
            (_, Form::Scalar(a), Form::Scalar(b)) => Form::Scalar(Expr::binary(operator, a, b)),
            (Operator::Add | Operator::Subtract, Form::Vector(ax, ay), Form::Vector(bx, by)) => {
                Form::Vector(Expr::binary(operator, ax, bx), Expr::binary(operator, ay, by))
            }
            (Operator::Multiply | Operator::Divide, Form::Vector(x, y), Form::Scalar(b)) => {
                Form::Vector(Expr::binary(operator, x, b.clone()), Expr::binary(operator, y, b))
            }
            (Operator::Multiply, Form::Scalar(a), Form::Vector(x, y)) => Form::Vector(a.clone() * x, a * y),
            _ => return Err(fault),
        };
        Ok(Self { form, measure })
    }

    fn measure_with(&self, operator: Operator, at: Span, other: &Self) -> Result<Measure> {
        let (a, b) = (self.measure, other.measure);
        Ok(match operator {
            Operator::Add | Operator::Subtract => match a.known().zip(b.known()) {
                Some((a, b)) if a != b => return Err(values::unlike_sum(at, operator, &a.in_words(), &b.in_words())),
                _ => a.or(b),
            },
            Operator::Multiply => a.times(b),
            Operator::Divide => a.over(b),
            Operator::Power => match &other.form {
                Form::Scalar(exponent) => a.power(number(exponent)),
                Form::Vector(..) => Measure::Unknown,
            },
        })
    }

    /// a · b
    pub fn dot(ax: Expr, ay: Expr, bx: Expr, by: Expr) -> Expr {
        ax * bx + ay * by
    }

    /// The component of a × b out of the plane.
    pub fn cross(ax: Expr, ay: Expr, bx: Expr, by: Expr) -> Expr {
        ax * by - ay * bx
    }
}

/// The value of a literal with or without signs.
fn number(expr: &Expr) -> Option<f64> {
    match expr {
        Expr::Number(value) => Some(*value),
        Expr::Neg(operand) => number(operand).map(|value| -value),
        Expr::Binary(Operator::Divide, a, b) => number(a).zip(number(b)).map(|(a, b)| a / b),
        _ => None,
    }
}
