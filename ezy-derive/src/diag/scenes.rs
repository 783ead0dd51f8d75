//! Messages about starts, effects and scenes.

use super::nearest::{quoted, suggestion};
use super::{Extent, Warning, fault_at_two_places, fault_with_help};
use proc_macro2::Ident;

messages! {
    ground_starts(at: &Ident):
        "the ground has no start values: it does not move", "remove this statement";

    ends_at_event_of_other_effect(name: &Ident, scene: &Ident, effect: &Ident):
        "event `{name}` belongs to effect `{effect}`, which scene `{scene}` does not call for",
        "write `with {effect};`, or declare the event in the model";

    condition_never_changes(at: Extent, what: &str):
        "{what} depends on nothing that changes",
        "write something that moves on one side, such as `ball.y < 0`";

    until_in_wrong_unit(unit: &Ident):
        "`{unit}` is no unit of time", "write `s`, `ms`, `min` or `h`";

    until_not_positive(at: Extent, scene: &Ident):
        "scene `{scene}` ends before it begins",
        "scenes begin at 0 s; write a positive time, such as `until 60 s;`";

    shared_parameter(name: &Ident, scene: &Ident, first: &Ident, second: &Ident):
        "scene `{scene}` calls for effects `{first}` and `{second}`, which both declare `{name}`",
        "write another name in one of them, such as `{second}_{name}`";

    releases_own_row(name: &Ident, effect: &Ident):
        "effect `{effect}` releases `{name}`, which it declares itself",
        "remove both, or name a constraint of the model";

    release_outside_effect(row: &Ident):
        "`{row}` is released outside of an effect, so that no scene could keep it",
        "move this into an effect, or remove the constraint";

    released_by_two(scene: &Ident, row: &Ident, first: &Ident, second: &Ident):
        "scene `{scene}` calls for effects `{first}` and `{second}`, which both release `{row}`",
        "two laws would replace one constraint; call for one of these effects";

    stop_with_counts(stop: &Ident):
        "stop `{stop}` cannot be followed in a model with counts, arrays or `for`",
        "write single bodies, or a stiff `spring` or `torsion` in place of this stop";

    limit_with_counts(row: &Ident):
        "skate `{row}` has a limit, which a model with counts, arrays or `for` cannot follow",
        "remove the limit, or write `tyre` in place of this skate";

    start_gives_twice(word: &Ident, start: &Ident, name: &str, first: &Ident):
        "start `{start}` gives `{name}` twice", "remove one of them", first: "first given here";

    moves_at_rest(rest: &Ident, start: &Ident, name: &str, word: &Ident):
        "start `{start}` is at rest, but gives `{name}`", "remove `at rest;`", word: "`{name}` is given here";

    start_breaks_row(start: &Ident, row: &str, level: &str, value: f64):
        "start `{start}` fixes too much: its values leave {value:.3} in constraint `{row}` at {level} level",
        "leave one of the values of its bodies out: what is not given is assembled from the constraints";

    effect_twice(name: &Ident, scene: &Ident, first: &Ident):
        "scene `{scene}` calls for effect `{name}` twice", "remove one of them", first: "first called for here";

    released_twice(name: &Ident, first: &Ident):
        "constraint `{name}` is released twice", "remove one of them", first: "first released here";

    same_type_name(scene: &Ident, type_name: &str, first: &Ident):
        "scenes `{first}` and `{scene}` would both be the type `{type_name}`",
        "write another name", first: "`{first}` is declared here";
}

pub fn scene_without_start(scene: &Ident, starts: &[&str]) -> syn::Error {
    let help = match starts.first() {
        Some(first) => format!("write `start {first};`; declared starts: {}", quoted(starts)),
        None => "declare one, such as `start folded { at rest; }`, and write `start folded;`".to_owned(),
    };
    fault_with_help(scene, format_args!("scene `{scene}` has no start"), help)
}

/// `conditional`: it ends where a condition holds.
pub fn scene_without_until(scene: &Ident, conditional: bool) -> syn::Error {
    if conditional {
        let text = format!("scene `{scene}` has no latest end: what it waits for may never take place");
        return fault_with_help(scene, text, "write `until 60 s;`, too");
    }
    fault_with_help(scene, format_args!("scene `{scene}` has no end"), "write `until 60 s;`")
}

pub fn ends_at_no_event(name: &Ident, what: Option<&str>, events: &[&str]) -> syn::Error {
    let text = match what {
        Some(what) => format!("`{name}` is {what}, not an event"),
        None => format!("event `{name}` is not declared"),
    };
    if events.is_empty() {
        return fault_with_help(name, text, "write a time, such as `until 60 s;`, or a condition: `until ball.y < 0;`");
    }
    fault_with_help(name, text, suggestion(&name.to_string(), events, "declared events"))
}

pub fn releases_no_row(name: &Ident, what: Option<&str>, rows: &[&str]) -> syn::Error {
    let text = match what {
        Some(what) => format!("`{name}` is {what}, not a constraint"),
        None => format!("constraint `{name}` is not declared"),
    };
    if what == Some("a stop") {
        return fault_with_help(name, text, "declare the stop in an effect, and leave that out of scenes without it");
    }
    fault_with_help(name, text, suggestion(&name.to_string(), rows, "declared constraints"))
}

pub fn two_stops(scene: &Ident, first: &Ident, second: &Ident) -> syn::Error {
    let text = format!("scene `{scene}` has two stops, `{first}` and `{second}`; only one of them can be followed");
    let help = "write both bounds of one quantity as `from a to b`, or declare this stop in an effect that the scene does not call for";
    let fault = fault_with_help(second, text, help);
    fault_at_two_places(fault, first, format_args!("`{first}` is declared here"))
}

pub fn effect_with_name_of_a_group(name: &Ident) -> syn::Error {
    let meaning = match name.to_string().as_str() {
        "model" => "the forces outside of effects",
        "stops" => "the impacts on a stop",
        _ => "the constraints that move with time",
    };
    fault_with_help(
        name,
        format_args!("no effect can be named `{name}`: this is the name of {meaning}"),
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

/// A number of an angle that is more than a turn in radians.
pub fn angle_beyond_a_turn(word: &Ident, name: &str, value: f64) -> Warning {
    Warning {
        span: word.span(),
        name: "angle_beyond_a_turn",
        text: format!("`{name}` starts at {value} rad, more than a turn; if degrees are meant write `{value} deg`"),
    }
}

pub fn parameter_of_unused_effect(name: &Ident, effect: &Ident) -> Warning {
    Warning {
        span: name.span(),
        name: "parameter_of_unused_effect",
        text: format!("no scene calls for effect `{effect}`, so that its parameter `{name}` is never used"),
    }
}
