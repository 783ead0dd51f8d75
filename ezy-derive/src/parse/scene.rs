//! `scene name { start name; until 60 s; with effect, effect; }`

use super::Log;
use super::ast::{Duration, ItemKind, Scene};
use super::expression::expression_before_unit;
use super::token::{braced, expected, name, sign, skip};
use crate::diag::syntax;
use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Result, Token};

const WORDS: [&str; 3] = ["start", "until", "with"];

pub fn scene(input: ParseStream, log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the scene")?;
    let inside = braced(input)?.inside;
    let mut scene = Scene { name, start: None, until: None, effects: Vec::new(), broken: false };
    let mut said = Vec::new();
    while !inside.is_empty() {
        if let Err(error) = statement(&inside, &mut scene, &mut said) {
            scene.broken = true;
            let example = "scene driven { start folded; until 60 s; with pump; }";
            log.diag.error(syntax::with_example(error, "scene", example));
            while !inside.peek(Token![;]) && skip(&inside) {}
            inside.parse::<Option<Token![;]>>()?;
        }
    }
    Ok(ItemKind::Scene(scene))
}

fn statement(input: ParseStream, scene: &mut Scene, said: &mut Vec<Ident>) -> Result<()> {
    let Some((word, _)) = input.cursor().ident() else { return Err(expected(input, "`start`, `until` or `with`")) };
    if let Some(first) = said.iter().find(|first| **first == word) {
        return Err(syntax::statement_twice(&word, first, &scene.name));
    }
    if !WORDS.iter().any(|known| word == known) {
        return Err(syntax::unknown_word(&word, "a scene", &WORDS));
    }
    input.call(Ident::parse_any)?;
    said.push(word.clone());
    if word == "start" {
        scene.start = Some(name(input, "the name of a start")?);
    } else if word == "until" {
        scene.until = Some(duration(input)?);
    } else {
        scene.effects.push(name(input, "the name of an effect")?);
        while input.peek(Token![,]) {
            input.parse::<Token![,]>()?;
            scene.effects.push(name(input, "the name of an effect")?);
        }
    }
    sign::<Token![;]>(input).map(|_| ())
}

fn duration(input: ParseStream) -> Result<Duration> {
    let value = expression_before_unit(input)?;
    if input.peek(Token![;]) {
        return Err(syntax::until_without_unit(value.extent()));
    }
    Ok(Duration { value, unit: name(input, "a unit of time")? })
}
