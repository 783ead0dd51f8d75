//! `effect name { param …; let …; release …; rows and forces }`

use super::Log;
use super::ast::{Effect, ItemKind};
use super::item::{EFFECT, items};
use super::token::{braced, name};
use syn::Result;
use syn::parse::ParseStream;

pub fn effect(input: ParseStream, log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the effect")?;
    let inside = braced(input)?.inside;
    let mut effect = Effect { name, items: Vec::new() };
    items(&inside, EFFECT, &[], &mut effect.items, log);
    Ok(ItemKind::Effect(effect))
}
