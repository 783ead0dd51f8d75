//! Messages about names.

use super::nearest::{quoted, suggestion};
use super::{fault_at_two_places, fault_with_help};
use proc_macro2::{Ident, Span};

fn unknown(name: &Ident, what: &str, known: &[&str], list: &str) -> syn::Error {
    let help = suggestion(&name.to_string(), known, list);
    fault_with_help(name, format_args!("{what} `{name}` is not declared"), help)
}

pub fn of_another_effect(name: &Ident, what: &str, effect: &str) -> syn::Error {
    fault_with_help(
        name,
        format_args!("`{name}` is {what} of effect `{effect}`, and known only there"),
        format_args!("move this into effect `{effect}`, or the declaration of `{name}` out of it"),
    )
}

pub fn unknown_body(name: &Ident, bodies: &[&str]) -> syn::Error {
    unknown(name, "body", bodies, "declared bodies")
}

pub fn unknown_place(name: &Ident, places: &[&str]) -> syn::Error {
    unknown(name, "point", places, "declared points")
}

pub fn unknown_value(name: &Ident, values: &[&str]) -> syn::Error {
    unknown(name, "parameter", values, "declared parameters and values")
}

pub fn unknown_owner(name: &Ident, owners: &[&str]) -> syn::Error {
    unknown(name, "body or point", owners, "declared bodies and points")
}

pub fn unknown_start(name: &Ident, starts: &[&str]) -> syn::Error {
    unknown(name, "start", starts, "declared starts")
}

pub fn unknown_effect(name: &Ident, effects: &[&str]) -> syn::Error {
    unknown(name, "effect", effects, "declared effects")
}

/// `instead`: the unit that is meant, and how many of these the other one is, unless one.
pub fn unknown_unit(name: &Ident, instead: Option<(String, Option<&str>)>, units: &[&str]) -> syn::Error {
    let help = match instead {
        Some((unit, None)) => format!("write `{unit}`"),
        Some((unit, Some(is))) => format!("write the value in `{unit}`: 1 {name} is {is} {unit}"),
        None => suggestion(&name.to_string(), units, "units"),
    };
    fault_with_help(name, format_args!("`{name}` is no known unit"), help)
}

/// `instead`: the same in functions of the language.
pub fn unknown_function(name: &Ident, instead: Option<&str>, functions: &[&str]) -> syn::Error {
    let help = match instead {
        Some(expression) => format!("write `{expression}`"),
        None => suggestion(&name.to_string(), functions, "functions"),
    };
    fault_with_help(name, format_args!("`{name}` is no known function"), help)
}

pub fn unknown_member(member: &Ident, owner: &Ident, what: &str, members: &[&str]) -> syn::Error {
    let help = suggestion(&member.to_string(), members, &format!("members of {what}"));
    fault_with_help(member, format_args!("`{owner}` is {what} and has no member `{member}`"), help)
}

pub fn no_members(member: &Ident, owner: &Ident, what: &str) -> syn::Error {
    fault_with_help(
        member,
        format_args!("`{owner}` is {what} and has no members"),
        format_args!("only bodies, points and hinges have members, such as `body.x`; remove `.{member}`"),
    )
}

pub fn not_a_value(name: &Ident, what: &str, members: &[&str]) -> syn::Error {
    let help = match members.first() {
        Some(first) => format!("write a member, such as `{name}.{first}`; members: {}", quoted(members)),
        None if what == "an output" => {
            "outputs are for whoever runs the scene; write `let` for a value used again".to_owned()
        }
        None => "write a parameter or a number".to_owned(),
    };
    fault_with_help(name, format_args!("`{name}` is {what}, not a value"), help)
}

pub fn not_a_place(name: &Ident, what: &str, carries: bool) -> syn::Error {
    let help = if carries {
        format!("write `{name}(0, 0)` for its origin")
    } else {
        "write the name of a point, or `body(x, y)`".to_owned()
    };
    fault_with_help(name, format_args!("`{name}` is {what}, not a point"), help)
}

pub fn not_a_body(name: &Ident, what: &str) -> syn::Error {
    fault_with_help(name, format_args!("`{name}` is {what}, not a body"), "write the name of a body")
}

pub fn declared_twice(name: &Ident, first_what: &str, first: Span) -> syn::Error {
    let error = fault_with_help(
        name,
        format_args!("`{name}` is declared twice"),
        format_args!("write another name; `{name}` is {first_what} already"),
    );
    fault_at_two_places(error, first, &format!("`{name}` is first declared here"))
}

pub fn reserved(name: &Ident, meaning: &str) -> syn::Error {
    fault_with_help(
        name,
        format_args!("`{name}` is a word of the language: {meaning}"),
        format_args!("write another name, such as `{name}1`"),
    )
}
