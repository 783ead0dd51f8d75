//! Messages about bodies, rows and forces, and what a model needs.

use super::{Extent, fault_with_help};
use proc_macro2::Ident;

pub fn negative_mass(at: Extent, what: &str, value: f64, unit: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("{what} is negative: {value:?} {unit}"),
        format_args!("write a positive value, such as `{:?}`", -value),
    )
}

pub fn not_positive(at: Extent, what: &str, value: f64, unit: &str) -> syn::Error {
    fault_with_help(at, format_args!("{what} is {value:?} {unit}"), "write a positive value")
}

pub fn stop_of_nothing(at: Extent, what: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("{what} bounds a quantity that does not move with a body"),
        "write a position or an angle, such as `ball.x` or `B.angle`",
    )
}

pub fn no_restitution(at: Extent, what: &str, value: f64) -> syn::Error {
    fault_with_help(
        at,
        format_args!("{what} is {value:?}"),
        "write a number from 0, which comes to rest, to 1, which loses no energy",
    )
}

pub fn massless_and_free(at: Extent, body: &Ident, word: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("the {word} of body `{body}` is zero, and no constraint holds the body"),
        format_args!("write a positive {word}, or hold `{body}` by a hinge"),
    )
}

/// `subject`: "hinge `B`", or "this spring".
pub fn within_body(at: &Ident, subject: &str, ground: bool) -> syn::Error {
    let body = if ground { "the ground" } else { "a body" };
    fault_with_help(
        at,
        format_args!("{subject} joins {body} to itself"),
        "its points need to be on two bodies, or on a body and the ground",
    )
}

pub fn on_ground(at: &Ident, subject: &str) -> syn::Error {
    fault_with_help(at, format_args!("{subject} is on the ground, which does not move"), "write a point on a body")
}

pub fn ground_is_no_body(at: &Ident) -> syn::Error {
    fault_with_help(at, "this acts on the ground, which does not move", "write the name of a body")
}

pub fn couple_of_one(at: &Ident, subject: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("{subject} acts from `{at}` on itself"),
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

pub fn cyclic_place(at: &Ident) -> syn::Error {
    fault_with_help(
        at,
        format_args!("the point of hinge `{at}` is its own point"),
        "write `body(x, y)` for the first point of one hinge of this circle",
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
