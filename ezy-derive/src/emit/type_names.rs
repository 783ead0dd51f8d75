//! What the types of scenes are called, at the spans of their names in the model file.

use proc_macro2::Ident;
use quote::format_ident;

use crate::model::case::{camel_case, snake_case};
use crate::model::{Bound, Mode, Scene, Side};

/// Type of a scene, in its mode.
pub fn scene_type(scene: &Scene) -> Ident {
    let name = match scene.mode {
        None => &camel_case(&scene.name.to_string()),
        Some(Mode::Slides(Side::Left)) => "SlidesLeft",
        Some(Mode::Slides(Side::Right)) => "SlidesRight",
        Some(Mode::Rests(Bound::Lower)) => "RestsBelow",
        Some(Mode::Rests(Bound::Upper)) => "RestsAbove",
    };
    Ident::new(name, scene.name.span())
}

/// Module with the types of its other modes.
pub fn module_of_modes(scene: &Scene) -> Ident {
    let name = snake_case(&camel_case(&scene.name.to_string()));
    format_ident!("modes_of_{}", name, span = scene.name.span())
}
