//! The inputs of a scene as fields.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{Shared, field_documentation};
use crate::model::{InputId, Model};

/// The type of scenes with these inputs; nothing without inputs.
pub fn definition(model: &Model, shared: &Shared<'_, InputId>) -> Option<TokenStream> {
    let (type_name, title) = (&shared.type_name, shared.title("Inputs"));
    let inputs: Vec<_> = shared.items.iter().map(|id| &model.inputs[id.0]).collect();
    let fields = inputs.iter().map(|input| {
        let name = &input.name;
        let documentation = field_documentation(&format!("Input `{name}`"), &input.documentation, &input.unit);
        quote!(#[doc = #documentation] pub #name: f64)
    });
    let names: Vec<_> = inputs.iter().map(|input| &input.name).collect();
    let places: Vec<_> = (0..names.len()).map(Literal::usize_unsuffixed).collect();
    let n = Literal::usize_unsuffixed(names.len());
    (!inputs.is_empty()).then(|| {
        quote! {
            #[doc = #title]
            #[derive(Debug, Clone, Copy, PartialEq)]
            pub struct #type_name { #(#fields),* }

            impl ezy::NamedInputs for #type_name {
                fn read(values: &[f64]) -> Self {
                    let values = ezy::array::<#n, f64>(values);
                    Self { #(#names: values[#places]),* }
                }

                fn write(&self, values: &mut [f64]) {
                    *ezy::array_mut::<#n, f64>(values) = [#(self.#names),*];
                }
            }
        }
    })
}

/// The type, as the module of the model calls it.
pub fn type_of(shared: &Shared<'_, InputId>) -> TokenStream {
    let type_name = &shared.type_name;
    if shared.items.is_empty() { quote!(ezy::NoInputs) } else { quote!(names::#type_name) }
}
