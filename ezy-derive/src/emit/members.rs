//! Constants that depend on indices of `for`. Each pass of the innermost one has its own; they stand behind the other constants,
//! so that a kernel reads them and computes none.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::loops::passes;
use crate::model::Model;
use crate::model::whole::IndexId;
use crate::symbolic::coefficient::CoefficientId;

/// What each pass of a `for` has for itself.
pub struct OfMembers {
    /// Place among all of the scene.
    block: usize,
    pub index: IndexId,
    /// In the order in which they stand.
    pub stored: Vec<CoefficientId>,
}

impl OfMembers {
    /// By the index of the innermost `for` that each of the `stored` depends on.
    pub fn all(stored: impl Iterator<Item = (IndexId, CoefficientId)>) -> Vec<Self> {
        let mut all: Vec<Self> = Vec::new();
        for (index, id) in stored {
            match all.iter_mut().find(|of| of.index == index) {
                Some(of) => of.stored.push(id),
                None => all.push(Self { block: all.len(), index, stored: vec![id] }),
            }
        }
        all
    }

    /// Where the constants of the present pass begin in `c`.
    fn counter(&self) -> Ident {
        format_ident!("member_{}", self.block)
    }

    pub fn place(&self, i: usize) -> TokenStream {
        let (counter, i) = (self.counter(), Literal::usize_unsuffixed(i));
        quote!(#counter + #i)
    }

    pub fn begin(&self) -> TokenStream {
        let (counter, block) = (self.counter(), Literal::usize_unsuffixed(self.block));
        quote!(let mut #counter = members[#block];)
    }

    /// On to the next pass.
    pub fn step(&self) -> TokenStream {
        let (counter, n) = (self.counter(), Literal::usize_unsuffixed(self.stored.len()));
        quote!(#counter += #n;)
    }
}

/// The function that knows where they are, behind `n_before` other numbers.
pub fn places(model: &Model, all: &[OfMembers], n_before: usize) -> Option<TokenStream> {
    let n = Literal::usize_unsuffixed(all.len() + 1);
    let blocks = all.iter().enumerate().map(|(i, of)| {
        let (n, passes) = (Literal::usize_unsuffixed(of.stored.len()), passes(model, model.loops_to(of.index)));
        let (block, next) = (Literal::usize_unsuffixed(i), Literal::usize_unsuffixed(i + 1));
        quote!(members[#next] = members[#block] + #n * (#passes) as usize;)
    });
    (!all.is_empty()).then(|| {
        quote! {
            /// Where the constants of the members of each `for` begin in `c`, and where all of them end.
            fn members(&self) -> [usize; #n] {
                let mut members = [#n_before; #n];
                #(#blocks)*
                members
            }
        }
    })
}
