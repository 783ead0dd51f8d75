//! `param name: unit = value;`, `param name = value;`

use super::Log;
use super::ast::{ItemKind, Parameter};
use super::expression::expression;
use super::token::{expected, name, sign};
use super::unit::unit;
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn parameter(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the parameter")?;
    let unit = if input.peek(Token![:]) {
        input.parse::<Token![:]>()?;
        Some(unit(input)?)
    } else if input.peek(Token![=]) {
        None
    } else {
        return Err(expected(input, "`:` or `=`"));
    };
    sign::<Token![=]>(input)?;
    let begin = input.cursor();
    let value = expression(input)?;
    let mut value_text = String::new();
    let mut cursor = begin;
    while cursor != input.cursor() {
        let Some((tree, rest)) = cursor.token_tree() else { break };
        value_text.push_str(&tree.to_string());
        cursor = rest;
    }
    value_text.retain(|sign| !sign.is_whitespace());
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Parameter(Parameter { name, unit, value, value_text }))
}
