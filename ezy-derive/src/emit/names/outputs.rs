//! The outputs of a scene as fields.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{Shared, field_documentation};
use crate::emit::loops::{looped, whole};
use crate::model::{Model, Output};

/// The type of scenes with these outputs; nothing without outputs.
pub fn definition(model: &Model, shared: &Shared<'_, usize>) -> Option<TokenStream> {
    let (type_name, title, lifetime) = (&shared.type_name, shared.title("Outputs"), lifetime(model, shared));
    let fields = declarations(model, shared).map(|outputs| {
        let Output { name, documentation, unit, .. } = outputs[0];
        let documentation = field_documentation(&format!("Output `{name}`"), documentation, unit);
        let scalar = match n_indices(outputs[0]) {
            0 => quote!(f64),
            n => {
                let n = Literal::usize_unsuffixed(n);
                quote!(ezy::OutputArray<'a, #n>)
            }
        };
        let kind = if outputs.len() == 1 { scalar } else { quote!(ezy::Vector<#scalar>) };
        quote!(#[doc = #documentation] pub #name: #kind)
    });
    (!shared.items.is_empty()).then(|| {
        quote! {
            #[doc = #title]
            #[derive(Debug, Clone, Copy)]
            pub struct #type_name #lifetime { #(#fields),* }
        }
    })
}

/// The type, as the module of the model calls it.
pub fn type_of(model: &Model, shared: &Shared<'_, usize>) -> TokenStream {
    let (type_name, lifetime) = (&shared.type_name, lifetime(model, shared));
    if shared.items.is_empty() { quote!(ezy::NoOutputs) } else { quote!(names::#type_name #lifetime) }
}

/// Its value, from `values`.
pub fn read(model: &Model, shared: &Shared<'_, usize>) -> TokenStream {
    if shared.items.is_empty() {
        return quote!(ezy::NoOutputs);
    }
    let type_name = &shared.type_name;
    let fields = declarations(model, shared).map(|outputs| {
        let name = &outputs[0].name;
        let scalar = scalar(model, outputs[0]);
        match outputs.len() {
            1 => quote!(#name: #scalar),
            _ => quote!(#name: ezy::Vector { x: #scalar, y: #scalar }),
        }
    });
    let fields: Vec<_> = fields.collect();
    quote! {
        let mut outputs = ezy::OutputReader::new(values);
        names::#type_name { #(#fields),* }
    }
}

/// The next values, those of an output.
fn scalar(model: &Model, output: &Output) -> TokenStream {
    if output.loops.is_empty() {
        return quote!(outputs.number());
    }
    if n_indices(output) == output.loops.len() {
        let ranges = output.loops.iter().map(|range| {
            let (from, to) = (whole(model, &range.from), whole(model, &range.to));
            quote!([#from, #to])
        });
        return quote!(outputs.array([#(#ranges),*]));
    }
    let count = looped(model, &output.loops, &|from, to| quote!(#from..#to), quote!(n += 1;));
    quote! {{
        let mut n: i64 = 0;
        #count
        outputs.array([[0, n]])
    }}
}

/// The indices of an output: those of its loops; where the range of a loop depends on another one, its place among all.
fn n_indices(output: &Output) -> usize {
    let depends = output.loops.iter().any(|range| range.from.innermost().or(range.to.innermost()).is_some());
    if depends { 1 } else { output.loops.len() }
}

/// One output, or the two of a vector, for each declaration.
fn declarations<'a>(model: &'a Model, shared: &'a Shared<'_, usize>) -> impl Iterator<Item = Vec<&'a Output>> {
    let outputs: Vec<&Output> = shared.items.iter().map(|&i| &model.outputs[i]).collect();
    let mut all: Vec<Vec<&Output>> = Vec::new();
    for output in outputs {
        match all.last_mut() {
            Some(last) if last[0].name == output.name => last.push(output),
            _ => all.push(vec![output]),
        }
    }
    all.into_iter()
}

fn lifetime(model: &Model, shared: &Shared<'_, usize>) -> Option<TokenStream> {
    let repeated = shared.items.iter().any(|&i| !model.outputs[i].loops.is_empty());
    repeated.then(|| quote!(<'a>))
}
