//! Placeholders that are emitted beside the errors of a model: the names that programs use.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::model::case::{camel_case, snake_case};
use crate::parse::ast::{Expr, Item, ItemKind, Model};
use crate::parse::is_rust_keyword;

/// The module of the model with a type for each scene that could be read, and everything that programs use by name.
pub fn model(model: &Model) -> TokenStream {
    let module = snake_case(&model.name.to_string());
    // without its header a model has no name
    if is_rust_keyword(&module) || model.broken.contains(&model.name) {
        return TokenStream::new();
    }
    let (visibility, module) = (&model.visibility, Ident::new(&module, model.name.span()));
    let mut names = Names::default();
    names.collect(&model.items);
    let Names { fields, bodies, inputs, outputs, events, stops } = names;
    let mut types = BTreeSet::new();
    let scenes = model.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Scene(scene) => {
            let name = camel_case(&scene.name.to_string());
            (!is_rust_keyword(&name) && types.insert(name.clone())).then(|| Ident::new(&name, scene.name.span()))
        }
        _ => None,
    });
    let (core, fields) = (&model.core, fields.values());
    let scenes = scenes.map(|scene| {
        let fields = fields.clone();
        quote!(#scene { #(#fields),* })
    });
    let [bodies, inputs, outputs] = [bodies, inputs, outputs].map(|names| {
        let fields = names.into_values();
        quote!({ #(#fields),* })
    });
    let (events, stops) = (events.into_values(), stops.into_values());
    quote! {
        #core::__private::faulty_model! {
            #visibility mod #module { #(#scenes)* }
            names #bodies #inputs #outputs
            events { #(#events)* } { #(#stops)* }
        }
    }
}

/// What programs use by name, each name once.
#[derive(Default)]
struct Names {
    /// Parameters and counts.
    fields: BTreeMap<Ident, TokenStream>,
    bodies: BTreeMap<Ident, TokenStream>,
    inputs: BTreeMap<Ident, TokenStream>,
    outputs: BTreeMap<Ident, TokenStream>,
    events: BTreeMap<Ident, TokenStream>,
    stops: BTreeMap<Ident, TokenStream>,
}

impl Names {
    fn collect(&mut self, items: &[Item]) {
        for item in items {
            let (list, name, kind) = match &item.kind {
                ItemKind::Parameter(parameter) => (&mut self.fields, &parameter.name, quote!(: f64)),
                ItemKind::Count(count) => (&mut self.fields, &count.name, quote!(: usize)),
                ItemKind::Body(body) => {
                    let kind = match body.name.indices.len() {
                        0 => quote!(: ezy::BodyState),
                        n => quote!(: ezy::BodyArray<'static, #n>),
                    };
                    (&mut self.bodies, &body.name.word, kind)
                }
                ItemKind::Input(input) if input.rate.is_none() => (&mut self.inputs, &input.name, quote!(: f64)),
                ItemKind::Output(output) => {
                    let number = match item.loops.len() {
                        0 => quote!(f64),
                        n => quote!(ezy::OutputArray<'static, #n>),
                    };
                    let is_vector = matches!(output.value, Expr::Vector { .. });
                    let kind = if is_vector { quote!(: ezy::Vector<#number>) } else { quote!(: #number) };
                    (&mut self.outputs, &output.name.word, kind)
                }
                ItemKind::Event(event) => (&mut self.events, &event.name, quote!(;)),
                ItemKind::Stop(stop) => (
                    &mut self.stops,
                    &stop.name,
                    quote!({
                        hits;
                        holds;
                        lets_go;
                    }),
                ),
                ItemKind::Effect(effect) => {
                    self.collect(&effect.items);
                    continue;
                }
                _ => continue,
            };
            list.entry(name.clone()).or_insert_with(|| quote!(#name #kind));
        }
    }
}
