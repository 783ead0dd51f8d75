//! Messages about expressions: shapes, units, numbers of arguments, what must not move.

use super::{Extent, fault_at_two_places, fault_with_help};
use crate::function::Operator;
use proc_macro2::{Ident, Span};

/// What messages say in place of the unit `1`.
pub const PLAIN_NUMBER: &str = "a plain number";

pub fn operands(at: Span, operator: Operator, left: &str, right: &str) -> syn::Error {
    let sign = operator.sign();
    let help = match operator {
        Operator::Add | Operator::Subtract => "both sides must be scalars, or both vectors such as `(x, y)`",
        Operator::Multiply => "write `dot(a, b)` or `cross(a, b)` for a product of vectors",
        Operator::Divide => "a vector can be divided by a scalar only",
        Operator::Power => "write `dot(a, a)` for the square of a vector",
    };
    fault_with_help(at, format_args!("`{sign}` stands between {left} and {right}"), help)
}

/// `left`, `right`: units, or "a plain number".
pub fn unlike_sum(at: Span, operator: Operator, left: &str, right: &str) -> syn::Error {
    let text = format_args!("`{}` stands between {left} and {right}", operator.sign()).to_string();
    fault_with_help(at, text, "both sides of a sum need the same unit")
}

/// `found`, `wanted`: units, or "a plain number".
pub fn wrong_dimension(at: Extent, what: &str, found: &str, wanted: &str) -> syn::Error {
    let is = |unit: &str| if unit == PLAIN_NUMBER { format!("is {unit}") } else { format!("is in {unit}") };
    let wanted_expression = match wanted {
        PLAIN_NUMBER => "a number without unit".to_owned(),
        unit => format!("an expression in {unit}"),
    };
    fault_with_help(
        at,
        format_args!("{what} {}, but this {}", is(wanted), is(found)),
        format_args!("write {wanted_expression}, or correct the unit of a parameter in it"),
    )
}

pub fn expected_scalar(at: Extent, what: &str) -> syn::Error {
    let help = "write one number, such as `A.x` or `norm(A.r)` in place of `A.r`";
    fault_with_help(at, format_args!("{what} is a scalar, but this is a vector"), help)
}

pub fn vector_as_constant(at: Extent, of: &str) -> syn::Error {
    fault_with_help(at, format_args!("{of} is a scalar, but this is a vector"), "write one number")
}

pub fn expected_vector(at: Extent, what: &str) -> syn::Error {
    fault_with_help(at, format_args!("{what} is a vector, but this is a scalar"), "write two components, `(x, y)`")
}

pub fn arity(function: &Ident, wanted: usize, found: usize) -> syn::Error {
    let plural = if wanted == 1 { "argument" } else { "arguments" };
    let example = ["", "(a)", "(a, b)", "(a, b, c)"][wanted.min(3)];
    fault_with_help(
        function,
        format_args!("`{function}` takes {wanted} {plural}, but {found} are given"),
        format_args!("write `{function}{example}`"),
    )
}

pub fn expected_name(at: Extent, function: &str, example: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("`{function}` takes the name of a point and the name of a body"),
        format_args!("write `{example}`"),
    )
}

pub fn place_as_value(at: Extent, body: &Ident) -> syn::Error {
    fault_with_help(
        at,
        format_args!("`{body}(…)` is a point, not a value"),
        format_args!("name it with `point P = {body}(…);` and write `P.x`, `P.y` or `P.v`"),
    )
}

pub fn called_value(name: &Ident, what: &str) -> syn::Error {
    fault_with_help(
        name,
        format_args!("`{name}` is {what}, not a function"),
        format_args!("write `{name} * (…)` for a product"),
    )
}

pub fn must_not_move(at: impl Into<Extent>, what: &str, on: &str, help: &str) -> syn::Error {
    fault_with_help(at, format_args!("{what} cannot depend on {on}"), help)
}

/// `left`, `right`: units, or "a plain number".
pub fn unlike_sides(at: Span, sign: &str, left: &str, right: &str) -> syn::Error {
    fault_with_help(at, format_args!("`{sign}` stands between {left} and {right}"), "both sides need the same unit")
}

/// `instead`: what does what a name was meant for.
pub fn name_in_constant(at: impl Into<Extent>, name: &str, of: &str, instead: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("{of} cannot use `{name}`"),
        format_args!("write numbers, `pi` and operators; {instead}"),
    )
}

pub fn constant_not_finite(at: Extent, of: &str, value: f64) -> syn::Error {
    fault_with_help(at, format_args!("{of} is {value}"), "write a finite number")
}

pub fn division_by_zero(at: Span) -> syn::Error {
    fault_with_help(at, "`/` divides by zero", "divide by something that is not zero")
}

pub fn cyclic_let(at: &Ident, name: &Ident) -> syn::Error {
    let error = fault_with_help(
        at,
        format_args!("the value `{name}` depends on itself"),
        "remove one of the uses in this circle",
    );
    fault_at_two_places(error, name, &format!("`{name}` is declared here"))
}

pub fn let_too_large(name: &Ident) -> syn::Error {
    fault_with_help(
        name,
        format_args!("the value `{name}` grows too large when the values that it uses are inserted"),
        "use fewer values of values",
    )
}

pub fn let_used_too_early(name: &Ident) -> syn::Error {
    fault_with_help(
        name,
        format_args!("the value `{name}` ends a long chain of values, each used before it is declared"),
        "declare values before their uses",
    )
}
