//! `stop name: quantity from a to b restitution e;`

use super::Log;
use super::ast::{Expr, ItemKind, Stop};
use super::expression::expression;
use super::token::{expected, name, peek_word, sign, word};
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn stop(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the stop")?;
    sign::<Token![:]>(input)?;
    let quantity = expression(input)?;
    let bounds = [setting(input, "from")?, setting(input, "to")?];
    if bounds.iter().all(Option::is_none) {
        return Err(expected(input, "`from` or `to`"));
    }
    let restitution = setting(input, "restitution")?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Stop(Stop { name, quantity, bounds, restitution }))
}

/// `word expression`, where the word follows.
fn setting(input: ParseStream, known: &str) -> Result<Option<Expr>> {
    if !peek_word(input, known) {
        return Ok(None);
    }
    word(input, known)?;
    expression(input).map(Some)
}
