//! `body name { mass: expression, inertia: expression }`

use super::Log;
use super::ast::{Body, Expr, ItemKind};
use super::expression::{expression, indexed};
use super::token::{braced, name, sign};
use crate::diag::syntax;
use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::{Result, Token};

const FIELDS: [&str; 2] = ["mass", "inertia"];

pub fn body(input: ParseStream, _log: &mut Log) -> Result<ItemKind> {
    let body = indexed(input, "the name of the body")?;
    let fields = braced(input)?.inside;
    let mut given: [Option<(Ident, Expr)>; FIELDS.len()] = [None, None];
    while !fields.is_empty() {
        let field = name(&fields, "`mass` or `inertia`")?;
        let Some(i) = FIELDS.iter().position(|known| field == known) else {
            return Err(syntax::unknown_word(&field, "a body", &FIELDS));
        };
        if let Some((first, _)) = &given[i] {
            return Err(syntax::field_twice(&field, first));
        }
        sign::<Token![:]>(&fields)?;
        given[i] = Some((field, expression(&fields)?));
        if !fields.is_empty() {
            fields.parse::<Token![,]>().map_err(|_| super::token::expected(&fields, "`,` or `}`"))?;
        }
    }
    let [mass, inertia] = given;
    let (_, mass) = mass.ok_or_else(|| syntax::field_missing(&body, "mass"))?;
    let (_, inertia) = inertia.ok_or_else(|| syntax::field_missing(&body, "inertia"))?;
    Ok(ItemKind::Body(Body { name: body, mass, inertia }))
}
