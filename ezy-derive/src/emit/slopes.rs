//! The slopes of the equations of motion as methods.

use proc_macro2::TokenStream;
use quote::quote;

use crate::mechanics::slopes::{Read, Slopes};
use crate::symbolic::Symbol;

/// Where a kernel finds the accelerations and multipliers that slopes read.
pub fn source(
    slopes: &Slopes,
    symbol: Symbol,
    acceleration: &dyn Fn(usize) -> TokenStream,
    multiplier: &dyn Fn(usize) -> TokenStream,
) -> TokenStream {
    match slopes.read(symbol) {
        Some(Read::Acceleration(i)) => acceleration(i),
        Some(Read::Multiplier(row)) => multiplier(row),
        None => quote!(f64::NAN),
    }
}

/// Both methods around what they do.
pub fn methods(places: TokenStream, kernel: TokenStream) -> TokenStream {
    quote! {
        fn slope_places(&self) -> ::core::option::Option<::ezy_core::model::SlopePlaces> {
            #places
        }
        fn slopes(
            &self,
            c: &[f64],
            t: f64,
            q: &[f64],
            v: &[f64],
            a: &[f64],
            lambda: &[f64],
            by_q: &mut [f64],
            by_v: &mut [f64],
        ) {
            #kernel
        }
    }
}
