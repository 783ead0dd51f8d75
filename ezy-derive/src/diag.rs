//! Errors of a model text, collected so that a user sees all errors of a stage at once.
//!
//! The wording of every message is in the catalogue below this module: [`syntax`], [`names`], [`values`], [`rules`],
//! [`repeats`], [`scenes`], [`equations`]; words of other languages: [`elsewhere`].

/// Functions that make a message: name, place of the message and what it speaks of; then the fault, the help, and what to
/// say at a second place.
macro_rules! messages {
    ($($(#[$remark:meta])* $name:ident($at:ident: $place:ty $(, $argument:ident: $type:ty)*):
        $fault:literal, $help:literal $(, $other:ident: $note:literal)?;)*) => {
        $($(#[$remark])*
        pub fn $name($at: $place $(, $argument: $type)*) -> syn::Error {
            let error = $crate::diag::fault_with_help($at, format_args!($fault), format_args!($help));
            $(let error = $crate::diag::fault_at_two_places(error, $other, format_args!($note));)?
            error
        })*
    };
}

pub mod elsewhere;
pub mod equations;
pub mod names;
pub mod nearest;
pub mod repeats;
pub mod rules;
pub mod scenes;
pub mod syntax;
pub mod values;

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote_spanned;

/// The errors and warnings of a model text so far.
#[derive(Debug, Default)]
pub struct Diagnostics {
    errors: Vec<syn::Error>,
    warnings: Vec<Warning>,
}

/// A warning: something that compiles but is probably not intended.
#[derive(Debug)]
pub struct Warning {
    pub span: Span,
    /// snake_case; rustc prints it before the text.
    pub name: &'static str,
    pub text: String,
}

impl Diagnostics {
    pub fn error(&mut self, error: syn::Error) {
        self.errors.push(error);
    }

    pub fn warning(&mut self, warning: Warning) {
        self.warnings.push(warning);
    }

    /// Keeps the error in place of a value.
    pub fn refuse<T>(&mut self, error: syn::Error) -> Option<T> {
        self.errors.push(error);
        None
    }

    /// The value, or `None` after keeping the error.
    pub fn keep<T>(&mut self, result: syn::Result<T>) -> Option<T> {
        result.map_err(|error| self.error(error)).ok()
    }

    /// Number of errors so far.
    pub fn n_errors(&self) -> usize {
        self.errors.len()
    }

    /// Whether there is no error; warnings do not count.
    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// One `compile_error!` per error, each at its own place, and the warnings.
    pub fn into_compile_errors(self) -> TokenStream {
        let errors = self.errors.into_iter().map(syn::Error::into_compile_error);
        errors.chain(self.warnings.into_iter().map(Warning::into_tokens)).collect()
    }

    /// Every message as `line:column text`, for tests.
    #[cfg(test)]
    pub fn listing(&self) -> Vec<String> {
        let place = |span: Span| format!("{}:{}", span.start().line, span.start().column + 1);
        let errors = self.errors.iter().flat_map(syn::Error::clone);
        let errors = errors.map(|error| format!("{} {error}", place(error.span())));
        let warnings = self.warnings.iter().map(|w| format!("{} warning: {}", place(w.span), w.text));
        errors.chain(warnings).collect()
    }
}

impl Warning {
    /// Stable Rust has no way to warn from a macro but the use of a deprecated item, whose name stands before the text.
    fn into_tokens(self) -> TokenStream {
        let (text, name) = (self.text, Ident::new(&format!("EZY_warns_of_{}", self.name), self.span));
        quote_spanned! {self.span=>
            const _: () = {
                #[deprecated(note = #text)]
                #[allow(non_upper_case_globals)]
                const #name: () = ();
                #name
            };
        }
    }
}

/// The span of a message: from the first to the last token.
#[derive(Debug, Clone, Copy)]
pub struct Extent {
    pub first: Span,
    pub last: Span,
}

impl From<Span> for Extent {
    fn from(span: Span) -> Self {
        Self { first: span, last: span }
    }
}

impl From<&Ident> for Extent {
    fn from(name: &Ident) -> Self {
        name.span().into()
    }
}

/// A message of one line: the error in the user's words.
fn fault(at: impl Into<Extent>, text: impl std::fmt::Display) -> syn::Error {
    let Extent { first, last } = at.into();
    let (first, last) = (Ident::new("first", first), Ident::new("last", last));
    syn::Error::new_spanned(quote::quote!(#first #last), text)
}

/// A message with a help: an edit that would compile.
fn fault_with_help(at: impl Into<Extent>, text: impl std::fmt::Display, help: impl std::fmt::Display) -> syn::Error {
    fault(at, format_args!("{text}\nhelp: {help}"))
}

/// A message with a second span.
fn fault_at_two_places(mut error: syn::Error, other: impl Into<Extent>, remark: impl std::fmt::Display) -> syn::Error {
    error.combine(fault(other, remark));
    error
}
