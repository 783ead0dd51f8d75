//! Messages about expressions: shapes, units, numbers of arguments, what must not move.

use super::{Extent, fault_with_help};
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

messages! {
    vector_as_constant(at: Extent, of: &str):
        "{of} is a scalar, but this is a vector", "write one number";

    expected_vector(at: Extent, what: &str):
        "{what} is a vector, but this is a scalar", "write two components, `(x, y)`";

    expected_name(at: Extent, function: &str, example: &str):
        "`{function}` takes the name of a point and the name of a body", "write `{example}`";

    place_as_value(at: Extent, body: &Ident):
        "`{body}(…)` is a point, not a value",
        "name it with `point P = {body}(…);` and write `P.x`, `P.y` or `P.v`; a force in the axes of `{body}` is `force at P along {body}(1, 0): …;`";

    called_value(name: &Ident, what: &str):
        "`{name}` is {what}, not a function", "write `{name} * (…)` for a product";

    /// `left`, `right`: units, or "a plain number".
    unlike_sides(at: Span, sign: &str, left: &str, right: &str):
        "`{sign}` stands between {left} and {right}", "both sides need the same unit";

    /// `instead`: what does what a name was meant for.
    name_in_constant(at: impl Into<Extent>, name: &str, of: &str, instead: &str):
        "{of} cannot use `{name}`", "write numbers, `pi` and operators; {instead}";

    unit_in_constant(at: Extent, unit: &str, of: &str):
        "{of} is a number without unit, but `{unit}` stands behind one",
        "write numbers alone; the unit of a declaration stands behind its name, as in `param l: mm = 5;`";

    unit_or_value(name: &Ident, unit: &str):
        "`{name}` in `{unit}` is a unit here, and a declared name",
        "write `({unit})` for the unit, or the value first: `{name} * …`";

    constant_not_finite(at: Extent, of: &str, value: f64):
        "{of} is {value}", "write a finite number";

    division_by_zero(at: Span):
        "`/` divides by zero", "divide by something that is not zero";

    let_too_large(name: &Ident):
        "the value `{name}` grows too large when the values that it uses are inserted",
        "use fewer values of values";

    let_used_too_early(name: &Ident):
        "the value `{name}` ends a long chain of values, each used before it is declared",
        "declare values before their uses";

    cyclic_let(at: &Ident, name: &Ident):
        "the value `{name}` depends on itself",
        "remove one of the uses in this circle", name: "`{name}` is declared here";

    expected_scalar(at: Extent, what: &str):
        "{what} is a scalar, but this is a vector",
        "write one number, such as `A.x` or `norm(A.r)` in place of `A.r`";

    must_not_move(at: impl Into<Extent>, what: &str, on: &str, help: &str):
        "{what} cannot depend on {on}", "{help}";
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
