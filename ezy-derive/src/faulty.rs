//! Placeholders that are emitted beside the errors of a model: the names that programs use.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::model::case::{camel_case, snake_case};
use crate::parse::ast::{Item, ItemKind, Model};
use crate::parse::is_rust_keyword;

/// The module of the model with a type for each scene that could be read, and every parameter as a field.
pub fn model(model: &Model) -> TokenStream {
    let module = snake_case(&model.name.to_string());
    // without its header a model has no name
    if is_rust_keyword(&module) || model.broken.contains(&model.name) {
        return TokenStream::new();
    }
    let (visibility, module) = (&model.visibility, Ident::new(&module, model.name.span()));
    let mut fields = Vec::new();
    let mut taken = BTreeSet::new();
    collect(&model.items, &mut fields, &mut taken);
    let mut types = BTreeSet::new();
    let scenes = model.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Scene(scene) => {
            let name = camel_case(&scene.name.to_string());
            (!is_rust_keyword(&name) && types.insert(name.clone())).then(|| Ident::new(&name, scene.name.span()))
        }
        _ => None,
    });
    let scenes = scenes.map(|scene| quote!(#scene { #(#fields),* }));
    let core = &model.core;
    quote!(#core::__private::faulty_model! { #visibility mod #module { #(#scenes)* } })
}

fn collect(items: &[Item], fields: &mut Vec<TokenStream>, taken: &mut BTreeSet<String>) {
    for item in items {
        match &item.kind {
            ItemKind::Parameter(parameter) if taken.insert(parameter.name.to_string()) => {
                let name = &parameter.name;
                fields.push(quote!(#name: f64));
            }
            ItemKind::Count(count) if taken.insert(count.name.to_string()) => {
                let name = &count.name;
                fields.push(quote!(#name: usize));
            }
            ItemKind::Effect(effect) => collect(&effect.items, fields, taken),
            _ => {}
        }
    }
}
