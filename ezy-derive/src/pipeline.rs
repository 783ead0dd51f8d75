//! The stages in order; errors are flushed after each. The file to read first.

use proc_macro2::TokenStream;

use crate::diag::Diagnostics;
use crate::{emit, model, parse};

/// A model file as Rust items, or as compile errors on the words to change.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let mut diag = Diagnostics::default();
    let syntax = parse::parse(tokens, &mut diag);
    if !diag.is_empty() {
        return diag.into_compile_errors();
    }
    let Some(model) = model::resolve(syntax, &mut diag).filter(|_| diag.is_empty()) else {
        return diag.into_compile_errors();
    };
    let mut items = diag.into_compile_errors();
    items.extend(emit::model(&model));
    items
}
