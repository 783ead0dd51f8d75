//! The items of a model or an effect: one row of a table for each word, and recovery after an error.

use super::ast::{Effect, Item, ItemKind, Loop};
use super::repeat::repeated;
use super::statement::statement;
use super::token::{braced, expected, name, peek_word, skip, take};
use super::{Log, declaration, event, integrated, scene, start};
use crate::diag::syntax;
use crate::grammar::WORDS;
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Expr, ExprLit, Lit, Meta, Result, Token};

/// How an item is written, from behind its word on; rows and forces have their own table.
struct ItemWord {
    word: &'static str,
    example: &'static str,
    /// Where it may stand.
    levels: &'static [Level],
    parse: Parse,
}

type Parse = fn(ParseStream, &mut Log) -> Result<ItemKind>;

/// Where items stand.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Level {
    Model,
    Effect,
    /// In a `for` of the model.
    ForOfModel,
    ForOfEffect,
}

use Level::{Effect as InEffect, ForOfEffect, ForOfModel, Model};

const EVERYWHERE: &[Level] = &[Model, InEffect, ForOfModel, ForOfEffect];

const fn item_word(word: &'static str, example: &'static str, levels: &'static [Level], parse: Parse) -> ItemWord {
    ItemWord { word, example, levels, parse }
}

/// In the order of the manual.
static ITEMS: &[ItemWord] = &[
    item_word("body", "body seat { mass: m1, inertia: i1 }", &[Model, ForOfModel], declaration::body),
    item_word("point", "point A = seat(-a, 0);", &[Model, ForOfModel], declaration::point),
    item_word("effect", "effect pump { torque seat ~ bar: 2*cos(t); }", &[Model], effect),
    item_word("start", start::EXAMPLE, &[Model], start::start),
    item_word("scene", scene::EXAMPLE, &[Model], scene::scene),
    item_word("param", "param a: m = 0.2;", &[Model, InEffect], declaration::parameter),
    item_word("input", "input torque: N*m = 0;", &[Model, InEffect], declaration::input),
    item_word("state", "state current: A = 0 rate (u - R*current)/L;", &[Model, InEffect], declaration::state),
    item_word("output", "output speed: m/s = norm(seat.v);", EVERYWHERE, declaration::output),
    item_word("let", "let speed = norm(seat.v);", &[Model, InEffect], declaration::let_value),
    item_word("event", "event landing: ball.y < 0;", &[Model, InEffect], event::event),
    item_word("stop", "stop limit: B.angle from -1 to 1 restitution 0.5;", &[Model, InEffect], declaration::stop),
    item_word("release", "release rear;", &[Model, InEffect], declaration::release),
    item_word("count", "count n = 100;", &[Model], declaration::count),
];

impl Level {
    /// In a message.
    const fn place(self) -> &'static str {
        match self {
            Model => "a model",
            InEffect => "an effect",
            ForOfModel | ForOfEffect => "a `for`",
        }
    }

    fn items(self) -> impl Iterator<Item = &'static ItemWord> {
        ITEMS.iter().filter(move |item| item.levels.contains(&self))
    }

    /// Every word of the level, in the order of the manual.
    pub fn words(self) -> Vec<&'static str> {
        let items = self.items().map(|item| item.word);
        items.chain(WORDS.iter().map(|row| row.word)).chain(["for"]).collect()
    }

    /// The inside of a `for` at this level.
    const fn repeated(self) -> Self {
        match self {
            Model | ForOfModel => ForOfModel,
            InEffect | ForOfEffect => ForOfEffect,
        }
    }
}

/// Reads items to the end of the brackets, inside the `for` of `loops`. After a fault it goes on with the next item.
pub fn items(input: ParseStream, level: Level, loops: &[Loop], items: &mut Vec<Item>, log: &mut Log) {
    while !input.is_empty() {
        if take::<Token![;]>(input) {
            continue; // an empty item, as in Rust
        }
        let begin = input.fork();
        let outcome = if peek_word(input, "for") {
            repeated(input, loops, log, |inside, loops, log| {
                self::items(inside, level.repeated(), loops, items, log);
                Ok(())
            })
        } else {
            item(input, level, loops, log).map(|item| {
                let parts = integrated::parts(&item);
                items.push(item);
                items.extend(parts);
            })
        };
        match outcome {
            Ok(()) => {}
            Err(error) => {
                log.diag.error(error);
                log.broken.extend(item_name(&begin.fork()));
                skip_to_next_item(input, &begin, level);
            }
        }
    }
}

/// `effect name { param …; let …; release …; rows and forces }`
fn effect(input: ParseStream, log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the effect")?;
    let inside = braced(input)?.inside;
    let mut effect = Effect { name, items: Vec::new() };
    items(&inside, InEffect, &[], &mut effect.items, log);
    Ok(ItemKind::Effect(effect))
}

fn item(input: ParseStream, level: Level, loops: &[Loop], log: &mut Log) -> Result<Item> {
    let begin = input.span();
    let documentation = documentation(input)?;
    if input.is_empty() {
        return Err(syntax::documents_nothing(begin));
    }
    let Some((word, _)) = input.cursor().ident() else { return Err(expected(input, "an item")) };
    let (name, example, kind) = if let Some(item) = level.items().find(|item| word == item.word) {
        input.call(Ident::parse_any)?;
        (item.word, item.example, (item.parse)(input, log))
    } else if let Some(found) = WORDS.iter().find(|known| is_next(input, known.word)) {
        let keyword = keyword(input, found.word)?;
        (found.word, found.example, statement(input, found, keyword))
    } else {
        let elsewhere = ITEMS.iter().any(|item| word == item.word);
        let fault = if elsewhere { syntax::word_of_a_model } else { syntax::unknown_word };
        return Err(fault(&word, level.place(), &level.words()));
    };
    let kind = kind.map_err(|error| syntax::with_example(error, name, example))?;
    Ok(Item { documentation, loops: loops.to_vec(), kind })
}

/// Whether the next tokens are this word, or these words with or without hyphens.
fn is_next(input: ParseStream, words: &str) -> bool {
    let mut cursor = input.cursor();
    words.split(' ').enumerate().all(|(i, word)| {
        let hyphen = cursor.punct().filter(|(sign, _)| i > 0 && sign.as_char() == '-');
        let begin = hyphen.map_or(cursor, |(_, rest)| rest);
        match begin.ident() {
            Some((found, rest)) if found == word => {
                cursor = rest;
                true
            }
            _ => false,
        }
    })
}

/// Takes these words; the last of them stands for all.
fn keyword(input: ParseStream, words: &str) -> Result<Ident> {
    let mut last = input.call(Ident::parse_any)?;
    for _ in words.split(' ').skip(1) {
        input.parse::<Option<Token![-]>>()?;
        last = input.call(Ident::parse_any)?;
    }
    Ok(last)
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

/// Skips to behind the `;` or `}` of a faulty item, or to the word of the next one; what stands behind `else` belongs to it.
fn skip_to_next_item(input: ParseStream, begin: ParseStream, level: Level) {
    while !input.is_empty() {
        let at_begin = input.cursor() == begin.cursor();
        if !at_begin && begins_item(input, level) {
            return;
        }
        let last = input.peek(Token![;]) || input.peek(syn::token::Brace);
        if !skip(input) || last && !input.peek(Token![else]) {
            return;
        }
    }
}

/// A word of the table and a name: words alone may be names.
fn begins_item(input: ParseStream, level: Level) -> bool {
    let named = input.cursor().ident().is_some_and(|(_, behind)| behind.ident().is_some());
    named && level.words().iter().any(|known| is_next(input, known))
}
