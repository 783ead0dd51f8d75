//! The items of a model or an effect: one row of a table for each word, and what is skipped after a fault.

use super::ast::{Item, ItemKind};
use super::token::{expected, skip};
use super::{Log, body, effect, force, hinge, let_value, parameter, point, scene, skate, start, torque};
use crate::diag::syntax;
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Expr, ExprLit, Lit, Meta, Result, Token};

/// How an item is written, from behind its word on.
pub struct Word {
    word: &'static str,
    example: &'static str,
    parse: fn(ParseStream, &mut Log) -> Result<ItemKind>,
}

/// Where items stand.
#[derive(Clone, Copy)]
pub struct Level {
    place: &'static str,
    words: &'static [Word],
}

/// The items of a model.
pub const MODEL: Level = Level { place: "a model", words: &WORDS };
/// The items of an effect: the first ones of the table.
pub const EFFECT: Level = Level { place: "an effect", words: WORDS.split_at(N_EFFECT_WORDS).0 };

const N_EFFECT_WORDS: usize = 4;

const WORDS: [Word; 11] = [
    Word { word: "param", example: "param a: m = 0.2;", parse: parameter::parameter },
    Word { word: "let", example: "let speed = norm(seat.v);", parse: let_value::let_value },
    Word { word: "torque", example: "torque seat ~ bar: m0 * cos(omega*t);", parse: torque::torque },
    Word { word: "force", example: "force at A: -k * A.v;", parse: force::force },
    Word { word: "body", example: "body seat { mass: m1, inertia: i1 }", parse: body::body },
    Word { word: "point", example: "point A = seat(-a, 0);", parse: point::point },
    Word { word: "hinge", example: "hinge B: seat(b, 0) ~ bar(-d, 0);", parse: hinge::hinge },
    Word { word: "skate", example: "skate rear: at A along seat(1, 0);", parse: skate::skate },
    Word { word: "effect", example: "effect pump { torque seat ~ bar: 2*cos(t); }", parse: effect::effect },
    Word { word: "start", example: "start folded { seat at (0, 0) angle 0; at rest; }", parse: start::start },
    Word { word: "scene", example: "scene driven { start folded; until 60 s; with pump; }", parse: scene::scene },
];

/// Reads items to the end of the brackets. After a fault it goes on with the next item.
pub fn items(input: ParseStream, level: Level, items: &mut Vec<Item>, log: &mut Log) {
    while !input.is_empty() {
        if input.peek(Token![;]) {
            input.parse::<Token![;]>().ok(); // an empty item, as in Rust
            continue;
        }
        let begin = input.fork();
        match item(input, level, log) {
            Ok(item) => items.push(item),
            Err(error) => {
                log.diag.error(error);
                log.broken.extend(item_name(&begin));
                skip_to_next_item(input, &begin, level);
            }
        }
    }
}

fn item(input: ParseStream, level: Level, log: &mut Log) -> Result<Item> {
    let begin = input.span();
    let documentation = documentation(input)?;
    if input.is_empty() {
        return Err(syntax::documents_nothing(begin));
    }
    let Some((word, _)) = input.cursor().ident() else { return Err(expected(input, "an item")) };
    let Some(row) = level.words.iter().find(|row| word == row.word) else {
        let words: Vec<&str> = level.words.iter().map(|row| row.word).collect();
        return Err(syntax::unknown_word(&word, level.place, &words));
    };
    input.call(Ident::parse_any)?;
    let kind = (row.parse)(input, log).map_err(|error| syntax::with_example(error, row.word, row.example))?;
    Ok(Item { documentation, kind })
}

/// The doc comments before an item, one line each.
pub fn documentation(input: ParseStream) -> Result<String> {
    let mut lines = Vec::new();
    for attribute in input.call(syn::Attribute::parse_outer)? {
        let at = attribute.pound_token.span;
        let Meta::NameValue(pair) = &attribute.meta else { return Err(syntax::foreign_attribute(at)) };
        let text = match &pair.value {
            Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) if pair.path.is_ident("doc") => text.value(),
            _ => return Err(syntax::foreign_attribute(at)),
        };
        lines.push(text.strip_prefix(' ').unwrap_or(&text).trim_end().to_owned());
    }
    Ok(lines.join("\n"))
}

/// The name behind the word of an item that could not be parsed.
fn item_name(begin: ParseStream) -> Option<Ident> {
    documentation(begin).ok()?;
    begin.call(Ident::parse_any).ok()?;
    begin.call(Ident::parse_any).ok()
}

/// Skips to behind the `;` or `}` of a faulty item, or to the word of the next one.
fn skip_to_next_item(input: ParseStream, begin: ParseStream, level: Level) {
    while !input.is_empty() {
        let at_begin = input.cursor() == begin.cursor();
        if !at_begin && begins_item(input, level) {
            return;
        }
        let last = input.peek(Token![;]) || input.peek(syn::token::Brace);
        if !skip(input) || last {
            return;
        }
    }
}

/// A word of the table and a name: words alone may be names.
fn begins_item(input: ParseStream, level: Level) -> bool {
    let Some((word, behind)) = input.cursor().ident() else { return false };
    behind.ident().is_some() && level.words.iter().any(|row| word == row.word)
}
