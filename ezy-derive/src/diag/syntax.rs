//! Messages of the parser.

use super::nearest::meaning_or_suggestion;
use super::{Extent, elsewhere, fault, fault_with_help};
use proc_macro2::{Ident, Span};

/// The next token is not what the grammar expects.
pub fn expected(at: Span, what: &str, found: &str) -> syn::Error {
    match elsewhere::sign(what, found) {
        Some(help) => fault_with_help(at, format_args!("expected {what}, found {found}"), help),
        None => fault(at, format_args!("expected {what}, found {found}")),
    }
}

/// `error` with the way the item is written, unless it has its own help.
pub fn with_example(error: syn::Error, keyword: &str, example: &str) -> syn::Error {
    if error.to_string().contains("help:") {
        return error;
    }
    fault_with_help(error.span(), &error, format_args!("`{keyword}` is written `{example}`"))
}

messages! {
    no_model(at: Span):
        "there is no model here", "write `pub model Name {{ … }}`";

    text_after_model(at: Span, found: &str):
        "{found} stands after the model's closing brace",
        "put it inside the braces; each `model!` holds one model";

    foreign_attribute(at: Span):
        "a model takes no attribute but documentation", "write `/// …`, or remove the attribute";

    documents_nothing(at: Span):
        "this documentation stands before no item", "write `//` for a remark";

    raw_name(at: Span, name: &str):
        "`{name}` is a raw identifier", "write a name without `r#`";

    power_of_other_languages(at: Span):
        "`**` is no operator", "write `^` for a power, such as `x^2`";

    /// A name behind a number, or a suffix of Rust.
    number_with_suffix(at: Span, digits: &str, suffix: &str, instead: &str):
        "the number `{digits}{suffix}` has a suffix",
        "write `{instead}`";

    number_joined_with_unit(at: Span, digits: &str, suffix: &str):
        "the number `{digits}{suffix}` has a suffix",
        "write `{digits} {suffix}`, with a blank before the unit";

    function_without_brackets(at: &Ident):
        "`{at}` is a function", "write its argument in brackets: `{at}(…)`";

    product_without_sign(at: Span, number: &str, factor: &str):
        "expected an operator, found {factor}", "write `*` between the factors: `{number} * …`";

    member_of_member(at: &Ident, written: &str, instead: &str):
        "`{written}` has no member `{at}`", "{instead}";

    equals_for_value(at: Span):
        "expected a value, found `=`", "leave this `=` out: an equation is `left = right`, and settings have none";

    expression_too_large(at: Span, limit: usize):
        "this expression has more than {limit} parts",
        "name some of its parts with `let name = …;`";

    brackets_too_deep(at: Span, limit: usize):
        "these brackets are nested more than {limit} deep",
        "name some of the parts with `let name = …;`";

    state_without_rate(at: Span, name: &Ident):
        "state `{name}` has no rate",
        "a state needs the equation of its rate: `state current: A = 0 rate (u - R*current)/L;`";

    field_missing(body: &Ident, field: &str):
        "body `{body}` has no {field}", "write `body {body} {{ mass: …, inertia: … }}`";

    bare_vector_component(at: impl Into<Extent>):
        "a vector has two components", "write `(x, y)`";

    third_component(at: Span):
        "a vector has two components, but a third one follows", "write `(x, y)`; decimals have a point, such as `0.5`";

    no_body_before_bracket(at: Span, what: &str):
        "expected {what}, found `(`",
        "write a body in front of it: `ground` for what does not move, or the one whose axes are meant";

    end_of_range(at: Span):
        "expected the end of the range, found `=`", "write `a..b`: the last index is b - 1";

    no_end(found: &Ident, statement: &str):
        "the `{statement}` before this `{found}` has no end", "write `;` behind it";

    empty_start_statement(body: &Ident):
        "nothing is given for `{body}`", "write `{body} at (0, 0) angle 0;` or remove `{body}`";

    body_at_rest(at: Span, body: &Ident):
        "`rest` is said of all bodies at once, not of `{body}` alone",
        "write `at rest;`, or `{body} velocity (0, 0) rate 0;`";

    second_relation(at: Span, found: &str):
        "a condition has two sides, but {found} begins a third one",
        "write a condition for each bound, since what counts is the passage of one";

    joined_conditions(at: Span, found: &str):
        "conditions are not joined, but {found} stands behind one",
        "write an `event` or an `until` for each; the first `until` that comes true ends the scene";

    until_without_unit(at: impl Into<Extent>):
        "the time after `until` has no unit", "write it with a unit, such as `until 60 s;`";

    field_twice(field: &Ident, first: &Ident):
        "`{field}` is given twice", "remove one of them", first: "first given here";

    statement_twice(word: &Ident, first: &Ident, scene: &Ident):
        "scene `{scene}` says `{word}` twice", "remove one of them", first: "first said here";
}

pub fn unknown_word(word: &Ident, place: &str, words: &[&str]) -> syn::Error {
    let table = match place {
        "a model" | "an effect" | "a `for`" => elsewhere::ITEMS,
        "a body" => elsewhere::BODY,
        "a start" => elsewhere::START,
        "a scene" => elsewhere::SCENE,
        _ => &[],
    };
    fault_with_help(
        word,
        format_args!("`{word}` is no word of {place}"),
        meaning_or_suggestion(table, &word.to_string(), words, &format!("words of {place}")),
    )
}

/// A setting that a constraint or a force has not, `place`; the message for its `;`, unless the word is known elsewhere.
pub fn no_setting_behind(word: &Ident, place: &str) -> syn::Error {
    let text = word.to_string();
    match elsewhere::meaning(elsewhere::BEHIND, &text) {
        Some(help) => fault_with_help(word, format_args!("{place} has no `{word}`"), help),
        None => expected(word.span(), "`;`", &format!("`{word}`")),
    }
}

pub fn no_conditions(at: Span, word: &str) -> syn::Error {
    fault_with_help(at, format_args!("expressions know no {word}"), elsewhere::CHOICES)
}

/// A word of a model that stands in an effect or a `for`.
pub fn word_of_a_model(word: &Ident, place: &str, words: &[&str]) -> syn::Error {
    fault_with_help(
        word,
        format_args!("`{word}` is no word of {place}"),
        format_args!("move it out of there; words of {place}: {}", super::nearest::quoted(words)),
    )
}

pub fn keyword_as_name(at: Span, name: &str) -> syn::Error {
    let better = format!("{}_", name.trim_start_matches("r#"));
    fault_with_help(
        at,
        format_args!("`{name}` is a word of Rust and cannot be a name"),
        format_args!("write another name, such as `{better}`"),
    )
}

/// A unit behind the value of a declaration.
pub fn value_with_unit(at: Span, keyword: &str, name: &Ident, written: &str, unit: &str, value: &str) -> syn::Error {
    let help = format!("write `{keyword} {name}: {unit} = {value};`");
    fault_with_help(at, format_args!("the unit `{written}` stands behind the value of `{name}`"), help)
}

/// A unit that the language does not know behind a number.
pub fn other_unit(at: Span, written: &str, unit: &str, value: &str) -> syn::Error {
    let unit = if unit.contains(['*', '/']) { format!("({unit})") } else { unit.to_owned() };
    fault_with_help(at, format_args!("`{written}` is no unit"), format_args!("write `{value} {unit}`"))
}

pub fn number_too_large(at: Span, text: &str) -> syn::Error {
    fault_with_help(
        at,
        format_args!("`{text}` is too large for a number of double precision"),
        format_args!("write a number below {:e}", f64::MAX),
    )
}

pub fn no_setting(at: Span, place: &str, settings: &[&str]) -> syn::Error {
    fault(at, format_args!("{place} needs one of {}", super::nearest::quoted(settings)))
}

pub fn setting_missing(at: Span, setting: &str, place: &str) -> syn::Error {
    fault(at, format_args!("{place} needs its `{setting}`"))
}

pub fn relation_with_equals(at: Span, word: &str) -> syn::Error {
    let text = if word == "=" {
        "`==` is written `=` here".to_owned()
    } else {
        format!("`{word}=` is written `{word}` here: what counts is the passage from one side to the other")
    };
    fault_with_help(at, text, format_args!("write `{word}`"))
}
