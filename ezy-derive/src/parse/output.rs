//! `output name: unit = expression;`, `output name = expression;`

use super::Log;
use super::ast::{ItemKind, Output};
use super::expression::{expression, indexed};
use super::token::sign;
use super::unit::optional_unit;
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn output(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = indexed(input, "the name of the output")?;
    let unit = optional_unit(input)?;
    sign::<Token![=]>(input)?;
    let value = expression(input)?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Output(Output { name, unit, value }))
}
