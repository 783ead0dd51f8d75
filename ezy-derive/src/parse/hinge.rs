//! `hinge name: place ~ place;`

use super::Log;
use super::ast::{Hinge, ItemKind};
use super::place::place;
use super::token::{name, sign};
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn hinge(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let name = name(input, "the name of the hinge")?;
    sign::<Token![:]>(input)?;
    let a = place(input)?;
    sign::<Token![~]>(input)?;
    let b = place(input)?;
    sign::<Token![;]>(input)?;
    Ok(ItemKind::Hinge(Hinge { name, a, b }))
}
