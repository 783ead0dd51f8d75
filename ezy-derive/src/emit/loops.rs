//! `for` and whole numbers as Rust.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use crate::model::whole::Whole;
use crate::model::{Array, Loop, Model};

/// The pass of a `for`, in all of its passes.
pub fn looped(
    model: &Model,
    loops: &[Loop],
    range: &dyn Fn(TokenStream, TokenStream) -> TokenStream,
    body: TokenStream,
) -> TokenStream {
    stepped(model, loops, range, body, &|_| TokenStream::new())
}

/// The same, with what is done at the end of each pass of a `for`.
pub fn stepped(
    model: &Model,
    loops: &[Loop],
    range: &dyn Fn(TokenStream, TokenStream) -> TokenStream,
    body: TokenStream,
    end: &dyn Fn(&Loop) -> TokenStream,
) -> TokenStream {
    if loops.is_empty() {
        return quote!({ #body });
    }
    loops.iter().rev().fold(body, |inside, around| {
        let (variable, end) = (variable(model, around), end(around));
        let range = range(whole(model, &around.from), whole(model, &around.to));
        quote!(for #variable in #range { #inside #end })
    })
}

/// How many passes these loops have, as an `i64`.
pub fn passes(model: &Model, loops: &[Loop]) -> TokenStream {
    let Some((around, inner)) = loops.split_first() else { return quote!(1) };
    let (from, to) = (whole(model, &around.from), whole(model, &around.to));
    let inside = passes(model, inner);
    let depends = |range: &Loop| range.from.depends_on(around.index) || range.to.depends_on(around.index);
    if inner.iter().any(depends) {
        let variable = variable(model, around);
        return quote!((#from..#to).map(|#variable| #inside).sum::<i64>());
    }
    quote!((#to - #from).max(0) * #inside)
}

/// A whole number as an `i64`.
pub fn whole(model: &Model, value: &Whole) -> TokenStream {
    match value {
        Whole::Number(number) => {
            let number = Literal::i64_unsuffixed(*number);
            quote!(#number)
        }
        Whole::Count(id) => {
            let field = &model.counts[id.0].name;
            quote!((self.#field as i64))
        }
        Whole::Index(id) => {
            let variable = format_ident!("at_{}", model.indices[id.0], span = Span::call_site());
            quote!(#variable)
        }
        Whole::Sum(a, b) => {
            let (a, b) = (whole(model, a), whole(model, b));
            quote!((#a + #b))
        }
        Whole::Difference(a, b) => {
            let (a, b) = (whole(model, a), whole(model, b));
            quote!((#a - #b))
        }
        Whole::Product(a, b) => {
            let (a, b) = (whole(model, a), whole(model, b));
            quote!((#a * #b))
        }
        Whole::Quotient(a, b) => {
            let (a, b) = (whole(model, a), Literal::i64_unsuffixed(*b));
            quote!((#a).div_euclid(#b))
        }
    }
}

/// How many bodies an array has, as an `i64`.
pub fn members(model: &Model, array: &Array) -> TokenStream {
    let mut lengths = array.lengths.iter().map(|length| whole(model, length));
    let first = lengths.next().unwrap_or_else(|| quote!(1));
    quote!(#first #(* #lengths)*)
}

pub fn variable(model: &Model, around: &Loop) -> TokenStream {
    whole(model, &Whole::Index(around.index))
}

/// Name in the emitted code of something about an array: `first_link`.
pub fn about(what: &str, array: &Array) -> Ident {
    format_ident!("{what}_{}", array.name, span = Span::call_site())
}
