//! `stop name: quantity from a to b restitution e;`

use super::Log;
use super::ast::{Expr, ItemKind, Stop};
use super::expression::expression;
use super::token::{expected, name, peek_word, sign, word};
use crate::diag::syntax;
use syn::parse::ParseStream;
use syn::{Result, Token};

/// In the order in which they are written.
const WORDS: [&str; 3] = ["from", "to", "restitution"];

pub fn stop(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the stop")?;
    sign::<Token![:]>(input)?;
    let quantity = expression(input)?;
    let bounds = [setting(input, "from")?, setting(input, "to")?];
    if bounds.iter().all(Option::is_none) {
        return Err(expected(input, "`from` or `to`"));
    }
    let restitution = setting(input, "restitution")?;
    match input.cursor().ident() {
        Some((word, _)) if !WORDS.iter().any(|known| word == known) => {
            return Err(syntax::unknown_word(&word, "a stop", &WORDS));
        }
        _ if !input.peek(Token![;]) && restitution.is_none() => return Err(expected(input, "`restitution` or `;`")),
        _ => sign::<Token![;]>(input)?,
    };
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
