//! `point name = body(x, y);`

use super::Log;
use super::ast::{ItemKind, Point};
use super::expression::indexed;
use super::place::on_body;
use super::token::sign;
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn point(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = indexed(input, "the name of the point")?;
    sign::<Token![=]>(input)?;
    let place = on_body(input, "a point `body(x, y)`")?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Point(Point { name, place }))
}
