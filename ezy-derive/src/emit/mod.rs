//! From equations to Rust items. Nothing here can fail, and nothing here does algebra.

mod abbreviations;
mod constants;
mod info;
mod kernel;
mod modes;
mod page;
mod repeated;
mod scene;
mod series;
mod slopes;
mod templates;

#[cfg(test)]
pub use kernel::LONGEST_WHOLE;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::mechanics::{Equations, Group, Templates};
use crate::model::case::{camel_case, snake_case};
use crate::model::{EffectId, Model, Scene};

/// The module of a model: one type for each scene, and the description of all of them.
pub fn model(model: &Model, equations: Vec<Equations>) -> TokenStream {
    let scenes = model.scenes.iter().zip(equations).map(|(scene, equations)| scene::items(model, scene, equations));
    let (mut scenes, summaries): (Vec<_>, Vec<_>) = scenes.unzip();
    scenes.extend(model.scenes.iter().filter_map(|scene| modes::items(model, scene)));
    let page = page::model(model, &summaries);
    module(model, &page, &scenes, |type_name| quote!(|| &#type_name::INFO))
}

/// The same for a model whose sizes are numbers of a run.
pub fn repeated(model: &Model, templates: Vec<Templates<'_>>) -> TokenStream {
    let scenes = model.scenes.iter().zip(templates);
    let scenes: Vec<_> = scenes.map(|(scene, templates)| repeated::items(model, scene, templates)).collect();
    module(
        model,
        &TokenStream::new(),
        &scenes,
        |type_name| quote!(|| ::ezy_core::model::Scene::info(&<#type_name as ::core::default::Default>::default())),
    )
}

fn module(
    model: &Model,
    page: &TokenStream,
    scenes: &[TokenStream],
    info: impl Fn(&Ident) -> TokenStream,
) -> TokenStream {
    let visibility = &model.visibility;
    let module = Ident::new(&snake_case(&model.name.to_string()), model.name.span());
    let name = model.name.to_string();
    let documentation = &model.documentation;
    let all: Vec<_> = (0..model.effects.len()).map(|i| Group::Effect(EffectId(i))).collect();
    let effects = info::effects(model, &all);
    let entries = model.scenes.iter().map(|scene| {
        let (type_name, name) = (scene_type(scene), scene.name.to_string());
        let info = info(&type_name);
        quote! {
            ::ezy_core::model::SceneEntry {
                name: #name,
                info: #info,
                new: || ::std::boxed::Box::new(<#type_name as ::core::default::Default>::default()),
            }
        }
    });
    quote! {
        #[doc = #documentation]
        #page
        #[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
        #visibility mod #module {
            /// The model and its scenes.
            pub static MODEL: ::ezy_core::model::ModelInfo = ::ezy_core::model::ModelInfo {
                name: #name,
                documentation: #documentation,
                effects: &[#(#effects),*],
                scenes: &[#(#entries),*],
            };
            #(#scenes)*
        }
    }
}

/// Type of a scene, at the span of its name in the model file.
fn scene_type(scene: &Scene) -> Ident {
    match scene.mode {
        Some(mode) => modes::type_name(mode, scene),
        None => Ident::new(&camel_case(&scene.name.to_string()), scene.name.span()),
    }
}
