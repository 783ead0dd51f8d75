//! What the types of scenes are called, at the spans of their names in the model file.

use proc_macro2::Ident;

use crate::model::Scene;
use crate::model::case::camel_case;

/// Type of a scene.
pub fn scene_type(scene: &Scene) -> Ident {
    Ident::new(&camel_case(&scene.name.to_string()), scene.name.span())
}
