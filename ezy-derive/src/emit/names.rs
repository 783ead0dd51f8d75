//! Names of the model file as Rust: bodies, inputs and outputs are fields, events are constants.
//!
//! The types stand in a module `names`, the constants in a module `events`. No scene has these names: types begin with a
//! capital letter.

mod bodies;
mod events;
mod inputs;
mod outputs;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::type_names::scene_type;
use crate::mechanics::Derived;
use crate::model::Model;

/// The modules `names` and `events` of a model, and what each scene says of its names.
pub fn of_model(model: &Model, scenes: &[Derived<'_>]) -> TokenStream {
    let (of_inputs, inputs) = shared(scenes, "Inputs", |derived| model.split_states(derived.inputs())[0].to_vec());
    let outputs = |derived: &Derived<'_>| model.outputs_of(&derived.scene).map(|(i, _)| i).collect();
    let (of_outputs, outputs) = shared(scenes, "Outputs", outputs);
    let bodies = bodies::definition(model);
    let definitions = inputs.iter().map(|shared| inputs::definition(model, shared));
    let definitions = definitions.chain(outputs.iter().map(|shared| outputs::definition(model, shared)));
    let (type_of_bodies, read_bodies) = (bodies::type_of(model), bodies::read(model));
    let implementations = scenes.iter().zip(of_inputs).zip(of_outputs).map(|((derived, i), o)| {
        let type_name = scene_type(&derived.scene);
        let type_of_inputs = inputs::type_of(&inputs[i]);
        let (type_of_outputs, read_outputs) = (outputs::type_of(model, &outputs[o]), outputs::read(model, &outputs[o]));
        quote! {
            #[automatically_derived]
            impl ezy::NamedScene for self::#type_name {
                type Bodies<'a> = #type_of_bodies;
                type Inputs = #type_of_inputs;
                type Outputs<'a> = #type_of_outputs;

                fn bodies_by_name<'a>(&self, q: &'a [f64], v: &'a [f64]) -> #type_of_bodies {
                    #read_bodies
                }

                fn outputs_by_name<'a>(&self, values: &'a [f64]) -> #type_of_outputs {
                    #read_outputs
                }
            }
        }
    });
    let events = events::module(model);
    quote! {
        /// Bodies, inputs and outputs as fields.
        #[allow(dead_code)]
        pub mod names {
            use super::ezy;

            #bodies
            #(#definitions)*
        }

        #(#implementations)*
        #events
    }
}

/// What scenes share that have the same inputs, or the same outputs.
struct Shared<'a, T> {
    scenes: Vec<&'a Ident>,
    items: Vec<T>,
    /// Name of their type, for which there are fields when there are items.
    type_name: Ident,
}

/// What scenes share, and for each scene the place of that.
fn shared<'a, T: PartialEq>(
    scenes: &'a [Derived<'_>],
    suffix: &str,
    items: impl Fn(&Derived<'_>) -> Vec<T>,
) -> (Vec<usize>, Vec<Shared<'a, T>>) {
    let mut all: Vec<Shared<'a, T>> = Vec::new();
    let places =
        scenes.iter().map(|Derived { scene, .. }| scene).zip(scenes.iter().map(items)).map(|(scene, items)| {
            let place = all.iter().position(|shared| shared.items == items).unwrap_or(all.len());
            if place == all.len() {
                all.push(Shared {
                    scenes: Vec::new(),
                    items,
                    type_name: format_ident!("{}{suffix}", scene_type(scene)),
                });
            }
            all[place].scenes.push(&scene.name);
            place
        });
    (places.collect(), all)
}

impl<T> Shared<'_, T> {
    /// The first line of the documentation of the type.
    fn title(&self, what: &str) -> String {
        let scenes: Vec<_> = self.scenes.iter().map(|scene| format!("`{scene}`")).collect();
        format!("{what} of {} {}.", if scenes.len() == 1 { "scene" } else { "scenes" }, scenes.join(", "))
    }
}

/// What a field is, as the model file says, and its unit.
fn field_documentation(what: &str, documentation: &str, unit: &str) -> String {
    let documentation = documentation.trim().trim_end_matches('.');
    let title = if documentation.is_empty() { what } else { documentation };
    format!("{title} ({}).", if unit.is_empty() { "1" } else { unit })
}
