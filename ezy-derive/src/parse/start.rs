//! `start name { body at (x, y) angle e velocity (vx, vy) rate w; body near angle e; …; at rest; }`

use super::Log;
use super::ast::{Expr, Given, GivenValues, ItemKind, Loop, Name, Quantity, Start};
use super::expression::{expression, indexed};
use super::place::pair;
use super::repeat::repeated;
use super::token::{braced, expected, name, peek_number, peek_word, sign, skip_statement, take, take_word, word};
use crate::diag::elsewhere::{START, meaning};
use crate::diag::nearest::nearest;
use crate::diag::syntax;
use proc_macro2::{Delimiter, Ident};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Result, Token};

/// The words that give a quantity of a body.
const QUANTITIES: [(&str, Quantity); 8] = [
    ("at", Quantity::Position),
    ("angle", Quantity::Angle),
    ("velocity", Quantity::Velocity),
    ("rate", Quantity::Rate),
    ("x", Quantity::X),
    ("y", Quantity::Y),
    ("vx", Quantity::VelocityX),
    ("vy", Quantity::VelocityY),
];

pub const EXAMPLE: &str = "start folded { seat at (0, 0) angle 0; at rest; }";

pub fn start(input: ParseStream, log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the start")?;
    let inside = braced(input)?.inside;
    let mut start = Start { name, given: Vec::new(), at_rest: None };
    statements(&inside, &mut start, &[], log);
    Ok(ItemKind::Start(start))
}

fn statements(inside: ParseStream, start: &mut Start, outer: &[Loop], log: &mut Log) {
    while !inside.is_empty() {
        let outcome = if peek_word(inside, "for") {
            repeated(inside, outer, log, |inside, loops, log| {
                statements(inside, start, loops, log);
                Ok(())
            })
        } else {
            statement(inside, start, outer).map_err(|error| syntax::with_example(error, "start", EXAMPLE))
        };
        if let Err(error) = outcome {
            log.diag.error(error);
            skip_statement(inside);
        }
    }
}

fn statement(input: ParseStream, start: &mut Start, loops: &[Loop]) -> Result<()> {
    if peek_word(input, "at") && input.peek2(Ident::peek_any) && is_at_rest(&input.fork()) {
        word(input, "at")?;
        start.at_rest = Some(word(input, "rest")?);
        sign::<Token![;]>(input)?;
        return Ok(());
    }
    let body = indexed(input, "the name of a body, or `at rest`")?;
    if input.peek(Token![;]) {
        return Err(syntax::empty_start_statement(&body));
    }
    let near = take_word(input, "near");
    let first = start.given.len();
    while !input.peek(Token![;]) {
        let given = given(input, &body, loops, start.given.len() == first)?;
        start.given.push(Given { near, ..given });
    }
    sign::<Token![;]>(input).map(|_| ())
}

fn is_at_rest(fork: ParseStream) -> bool {
    fork.call(Ident::parse_any).is_ok() && peek_word(fork, "rest")
}

fn given(input: ParseStream, body: &Name, loops: &[Loop], first: bool) -> Result<Given> {
    let Some((word, _)) = input.cursor().ident() else { return Err(expected(input, "a quantity or `;`")) };
    let Some((_, quantity)) = QUANTITIES.iter().find(|(known, _)| word == known) else {
        let words: Vec<&str> = QUANTITIES.iter().map(|(known, _)| *known).collect();
        let text = word.to_string();
        if !first && meaning(START, &text).is_none() && nearest(&text, &words).is_none() {
            return Err(expected(input, "a quantity or `;`"));
        }
        return Err(syntax::unknown_word(&word, "a start", &words));
    };
    input.call(Ident::parse_any)?;
    if *quantity == Quantity::Position && peek_word(input, "rest") {
        return Err(syntax::body_at_rest(input.span(), body));
    }
    let values = match quantity {
        Quantity::Position | Quantity::Velocity if is_pair(input) => {
            let (x, y) = pair(input, free_or_value)?;
            GivenValues::Each(vec![x, y])
        }
        Quantity::Position | Quantity::Velocity => GivenValues::Vector(expression(input)?),
        _ => GivenValues::Each(vec![Some(expression(input)?)]),
    };
    Ok(Given { loops: loops.to_vec(), body: body.clone(), near: false, quantity: *quantity, word, values })
}

/// Whether brackets alone follow, and not a longer expression such as `(1, 2) * k`.
fn is_pair(input: ParseStream) -> bool {
    let Some((_, _, behind)) = input.cursor().group(Delimiter::Parenthesis) else {
        let is_value = |(word, _): (Ident, _)| QUANTITIES.iter().all(|(known, _)| word != known);
        return !(peek_number(input) || input.peek(Token![-]) || input.cursor().ident().is_some_and(is_value));
    };
    behind.punct().is_none_or(|(sign, _)| sign.as_char() == ';')
}

/// `_` leaves a component free.
fn free_or_value(input: ParseStream) -> Result<Option<Expr>> {
    if take::<Token![_]>(input) { Ok(None) } else { expression(input).map(Some) }
}
