//! The outcome of one text.

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

/// The verdict, or what is wrong with the macro. Reading the items of a model as Rust takes longer than making them.
pub fn verdict(text: &str, read_models: bool) -> Result<Verdict, String> {
    let judged = catch_unwind(AssertUnwindSafe(|| judge(text, read_models)));
    let verdict = judged.unwrap_or_else(|_| Err("the macro panics".to_owned()));
    // the library keeps every text that it has read for the sake of its spans
    proc_macro2::extra::invalidate_current_thread_spans();
    verdict
}

fn judge(text: &str, read_models: bool) -> Result<Verdict, String> {
    let Ok(tokens) = text.parse::<TokenStream>() else { return Ok(Verdict::NoTokens) };
    // an error at the end of a text that has no braces has no token to be at
    let has_braces = tokens
        .clone()
        .into_iter()
        .any(|tree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace));
    let items = expand(tokens);
    let errors: Vec<Span> = items.clone().into_iter().filter_map(of_error).collect();
    if read_models || !errors.is_empty() {
        syn::parse2::<syn::File>(items).map_err(|error| format!("what it emits is no Rust: {error}"))?;
    }
    match errors.iter().any(|span| has_braces && span.source_text().is_none()) {
        true => Err("an error has no place".to_owned()),
        false if errors.is_empty() => Ok(Verdict::Model),
        false => Ok(Verdict::Refused),
    }
}

/// The place of an error among the items.
fn of_error(tree: TokenTree) -> Option<Span> {
    match tree {
        TokenTree::Ident(word) if word == "compile_error" => Some(word.span()),
        _ => None,
    }
}
