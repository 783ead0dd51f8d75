//! The scenes that a skate with a limit makes of one: it holds, or slides to one side.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::{scene, scene_type};
use crate::mechanics::Equations;
use crate::model::case::snake_case;
use crate::model::{Model, Scene, Slide};

/// The types of a sliding scene, in a module beside it; none where nothing slides.
pub fn items(model: &Model, of: &Scene) -> Option<TokenStream> {
    model.grip_of(of)?;
    let module = module(of);
    let scenes = [Slide::Left, Slide::Right].map(|slide| {
        let mode = Scene { slide: Some(slide), ..of.clone() };
        let equations = Equations::derive(model, &mode);
        scene::items(model, &mode, equations).0
    });
    Some(quote! {
        #[doc(hidden)]
        pub mod #module {
            #(#scenes)*
        }
    })
}

/// The method that hands them out, with the parameters of the scene.
pub fn access(scene: &Scene, parameters: &[&Ident]) -> TokenStream {
    let module = module(scene);
    let slides = [Slide::Left, Slide::Right].map(|slide| {
        let name = type_name(slide, scene);
        quote!(::std::boxed::Box::new(#module::#name { #(#parameters: self.#parameters),* }))
    });
    quote! {
        fn modes(&self) -> ::core::option::Option<[::std::boxed::Box<dyn ::ezy_core::model::Scene>; 3]> {
            ::core::option::Option::Some([::std::boxed::Box::new(*self), #(#slides),*])
        }
    }
}

/// Name of the type of a scene that slides.
pub fn type_name(slide: Slide, scene: &Scene) -> Ident {
    let name = match slide {
        Slide::Left => "SlidesLeft",
        Slide::Right => "SlidesRight",
    };
    Ident::new(name, scene.name.span())
}

fn module(scene: &Scene) -> Ident {
    format_ident!("modes_of_{}", snake_case(&scene_type(scene).to_string()), span = scene.name.span())
}
