//! Names of events as constants.

use std::collections::BTreeMap;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::model::Model;

/// The module `events`: a constant for each declared event, and a module for each skate with a limit and each stop.
pub fn module(model: &Model) -> Option<TokenStream> {
    // of two effects with an event of one name there is one constant
    let events: BTreeMap<&str, &str> =
        model.events.iter().map(|event| (event.name.as_str(), event.documentation.as_str())).collect();
    let constants = events.iter().map(|(name, documentation)| constant(&format_ident!("{name}"), name, documentation));
    let limited = model.rows.iter().filter(|row| row.limit().is_some()).map(|row| (&row.name, SKATE));
    let stops = model.stops.iter().map(|stop| (&stop.name, STOP));
    let mut changes: BTreeMap<&Ident, Vec<&str>> = BTreeMap::new();
    limited.chain(stops).for_each(|(name, words)| changes.entry(name).or_default().extend(words));
    let modules = changes.into_iter().map(|(name, mut words)| {
        words.sort_unstable();
        words.dedup();
        let documentation = format!("Changes of `{name}`.");
        let constants = words.iter().map(|word| {
            let text = format!("{name} {word}");
            constant(&format_ident!("{}", word.replace(' ', "_")), &text, "")
        });
        quote! {
            #[doc = #documentation]
            pub mod #name { #(#constants)* }
        }
    });
    let items: Vec<_> = constants.chain(modules).collect();
    (!items.is_empty()).then(|| {
        quote! {
            /// Names of events, to compare with those of a run.
            #[allow(non_upper_case_globals, dead_code)]
            pub mod events { #(#items)* }
        }
    })
}

/// What happens to a skate with a limit.
const SKATE: &[&str] = &["slides", "stops"];

/// What happens at a stop.
const STOP: &[&str] = &["hits", "holds", "lets go"];

fn constant(name: &Ident, text: &str, documentation: &str) -> TokenStream {
    let documentation = match documentation.trim() {
        "" => format!("`{text}`"),
        documentation => documentation.to_owned(),
    };
    quote! {
        #[doc = #documentation]
        pub const #name: &::core::primitive::str = #text;
    }
}
