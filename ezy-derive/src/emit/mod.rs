//! What was derived as Rust items. Nothing here can fail, and nothing here does algebra.

mod abbreviations;
mod constants;
mod elements;
mod equation;
mod equations;
mod info;
mod jacobians;
mod kernel;
mod loops;
mod members;
mod names;
mod numbers;
mod page;
mod parts;
mod passes;
mod places;
mod repeated;
mod scene;
mod series;
mod signature;
mod templates;
mod type_names;

#[cfg(test)]
pub use parts::LONGEST_WHOLE;
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::mechanics::{Derived, Group};
use crate::model::case::snake_case;
use crate::model::{EffectId, Model};
use type_names::scene_type;

/// The module of a model: one type for each scene, and the description of all of them.
pub fn model(model: &Model, scenes: &[Derived<'_>]) -> TokenStream {
    let (core, visibility) = (&model.core, &model.visibility);
    let module = Ident::new(&snake_case(&model.name.to_string()), model.name.span());
    let name = model.name.to_string();
    let documentation = &model.documentation;
    let page = page::model(model, scenes);
    let all: Vec<_> = (0..model.effects.len()).map(|i| Group::Effect(EffectId(i))).collect();
    let effects = info::effects(model, &all);
    let entries = scenes.iter().map(|derived| {
        let (type_name, name) = (scene_type(&derived.scene), derived.scene.name.to_string());
        quote! {
            ezy::SceneEntry {
                name: #name,
                info: || ezy::Scene::info(&<#type_name as ::core::default::Default>::default()),
                new: || ::std::boxed::Box::new(<#type_name as ::core::default::Default>::default()),
            }
        }
    });
    let names = names::of_model(model, scenes);
    let types = scenes.iter().map(|derived| scene::items(model, derived));
    quote! {
        #[doc = #documentation]
        #page
        #[allow(non_snake_case, unused_variables, clippy::all, clippy::pedantic)]
        #visibility mod #module {
            use #core::__private as ezy;

            /// The model and its scenes.
            pub static MODEL: ezy::ModelInfo = ezy::ModelInfo {
                name: #name,
                documentation: #documentation,
                effects: &[#(#effects),*],
                scenes: &[#(#entries),*],
            };
            #(#types)*
            #names
        }
    }
}
