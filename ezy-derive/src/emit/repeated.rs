//! Scenes with counts: their descriptions, made when a run gives the counts, and access to the counts.

mod describe;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::constants::Constants;
use super::equations::OfItems;
use super::{equations, info, templates};
use crate::mechanics::derived::Counted;
use crate::mechanics::{Derived, EventTemplate};
use crate::model::Model;
use crate::symbolic::print::print;
use describe::describe;

/// What is known of a scene when it is compiled, and the function that describes a run.
pub fn description(model: &Model, derived: &Derived<'_>, of: &Counted<'_>, constants: &Constants<'_>) -> TokenStream {
    let templates = &of.templates;
    let all = templates::all(model, templates);
    let of_items = OfItems { model, templates };
    let infos = all.iter().map(|template| template.info(&of_items));
    let fixed = fixed(model, derived, of, constants.n_single());
    let describe = describe(model, templates, &all);
    let members = constants.places_of_members().map(|_| quote!(layout.constants(|| self.members());));
    quote! {
        /// What is known of the scene when it is compiled: everything but its sizes.
        const FIXED: ezy::SceneInfo = #fixed;

        const TEMPLATES: &'static [ezy::TemplateInfo] = &[#(#infos),*];

        fn describe(&self, layout: &mut ezy::Layout) {
            #describe
            #members
        }
    }
}

/// The method that hands out the description of a run.
pub fn access(model: &Model) -> TokenStream {
    let counts: Vec<&Ident> = model.counts.iter().map(|count| &count.name).collect();
    quote! {
        fn info(&self) -> ::std::sync::Arc<ezy::SceneInfo> {
            static KNOWN: ezy::Known = ezy::Known::new();
            let scene = self.clone();
            KNOWN.info(&Self::FIXED, &[#(self.#counts),*], move |layout| scene.describe(layout))
        }
    }
}

/// The methods that hand out the counts, and take them.
pub fn access_to_counts(model: &Model) -> TokenStream {
    let counts: Vec<&Ident> = model.counts.iter().map(|count| &count.name).collect();
    let places: Vec<usize> = (0..counts.len()).collect();
    quote! {
        fn count(&self, index: usize) -> usize {
            match index { #(#places => self.#counts,)* _ => 0 }
        }
        fn set_count(&mut self, index: usize, value: usize) {
            match index { #(#places => self.#counts = value,)* _ => {} }
        }
    }
}

/// The part of the description that does not depend on counts.
fn fixed(model: &Model, derived: &Derived<'_>, of: &Counted<'_>, n_constants: usize) -> TokenStream {
    let (scene, templates) = (&derived.scene, &of.templates);
    let (model_name, name, documentation) = (model.name.to_string(), scene.name.to_string(), &scene.documentation);
    let fingerprint = model.fingerprint;
    let parameters = info::parameters(model, &templates.parameters, &templates.symbols);
    let integrated_inputs = info::integrated_inputs(model, &templates.inputs);
    let [inputs, states] = info::inputs_and_states(model, &templates.inputs, &templates.symbols);
    let effects = info::effects(model, &templates.groups);
    let until = scene.until_s;
    let events = templates.events.iter().map(|EventTemplate { event, .. }| {
        info::event(event, &print(&templates.algebra, &templates.symbols, event.value))
    });
    let counts = model.counts.iter().map(|count| {
        let (name, default, documentation) = (count.name.to_string(), count.default as usize, &count.documentation);
        quote!(ezy::CountInfo { name: #name, default: #default, documentation: #documentation })
    });
    let none = quote!(ezy::List::Borrowed(&[]));
    let series = info::series(derived.series_cost());
    let lets = equations::lets_of(templates).map(|lets| lets.tokens()).into_iter();
    let rates = equations::rates_of(templates).map(|rates| rates.tokens()).into_iter();
    let motion = equations::motion_of(templates).tokens();
    quote! {
        ezy::SceneInfo {
            model: #model_name,
            name: #name,
            documentation: #documentation,
            fingerprint: #fingerprint,
            bodies: #none,
            kinds: #none,
            coordinates: #none,
            velocities: #none,
            points: #none,
            rows: #none,
            n_position_rows: 0,
            parameters: &[#(#parameters),*],
            inputs: &[#(#inputs),*],
            integrated_inputs: &[#(#integrated_inputs),*],
            states: &[#(#states),*],
            outputs: #none,
            events: &[#(#events),*],
            limited_skates: &[],
            stop: ::core::option::Option::None,
            switches: &[],
            effects: &[#(#effects),*],
            until_s: #until,
            n_constants: #n_constants,
            jacobian: ezy::SparsityPattern::new(&[], &[]),
            jacobian_entries: &[],
            mass_entries: &[],
            force_entries: &[],
            potential_energy: ezy::Formula { text: "0", latex: "0", mathml: "<mn>0</mn>" },
            abbreviations: &[],
            equations: &[#(#lets,)* #(#rates,)* #motion],
            elimination: &[],
            acceleration_operations: ezy::Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
            correction_operations: ezy::Operations { add: 0, mul: 0, div: 0, trig: 0, calls: 0 },
            feedback: ::core::option::Option::None,
            quasi_velocities: ::core::option::Option::None,
            series: #series,
            repeats: ::core::option::Option::Some(ezy::Repeats {
                counts: &[#(#counts),*],
                values: #none,
                templates: Self::TEMPLATES,
                fault: ::core::option::Option::None,
            }),
        }
    }
}
