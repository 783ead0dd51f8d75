//! Where Jacobians are. In a scene with counts: those of each item, in loops over its members, rows before forces before rates.

use proc_macro2::TokenStream;
use quote::quote;

use super::loops::looped;
use super::places::{coordinate, firsts, slot_places};
use crate::mechanics::jacobians::{JacobianEntry, Jacobians};
use crate::mechanics::{Item, Templates};
use crate::model::Model;

/// What `jacobian_places` does.
pub fn places(jacobians: &Jacobians) -> TokenStream {
    let (by_q, by_v) = (straight(&jacobians.by_q), straight(&jacobians.by_v));
    quote! {
        ::core::option::Option::Some(ezy::JacobianPlaces {
            by_q: ::std::vec![#(#by_q),*],
            by_v: ::std::vec![#(#by_v),*],
        })
    }
}

/// What `state_jacobian_places` does.
pub fn places_by_states(jacobians: &Jacobians) -> TokenStream {
    let by_z = straight(&jacobians.by_z);
    quote!(::std::vec![#(#by_z),*])
}

fn straight(jacobians: &[JacobianEntry]) -> Vec<TokenStream> {
    jacobians.iter().map(|JacobianEntry { row, column, .. }| quote!((#row, #column))).collect()
}

/// What `jacobian_places` does in a scene with counts.
pub fn places_of_items(model: &Model, templates: &Templates<'_>, jacobians: &[Jacobians]) -> TokenStream {
    let n_q = templates.symbols.n_coordinates();
    let none = quote!(ezy::JacobianPlaces::default());
    let places = of_items(model, templates, jacobians, &none, &|item, jacobians| {
        let column = |i| coordinate(item.slots, i);
        let [by_q, by_v] = [&jacobians.by_q, &jacobians.by_v].map(|entries| of_members(item, entries, n_q, &column));
        quote! {
            places.by_q.extend_from_slice(&[#(#by_q),*]);
            places.by_v.extend_from_slice(&[#(#by_v),*]);
        }
    });
    quote! {
        #places
        ::core::option::Option::Some(places)
    }
}

/// What `state_jacobian_places` does in a scene with counts.
pub fn places_by_states_of_items(model: &Model, templates: &Templates<'_>, jacobians: &[Jacobians]) -> TokenStream {
    let n_q = templates.symbols.n_coordinates();
    let none = quote!(::std::vec::Vec::new());
    let places = of_items(model, templates, jacobians, &none, &|item, jacobians| {
        let by_z = of_members(item, &jacobians.by_z, n_q, &|i| quote!(#i));
        quote!(places.extend_from_slice(&[#(#by_z),*]);)
    });
    quote! {
        #places
        places
    }
}

/// `places`, at first `none`, with what each member of each item adds to them; `place` is the number of rows before it.
fn of_items(
    model: &Model,
    templates: &Templates<'_>,
    jacobians: &[Jacobians],
    none: &TokenStream,
    by_member: &dyn Fn(&Item<'_, '_>, &Jacobians) -> TokenStream,
) -> TokenStream {
    let firsts = firsts(model);
    let items = templates.items().zip(jacobians).map(|(item, jacobians)| {
        let (slots, n_rows) = (slot_places(model, item.slots), item.n_rows());
        let own = by_member(&item, jacobians);
        looped(model, item.loops, &|from, to| quote!(#from..#to), quote!(#slots #own place += #n_rows;))
    });
    quote! {
        #firsts
        let n_q = ezy::Scene::info(self).n_coordinates();
        let mut places = #none;
        let mut place = 0;
        #(#items)*
    }
}

/// Places of a member; rows of G and of rates are those behind `n_q`.
fn of_members(
    item: &Item<'_, '_>,
    jacobians: &[JacobianEntry],
    n_q: usize,
    column: &dyn Fn(usize) -> TokenStream,
) -> Vec<TokenStream> {
    let place = |entry: &JacobianEntry| {
        let column = column(entry.column);
        let row = match entry.row.checked_sub(n_q) {
            None => coordinate(item.slots, entry.row),
            Some(own) => quote!(n_q + place + #own),
        };
        quote!((#row, #column))
    };
    jacobians.iter().map(place).collect()
}
