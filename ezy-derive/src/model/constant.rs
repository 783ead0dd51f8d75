//! Values of parameters and durations: numbers, `pi` and operators, computed when the model is compiled.

use super::Expr;
use crate::diag::values;
use crate::parse::ast;
use std::f64::consts::PI;
use syn::Result;

/// The value of an expression of numbers; `of` says what it is for, `instead` what does what a name in
/// it was meant for.
pub fn constant(expr: &ast::Expr, of: &str, instead: &str) -> Result<f64> {
    let value = evaluate(expr, of, instead)?;
    if value.is_finite() { Ok(value) } else { Err(values::constant_not_finite(expr.extent(), of, value)) }
}

fn evaluate(expr: &ast::Expr, of: &str, instead: &str) -> Result<f64> {
    match expr {
        ast::Expr::Number { value, .. } => Ok(*value),
        ast::Expr::Quantity { unit, .. } => Err(values::unit_in_constant(expr.extent(), &unit.text, of)),
        ast::Expr::Name(name) if name == "pi" => Ok(PI),
        ast::Expr::Name(name) => Err(values::name_in_constant(name, &name.to_string(), of, instead)),
        ast::Expr::Indexed(name) => Err(values::name_in_constant(&**name, &name.word.to_string(), of, instead)),
        ast::Expr::Member { owner, member } => {
            Err(values::name_in_constant(expr.extent(), &format!("{}.{member}", owner.word), of, instead))
        }
        ast::Expr::Call { function, .. } => Err(values::name_in_constant(function, &function.to_string(), of, instead)),
        ast::Expr::Vector { .. } => Err(values::vector_as_constant(expr.extent(), of)),
        ast::Expr::Negative { operand, .. } => Ok(-evaluate(operand, of, instead)?),
        ast::Expr::Binary { operator, left, right, .. } => {
            Ok(operator.evaluate(evaluate(left, of, instead)?, evaluate(right, of, instead)?))
        }
    }
}

/// The value of a resolved expression of numbers alone.
pub fn literal(expr: &Expr) -> Option<f64> {
    at_defaults(expr, &[])
}

/// The value of a resolved expression with these parameters, in SI units; `None` where it moves.
pub fn at_defaults(expr: &Expr, parameters: &[f64]) -> Option<f64> {
    let value = |expr: &Expr| at_defaults(expr, parameters);
    Some(match expr {
        Expr::Number(number) => *number,
        Expr::Pi => PI,
        Expr::Conversion(unit) => unit.to_si(1.0),
        Expr::Parameter(id) => *parameters.get(id.0)?,
        Expr::Neg(a) => -value(a)?,
        Expr::Binary(operator, a, b) => operator.evaluate(value(a)?, value(b)?),
        Expr::Call(function, arguments) => {
            let arguments: Option<Vec<f64>> = arguments.iter().map(value).collect();
            function.evaluate(&arguments?)
        }
        _ => return None,
    })
}
