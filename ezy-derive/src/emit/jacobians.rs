//! Where Jacobians are. In a scene with counts: those of each item, in loops over its members, rows before forces.

use proc_macro2::TokenStream;
use quote::quote;

use super::loops::looped;
use super::places::{coordinate, firsts, slot_places};
use crate::mechanics::jacobians::{JacobianEntry, Jacobians};
use crate::mechanics::{Item, Templates};
use crate::model::Model;

/// What `jacobian_places` does.
pub fn places(jacobians: &Jacobians) -> TokenStream {
    let list = |jacobians: &[JacobianEntry]| -> Vec<TokenStream> {
        jacobians.iter().map(|JacobianEntry { row, column, .. }| quote!((#row, #column))).collect()
    };
    let (by_q, by_v) = (list(&jacobians.by_q), list(&jacobians.by_v));
    quote! {
        ::core::option::Option::Some(ezy::JacobianPlaces {
            by_q: ::std::vec![#(#by_q),*],
            by_v: ::std::vec![#(#by_v),*],
        })
    }
}

/// The same in a scene with counts.
pub fn places_of_items(model: &Model, templates: &Templates<'_>, jacobians: &[Jacobians]) -> TokenStream {
    let firsts = firsts(model);
    let n_q = templates.symbols.n_coordinates();
    let places = templates.items().zip(jacobians).map(|(item, jacobians)| of_item(model, &item, jacobians, n_q));
    quote! {
        #firsts
        let n_q = ezy::Scene::info(self).n_coordinates();
        let mut places = ezy::JacobianPlaces::default();
        let mut place = 0;
        #(#places)*
        ::core::option::Option::Some(places)
    }
}

/// Places of all members; rows of G are those behind `n_q`.
fn of_item(model: &Model, item: &Item<'_, '_>, jacobians: &Jacobians, n_q: usize) -> TokenStream {
    let list = |jacobians: &[JacobianEntry]| -> Vec<TokenStream> {
        let place = |entry: &JacobianEntry| {
            let column = coordinate(item.slots, entry.column);
            let row = match entry.row.checked_sub(n_q) {
                None => coordinate(item.slots, entry.row),
                Some(own) => quote!(n_q + place + #own),
            };
            quote!((#row, #column))
        };
        jacobians.iter().map(place).collect()
    };
    let (by_q, by_v, n_rows) = (list(&jacobians.by_q), list(&jacobians.by_v), item.n_rows());
    let slots = slot_places(model, item.slots);
    let body = quote! {
        #slots
        places.by_q.extend_from_slice(&[#(#by_q),*]);
        places.by_v.extend_from_slice(&[#(#by_v),*]);
        place += #n_rows;
    };
    looped(model, item.loops, &|from, to| quote!(#from..#to), body)
}
