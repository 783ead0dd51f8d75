//! `let name = expression;`

use super::Log;
use super::ast::{ItemKind, Let};
use super::expression::expression;
use super::token::{name, sign};
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn let_value(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the value")?;
    sign::<Token![=]>(input)?;
    let value = expression(input)?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Let(Let { name, value }))
}
