//! `scene name { start name; until 60 s; until ball.y < 0; with effect, effect; }`

use super::Log;
use super::ast::{Duration, End, Expr, ItemKind, Scene};
use super::event::{condition, peek_relation};
use super::expression::expression_before_unit;
use super::token::{braced, expected, name, sign, skip_statement, take};
use crate::diag::syntax;
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Result, Token};

const WORDS: [&str; 3] = ["start", "until", "with"];

pub const EXAMPLE: &str = "scene driven { start folded; until 60 s; with pump; }";

pub fn scene(input: ParseStream, log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the scene")?;
    let inside = braced(input)?.inside;
    let mut scene = Scene { name, start: None, until: None, ends: Vec::new(), effects: Vec::new(), broken: false };
    let mut said = Vec::new();
    while !inside.is_empty() {
        if let Err(error) = statement(&inside, &mut scene, &mut said) {
            scene.broken = true;
            log.diag.error(syntax::with_example(error, "scene", EXAMPLE));
            skip_statement(&inside);
        }
    }
    Ok(ItemKind::Scene(scene))
}

fn statement(input: ParseStream, scene: &mut Scene, said: &mut Vec<Ident>) -> Result<()> {
    let Some((word, _)) = input.cursor().ident() else { return Err(expected(input, "`start`, `until` or `with`")) };
    if !WORDS.iter().any(|known| word == known) {
        return Err(syntax::unknown_word(&word, "a scene", &WORDS));
    }
    let first = said.iter().find(|first| **first == word).cloned();
    let twice = |first: Ident| Err(syntax::statement_twice(&word, &first, &scene.name));
    input.call(Ident::parse_any)?;
    if word == "until" {
        match (until(input)?, first) {
            // conditions may end a scene before its time
            (Until::End(end), _) => {
                scene.ends.push(end);
                return sign::<Token![;]>(input).map(|_| ());
            }
            (Until::Time(_), Some(first)) => return twice(first),
            (Until::Time(time), None) => scene.until = Some(time),
        }
    } else if let Some(first) = first {
        return twice(first);
    } else if word == "start" {
        scene.start = Some(name(input, "the name of a start")?);
    } else {
        scene.effects.push(name(input, "the name of an effect")?);
        while take::<Token![,]>(input) {
            scene.effects.push(name(input, "the name of an effect")?);
        }
    }
    said.push(word);
    sign::<Token![;]>(input).map(|_| ())
}

/// What may stand behind `until`.
enum Until {
    Time(Duration),
    End(End),
}

fn until(input: ParseStream) -> Result<Until> {
    let begin = input.cursor();
    let value = expression_before_unit(input)?;
    if peek_relation(input) {
        return condition(begin, value, input).map(|condition| Until::End(End::Condition(condition)));
    }
    if input.peek(Token![;]) {
        return match value {
            Expr::Name(event) => Ok(Until::End(End::Event(event))),
            _ => Err(syntax::until_without_unit(value.extent())),
        };
    }
    Ok(Until::Time(Duration { value, unit: name(input, "a unit of time")? }))
}
