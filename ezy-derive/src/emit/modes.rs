//! The scenes that a skate with a limit, or a stop, makes of one.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::{scene, scene_type};
use crate::mechanics::Equations;
use crate::model::case::snake_case;
use crate::model::{Bound, Mode, Model, Scene, Side};

/// The types of what a scene becomes, in a module beside it; none where nothing changes.
pub fn items(model: &Model, of: &Scene) -> Option<TokenStream> {
    let modes = model.modes_of(of);
    if modes.is_empty() {
        return None;
    }
    let module = module(of);
    let scenes = modes.into_iter().map(|mode| {
        let mode = Scene { mode: Some(mode), ..of.clone() };
        let equations = Equations::derive(model, &mode);
        scene::items(model, &mode, equations).0
    });
    Some(quote! {
        #[doc(hidden)]
        pub mod #module {
            use super::ezy;

            #(#scenes)*
        }
    })
}

/// The method that hands them out behind the scene itself, with its parameters.
pub fn access(model: &Model, scene: &Scene, parameters: &[&Ident]) -> Option<TokenStream> {
    let modes = model.modes_of(scene);
    if modes.is_empty() || scene.mode.is_some() {
        return None;
    }
    let module = module(scene);
    let others = modes.into_iter().map(|mode| {
        let name = type_name(mode, scene);
        quote!(::std::boxed::Box::new(#module::#name { #(#parameters: self.#parameters),* }))
    });
    Some(quote! {
        fn modes(&self) -> ::std::vec::Vec<::std::boxed::Box<dyn ezy::Scene>> {
            ::std::vec![::std::boxed::Box::new(*self), #(#others),*]
        }
    })
}

/// Name of the type of a scene in another mode.
pub fn type_name(mode: Mode, scene: &Scene) -> Ident {
    let name = match mode {
        Mode::Slides(Side::Left) => "SlidesLeft",
        Mode::Slides(Side::Right) => "SlidesRight",
        Mode::Rests(Bound::Lower) => "RestsBelow",
        Mode::Rests(Bound::Upper) => "RestsAbove",
    };
    Ident::new(name, scene.name.span())
}

fn module(scene: &Scene) -> Ident {
    format_ident!("modes_of_{}", snake_case(&scene_type(scene).to_string()), span = scene.name.span())
}
