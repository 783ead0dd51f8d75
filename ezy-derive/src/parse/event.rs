//! `event name: a < b;`, and the same conditions behind `until`

use super::Log;
use super::ast::{Condition, Event, Expr, ItemKind, Relation};
use super::expression::expression;
use super::token::{expected, found, name, peek_word, sign, take_one_of, written};
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
    let relations = [('<', Relation::Less), ('>', Relation::Greater), ('=', Relation::Equal)];
    let Some((relation, at)) = take_one_of(input, &relations) else { return Err(expected(input, "`<`, `>` or `=`")) };
    let sign = relation.sign();
    if input.peek(Token![=]) {
        return Err(syntax::relation_with_equals(at, sign));
    }
    let begin = input.cursor();
    let right = expression(input)?;
    let text = format!("{left_text} {sign} {}", written(begin, input));
    if peek_relation(input) {
        return Err(syntax::second_relation(input.span(), &found(input)));
    }
    if input.peek(Token![&]) || input.peek(Token![|]) || peek_word(input, "and") || peek_word(input, "or") {
        return Err(syntax::joined_conditions(input.span(), &found(input)));
    }
    Ok(Condition { left, relation, at, right, text })
}
