//! Messages about values, shapes, units and what a model needs.

use super::nearest::quoted;
use super::{Extent, Warning, fault_at_two_places, fault_with_help};
use crate::parse::ast::Operator;
use proc_macro2::{Ident, Span};
use std::fmt::Display;

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

pub fn unlike_sum(at: Span, operator: Operator, left: &dyn Display, right: &dyn Display) -> syn::Error {
    let text = format_args!("`{}` stands between {left} and {right}", operator.sign()).to_string();
    fault_with_help(at, text, "both sides of a sum need the same unit")
}

pub fn wrong_dimension(at: Extent, what: &str, found: &dyn Display, wanted: &dyn Display) -> syn::Error {
    fault_with_help(
        at,
        format_args!("{what} is in {wanted}, but this is in {found}"),
        format_args!("write an expression in {wanted}, or correct the unit of a parameter in it"),
    )
}

pub fn expected_scalar(at: Extent, what: &str) -> syn::Error {
    fault_with_help(at, format_args!("{what} is a scalar, but this is a vector"), "write one number")
}

pub fn expected_vector(at: Extent, what: &str) -> syn::Error {
    fault_with_help(at, format_args!("{what} is a vector, but this is a scalar"), "write two components, `(x, y)`")
}

pub fn arity(function: &Ident, wanted: usize, found: usize) -> syn::Error {
    let plural = if wanted == 1 { "argument" } else { "arguments" };
    let example = if wanted == 1 { "(a)" } else { "(a, b)" };
    fault_with_help(
        function,
        format_args!("`{function}` takes {wanted} {plural}, but {found} are given"),
        format_args!("write `{function}{example}`"),
    )
}

pub fn place_as_value(at: Extent, body: &Ident) -> syn::Error {
    fault_with_help(
        at,
        format_args!("`{body}(…)` is a place, not a value"),
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

pub fn must_not_move(at: impl Into<Extent>, what: &str, on: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("{what} cannot depend on {on}"),
        "write an expression of numbers, `pi` and parameters",
    )
}

pub fn name_in_constant(at: impl Into<Extent>, name: &str, of: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("{of} cannot use `{name}`"),
        "write numbers, `pi` and operators; `let name = …;` computes with parameters",
    )
}

pub fn constant_not_finite(at: Extent, of: &str, value: f64) -> syn::Error {
    fault_with_help(at, format_args!("{of} is {value}"), "write a finite number")
}

pub fn negative_mass(at: Extent, what: &str, value: f64, unit: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("{what} is negative: {value:?} {unit}"),
        format_args!("write a positive value, such as `{:?}`", -value),
    )
}

pub fn massless_and_free(at: Extent, body: &Ident, word: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("the {word} of body `{body}` is zero, and no hinge or skate holds the body"),
        format_args!("write a positive {word}, or hold `{body}` by a hinge"),
    )
}

pub fn hinge_within_body(at: &Ident, hinge: &Ident, ground: bool) -> syn::Error {
    let body = if ground { "the ground" } else { "a body" };
    fault_with_help(
        at,
        format_args!("hinge `{hinge}` joins {body} to itself"),
        "a hinge joins two bodies, or a body and the ground",
    )
}

pub fn skate_on_ground(at: &Ident, skate: &Ident) -> syn::Error {
    fault_with_help(
        at,
        format_args!("skate `{skate}` is on the ground, which does not move"),
        "write a place on a body",
    )
}

pub fn force_on_ground(at: &Ident) -> syn::Error {
    fault_with_help(at, "this force acts on the ground, which does not move", "write a place on a body")
}

pub fn ground_is_no_body(at: &Ident) -> syn::Error {
    fault_with_help(at, "this acts on the ground, which does not move", "write the name of a body")
}

pub fn ground_starts(at: &Ident) -> syn::Error {
    fault_with_help(at, "the ground has no start values: it does not move", "remove this statement")
}

pub fn torque_on_itself(at: &Ident) -> syn::Error {
    fault_with_help(
        at,
        format_args!("this torque acts from `{at}` on itself"),
        "write another body behind `~`, or `ground`",
    )
}

pub fn direction_without_length(at: Extent, body: &Ident) -> syn::Error {
    fault_with_help(
        at,
        "this direction has no length",
        format_args!("write `{body}(1, 0)` for the x axis of `{body}`, `{body}(0, 1)` for its y axis"),
    )
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

pub fn cyclic_place(at: &Ident) -> syn::Error {
    fault_with_help(
        at,
        format_args!("the place of hinge `{at}` is its own place"),
        "write `body(x, y)` for the first place of one hinge of this circle",
    )
}

pub fn start_gives_twice(word: &Ident, start: &Ident, name: &str, first: &Ident) -> syn::Error {
    fault_at_two_places(
        fault_with_help(word, format_args!("start `{start}` gives `{name}` twice"), "remove one of them"),
        first,
        "first given here",
    )
}

pub fn moves_at_rest(rest: &Ident, start: &Ident, name: &str, word: &Ident) -> syn::Error {
    fault_at_two_places(
        fault_with_help(rest, format_args!("start `{start}` is at rest, but gives `{name}`"), "remove `at rest;`"),
        word,
        &format!("`{name}` is given here"),
    )
}

pub fn scene_without_start(scene: &Ident, starts: &[&str]) -> syn::Error {
    let help = match starts.first() {
        Some(first) => format!("write `start {first};`; declared starts: {}", quoted(starts)),
        None => "declare one, such as `start folded { at rest; }`, and write `start folded;`".to_owned(),
    };
    fault_with_help(scene, format_args!("scene `{scene}` has no start"), help)
}

pub fn scene_without_until(scene: &Ident) -> syn::Error {
    fault_with_help(scene, format_args!("scene `{scene}` has no end"), "write `until 60 s;`")
}

pub fn until_in_wrong_unit(unit: &Ident) -> syn::Error {
    fault_with_help(unit, format_args!("`{unit}` is no unit of time"), "write `s`, `ms`, `min` or `h`")
}

pub fn until_not_positive(at: Extent, scene: &Ident) -> syn::Error {
    fault_with_help(
        at,
        format_args!("scene `{scene}` ends before it begins"),
        "scenes begin at 0 s; write a positive time, such as `until 60 s;`",
    )
}

pub fn effect_twice(name: &Ident, scene: &Ident, first: &Ident) -> syn::Error {
    fault_at_two_places(
        fault_with_help(name, format_args!("scene `{scene}` calls for effect `{name}` twice"), "remove one of them"),
        first,
        "first called for here",
    )
}

pub fn shared_parameter(name: &Ident, scene: &Ident, first: &Ident, second: &Ident) -> syn::Error {
    fault_with_help(
        name,
        format_args!("scene `{scene}` calls for effects `{first}` and `{second}`, which both declare `{name}`"),
        format_args!("write another name in one of them, such as `{second}_{name}`"),
    )
}

pub fn effect_named_model(name: &Ident) -> syn::Error {
    fault_with_help(
        name,
        "no effect can be named `model`: this is the name of the forces outside of effects",
        "write another name",
    )
}

pub fn no_type_name(scene: &Ident, type_name: &str) -> syn::Error {
    let text = if type_name.is_empty() {
        format!("scene `{scene}` has no letter that could name its type")
    } else {
        format!("scene `{scene}` would be the type `{type_name}`, which is no name in Rust")
    };
    fault_with_help(scene, text, "write another name")
}

pub fn same_type_name(scene: &Ident, type_name: &str, first: &Ident) -> syn::Error {
    fault_at_two_places(
        fault_with_help(
            scene,
            format_args!("scenes `{first}` and `{scene}` would both be the type `{type_name}`"),
            "write another name",
        ),
        first,
        &format!("`{first}` is declared here"),
    )
}

pub fn no_module_name(model: &Ident, module: &str) -> syn::Error {
    fault_with_help(
        model,
        format_args!("model `{model}` would be the module `{module}`, which is no name in Rust"),
        format_args!("write another name, such as `{model}Model`"),
    )
}

pub fn model_without_body(model: &Ident) -> syn::Error {
    fault_with_help(
        model,
        format_args!("model `{model}` has no body"),
        "declare one, such as `body seat { mass: 46.0, inertia: 10.0 }`",
    )
}

pub fn model_without_scene(model: &Ident) -> syn::Error {
    fault_with_help(
        model,
        format_args!("model `{model}` has no scene, so that there is nothing to run"),
        "declare one, such as `scene driven { start folded; until 60 s; }`",
    )
}

pub fn parameter_of_unused_effect(name: &Ident, effect: &Ident) -> Warning {
    Warning {
        span: name.span(),
        name: "parameter_of_unused_effect",
        text: format!("no scene calls for effect `{effect}`, so that its parameter `{name}` is never used"),
    }
}
