//! Kernels as the bodies of methods.
//!
//! A scene whose bodies are known has one pass: a straight line on slices that are opened as arrays, so that their lengths are
//! checked once. A scene with counts has one for each item, in loops over its members: a pass knows where the bodies that it
//! refers to stand (`slots`), and counts on where its results go and what is its own.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::kernel::{self, Binding, Body, Expression, Vocabulary};
use super::loops::stepped;
use super::parts::sequence;
use super::places::{Array, Lengths, OF_SERIES, Places, counter, firsts, slot_places};
use super::signature::{Order, Signature, Writes, argument, give};
use crate::mechanics::kernels::{Entries, Kernel, Pass, Put, Quantity, Read, Slot};
use crate::mechanics::symbols::Meaning;
use crate::model::Model;
use crate::symbolic::Symbol;
use crate::symbolic::program::{Node, Program};

/// A kernel and the method that it becomes.
#[derive(Clone, Copy)]
pub struct Method<'a> {
    pub model: &'a Model,
    pub vocabulary: Vocabulary<'a>,
    pub signature: &'a Signature,
    pub kernel: &'a Kernel<'a>,
}

impl Method<'_> {
    /// In a scene whose bodies are known.
    pub fn straight(self, lengths: &Lengths) -> TokenStream {
        let passes = self.kernel.passes.iter();
        let passes = passes.map(|pass| Writer { of: self, pass, places: Places::Fixed }.straight(lengths));
        let opening = self.opening(lengths);
        let seen = match (self.signature.writes, &self.kernel.pivots) {
            (Writes::Store(Order::Start), None) => Some(quote!(ezy::Pivots::ALL_VANISHED)),
            _ => None,
        };
        quote!(#opening #(#passes)* #seen)
    }

    /// Slices as arrays. Of the storage of a series, each program opens what it reads.
    fn opening(self, lengths: &Lengths) -> TokenStream {
        let is_zero = |pass: &Pass<'_>| pass.program.outputs().iter().all(|&output| pass.program.is_zero(output));
        let is_unread = match self.signature.writes {
            Writes::Value => self.kernel.passes.iter().all(is_zero),
            Writes::Store(_) => true,
            _ => false,
        };
        if is_unread {
            return TokenStream::new();
        }
        let number = self.signature.numbers().name();
        let reads = self.signature.reads.iter().filter(|&&read| read != "t").map(|&read| match read {
            "lambda" | "residual" => (read, lengths.of(Entries::Rows)),
            "quasi" => (read, lengths.of(Entries::QuasiVelocities)),
            "of_time" => (read, lengths.of(Entries::OfTime)),
            "sines" => (read, lengths.of(Entries::Sines)),
            _ => (read, lengths.of(Entries::Coordinates)),
        });
        let reads = std::iter::once(("c", lengths.n_fixed)).chain(reads).map(|(name, n)| {
            let name = argument(name);
            quote!(let #name = ezy::array::<#n, #number>(#name);)
        });
        let writes = self.signature.writes.vectors().iter().enumerate().map(|(i, &vector)| {
            let name = argument(vector);
            let puts = || self.kernel.passes.iter().flat_map(|pass| &pass.puts);
            let n = puts().filter(|&&put| put == Put::Next(i)).count();
            quote!(let #name = ezy::array_mut::<#n, #number>(#name);)
        });
        quote!(#(#reads)* #(#writes)*)
    }

    /// In a scene with counts.
    pub fn looped(self) -> TokenStream {
        let passes: Vec<TokenStream> = (self.kernel.passes.iter())
            .map(|pass| Writer { of: self, pass, places: Places::Member(&pass.slots) }.looped())
            .collect();
        let has_slots = |pass: &Pass<'_>| !pass.slots.is_empty();
        let firsts = self.kernel.passes.iter().any(has_slots).then(|| firsts(self.model));
        let counters = self.counters();
        let zero = self.signature.numbers().literal(0.0);
        let (opening, result) = match self.signature.quantity {
            Quantity::AppliedForce | Quantity::Power | Quantity::ElementPowers => (quote!(out.fill(#zero);), quote!()),
            Quantity::PotentialEnergy => (quote!(let mut total = #zero;), quote!(total)),
            Quantity::SeriesBegin => {
                let rows = quote!(let (q, v) = q[..2 * n_q].split_at(n_q););
                (store(&quote!(#rows force.fill(#zero);)), quote!(ezy::Pivots::ALL_VANISHED))
            }
            Quantity::SeriesRightSide => (store(&quote!(force.fill(#zero);)), quote!()),
            Quantity::SeriesFinish => {
                let inverse = quote!(T::from_f64(1f64) / T::from_f64(((k + 1) * (k + 2)) as f64));
                let rows = quote!(q[(k + 2) * n_q..(k + 3) * n_q].iter_mut().zip(a.iter()));
                let coordinates = quote!(let inverse = #inverse; #rows.for_each(|(q, a)| *q = *a * inverse););
                (store(&coordinates), quote!())
            }
            _ => (quote!(), quote!()),
        };
        let constants = self.vocabulary.constants;
        let reads_members = self.kernel.passes.iter().any(|pass| !constants.members_in(pass).is_empty());
        let members = reads_members.then(|| quote!(let members = self.members();));
        quote!(#firsts #members #opening #counters #(#passes)* #result)
    }

    /// Whether a kernel of a scene with counts reads sines of the angles of its bodies.
    pub fn reads_sines(self) -> bool {
        let is_angle = |program: &Program, id| match program.node(id) {
            Node::Input(symbol) => matches!(self.vocabulary.symbols.meaning(*symbol), Meaning::Coordinate(_)),
            _ => false,
        };
        let mut passes = self.kernel.passes.iter().map(|pass| &pass.program);
        self.signature.with_sines().is_some()
            && passes.any(|program| {
                program.live().into_iter().any(|id| match program.node(id) {
                    Node::Sin(angle) | Node::Cos(angle) => is_angle(program, *angle),
                    _ => false,
                })
            })
    }

    /// The counters that some pass moves on.
    fn counters(self) -> TokenStream {
        let vectors = self.signature.writes.vectors().iter().enumerate();
        let fills = |i| self.kernel.passes.iter().any(|pass| pass.puts.contains(&Put::Next(i)));
        let filled = vectors.filter(|&(i, _)| fills(i)).map(|(_, vector)| place_in(vector));
        let own = [Entries::Rows].into_iter().chain(OF_SERIES).filter(|&of| self.kernel.n(of) > 0).map(counter);
        let names = filled.chain(own);
        quote!(#(let mut #names = 0;)*)
    }
}

/// The arrays of the storage of a series with the lengths of their rows, and what is done with them first.
fn store(first: &TokenStream) -> TokenStream {
    quote! {
        let ezy::SeriesStore { q, lambda, left, right, sums, kept, base, force, row, a } = store;
        let (n_q, n_c, n_products) = (force.len(), row.len(), sums.len());
        let n_kept = if n_q == 0 { 0 } else { kept.len() / (q.len() / n_q) };
        #first
    }
}

/// What counts the entries of a vector.
fn place_in(vector: &str) -> Ident {
    argument(match vector {
        "by_q" => "place_q",
        "by_v" => "place_v",
        _ => "place",
    })
}

struct Writer<'a> {
    of: Method<'a>,
    pass: &'a Pass<'a>,
    places: Places<'a>,
}

impl Writer<'_> {
    fn body(&self) -> Body {
        let (numbers, place) = (self.of.signature.numbers(), |i| self.places.index(Entries::Coordinates, i));
        let sines = |i| self.of.signature.with_sines().and_then(|_| self.places.sines(i));
        kernel::body(numbers, &self.pass.program, self.of.vocabulary, &place, &|symbol| self.read(symbol), &sines)
    }

    fn straight(&self, lengths: &Lengths) -> TokenStream {
        let Body { statements, outputs } = self.body();
        let (values, pivots) = outputs.split_at(self.pass.puts.len());
        let (opening, puts) = match self.of.signature.writes {
            Writes::Store(order) => (self.stored_reads(lengths, order), self.stored_puts(values, lengths, order)),
            // a value is no statement
            Writes::Value => (quote!(), self.puts(values).collect()),
            _ => (quote!(), sequence(self.puts(values))),
        };
        let seen = self.of.kernel.pivots.as_ref().map(|rows| kernel::pivots(rows, pivots));
        quote!(#opening #statements #puts #seen)
    }

    fn looped(&self) -> TokenStream {
        let Body { statements, outputs } = self.body();
        let (puts, model) = (self.puts(&outputs), self.of.model);
        let moved = self.pass.lengths.iter().filter(|&&(_, n)| n > 0).map(|&(what, n)| {
            let counter = counter(what);
            quote!(#counter += #n;)
        });
        let has_slots = !self.pass.slots.is_empty();
        let slots = has_slots.then(|| slot_places(model, &self.pass.slots));
        let body = quote!(#slots #statements #(#puts)* #(#moved)*);
        let read = self.of.vocabulary.constants.members_in(self.pass);
        let begin = read.iter().map(|of| of.begin());
        let pass = stepped(model, self.pass.loops, &|from, to| quote!(#from..#to), body, &|around| {
            read.iter().filter(|of| of.index == around.index).map(|of| of.step()).collect()
        });
        quote!(#(#begin)* #pass)
    }

    /// What the pass reads besides time, coordinates, velocities and inputs.
    fn read(&self, symbol: Symbol) -> TokenStream {
        let numbers = self.of.signature.numbers();
        match self.pass.read(symbol) {
            Some(Read::Acceleration(i)) => {
                let i = self.places.index(Entries::Coordinates, i);
                quote!(a[#i])
            }
            Some(Read::Multiplier(row)) => {
                let row = self.places.index(Entries::Rows, row);
                quote!(lambda[#row])
            }
            Some(Read::Residual(row)) => {
                let row = self.places.index(Entries::Rows, row);
                quote!(residual[#row])
            }
            Some(Read::QuasiVelocity(k)) => quote!(quasi[#k]),
            Some(Read::OfTime(k)) => quote!(of_time[#k]),
            Some(Read::Sine(k)) => quote!(sines[#k]),
            Some(Read::Slot(slot)) => self.stored(slot),
            None => numbers.literal(f64::NAN),
        }
    }

    /// A number in the storage of a series.
    fn stored(&self, slot: Slot) -> TokenStream {
        let Writes::Store(order) = self.of.signature.writes else { return quote!(f64::NAN) };
        self.places.stored(slot, order)
    }

    /// A statement for each output.
    fn puts<'v>(&'v self, values: &'v [Expression]) -> impl Iterator<Item = TokenStream> + 'v {
        let vectors = self.of.signature.writes.vectors();
        let mut filled = vec![0_usize; vectors.len()];
        self.pass.puts.iter().zip(values).map(move |(put, value)| match (*put, self.places) {
            (Put::Next(vector), Places::Fixed) => {
                let (i, name) = (filled[vector], argument(vectors[vector]));
                filled[vector] += 1;
                quote!(#name[#i] = #value;)
            }
            (Put::Next(vector), Places::Member(_)) => {
                let (place, vector) = (place_in(vectors[vector]), argument(vectors[vector]));
                quote!(#vector[#place] = #value; #place += 1;)
            }
            (Put::Coordinate(i), places) => {
                let (i, value) = (places.index(Entries::Coordinates, i), value.within(Binding::Product));
                quote!(out[#i] = out[#i] + #value;)
            }
            (Put::Group(i), _) => quote!(out[#i] += #value;),
            (Put::Total, Places::Fixed) => quote!(#value),
            (Put::Total, Places::Member(_)) => quote!(total += #value;),
            (Put::Start { index, rate, near }, places) => {
                let (index, give) = (places.index(Entries::Coordinates, index), give(rate, near));
                quote!(start.#give(#index, #value);)
            }
            // several items may push the same body
            (Put::Slot(slot @ Slot::Force(_)), _) => {
                let (place, value) = (self.stored(slot), value.within(Binding::Product));
                quote!(#place = #place + #value;)
            }
            (Put::Slot(slot), _) => {
                let place = self.stored(slot);
                quote!(#place = #value;)
            }
        })
    }

    /// The arrays that a program reads, opened once.
    fn stored_reads(&self, lengths: &Lengths, order: Order) -> TokenStream {
        let slots = self.pass.reads.iter().filter_map(|&(_, read)| match read {
            Read::Slot(slot) => Array::of(slot),
            _ => None,
        });
        let arrays: BTreeSet<Array> = slots.map(|(array, _)| array).collect();
        let arrays = arrays.into_iter().map(|array| array.opened(lengths, order));
        let n = lengths.n_fixed;
        let c = self.pass.program.constants().next().is_some().then(|| quote!(let c = ezy::array::<#n, T>(c);));
        let state = matches!(order, Order::Start).then(|| {
            let n = lengths.of(Entries::Coordinates);
            quote!(let q = ezy::row::<#n, T>(&store.q, 0); let v = ezy::row::<#n, T>(&store.q, 1);)
        });
        quote!(#c #state #(#arrays)*)
    }

    /// Writes of all outputs, array by array.
    fn stored_puts(&self, values: &[Expression], lengths: &Lengths, order: Order) -> TokenStream {
        let mut arrays: BTreeMap<Array, Vec<TokenStream>> = BTreeMap::new();
        for (put, value) in self.pass.puts.iter().zip(values) {
            let Put::Slot(slot) = *put else { continue };
            let Some((array, i)) = Array::of(slot) else { continue };
            arrays.entry(array).or_default().push(quote!(target[#i] = #value;));
        }
        let arrays = arrays.into_iter().map(|(array, writes)| {
            let (target, writes) = (array.target(lengths, order), sequence(writes));
            quote!(#target #writes)
        });
        arrays.collect()
    }
}
