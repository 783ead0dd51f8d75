//! The function that computes everything that depends on parameters alone.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::kernel;
use crate::model::Model;
use crate::symbolic::coefficient::{Coefficient, CoefficientId, CoefficientNode, Coefficients};
use crate::symbolic::lower::ConstantPool;

/// Statements that write the vector `c` behind its inputs from the fields of `self`.
pub fn statements(model: &Model, coefficients: &Coefficients, pool: &ConstantPool, n_inputs: usize) -> TokenStream {
    let mut needed = BTreeSet::new();
    for &id in pool.coefficients() {
        collect(coefficients, id, &mut needed);
    }
    // operands have smaller ids than what is computed from them
    let temporaries = needed.iter().map(|&id| {
        let name = temporary(id);
        let value = value(model, coefficients, id);
        quote!(let #name = #value;)
    });
    let writes = pool.coefficients().iter().enumerate().map(|(i, &id)| {
        let (name, i) = (temporary(id), n_inputs + i);
        quote!(c[#i] = #name;)
    });
    quote!(#(#temporaries)* #(#writes)*)
}

fn collect(coefficients: &Coefficients, id: CoefficientId, needed: &mut BTreeSet<CoefficientId>) {
    if !needed.insert(id) {
        return;
    }
    let operands: Vec<CoefficientId> = match coefficients.node(id) {
        CoefficientNode::Number(_) | CoefficientNode::Pi | CoefficientNode::Parameter(_) => Vec::new(),
        CoefficientNode::Add(a, b) => vec![a.id, b.id],
        CoefficientNode::Mul(a, b) | CoefficientNode::Div(a, b) => vec![*a, *b],
        CoefficientNode::Call(_, arguments) => arguments.iter().map(|a| a.id).collect(),
    };
    for operand in operands {
        collect(coefficients, operand, needed);
    }
}

fn value(model: &Model, coefficients: &Coefficients, id: CoefficientId) -> TokenStream {
    match coefficients.node(id) {
        CoefficientNode::Number(x) => kernel::number(*x),
        CoefficientNode::Pi => quote!(::core::f64::consts::PI),
        CoefficientNode::Parameter(index) => match model.parameters.get(*index) {
            Some(parameter) => {
                let field = &parameter.name;
                quote!(self.#field)
            }
            None => {
                let field = &model.counts[*index - model.parameters.len()].name;
                quote!((self.#field as f64))
            }
        },
        CoefficientNode::Add(a, b) => {
            let (x, y) = (temporary(a.id), temporary(b.id));
            match (a.negative, b.negative) {
                (false, false) => quote!(#x + #y),
                (false, true) => quote!(#x - #y),
                (true, false) => quote!(#y - #x),
                (true, true) => quote!(-(#x + #y)),
            }
        }
        CoefficientNode::Mul(a, b) => {
            let (x, y) = (temporary(*a), temporary(*b));
            quote!(#x * #y)
        }
        CoefficientNode::Div(a, b) => {
            let (x, y) = (temporary(*a), temporary(*b));
            quote!(#x / #y)
        }
        CoefficientNode::Call(function, arguments) => {
            let arguments: Vec<TokenStream> = arguments.iter().map(signed).collect();
            kernel::call(*function, &arguments)
        }
    }
}

fn signed(k: &Coefficient) -> TokenStream {
    let name = temporary(k.id);
    if k.negative { quote!(-#name) } else { quote!(#name) }
}

fn temporary(id: CoefficientId) -> Ident {
    format_ident!("k{}", id.0, span = Span::mixed_site())
}
