//! `skate name: at place along body(x, y);`

use super::Log;
use super::ast::{ItemKind, Skate};
use super::place::{on_body, place};
use super::token::{name, sign, word};
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn skate(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the skate")?;
    sign::<Token![:]>(input)?;
    word(input, "at")?;
    let at = place(input)?;
    word(input, "along")?;
    let along = on_body(input, "a direction `body(x, y)`")?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Skate(Skate { name, at, along }))
}
