//! What becomes of one text.

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::pipeline::expand;

/// What a text is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// No tokens: rustc refuses it before the macro sees it.
    NoTokens,
    /// Errors, each at a place of the text.
    Refused,
    /// Items without an error.
    Model,
}

/// The verdict, or what is wrong with the macro.
pub fn verdict(text: &str) -> Result<Verdict, String> {
    let verdict = catch_unwind(AssertUnwindSafe(|| judge(text))).unwrap_or_else(|_| Err("the macro panics".to_owned()));
    // the library keeps every text that it has read for the sake of its spans
    proc_macro2::extra::invalidate_current_thread_spans();
    verdict
}

fn judge(text: &str) -> Result<Verdict, String> {
    let Ok(tokens) = text.parse::<TokenStream>() else { return Ok(Verdict::NoTokens) };
    // an error at the end of a text that has no braces has no token to be at
    let has_braces = tokens
        .clone()
        .into_iter()
        .any(|tree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace));
    let items: syn::File = syn::parse2(expand(tokens)).map_err(|error| format!("what it emits is no Rust: {error}"))?;
    let errors = items.items.iter().filter_map(|item| match item {
        syn::Item::Macro(item) => item.mac.path.segments.last().filter(|last| last.ident == "compile_error"),
        _ => None,
    });
    let places: Vec<Span> = errors.map(|last| last.ident.span()).collect();
    match places.iter().any(|span| has_braces && span.source_text().is_none()) {
        true => Err("an error has no place".to_owned()),
        false if places.is_empty() => Ok(Verdict::Model),
        false => Ok(Verdict::Refused),
    }
}
