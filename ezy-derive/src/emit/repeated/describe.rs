//! The loops that describe a run with given counts.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::emit::loops::{about, looped, variable, whole};
use crate::emit::templates::Template;
use crate::mechanics::Templates;
use crate::model::{Model, Slot};

/// The loops that describe a run: bodies, then every item with the bodies that it refers to.
pub fn describe(model: &Model, templates: &Templates<'_>, all: &[Template<'_>]) -> TokenStream {
    let arrays = model.arrays.iter().map(|array| {
        let (name, lengths, bodies) = (array.name.to_string(), about("lengths", array), about("bodies", array));
        let values = array.lengths.iter().map(|length| whole(model, length));
        quote! {
            let #lengths: &[usize] = &[#(usize::try_from(#values).unwrap_or(0)),*];
            let #bodies = layout.bodies(#name, #lengths);
        }
    });
    let members = all.iter().enumerate().filter(|(_, template)| template.is_repeated_item()).map(|(i, template)| {
        let at = template.loops.iter().map(|range| variable(model, range));
        let slots = template.slots.iter().map(|body| {
            let Slot { array, index } = &model.bodies[body.0].slot;
            let (bodies, index) =
                (about("bodies", &model.arrays[*array]), index.iter().map(|index| whole(model, index)));
            quote!(layout.member(&Self::TEMPLATES[#i], at, #bodies, &[#(#index),*]))
        });
        let describe = template.describe(i, templates);
        let n_slots = Literal::usize_unsuffixed(template.slots.len());
        let body = quote! {
            let at: &[i64] = &[#(#at),*];
            let slots: [usize; #n_slots] = [#(#slots),*];
            #describe
        };
        looped(model, template.loops, &|from, to| quote!(layout.range(#from, #to)), body)
    });
    quote!(#(#arrays)* #(#members)*)
}
