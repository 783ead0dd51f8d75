//! The Taylor series of a scene as an implementation of `Series`.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::loops::looped;
use super::places::{Lengths, OF_SERIES, size};
use super::signature::argument;
use crate::mechanics::Derived;
use crate::mechanics::derived::{Form, Straight};
use crate::mechanics::kernels::{Entries, Kernel, Quantity};
use crate::model::Model;

/// The implementation with its `methods` for the type of a scene; `None` without a series.
pub fn implementation(
    type_name: &Ident,
    model: &Model,
    derived: &Derived<'_>,
    methods: &TokenStream,
) -> Option<TokenStream> {
    let begin = derived.kernels.get(&Quantity::SeriesBegin)?;
    let (allowed, size) = match &derived.form {
        Form::Straight(of) => (quote!(), size_of_straight(derived, of)),
        Form::Counted(_) => (quote!(#[allow(unused_assignments, unused_mut)]), size_in_loops(model, begin)),
    };
    Some(quote! {
        #[automatically_derived]
        #allowed
        impl<T: ezy::Scalar> ezy::Series<T> for #type_name {
            fn series_size(&self) -> ezy::SeriesSize {
                #size
            }
            #methods
        }
    })
}

fn size_of_straight(derived: &Derived<'_>, of: &Straight) -> TokenStream {
    let lengths = Lengths::new(derived, of);
    let (n_q, n_c) = (lengths.of(Entries::Coordinates), lengths.of(Entries::Rows));
    let (names, numbers) = (OF_SERIES.map(|of| argument(size(of))), OF_SERIES.map(|of| lengths.of(of)));
    quote!(ezy::SeriesSize { n_coordinates: #n_q, n_rows: #n_c, #(#names: #numbers),* })
}

/// The sum of the sizes of all members.
fn size_in_loops(model: &Model, begin: &Kernel<'_>) -> TokenStream {
    let names = OF_SERIES.map(|of| argument(size(of)));
    let passes = begin.passes.iter().filter_map(|pass| {
        let numbers = OF_SERIES.iter().zip(&names).map(|(&of, name)| (pass.n(of), name)).filter(|&(n, _)| n > 0);
        let add: TokenStream = numbers.map(|(n, name)| quote!(size.#name += #n;)).collect();
        (!add.is_empty()).then(|| looped(model, pass.loops, &|from, to| quote!(#from..#to), add))
    });
    quote! {
        let info = ezy::Scene::info(self);
        let mut size =
            ezy::SeriesSize { n_coordinates: info.n_coordinates(), n_rows: info.n_rows(), #(#names: 0),* };
        #(#passes)*
        size.n_products = size.n_products.next_multiple_of(ezy::PRODUCT_GROUP);
        size
    }
}
