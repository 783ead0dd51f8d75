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

messages! {
    not_positive(at: Extent, what: &str, value: f64, unit: &str):
        "{what} is {value:?} {unit}", "write a positive value";

    stop_of_nothing(at: Extent, what: &str):
        "{what} bounds a quantity that does not move with a body",
        "write a position or an angle, such as `ball.x` or `B.angle`";

    no_restitution(at: Extent, what: &str, value: f64):
        "{what} is {value:?}",
        "write a number from 0, which comes to rest, to 1, which loses no energy";

    massless_and_free(at: Extent, body: &Ident, word: &str):
        "the {word} of body `{body}` is zero, and no constraint holds the body",
        "write a positive {word}, or hold `{body}` by a hinge";

    on_ground(at: &Ident, subject: &str):
        "{subject} is on the ground, which does not move", "write a point on a body";

    ground_is_no_body(at: &Ident):
        "this acts on the ground, which does not move", "write the name of a body";

    couple_of_one(at: &Ident, subject: &str):
        "{subject} acts from `{at}` on itself", "write another body behind `~`, or `ground`";

    direction_without_length(at: Extent, body: &Ident):
        "this direction has no length",
        "write `{body}(1, 0)` for the x axis of `{body}`, `{body}(0, 1)` for its y axis";

    cyclic_place(at: &Ident):
        "the point of hinge `{at}` is its own point",
        "write `body(x, y)` for the first point of one hinge of this circle";

    no_module_name(model: &Ident, module: &str):
        "model `{model}` would be the module `{module}`, which is no name in Rust",
        "write another name, such as `{model}Model`";

    model_without_body(model: &Ident):
        "model `{model}` has no body",
        "declare one, such as `body seat {{ mass: 46.0, inertia: 10.0 }}`";

    model_without_scene(model: &Ident):
        "model `{model}` has no scene, so that there is nothing to run",
        "declare one, such as `scene driven {{ start folded; until 60 s; }}`";
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
