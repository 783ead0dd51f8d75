//! Kernels that loop over the members of each item.
//!
//! A pass of a loop knows where the bodies that it refers to stand (`slots`), and counts on where its results go
//! (`place`), or which rows are its own.

use proc_macro2::TokenStream;
use quote::quote;

use super::loops::{looped, members, whole};
use super::slots::{coordinate, firsts, slot_places};
use crate::emit::kernel::{self, Binding, Body, Expression, Vocabulary};
use crate::emit::signature::{Signature, Writes, argument, give};
use crate::mechanics::kernels::{Kernel, Over, Pass, Put, Quantity, Read};
use crate::model::Model;
use crate::model::whole::Whole;
use crate::symbolic::Symbol;

/// What a kernel does.
pub fn body(model: &Model, vocabulary: Vocabulary<'_>, signature: &Signature, kernel: &Kernel<'_>) -> TokenStream {
    let passes: Vec<TokenStream> =
        kernel.passes.iter().map(|pass| Writer { model, vocabulary, signature, pass }.pass()).collect();
    let firsts = kernel.passes.iter().any(|pass| !matches!(pass.over, Over::Members(_))).then(|| firsts(model));
    let counters = counters(signature, kernel);
    let zero = signature.numbers().convert(quote!(0.0));
    let (opening, result) = match (signature.quantity, signature.writes) {
        (Quantity::AppliedForce | Quantity::Power, _) => (quote!(out.fill(#zero);), quote!()),
        (_, Writes::Value) => (quote!(let mut total = #zero;), quote!(total)),
        _ => (quote!(), quote!()),
    };
    quote!(#firsts #counters #opening #(#passes)* #result)
}

/// The counters that some pass moves on.
fn counters(signature: &Signature, kernel: &Kernel<'_>) -> TokenStream {
    let vectors = signature.writes.vectors().iter().enumerate();
    let filled = vectors.filter(|&(i, _)| kernel.passes.iter().any(|pass| pass.puts.contains(&Put::Next(i))));
    let mut names: Vec<&str> = filled.map(|(_, vector)| counter(vector)).collect();
    names.extend(kernel.passes.iter().any(|pass| pass.n_rows > 0).then_some("place"));
    let names = names.into_iter().map(argument);
    quote!(#(let mut #names = 0;)*)
}

/// What counts the entries of a vector.
fn counter(vector: &str) -> &'static str {
    match vector {
        "by_q" => "place_q",
        "by_v" => "place_v",
        _ => "place",
    }
}

struct Writer<'a> {
    model: &'a Model,
    vocabulary: Vocabulary<'a>,
    signature: &'a Signature,
    pass: &'a Pass<'a>,
}

impl Writer<'_> {
    fn pass(&self) -> TokenStream {
        let Pass { over, slots, program, puts, n_rows, .. } = self.pass;
        let place = |i| coordinate(slots, i);
        let Body { statements, outputs } =
            kernel::body_at(self.signature.numbers(), program, self.vocabulary, &place, &|symbol| self.read(symbol));
        let puts = puts.iter().zip(outputs).map(|(put, value)| self.put(*put, &value));
        let rows = (*n_rows > 0).then(|| quote!(place += #n_rows;));
        match over {
            Over::Loops(loops) => {
                let slots = slot_places(self.model, slots);
                let body = quote!(#slots #statements #(#puts)* #rows);
                looped(self.model, loops, &|from, to| quote!(#from..#to), body)
            }
            Over::Members(array) => {
                let members = members(self.model, &self.model.arrays[*array]);
                quote!(for _ in 0..#members { #statements #(#puts)* })
            }
        }
    }

    fn put(&self, put: Put, value: &Expression) -> TokenStream {
        match put {
            Put::Next(vector) => {
                let vector = self.signature.writes.vectors()[vector];
                let (counter, vector) = (argument(counter(vector)), argument(vector));
                quote!(#vector[#counter] = #value; #counter += 1;)
            }
            Put::Coordinate(i) => {
                let (place, value) = (coordinate(&self.pass.slots, i), value.within(Binding::Product));
                quote!(out[#place] = out[#place] + #value;)
            }
            Put::Group(i) => quote!(out[#i] += #value;),
            Put::Total => quote!(total += #value;),
            Put::Start { index, rate, near } => {
                let (place, give) = (coordinate(&self.pass.slots, index), give(rate, near));
                quote!(start.#give(#place, #value);)
            }
        }
    }

    /// What the pass reads besides time, coordinates, velocities and inputs.
    fn read(&self, symbol: Symbol) -> TokenStream {
        if let Some(id) = self.vocabulary.symbols.index_of(symbol) {
            let value = whole(self.model, &Whole::Index(id));
            return self.signature.numbers().convert(quote!((#value as f64)));
        }
        match self.pass.read(symbol) {
            Some(Read::Acceleration(i)) => {
                let i = coordinate(&self.pass.slots, i);
                quote!(a[#i])
            }
            Some(Read::Multiplier(row)) => quote!(lambda[place + #row]),
            Some(Read::Residual(row)) => quote!(residual[place + #row]),
            None => quote!(f64::NAN),
        }
    }
}
