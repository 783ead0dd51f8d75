//! The recurrences of a scene with counts: those of each item, in loops over its members.
//!
//! Members stand one after the other in every array of the store, in the order of items: rows, then forces.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::loops::{looped, whole};
use super::slots::{coordinate, firsts, slot_places};
use crate::emit::kernel::{self, Binding, Body, Vocabulary};
use crate::emit::numbers::Numbers;
use crate::mechanics::series::{Ahead, Kernel, Recurrences, Slot};
use crate::mechanics::{Item, Templates};
use crate::model::Model;
use crate::model::whole::Whole;
use crate::symbolic::Symbol;

/// The implementation for the type of a scene.
pub fn implementation(
    type_name: &Ident,
    model: &Model,
    templates: &Templates<'_>,
    recurrences: &[Recurrences],
    vocabulary: Vocabulary<'_>,
) -> TokenStream {
    let firsts = firsts(model);
    let opening = opening();
    let writers = || {
        let items = templates.items().zip(recurrences);
        items.map(|(item, recurrences)| Writer { model, vocabulary, item, recurrences })
    };
    let sizes = writers().map(|writer| writer.sizes());
    let (begin, right_side, finish) = (
        writers().map(|writer| writer.pass(&writer.recurrences.begin, Phase::Begin)),
        writers().map(|writer| writer.pass(&writer.recurrences.right_side, Phase::Order)),
        writers().map(|writer| writer.pass(&writer.recurrences.finish, Phase::Order)),
    );
    quote! {
        #[automatically_derived]
        #[allow(unused_assignments, unused_mut)]
        impl<T: ezy::Scalar> ezy::Series<T> for #type_name {
            fn series_size(&self) -> ezy::SeriesSize {
                let info = ezy::Scene::info(self);
                let mut size = ezy::SeriesSize {
                    n_coordinates: info.n_coordinates(),
                    n_rows: info.n_rows(),
                    n_products: 0,
                    n_base: 0,
                    n_kept: 0,
                };
                #(#sizes)*
                size.n_products = size.n_products.next_multiple_of(ezy::PRODUCT_GROUP);
                size
            }
            fn begin(
                &self,
                c: &[T],
                t: T,
                store: &mut ezy::SeriesStore<T>,
            ) -> ezy::Pivots {
                #firsts
                #opening
                let (q, v) = q[..2 * n_q].split_at(n_q);
                force.fill(T::from_f64(0f64));
                #(#begin)*
                ezy::Pivots::ALL_VANISHED
            }
            fn right_side(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
                #firsts
                #opening
                force.fill(T::from_f64(0f64));
                #(#right_side)*
            }
            fn solve(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {}
            fn finish(&self, c: &[T], k: usize, store: &mut ezy::SeriesStore<T>) {
                #firsts
                #opening
                let inverse = T::from_f64(1f64) / T::from_f64(((k + 1) * (k + 2)) as f64);
                q[(k + 2) * n_q..(k + 3) * n_q].iter_mut().zip(a.iter()).for_each(|(q, a)| *q = *a * inverse);
                #(#finish)*
            }
        }
    }
}

/// The arrays of the store with the lengths of their rows, and where the first member stands.
fn opening() -> TokenStream {
    quote! {
        let ezy::SeriesStore { q, lambda, left, right, sums, kept, base, force, row, a } = store;
        let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
        let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
        let (mut row_place, mut product_place, mut base_place, mut kept_place) = (0, 0, 0, 0);
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Phase {
    /// What is one order ahead is of order 0.
    Begin,
    /// Present order k.
    Order,
}

struct Writer<'a> {
    model: &'a Model,
    vocabulary: Vocabulary<'a>,
    item: Item<'a, 'a>,
    recurrences: &'a Recurrences,
}

impl Writer<'_> {
    fn sizes(&self) -> TokenStream {
        let Recurrences { n_base, n_kept, n_products, .. } = self.recurrences;
        let add = quote!(size.n_products += #n_products; size.n_base += #n_base; size.n_kept += #n_kept;);
        looped(self.model, self.item.loops, &|from, to| quote!(#from..#to), add)
    }

    /// A program for each member of an item.
    fn pass(&self, kernel: &Kernel, phase: Phase) -> TokenStream {
        let Recurrences { n_base, n_kept, n_products, .. } = self.recurrences;
        let n_rows = self.item.n_rows();
        let read = |symbol: Symbol| self.read(phase, symbol);
        let place = |i| coordinate(self.item.slots, i);
        let Body { statements, outputs } =
            kernel::body_at(Numbers::Any, &kernel.program, self.vocabulary, &place, &read);
        let written = kernel.targets.iter().zip(outputs).map(|(&target, value)| {
            let place = self.place(phase, target);
            match target {
                // several items may push the same body
                Slot::Force(_) => {
                    let value = value.within(Binding::Product);
                    quote!(#place = #place + #value;)
                }
                _ => quote!(#place = #value;),
            }
        });
        let slots = slot_places(self.model, self.item.slots);
        let body = quote! {
            #slots
            #statements
            #(#written)*
            row_place += #n_rows;
            product_place += #n_products;
            base_place += #n_base;
            kept_place += #n_kept;
        };
        looped(self.model, self.item.loops, &|from, to| quote!(#from..#to), body)
    }

    fn read(&self, phase: Phase, symbol: Symbol) -> TokenStream {
        if let Some(id) = self.vocabulary.symbols.index_of(symbol) {
            let value = whole(self.model, &Whole::Index(id));
            return quote!(T::from_f64(#value as f64));
        }
        match self.recurrences.slots.slot(symbol) {
            Some(slot) => self.place(phase, slot),
            None => quote!(T::from_f64(f64::NAN)),
        }
    }

    /// Where a slot of a member is.
    fn place(&self, phase: Phase, slot: Slot) -> TokenStream {
        let order = |ahead: Ahead| match phase {
            Phase::Begin => {
                let order = Literal::usize_unsuffixed(ahead.saturating_sub(1));
                quote!(#order)
            }
            Phase::Order => {
                let ahead = Literal::usize_unsuffixed(ahead);
                quote!((k + #ahead))
            }
        };
        let of_order = |array: &str, row: TokenStream, ahead: Ahead, place: TokenStream| {
            let (array, order) = (Ident::new(array, Span::call_site()), order(ahead));
            quote!(#array[#order * #row + #place])
        };
        let member = |what: &str, i: usize| {
            let (place, i) = (format_ident!("{what}_place"), Literal::usize_unsuffixed(i));
            quote!(#place + #i)
        };
        match slot {
            Slot::Base(i) => {
                let place = member("base", i);
                quote!(base[#place])
            }
            Slot::Sum(i) => {
                let place = member("product", i);
                quote!(sums[#place])
            }
            Slot::Kept(ahead, i) => of_order("kept", quote!(n_kept), ahead, member("kept", i)),
            Slot::Coordinate(ahead, i) => of_order("q", quote!(n_q), ahead, coordinate(self.item.slots, i)),
            Slot::Force(i) => {
                let place = coordinate(self.item.slots, i);
                quote!(force[#place])
            }
            Slot::Acceleration(i) => {
                let place = coordinate(self.item.slots, i);
                quote!(a[#place])
            }
            Slot::Row(i) => {
                let place = member("row", i);
                quote!(row[#place])
            }
            Slot::Multiplier(i) => of_order("lambda", quote!(n_c), 0, member("row", i)),
            Slot::Left(ahead, i) => of_order("left", quote!(n_products), ahead, member("product", i)),
            Slot::Right(ahead, i) => of_order("right", quote!(n_products), ahead, member("product", i)),
            Slot::Order(ahead) => {
                let order = order(ahead);
                quote!(T::from_f64(#order as f64))
            }
            Slot::InverseOrder(ahead) => {
                let order = order(ahead);
                quote!(T::from_f64(1f64) / T::from_f64(#order as f64))
            }
        }
    }
}
