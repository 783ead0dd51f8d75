//! Messages about names.

use super::elsewhere::{self, meaning};
use super::fault_with_help;
use super::nearest::{meaning_or_suggestion, nearest, quoted};
use crate::function::FUNCTIONS;
use proc_macro2::{Ident, Span};

/// What a name could be, and what those that are declared are called.
pub type Kind = (&'static str, &'static str);

pub const BODY: Kind = ("body", "declared bodies");
pub const POINT: Kind = ("point", "declared points");
pub const VALUE: Kind = ("parameter", "declared parameters and values");
pub const OWNER: Kind = ("body or point", "declared bodies and points");
pub const START: Kind = ("start", "declared starts");
pub const EFFECT: Kind = ("effect", "declared effects");

pub fn unknown(name: &Ident, (what, list): Kind, known: &[&str]) -> syn::Error {
    let table = if [VALUE.1, OWNER.1].contains(&list) { elsewhere::VALUES } else { &[] };
    let text = name.to_string();
    let help = match (meaning(table, &text), nearest(&text, known)) {
        (Some(meaning), Some(similar)) => format!("{meaning}; or did you mean `{similar}`?"),
        _ => meaning_or_suggestion(table, &text, known, list),
    };
    fault_with_help(name, format_args!("{what} `{name}` is not declared"), help)
}

/// Whether one of the candidates may be meant.
pub fn is_similar(name: &Ident, candidates: &[&str]) -> bool {
    nearest(&name.to_string(), candidates).is_some()
}

messages! {
    of_another_effect(name: &Ident, what: &str, effect: &str):
        "`{name}` is {what} of effect `{effect}`, and known only there",
        "move this into effect `{effect}`, or the declaration of `{name}` out of it";

    not_a_body(name: &Ident, what: &str):
        "`{name}` is {what}, not a body", "write the name of a body";

    reserved(name: &Ident, meaning: &str):
        "`{name}` is a word of the language: {meaning}", "write another name, such as `{name}1`";

    declared_twice(name: &Ident, first_what: &str, first: Span):
        "`{name}` is declared twice",
        "write another name; `{name}` is {first_what} already", first: "`{name}` is first declared here";
}

pub fn no_members(member: &Ident, owner: &Ident, what: &str) -> syn::Error {
    let help = match meaning(elsewhere::OF_CONSTRAINTS, &member.to_string()) {
        Some(help) => help.to_owned(),
        None => format!("only bodies, points and hinges have members, such as `body.x`; remove `.{member}`"),
    };
    fault_with_help(member, format_args!("`{owner}` is {what} and has no members"), help)
}

/// `instead`: the unit that is meant, and how many of these the other one is, unless one.
pub fn unknown_unit(name: &Ident, instead: Option<(String, Option<&str>)>, units: &[&str]) -> syn::Error {
    let help = match instead {
        Some((unit, None)) => format!("write `{unit}`"),
        Some((unit, Some(is))) => format!("write the value in `{unit}`: 1 {name} is {is} {unit}"),
        None => meaning_or_suggestion(elsewhere::UNITS, &name.to_string(), units, "units"),
    };
    fault_with_help(name, format_args!("`{name}` is no known unit"), help)
}

pub fn unknown_function(name: &Ident) -> syn::Error {
    let help = meaning_or_suggestion(elsewhere::FUNCTIONS, &name.to_string(), &FUNCTIONS, "functions");
    fault_with_help(name, format_args!("`{name}` is no known function"), help)
}

pub fn unknown_member(member: &Ident, owner: &Ident, what: &str, members: &[&str]) -> syn::Error {
    let (name, list) = (member.to_string(), format!("members of {what}"));
    let reaction = meaning(elsewhere::OF_CONSTRAINTS, &name).filter(|_| what.contains("hinge"));
    let help = reaction.map_or_else(|| meaning_or_suggestion(elsewhere::MEMBERS, &name, members, &list), str::to_owned);
    fault_with_help(member, format_args!("`{owner}` is {what} and has no member `{member}`"), help)
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

/// `indexed` when square brackets follow.
pub fn not_a_place(name: &Ident, what: &str, carries: bool, indexed: bool) -> syn::Error {
    let help = if carries && indexed {
        format!("write round brackets for a point on it, such as `{name}(0, 0)`")
    } else if carries {
        format!("write `{name}(0, 0)` for its origin")
    } else {
        "write the name of a point, or `body(x, y)`".to_owned()
    };
    fault_with_help(name, format_args!("`{name}` is {what}, not a point"), help)
}
