//! `release row;`

use super::Log;
use super::ast::ItemKind;
use super::token::{name, sign};
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn release(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let row = name(input, "the name of a constraint")?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Release(row))
}
