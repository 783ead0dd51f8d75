//! Items of one line: `count`, `param`, `input`, `state`, `output`, `let`, `body`, `point`, `release`, `stop`.

use super::Log;
use super::ast::{Body, Count, Expr, ItemKind, Let, Output, Parameter, Part, Point, Stop};
use super::expression::{expression, indexed};
use super::place::on_body;
use super::token::{braced, comma_or_end, expected, name, sign, take_word, written};
use super::unit::{self, Misplaced, optional_unit};
use crate::diag::syntax;
use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::{Result, Token};

/// `name = 100;`
pub fn count(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the count")?;
    Ok(ItemKind::Count(Count { name, value: equals_value(input)? }))
}

/// `name: unit = value;`, `name = value;`
pub fn parameter(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let parameter = quantity(input, "param", "the name of the parameter")?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Parameter(parameter))
}

/// The same, or with `by acceleration`.
pub fn input(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let mut parameter = quantity(input, "input", "the name of the input")?;
    if take_word(input, "by") {
        if !take_word(input, "acceleration") {
            return Err(expected(input, "`acceleration`"));
        }
        parameter.part = Some(Part::Value);
    }
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Input(parameter))
}

/// `name: unit = value rate expression;`
pub fn state(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let mut state = quantity(input, "state", "the name of the state")?;
    if !take_word(input, "rate") {
        return Err(syntax::state_without_rate(input.span(), &state.name));
    }
    state.rate = Some(expression(input)?);
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Input(state))
}

fn quantity(input: ParseStream, keyword: &str, what: &str) -> Result<Parameter> {
    let name = name(input, what)?;
    let unit = optional_unit(input)?;
    sign::<Token![=]>(input)?;
    if let Some(Misplaced { at, written, unit, value }) = unit::behind_value(input) {
        let behind = if keyword == "state" { " rate …" } else { "" };
        return Err(syntax::value_with_unit(at, keyword, &name, &written, &unit, &format!("{value}{behind}")));
    }
    let begin = input.cursor();
    let value = expression(input)?;
    let value_text = written(begin, input);
    Ok(Parameter { name, unit, value, value_text, part: None, rate: None })
}

/// `name: unit = expression;`, `name = expression;`
pub fn output(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = indexed(input, "the name of the output")?;
    let unit = optional_unit(input)?;
    Ok(ItemKind::Output(Output { name, unit, value: equals_value(input)? }))
}

/// `name = expression;`
pub fn let_value(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the value")?;
    Ok(ItemKind::Let(Let { name, value: equals_value(input)? }))
}

fn equals_value(input: ParseStream) -> Result<Expr> {
    sign::<Token![=]>(input)?;
    let value = expression(input)?;
    sign::<Token![;]>(input)?;
    Ok(value)
}

const FIELDS: [&str; 2] = ["mass", "inertia"];

/// `name { mass: expression, inertia: expression }`
pub fn body(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let body = indexed(input, "the name of the body")?;
    let fields = braced(input)?.inside;
    let mut given: [Option<(Ident, Expr)>; FIELDS.len()] = [None, None];
    while !fields.is_empty() {
        let field = name(&fields, "`mass` or `inertia`")?;
        let Some(i) = FIELDS.iter().position(|known| field == known) else {
            return Err(syntax::unknown_word(&field, "a body", &FIELDS));
        };
        if let Some((first, _)) = &given[i] {
            return Err(syntax::field_twice(&field, first));
        }
        sign::<Token![:]>(&fields)?;
        given[i] = Some((field, expression(&fields)?));
        comma_or_end(&fields, "}")?;
    }
    let [mass, inertia] = given;
    let (_, mass) = mass.ok_or_else(|| syntax::field_missing(&body, "mass"))?;
    let (_, inertia) = inertia.ok_or_else(|| syntax::field_missing(&body, "inertia"))?;
    Ok(ItemKind::Body(Body { name: body, mass, inertia }))
}

/// `name = body(x, y);`
pub fn point(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = indexed(input, "the name of the point")?;
    sign::<Token![=]>(input)?;
    let place = on_body(input, "a point `body(x, y)`")?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Point(Point { name, place }))
}

/// `row;`
pub fn release(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let row = name(input, "the name of a constraint")?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Release(row))
}

/// Of a stop, in the order in which they are written.
const BOUNDS: [&str; 3] = ["from", "to", "restitution"];

/// `name: quantity from a to b restitution e;`
pub fn stop(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the stop")?;
    sign::<Token![:]>(input)?;
    let quantity = expression(input)?;
    let bounds = [behind_word(input, "from")?, behind_word(input, "to")?];
    if bounds.iter().all(Option::is_none) {
        return Err(expected(input, "`from` or `to`"));
    }
    let restitution = behind_word(input, "restitution")?;
    match input.cursor().ident() {
        Some((word, _)) if !BOUNDS.iter().any(|known| word == known) => {
            return Err(syntax::unknown_word(&word, "a stop", &BOUNDS));
        }
        _ if !input.peek(Token![;]) && restitution.is_none() => return Err(expected(input, "`restitution` or `;`")),
        _ => sign::<Token![;]>(input)?,
    };
    Ok(ItemKind::Stop(Stop { name, quantity, bounds, restitution }))
}

/// The expression behind this word, if the word follows.
fn behind_word(input: ParseStream, word: &str) -> Result<Option<Expr>> {
    if take_word(input, word) { expression(input).map(Some) } else { Ok(None) }
}
