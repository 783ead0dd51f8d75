//! Where the bodies of a pass stand.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::loops::{about, members, whole};
use crate::model::{BodyId, Component, Coordinate, Model, Slot};

/// Index of the first body of each array.
pub fn firsts(model: &Model) -> TokenStream {
    let mut behind = quote!(0);
    let firsts = model.arrays.iter().map(|array| {
        let first = about("first", array);
        let declared = quote!(let #first: i64 = #behind;);
        let members = members(model, array);
        behind = quote!(#first + #members);
        declared
    });
    firsts.collect()
}

/// Index of the first coordinate of each body that a pass refers to.
pub fn slot_places(model: &Model, slots: &[BodyId]) -> TokenStream {
    let places = slots.iter().map(|body| {
        let Slot { array, index } = &model.bodies[body.0].slot;
        let lengths = &model.arrays[*array].lengths;
        let place = index.iter().zip(lengths).fold(None, |place: Option<TokenStream>, (index, length)| {
            let (index, length) = (whole(model, index), whole(model, length));
            Some(match place {
                None => index,
                Some(place) => quote!(((#place) * #length + #index)),
            })
        });
        let first = about("first", &model.arrays[*array]);
        let place = place.map(|place| quote!(+ #place));
        let n = Literal::usize_unsuffixed(Component::ALL.len());
        quote!(#n * (#first #place) as usize)
    });
    let n = Literal::usize_unsuffixed(slots.len());
    quote!(let slots: [usize; #n] = [#(#places),*];)
}

/// Place in q of a coordinate of a slot.
pub fn coordinate(slots: &[BodyId], i: usize) -> TokenStream {
    let Coordinate { body, component } = Coordinate::at(i);
    let slot = slots.iter().position(|slot| *slot == body).unwrap_or(0);
    let [slot, component] = [slot, component as usize].map(Literal::usize_unsuffixed);
    quote!(slots[#slot] + #component)
}
