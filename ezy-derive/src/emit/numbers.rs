//! The numbers that emitted code computes with.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::function::{Function, Path};

/// The numbers that a kernel computes with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Numbers {
    F64,
    /// Any `T` that is a `Scalar`.
    Any,
}

impl Numbers {
    /// Their type.
    pub fn name(self) -> TokenStream {
        match self {
            Self::F64 => quote!(f64),
            Self::Any => quote!(T),
        }
    }

    /// A number; what overflowed while numbers were folded has no literal.
    pub fn literal(self, x: f64) -> TokenStream {
        let number = if x.is_nan() {
            quote!(f64::NAN)
        } else if x.is_infinite() {
            quote!(f64::INFINITY)
        } else {
            quote!(#x)
        };
        self.convert(number)
    }

    /// From an expression that is an `f64`.
    pub fn convert(self, x: TokenStream) -> TokenStream {
        match self {
            Self::F64 => x,
            Self::Any => quote!(T::from_f64(#x)),
        }
    }

    /// A part of a long kernel, a function of its own, which the compiler optimises by itself.
    pub fn part(self, statements: &TokenStream) -> TokenStream {
        match self {
            Self::F64 => quote!((|| { #statements })();),
            Self::Any => quote!(T::in_part(#[inline(always)] || { #statements });),
        }
    }

    /// A call of a function of the model language.
    pub fn call(self, function: Function, arguments: &[TokenStream]) -> TokenStream {
        let ident = |segment: &str| Ident::new(segment, Span::call_site());
        let path = match (self, function.path()) {
            (Self::F64, Path::OfKernel(name)) => {
                let name = ident(name);
                quote!(ezy::#name)
            }
            (_, Path::OfNumber(name) | Path::OfKernel(name)) => {
                let (number, name) = (self.name(), ident(name));
                quote!(#number::#name)
            }
        };
        quote!(#path(#(#arguments),*))
    }
}
