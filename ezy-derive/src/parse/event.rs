//! `event name: a < b;`, and the same conditions behind `until`

use super::Log;
use super::ast::{Condition, Event, Expr, ItemKind, Relation};
use super::expression::expression;
use super::token::{expected, name, sign, written};
use crate::diag::syntax;
use syn::buffer::Cursor;
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn event(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the event")?;
    sign::<Token![:]>(input)?;
    let begin = input.cursor();
    let left = expression(input)?;
    let condition = condition(begin, left, input)?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Event(Event { name, condition }))
}

/// Whether the sign of a condition follows.
pub fn peek_relation(input: ParseStream) -> bool {
    input.peek(Token![<]) || input.peek(Token![>]) || input.peek(Token![=])
}

/// What stands behind `left`, which was written from `begin` on.
pub fn condition(begin: Cursor, left: Expr, input: ParseStream) -> Result<Condition> {
    let left_text = written(begin, input);
    let (relation, at, word) = match () {
        () if input.peek(Token![<]) => (Relation::Less, input.parse::<Token![<]>()?.span, "<"),
        () if input.peek(Token![>]) => (Relation::Greater, input.parse::<Token![>]>()?.span, ">"),
        () if input.peek(Token![=]) => (Relation::Equal, input.parse::<Token![=]>()?.span, "="),
        () => return Err(expected(input, "`<`, `>` or `=`")),
    };
    if input.peek(Token![=]) {
        return Err(syntax::relation_with_equals(at, word));
    }
    let begin = input.cursor();
    let right = expression(input)?;
    let text = format!("{left_text} {word} {}", written(begin, input));
    Ok(Condition { left, relation, at, right, text })
}
