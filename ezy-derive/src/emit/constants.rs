//! The function that computes everything that depends on parameters alone.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::kernel::Numbers;
use crate::model::{Model, ParameterId};
use crate::symbolic::coefficient::{Coefficient, CoefficientId, CoefficientNode, Coefficients};
use crate::symbolic::lower::ConstantPool;

/// Writes the function for a scene with these parameters.
pub struct Constants<'a> {
    pub model: &'a Model,
    pub parameters: &'a [ParameterId],
    pub coefficients: &'a Coefficients,
}

impl Constants<'_> {
    /// The method that writes the vector `c` behind its inputs.
    pub fn method(&self, pool: &ConstantPool, n_inputs: usize) -> TokenStream {
        let mut needed = BTreeSet::new();
        for &id in pool.coefficients() {
            self.collect(id, &mut needed);
        }
        // operands have smaller ids than what is computed from them
        let temporaries = needed.iter().map(|&id| {
            let name = self.temporary(id);
            let value = self.value(id);
            quote!(let #name = #value;)
        });
        let writes = pool.coefficients().iter().enumerate().map(|(i, &id)| {
            let (name, i) = (self.temporary(id), n_inputs + i);
            quote!(c[#i] = #name;)
        });
        let (n_parameters, n_fixed) = (self.parameters.len(), n_inputs + pool.coefficients().len());
        quote! {
            fn constants(&self, parameters: &[T], c: &mut [T]) {
                let parameters = ezy::array::<#n_parameters, T>(parameters);
                let c = ezy::array_mut::<#n_fixed, T>(c);
                #(#temporaries)*
                #(#writes)*
            }
        }
    }

    fn collect(&self, id: CoefficientId, needed: &mut BTreeSet<CoefficientId>) {
        if !needed.insert(id) {
            return;
        }
        let operands: Vec<CoefficientId> = match self.coefficients.node(id) {
            CoefficientNode::Number(_) | CoefficientNode::Pi | CoefficientNode::Parameter(_) => Vec::new(),
            CoefficientNode::Add(a, b) => vec![a.id, b.id],
            CoefficientNode::Mul(a, b) | CoefficientNode::Div(a, b) => vec![*a, *b],
            CoefficientNode::Call(_, arguments) => arguments.iter().map(|a| a.id).collect(),
        };
        for operand in operands {
            self.collect(operand, needed);
        }
    }

    fn value(&self, id: CoefficientId) -> TokenStream {
        match self.coefficients.node(id) {
            CoefficientNode::Number(x) => Numbers::Any.literal(*x),
            CoefficientNode::Pi => quote!(T::PI),
            CoefficientNode::Parameter(index) => match self.model.parameters.get(*index) {
                Some(_) => {
                    let place = self.parameters.iter().position(|id| id.0 == *index).unwrap_or(0);
                    quote!(parameters[#place])
                }
                None => {
                    let field = &self.model.counts[*index - self.model.parameters.len()].name;
                    quote!(T::from_f64(self.#field as f64))
                }
            },
            CoefficientNode::Add(a, b) => {
                let (x, y) = (self.temporary(a.id), self.temporary(b.id));
                match (a.negative, b.negative) {
                    (false, false) => quote!(#x + #y),
                    (false, true) => quote!(#x - #y),
                    (true, false) => quote!(#y - #x),
                    (true, true) => quote!(-(#x + #y)),
                }
            }
            CoefficientNode::Mul(a, b) => {
                let (x, y) = (self.temporary(*a), self.temporary(*b));
                quote!(#x * #y)
            }
            CoefficientNode::Div(a, b) => {
                let (x, y) = (self.temporary(*a), self.temporary(*b));
                quote!(#x / #y)
            }
            CoefficientNode::Call(function, arguments) => {
                let arguments: Vec<TokenStream> = arguments.iter().map(|k| self.signed(k)).collect();
                Numbers::Any.call(*function, &arguments)
            }
        }
    }

    fn signed(&self, k: &Coefficient) -> TokenStream {
        let name = self.temporary(k.id);
        if k.negative { quote!(-#name) } else { quote!(#name) }
    }

    fn temporary(&self, id: CoefficientId) -> Ident {
        let parameter = match self.coefficients.node(id) {
            CoefficientNode::Parameter(index) => self.model.parameters.get(*index),
            _ => None,
        };
        match parameter {
            Some(parameter) => format_ident!("parameter_{}", parameter.name, span = Span::mixed_site()),
            None => format_ident!("k{}", id.0, span = Span::mixed_site()),
        }
    }
}
