//! `force at place: vector;`, `force at place along body(x, y): scalar;`, the same with `across`

use super::Log;
use super::ast::{Force, ForceDirection, ItemKind};
use super::expression::expression;
use super::place::{on_body, place};
use super::token::{expected, peek_word, sign, word};
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn force(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    word(input, "at")?;
    let at = place(input)?;
    let direction = if input.peek(Token![:]) { None } else { Some(direction(input)?) };
    sign::<Token![:]>(input)?;
    let value = expression(input)?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Force(Force { at, direction, value }))
}

fn direction(input: ParseStream) -> Result<ForceDirection> {
    let across = peek_word(input, "across");
    if !across && !peek_word(input, "along") {
        return Err(expected(input, "`along`, `across` or `:`"));
    }
    word(input, if across { "across" } else { "along" })?;
    Ok(ForceDirection { across, direction: on_body(input, "a direction `body(x, y)`")? })
}
