//! The bodies of a model as fields.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::loops::whole;
use crate::model::Model;

/// The type that all scenes of the model share.
pub fn definition(model: &Model) -> TokenStream {
    let title = format!("Bodies of `{}`.", model.name);
    let lifetime = lifetime(model);
    let fields = model.arrays.iter().map(|array| {
        let (name, d) = (&array.name, Literal::usize_unsuffixed(array.lengths.len()));
        let documentation = format!("Position and velocity of `{name}`.");
        let kind = if array.lengths.is_empty() { quote!(ezy::BodyState) } else { quote!(ezy::BodyArray<'a, #d>) };
        quote!(#[doc = #documentation] pub #name: #kind)
    });
    quote! {
        #[doc = #title]
        #[derive(Debug, Clone, Copy)]
        pub struct Bodies #lifetime { #(#fields),* }
    }
}

/// The type, as the module of the model calls it.
pub fn type_of(model: &Model) -> TokenStream {
    let lifetime = lifetime(model);
    quote!(names::Bodies #lifetime)
}

/// Its value, from `q` and `v`.
pub fn read(model: &Model) -> TokenStream {
    let values = model.arrays.iter().map(|array| {
        let (name, lengths) = (&array.name, array.lengths.iter().map(|length| whole(model, length)));
        let value = if array.lengths.is_empty() { quote!(body()) } else { quote!(array([#(#lengths),*])) };
        quote!(#name: bodies.#value)
    });
    quote! {
        let mut bodies = ezy::BodyReader::new(q, v);
        names::Bodies { #(#values),* }
    }
}

fn lifetime(model: &Model) -> Option<TokenStream> {
    model.arrays.iter().any(|array| !array.lengths.is_empty()).then(|| quote!(<'a>))
}
