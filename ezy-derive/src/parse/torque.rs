//! `torque body: expression;`, `torque body ~ body: expression;`

use super::Log;
use super::ast::{ItemKind, Torque};
use super::expression::expression;
use super::token::{expected, name, sign};
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn torque(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let on = name(input, "the name of a body")?;
    let from = if input.peek(Token![~]) {
        input.parse::<Token![~]>()?;
        Some(name(input, "the name of a body")?)
    } else if input.peek(Token![:]) {
        None
    } else {
        return Err(expected(input, "`~` or `:`"));
    };
    sign::<Token![:]>(input)?;
    let value = expression(input)?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Torque(Torque { on, from, value }))
}
