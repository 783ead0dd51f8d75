//! Names of generated items.

use proc_macro2::Ident;

use crate::model::Scene;

/// `EzyRoller` → `ezy_roller`
pub fn snake(name: &str) -> String {
    let mut out = String::new();
    let mut previous_lower = false;
    for c in name.chars() {
        if c.is_uppercase() && previous_lower {
            out.push('_');
        }
        previous_lower = !c.is_uppercase() && c != '_';
        out.extend(c.to_lowercase());
    }
    out
}

/// `driven_on_tarmac` → `DrivenOnTarmac`
pub fn camel(name: &str) -> String {
    name.split('_')
        .flat_map(|part| {
            let mut letters = part.chars();
            letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect::<Vec<_>>()
        })
        .collect()
}

/// Type of a scene, at the span of its name in the model file.
pub fn scene_type(scene: &Scene) -> Ident {
    Ident::new(&camel(&scene.name.to_string()), scene.name.span())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_names_change_case_at_word_boundaries() {
        assert_eq!(snake("EzyRoller"), "ezy_roller");
        assert_eq!(snake("Andrews"), "andrews");
        assert_eq!(camel("driven_on_tarmac"), "DrivenOnTarmac");
    }
}
