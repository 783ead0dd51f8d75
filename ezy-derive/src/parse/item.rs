//! The items of a model or an effect: one row of a table for each word, and recovery after an error.

use super::ast::{Effect, Item, ItemKind, Loop};
use super::statement::statement;
use super::token::{braced, expected, name, peek_word, skip};
use super::{Log, body, event, let_value, output, parameter, point, release, repeat, scene, start, stop};
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
    parse: fn(ParseStream, &mut Log) -> Result<ItemKind>,
}

/// Where items stand.
#[derive(Clone, Copy)]
pub struct Level {
    place: &'static str,
    items: &'static [ItemWord],
    /// What can stand in a `for`, besides rows and forces.
    in_for: &'static [ItemWord],
}

/// The items of a model.
pub const MODEL: Level = Level {
    place: "a model",
    items: &[BODY, POINT, EFFECT_ITEM, START, SCENE, PARAM, INPUT, OUTPUT, LET, EVENT, STOP, RELEASE, COUNT],
    in_for: &[POINT, OUTPUT],
};
/// The items of an effect.
const EFFECT: Level =
    Level { place: "an effect", items: &[PARAM, INPUT, OUTPUT, LET, EVENT, STOP, RELEASE], in_for: &[OUTPUT] };

const BODY: ItemWord = ItemWord { word: "body", example: "body seat { mass: m1, inertia: i1 }", parse: body::body };
const POINT: ItemWord = ItemWord { word: "point", example: "point A = seat(-a, 0);", parse: point::point };
const EFFECT_ITEM: ItemWord =
    ItemWord { word: "effect", example: "effect pump { torque seat ~ bar: 2*cos(t); }", parse: effect };
const START: ItemWord =
    ItemWord { word: "start", example: "start folded { seat at (0, 0) angle 0; at rest; }", parse: start::start };
const SCENE: ItemWord =
    ItemWord { word: "scene", example: "scene driven { start folded; until 60 s; with pump; }", parse: scene::scene };
const PARAM: ItemWord = ItemWord { word: "param", example: "param a: m = 0.2;", parse: parameter::parameter };
const INPUT: ItemWord = ItemWord { word: "input", example: "input torque: N*m = 0;", parse: parameter::input };
const OUTPUT: ItemWord =
    ItemWord { word: "output", example: "output speed: m/s = norm(seat.v);", parse: output::output };
const LET: ItemWord = ItemWord { word: "let", example: "let speed = norm(seat.v);", parse: let_value::let_value };
const EVENT: ItemWord = ItemWord { word: "event", example: "event landing: ball.y < 0;", parse: event::event };
const STOP: ItemWord =
    ItemWord { word: "stop", example: "stop limit: B.angle from -1 to 1 restitution 0.5;", parse: stop::stop };
const RELEASE: ItemWord = ItemWord { word: "release", example: "release rear;", parse: release::release };
const COUNT: ItemWord = ItemWord { word: "count", example: "count n = 100;", parse: repeat::count };

impl Level {
    /// Every word of the level, in the order of the manual.
    fn words(self) -> Vec<&'static str> {
        let items = self.items.iter().map(|item| item.word);
        items.chain(WORDS.iter().map(|row| row.word)).chain(["for"]).collect()
    }

    /// The inside of a `for` at this level.
    const fn repeated(self) -> Self {
        Self { place: "a `for`", items: self.in_for, in_for: self.in_for }
    }
}

/// Reads items to the end of the brackets, inside the `for` of `loops`. After a fault it goes on with the next item.
pub fn items(input: ParseStream, level: Level, loops: &[Loop], items: &mut Vec<Item>, log: &mut Log) {
    while !input.is_empty() {
        if input.peek(Token![;]) {
            input.parse::<Token![;]>().ok(); // an empty item, as in Rust
            continue;
        }
        let begin = input.fork();
        let outcome = if peek_word(input, "for") {
            repeated(input, level, loops, items, log)
        } else {
            item(input, level, loops, log).map(|item| items.push(item))
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
    items(&inside, EFFECT, &[], &mut effect.items, log);
    Ok(ItemKind::Effect(effect))
}

/// `for i in a..b { … }`: its items, each with the `for` around it.
fn repeated(input: ParseStream, level: Level, outer: &[Loop], items: &mut Vec<Item>, log: &mut Log) -> Result<()> {
    let range = repeat::range(input, outer)?;
    let inside = braced(input)?.inside;
    log.loops.push((range.clone(), outer.to_vec()));
    self::items(&inside, level.repeated(), &[outer, &[range]].concat(), items, log);
    Ok(())
}

fn item(input: ParseStream, level: Level, loops: &[Loop], log: &mut Log) -> Result<Item> {
    let begin = input.span();
    let documentation = documentation(input)?;
    if input.is_empty() {
        return Err(syntax::documents_nothing(begin));
    }
    let Some((word, _)) = input.cursor().ident() else { return Err(expected(input, "an item")) };
    let (name, example, kind) = if let Some(item) = level.items.iter().find(|item| word == item.word) {
        input.call(Ident::parse_any)?;
        (item.word, item.example, (item.parse)(input, log))
    } else if let Some(found) = WORDS.iter().find(|known| is_next(input, known.word)) {
        let keyword = keyword(input, found.word)?;
        (found.word, found.example, statement(input, found, keyword))
    } else {
        let elsewhere = MODEL.items.iter().any(|item| word == item.word);
        let fault = if elsewhere { syntax::word_of_a_model } else { syntax::unknown_word };
        return Err(fault(&word, level.place, &level.words()));
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
