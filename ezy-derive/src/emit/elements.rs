//! The methods that list what a picture of the scene shows, and what gives and takes power.

use proc_macro2::TokenStream;
use quote::quote;

use super::info::{name_of, option};
use super::loops::{looped, variable};
use super::places::{firsts, slot_places};
use crate::mechanics::Derived;
use crate::mechanics::derived::Form;
use crate::mechanics::elements::{Element, Fixed, Loading};
use crate::mechanics::powers::ForceElement;
use crate::model::{BodyId, Component, Model};
use crate::symbolic::print::print;

/// Of a scene whose bodies are known it hands out a list of the program, of a scene with counts it makes one.
pub fn method(model: &Model, derived: &Derived<'_>) -> TokenStream {
    let body = match derived.form {
        Form::Straight(_) => straight(derived),
        Form::Counted(_) => counted(model, derived),
    };
    quote! {
        fn elements(&self) -> ezy::List<ezy::ElementInfo> {
            #body
        }
    }
}

/// The list of the force elements, which no count changes.
pub fn force_elements(model: &Model, derived: &Derived<'_>) -> TokenStream {
    let all = derived.force_elements.iter().map(|element| {
        let ForceElement { name, word, has_potential, works, .. } = element;
        let effect = option(element.effect.map(|id| model.effects[id.0].name.to_string()));
        quote! {
            ezy::ForceElement {
                name: #name,
                kind: #word,
                effect: #effect,
                has_potential: #has_potential,
                does_work: #works,
            }
        }
    });
    quote! {
        fn force_elements(&self) -> &'static [ezy::ForceElement] {
            &[#(#all),*]
        }
    }
}

fn straight(derived: &Derived<'_>) -> TokenStream {
    let all = derived.elements.iter().map(|element| {
        let list = |items: Vec<TokenStream>| quote!(ezy::List::Borrowed(&[#(#items),*]));
        info(derived, element, name_of(&element.name), &|body| quote!(#body), &list)
    });
    quote! {
        const ELEMENTS: &[ezy::ElementInfo] = &[#(#all),*];
        ezy::List::Borrowed(ELEMENTS)
    }
}

fn counted(model: &Model, derived: &Derived<'_>) -> TokenStream {
    let firsts = firsts(model);
    let all = derived.elements.iter().map(|element| {
        let list = |items: Vec<TokenStream>| quote!(ezy::List::Owned(::std::vec![#(#items),*]));
        let (name, at) = (&element.name, element.loops.iter().map(|range| variable(model, range)));
        let name = quote!(ezy::member(#name, &[#(#at),*], ""));
        let body_of = |body: usize| {
            let slot = element.slots.iter().position(|slot| slot.0 == body).unwrap_or(0);
            let n = Component::ALL.len();
            quote!(slots[#slot] / #n)
        };
        let (slots, info) = (slot_places(model, &element.slots), info(derived, element, name, &body_of, &list));
        looped(model, element.loops, &|from, to| quote!(#from..#to), quote!(#slots all.push(#info);))
    });
    quote! {
        #firsts
        let mut all = ::std::vec::Vec::new();
        #(#all)*
        ezy::List::Owned(all)
    }
}

fn info(
    derived: &Derived<'_>,
    of: &Element<'_>,
    name: TokenStream,
    index: &dyn Fn(usize) -> TokenStream,
    list: &dyn Fn(Vec<TokenStream>) -> TokenStream,
) -> TokenStream {
    let text = |sum| print(derived.algebra(), derived.symbols(), sum).text;
    let body = |id: Option<BodyId>| option(id.map(|id| index(id.0)));
    let fixed = |all: &[Fixed]| {
        let fixed = all.iter().map(|Fixed { body: on, local, by_index }| {
            let named = |k: usize| if by_index[k] { String::new() } else { text(local[k]) };
            let (body, [x, y]) = (body(*on), [0, 1].map(named));
            quote!(ezy::LocalVector { body: #body, text: [#x, #y] })
        });
        list(fixed.collect())
    };
    let (kind, points, directions) = (of.word, fixed(&of.points), fixed(&of.directions));
    let bodies = list(of.bodies.iter().map(|id| body(*id)).collect());
    let settings = of.settings.iter().map(|&(word, value)| {
        let value = text(value);
        quote!((#word, #value))
    });
    let load = option(of.load.as_ref().map(|(on, load)| {
        let body = index(on.0);
        let kind = match load {
            Loading::Force(_) => quote!(Force),
            Loading::Torque(_) => quote!(Torque),
        };
        quote!((#body, ezy::LoadKind::#kind))
    }));
    quote! {
        ezy::ElementInfo {
            kind: #kind,
            name: #name,
            points: #points,
            directions: #directions,
            bodies: #bodies,
            settings: &[#(#settings),*],
            load: #load,
        }
    }
}
