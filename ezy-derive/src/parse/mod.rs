//! From tokens to a tree. Knows syntax alone, and continues after an error.

pub mod ast;
mod declaration;
mod event;
mod expression;
mod fingerprint;
mod integrated;
mod item;
mod place;
mod repeat;
mod scene;
mod start;
mod statement;
mod token;
mod unit;

#[cfg(test)]
pub use fingerprint::Hash;
pub use token::is_rust_keyword;

use crate::diag::{Diagnostics, syntax};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::Result;
use syn::buffer::Cursor;
use syn::parse::{ParseStream, Parser, StepCursor};
use token::{found, name, word};

/// A unit of the language's own tables.
pub fn unit_of_text(text: &str) -> Result<ast::Unit> {
    unit::unit.parse_str(text)
}

/// Every word of a model, in the order of the manual.
#[cfg(test)]
pub fn words_of_the_language() -> Vec<&'static str> {
    item::Level::Model.words()
}

/// The state of the parser.
pub struct Log<'a> {
    pub diag: &'a mut Diagnostics,
    pub broken: Vec<Ident>,
    pub loops: Vec<(ast::Loop, Vec<ast::Loop>)>,
}

/// The model text as a tree. Errors go to `diag`. Items that could not be parsed are missing in the tree, their names are kept.
pub fn parse(tokens: TokenStream, diag: &mut Diagnostics) -> ast::Model {
    let mut model = ast::Model {
        core: quote!(::ezy_core),
        visibility: syn::Visibility::Inherited,
        name: Ident::new("Model", Span::call_site()),
        documentation: String::new(),
        fingerprint: fingerprint::of(&tokens),
        items: Vec::new(),
        broken: Vec::new(),
        loops: Vec::new(),
    };
    let mut log = Log { diag, broken: Vec::new(), loops: Vec::new() };
    let mut header = Ok(());
    let rest = (|input: ParseStream| {
        if let Ok(core) = input.step(core) {
            model.core = core;
        }
        header = self::model(input, &mut model, &mut log)
            .map_err(|error| syntax::with_example(error, "model", "pub model Name { … }"));
        Ok(())
    })
    .parse2(tokens);
    model.broken = log.broken;
    model.loops = log.loops;
    if header.is_err() {
        model.broken.push(model.name.clone()); // then everything is missing, which is no fault of its own
    }
    // syn reports tokens that were left over; those follow a fault that is known already, if there is one
    let rest = if diag.is_empty() { rest } else { Ok(()) };
    diag.keep(header.and(rest));
    model
}

/// `$crate`, which the `model!` of `ezy-core` writes before the model, so that the crate may have any name where it is used.
fn core<'c>(cursor: StepCursor<'c, '_>) -> Result<(TokenStream, Cursor<'c>)> {
    match cursor.ident() {
        Some((ident, rest)) if ident == "$crate" => Ok((quote!(#ident), rest)),
        _ => Err(cursor.error("no path")),
    }
}

fn model(input: ParseStream, model: &mut ast::Model, log: &mut Log) -> Result<()> {
    if input.is_empty() {
        return Err(syntax::no_model(Span::call_site()));
    }
    model.documentation = item::documentation(input)?;
    model.visibility = input.parse()?;
    word(input, "model")?;
    model.name = name(input, "the name of the model")?;
    let body = token::braced(input)?;
    item::items(&body.inside, item::Level::Model, &[], &mut model.items, log);
    if !input.is_empty() {
        log.diag.error(syntax::text_after_model(input.span(), &found(input)));
    }
    Ok(())
}
