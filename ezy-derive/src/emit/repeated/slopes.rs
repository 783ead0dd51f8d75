//! The slopes of a scene with counts: those of each item, in loops over its members, rows before forces.

use proc_macro2::TokenStream;
use quote::quote;

use super::kernels::{Emitter, Written, coordinate, firsts, slot_places};
use super::loops::looped;
use crate::emit::kernel::Numbers;
use crate::emit::slopes::{methods, source};
use crate::mechanics::Templates;
use crate::mechanics::slopes::{Slope, Slopes};
use crate::model::{BodyId, Loop, Model};
use crate::symbolic::Symbol;

/// An item and its slopes.
pub struct Item<'m> {
    loops: &'m [Loop],
    slots: Vec<BodyId>,
    n_rows: usize,
    slopes: Slopes,
}

/// The slopes of all rows and forces; `None` when some are too long to write.
pub fn derive<'m>(templates: &mut Templates<'m>) -> Option<Vec<Item<'m>>> {
    let Templates { algebra, symbols, rows, forces, .. } = templates;
    let mut items = Vec::new();
    for row in rows {
        items.push(Item {
            loops: &row.row.loops,
            slots: row.slots.clone(),
            n_rows: row.constraints.rows.len(),
            slopes: Slopes::derive(algebra, symbols, Some(&row.constraints), [])?,
        });
    }
    for force in forces {
        items.push(Item {
            loops: &force.force.loops,
            slots: force.slots.clone(),
            n_rows: 0,
            slopes: Slopes::derive(algebra, symbols, None, force.entries.iter().copied())?,
        });
    }
    Some(items)
}

impl Emitter<'_> {
    /// The methods that know the slopes.
    pub fn slopes(&mut self, items: &[Item<'_>]) -> TokenStream {
        let firsts = firsts(self.model);
        let n_q = self.templates.symbols.n_coordinates();
        let places: Vec<TokenStream> = items.iter().map(|item| item.places(self.model, n_q)).collect();
        let kernels: Vec<TokenStream> = items.iter().map(|item| self.item(item)).collect();
        methods(
            quote! {
                #firsts
                let n_q = ezy::Scene::info(self).n_coordinates();
                let mut places = ezy::SlopePlaces::default();
                let mut place = 0;
                #(#places)*
                ::core::option::Option::Some(places)
            },
            quote!(#firsts let (mut place, mut place_q, mut place_v) = (0, 0, 0); #(#kernels)*),
        )
    }

    fn item(&mut self, item: &Item<'_>) -> TokenStream {
        let (n_by_q, n_rows) = (item.slopes.by_q.len(), item.n_rows);
        let put = move |values: Vec<TokenStream>| {
            let (by_q, by_v) = values.split_at(n_by_q);
            quote! {
                #(by_q[place_q] = #by_q; place_q += 1;)*
                #(by_v[place_v] = #by_v; place_v += 1;)*
                place += #n_rows;
            }
        };
        let other = |symbol: Symbol| {
            let acceleration = |i: usize| {
                let i = coordinate(&item.slots, i);
                quote!(a[#i])
            };
            source(&item.slopes, symbol, &acceleration, &|row| quote!(lambda[place + #row]))
        };
        let sums = item.slopes.values();
        let written = Written { loops: item.loops, slots: &item.slots, sums, put: Box::new(put) };
        self.written(Numbers::F64, &written, &other)
    }
}

impl Item<'_> {
    /// Places of all members; rows of G are those behind `n_q`.
    fn places(&self, model: &Model, n_q: usize) -> TokenStream {
        let list = |slopes: &[Slope]| -> Vec<TokenStream> {
            let place = |slope: &Slope| {
                let column = coordinate(&self.slots, slope.column);
                let row = match slope.row.checked_sub(n_q) {
                    None => coordinate(&self.slots, slope.row),
                    Some(own) => quote!(n_q + place + #own),
                };
                quote!((#row, #column))
            };
            slopes.iter().map(place).collect()
        };
        let (by_q, by_v, n_rows) = (list(&self.slopes.by_q), list(&self.slopes.by_v), self.n_rows);
        let slots = slot_places(model, &self.slots);
        let body = quote! {
            #slots
            places.by_q.extend_from_slice(&[#(#by_q),*]);
            places.by_v.extend_from_slice(&[#(#by_v),*]);
            place += #n_rows;
        };
        looped(model, self.loops, &|from, to| quote!(#from..#to), body)
    }
}
