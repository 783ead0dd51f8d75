//! Kernels of scenes whose bodies are known: straight lines.

use proc_macro2::TokenStream;
use quote::quote;

use super::kernel::{self, Body, Vocabulary};
use super::parts::sequence;
use super::signature::{Signature, Writes, argument, give};
use crate::mechanics::derived::Straight;
use crate::mechanics::jacobians::{JacobianEntry, Jacobians};
use crate::mechanics::kernels::{Kernel, Pass, Put, Read};
use crate::symbolic::Symbol;

/// What a kernel does.
pub fn body(
    of: &Straight,
    n_fixed: usize,
    vocabulary: Vocabulary<'_>,
    signature: &Signature,
    kernel: &Kernel<'_>,
) -> TokenStream {
    let numbers = signature.numbers();
    let vectors = signature.writes.vectors();
    let passes = kernel.passes.iter().map(|pass| {
        let Body { statements, outputs } =
            kernel::body(numbers, &pass.program, vocabulary, &|symbol| read(pass, symbol));
        let (put, pivots) = outputs.split_at(pass.puts.len());
        let mut filled = vec![0_usize; vectors.len()];
        let puts = pass.puts.iter().zip(put).map(|(put, value)| match *put {
            Put::Next(vector) => {
                let (i, name) = (filled[vector], argument(vectors[vector]));
                filled[vector] += 1;
                quote!(#name[#i] = #value;)
            }
            Put::Start { index, rate, near } => {
                let give = give(rate, near);
                quote!(start.#give(#index, #value);)
            }
            // a straight line adds nothing up
            Put::Total | Put::Coordinate(_) | Put::Group(_) => quote!(#value),
        });
        // a value is no statement
        let puts = if matches!(signature.writes, Writes::Value) { puts.collect() } else { sequence(puts) };
        let seen = matches!(signature.writes, Writes::Solution(_)).then(|| kernel::pivots(&kernel.pivots, pivots));
        quote!(#statements #puts #seen)
    });
    let opening = opening(of, n_fixed, signature, kernel);
    quote!(#opening #(#passes)*)
}

/// Slices as arrays, so that their lengths are checked once.
fn opening(of: &Straight, n_fixed: usize, signature: &Signature, kernel: &Kernel<'_>) -> TokenStream {
    let is_zero = |pass: &Pass<'_>| pass.program.outputs().iter().all(|&output| pass.program.is_zero(output));
    if matches!(signature.writes, Writes::Value) && kernel.passes.iter().all(is_zero) {
        return TokenStream::new();
    }
    let (n_q, n_c) = (of.equations.mass.len(), of.equations.constraints.rows.len());
    let number = signature.numbers().name();
    let reads = signature.reads.iter().filter(|&&read| read != "t").map(|&read| match read {
        "lambda" | "residual" => (read, n_c),
        _ => (read, n_q),
    });
    let reads = std::iter::once(("c", n_fixed)).chain(reads).map(|(name, n)| {
        let name = argument(name);
        quote!(let #name = ezy::array::<#n, #number>(#name);)
    });
    let writes = signature.writes.vectors().iter().enumerate().map(|(i, &vector)| {
        let name = argument(vector);
        let puts = || kernel.passes.iter().flat_map(|pass| &pass.puts);
        let n = puts().filter(|&&put| put == Put::Next(i)).count();
        quote!(let #name = ezy::array_mut::<#n, #number>(#name);)
    });
    quote!(#(#reads)* #(#writes)*)
}

/// What a kernel reads besides time, coordinates, velocities and inputs.
fn read(pass: &Pass<'_>, symbol: Symbol) -> TokenStream {
    match pass.read(symbol) {
        Some(Read::Acceleration(i)) => quote!(a[#i]),
        Some(Read::Multiplier(row)) => quote!(lambda[#row]),
        Some(Read::Residual(row)) => quote!(residual[#row]),
        None => quote!(f64::NAN),
    }
}

/// The method that says where Jacobians are.
pub fn jacobian_places(jacobians: &Jacobians) -> TokenStream {
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
