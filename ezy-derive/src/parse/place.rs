//! Places and directions: `body(x, y)`, or the name of a point.

use super::ast::{Name, OnBody, Place};
use super::expression::{expression, indexed};
use super::token::{end_of_pair, parenthesised};
use crate::diag::syntax;
use syn::parse::ParseStream;
use syn::{Result, Token};

pub fn place(input: ParseStream) -> Result<Place> {
    let owner = owner(input, "a point: its name, or `body(x, y)`")?;
    if !input.peek(syn::token::Paren) {
        return Ok(Place::Named(owner));
    }
    let (x, y) = pair(input, expression)?;
    Ok(Place::OnBody(OnBody { body: owner, x, y }))
}

pub fn on_body(input: ParseStream, what: &str) -> Result<OnBody> {
    let body = owner(input, what)?;
    let (x, y) = pair(input, expression)?;
    Ok(OnBody { body, x, y })
}

/// The body, or the name of a point.
fn owner(input: ParseStream, what: &str) -> Result<Name> {
    if input.peek(syn::token::Paren) {
        return Err(syntax::no_body_before_bracket(input.span(), what));
    }
    indexed(input, what)
}

/// `(x, y)`
pub fn pair<T>(input: ParseStream, component: impl Fn(ParseStream) -> Result<T>) -> Result<(T, T)> {
    let brackets = parenthesised(input)?;
    let inside = &brackets.inside;
    let x = component(inside)?;
    if inside.is_empty() {
        return Err(syntax::bare_vector_component(crate::diag::Extent { first: brackets.open, last: brackets.close }));
    }
    super::token::sign::<Token![,]>(inside)?;
    let y = component(inside)?;
    end_of_pair(inside)?;
    Ok((x, y))
}
