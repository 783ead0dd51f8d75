//! The type of a scene with arrays: kernels that loop over the members of each item, and the loops that describe a
//! run with given counts.

mod describe;
mod kernels;
mod loops;
mod series;
mod slopes;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::constants::Constants;
use super::{info, page, scene, scene_type, templates};
use crate::function::Function;
use crate::mechanics::{EventTemplate, Templates};
use crate::model::{Model, Scene};
use crate::symbolic::lower::ConstantPool;
use crate::symbolic::print::print;
use describe::describe;
use kernels::{Emitter, Methods};

/// The struct, its defaults and its equations.
pub fn items(model: &Model, scene: &Scene, mut templates: Templates<'_>) -> TokenStream {
    let templates = &mut templates;
    let mut pool = ConstantPool::default();
    let mut emitter = Emitter { model, templates, pool: &mut pool };
    let Methods { equations, scene: methods, events } = emitter.methods();
    let recurrences = series::derive(templates, &mut pool);
    let items = slopes::derive(templates);
    let slopes = items.map(|items| Emitter { model, templates, pool: &mut pool }.slopes(&items));
    let templates = &*templates;
    let n_inputs = templates.inputs.len();
    let n_constants = pool.coefficients().len();
    let coefficients = &templates.algebra.coefficients;
    let constants = Constants { model, parameters: &templates.parameters, coefficients }.method(&pool, n_inputs);
    let type_name = scene_type(scene);
    let structure = structure(model, scene, templates, &type_name);
    let parameters: Vec<&Ident> = templates.parameters.iter().map(|id| &model.parameters[id.0].name).collect();
    let (parameter, set_parameter) = scene::parameter_access(&parameters);
    let counts: Vec<&Ident> = model.counts.iter().map(|count| &count.name).collect();
    let places: Vec<usize> = (0..counts.len()).collect();
    let all = templates::all(model, templates);
    let infos = all.iter().map(|template| template.info(model, templates));
    let fixed = fixed(model, scene, templates, n_constants, &recurrences);
    let recurrences = recurrences.ok();
    let access_to_series = recurrences.is_some().then(scene::access_to_series);
    let recurrences = recurrences.map(|items| series::implementation(&type_name, model, &templates.symbols, &items));
    let describe = describe(model, templates, &all);
    quote! {
        #structure

        impl #type_name {
            /// What is known of the scene when it is compiled: everything but its sizes.
            const FIXED: ezy::SceneInfo = #fixed;

            const TEMPLATES: &'static [ezy::TemplateInfo] = &[#(#infos),*];

            fn describe(&self, layout: &mut ezy::Layout) {
                #describe
            }
        }

        #[automatically_derived]
        impl<T: ezy::Scalar> ezy::Equations<T> for self::#type_name {
            #constants
            #equations
        }

        #[automatically_derived]
        impl ezy::Derived for #type_name {
            fn count(&self, index: usize) -> usize {
                match index { #(#places => self.#counts,)* _ => 0 }
            }
            fn set_count(&mut self, index: usize, value: usize) {
                match index { #(#places => self.#counts = value,)* _ => {} }
            }
            #events
            #slopes
            #access_to_series
        }

        #[automatically_derived]
        impl ezy::Scene for #type_name {
            fn info(&self) -> &'static ezy::SceneInfo {
                static KNOWN: ezy::Known = ezy::Known::new();
                KNOWN.info(&Self::FIXED, &[#(self.#counts),*], |layout| self.describe(layout))
            }
            fn parameter(&self, index: usize) -> f64 {
                #parameter
            }
            fn set_parameter(&mut self, index: usize, value: f64) {
                #set_parameter
            }
            #methods
        }

        #recurrences
    }
}

fn structure(model: &Model, scene: &Scene, templates: &Templates<'_>, type_name: &Ident) -> TokenStream {
    let parameters: Vec<_> = templates.parameters.iter().map(|id| &model.parameters[id.0]).collect();
    let counts = model.counts.iter().map(|count| {
        let name = &count.name;
        let documentation = match count.documentation.trim() {
            "" => format!("Count `{name}`; default {}.", count.default),
            text => format!("{text}; default {}.", count.default),
        };
        quote!(#[doc = #documentation] pub #name: usize)
    });
    let fields = counts.chain(parameters.iter().map(|parameter| scene::field(parameter)));
    let count_defaults = model.counts.iter().map(|count| {
        let (name, value) = (&count.name, Literal::usize_unsuffixed(usize::try_from(count.default).unwrap_or(1)));
        quote!(#name: #value)
    });
    let defaults = parameters.iter().map(|parameter| {
        let (name, value) = (&parameter.name, parameter.default);
        quote!(#name: #value)
    });
    let defaults = count_defaults.chain(defaults);
    let title = scene::title(model, scene);
    let page = page::repeated(model, templates);
    quote! {
        #[doc = #title]
        #[doc = ""]
        #page
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct #type_name {
            #(#fields),*
        }

        impl ::core::default::Default for #type_name {
            fn default() -> Self {
                Self { #(#defaults),* }
            }
        }
    }
}

/// The part of the description that does not depend on counts.
fn fixed(
    model: &Model,
    scene: &Scene,
    templates: &Templates<'_>,
    n_constants: usize,
    recurrences: &Result<Vec<series::Item<'_>>, Function>,
) -> TokenStream {
    let (model_name, name, documentation) = (model.name.to_string(), scene.name.to_string(), &scene.documentation);
    let parameters = info::parameters(model, &templates.parameters, &templates.symbols);
    let inputs = info::inputs(model, &templates.inputs, &templates.symbols);
    let effects = info::effects(model, &templates.groups);
    let until = scene.until_s;
    let events = templates.events.iter().map(|EventTemplate { event, .. }| {
        info::event(event, &print(&templates.algebra, &templates.symbols, event.value))
    });
    let counts = model.counts.iter().map(|count| {
        let (name, default, documentation) = (count.name.to_string(), count.default as usize, &count.documentation);
        quote!(ezy::CountInfo { name: #name, default: #default, documentation: #documentation })
    });
    let defaults = model.counts.iter().map(|count| count.default as usize);
    let series = info::series(recurrences.as_ref().map(|items| series::cost(items)).map_err(|function| *function));
    quote! {
        ezy::SceneInfo {
            model: #model_name,
            name: #name,
            documentation: #documentation,
            bodies: &[],
            coordinates: &[],
            points: &[],
            rows: &[],
            n_position_rows: 0,
            parameters: &[#(#parameters),*],
            inputs: &[#(#inputs),*],
            outputs: &[],
            events: &[#(#events),*],
            grip: ::core::option::Option::None,
            stop: ::core::option::Option::None,
            effects: &[#(#effects),*],
            until_s: #until,
            n_constants: #n_constants,
            jacobian: ezy::SparsityPattern { starts: &[0], columns: &[] },
            jacobian_entries: &[],
            mass_entries: &[],
            force_entries: &[],
            potential_energy: ezy::Formula { text: "0", latex: "0", mathml: "<mn>0</mn>" },
            abbreviations: &[],
            elimination: &[],
            acceleration_operations: ezy::Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
            correction_operations: ezy::Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
            series: #series,
            repeats: ::core::option::Option::Some(ezy::Repeats {
                counts: &[#(#counts),*],
                values: &[#(#defaults),*],
                templates: Self::TEMPLATES,
                fault: ::core::option::Option::None,
            }),
        }
    }
}
