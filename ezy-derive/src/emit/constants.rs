//! The function that computes everything that depends on parameters alone.

use std::collections::BTreeSet;

use proc_macro2::{Span, TokenStream};
use quote::{format_ident, quote};

use super::kernel::{self, LONGEST_WHOLE, Numbers};
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
        let needed: Vec<CoefficientId> = needed.into_iter().collect();
        let is_long = needed.len() > LONGEST_WHOLE;
        let writer = Values { constants: self, needed: is_long.then_some(&needed) };
        let temporaries = needed.iter().map(|&id| {
            let (name, value) = (writer.temporary(id), writer.value(id));
            if is_long { quote!(#name = #value;) } else { quote!(let #name = #value;) }
        });
        let temporaries: Vec<TokenStream> = temporaries.collect();
        let temporaries = if is_long {
            let (n, zero) = (needed.len(), Numbers::Any.literal(0.0));
            let computed = kernel::sequence(temporaries);
            quote!(let mut k = [#zero; #n]; #computed)
        } else {
            quote!(#(#temporaries)*)
        };
        let writes = pool.coefficients().iter().enumerate().map(|(i, &id)| {
            let (name, i) = (writer.temporary(id), n_inputs + i);
            quote!(c[#i] = #name;)
        });
        let writes = kernel::sequence(writes);
        let (n_parameters, n_fixed) = (self.parameters.len(), n_inputs + pool.coefficients().len());
        quote! {
            fn constants(&self, parameters: &[T], c: &mut [T]) {
                let parameters = ezy::array::<#n_parameters, T>(parameters);
                let c = ezy::array_mut::<#n_fixed, T>(c);
                #temporaries
                #writes
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
}

/// What temporaries hold, and where.
struct Values<'a> {
    constants: &'a Constants<'a>,
    /// All of them, ascending, where they are too many for names of their own: they are then entries of an array.
    needed: Option<&'a Vec<CoefficientId>>,
}

impl Values<'_> {
    fn value(&self, id: CoefficientId) -> TokenStream {
        match self.constants.coefficients.node(id) {
            CoefficientNode::Number(x) => Numbers::Any.literal(*x),
            CoefficientNode::Pi => quote!(T::PI),
            CoefficientNode::Parameter(index) => match self.constants.model.parameters.get(*index) {
                Some(_) => {
                    let place = self.constants.parameters.iter().position(|id| id.0 == *index).unwrap_or(0);
                    quote!(parameters[#place])
                }
                None => {
                    let field = &self.constants.model.counts[*index - self.constants.model.parameters.len()].name;
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

    fn temporary(&self, id: CoefficientId) -> TokenStream {
        if let Some(needed) = self.needed {
            let place = needed.binary_search(&id).unwrap_or_default();
            return quote!(k[#place]);
        }
        let parameter = match self.constants.coefficients.node(id) {
            CoefficientNode::Parameter(index) => self.constants.model.parameters.get(*index),
            _ => None,
        };
        let name = match parameter {
            Some(parameter) => format_ident!("parameter_{}", parameter.name, span = Span::mixed_site()),
            None => format_ident!("k{}", id.0, span = Span::mixed_site()),
        };
        quote!(#name)
    }
}
