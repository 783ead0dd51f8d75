//! The stages in order; what they found wrong is flushed before equations are derived, and before they are emitted.
//! The file to read first.

use proc_macro2::TokenStream;

use crate::diag::Diagnostics;
use crate::mechanics::{Equations, Templates};
use crate::{emit, faulty, mechanics, model, parse};

/// A model file as Rust items, or as compile errors on the words to change.
pub fn expand(tokens: TokenStream) -> TokenStream {
    let mut diag = Diagnostics::default();
    // names are resolved after faults of syntax too, so that both are seen at once
    let syntax = parse::parse(tokens, &mut diag);
    let names = faulty::model(&syntax);
    let with_faults = |diag: Diagnostics| diag.into_compile_errors().into_iter().chain(names).collect();
    let Some(model) = model::resolve(syntax, &mut diag).filter(|_| diag.is_empty()) else {
        return with_faults(diag);
    };
    mechanics::check::rows(&model, &mut diag);
    mechanics::check::stops(&model, &mut diag);
    if !diag.is_empty() {
        return with_faults(diag);
    }
    let mut items = diag.into_compile_errors();
    items.extend(if model.is_repeated() {
        let templates: Vec<Templates> = model.scenes.iter().map(|scene| Templates::derive(&model, scene)).collect();
        emit::repeated(&model, templates)
    } else {
        emit::model(&model, model.scenes.iter().map(|scene| Equations::derive(&model, scene)).collect())
    });
    items
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::path::{Path, PathBuf};

    use super::*;
    use crate::model::case::snake_case;

    /// The `model!` text of a model file of this workspace.
    fn model_text(file: &str) -> TokenStream {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/src").join(file);
        let source = std::fs::read_to_string(path).expect("the model file is there");
        let file = syn::parse_file(&source).expect("the model file is Rust");
        let text = file.items.into_iter().find_map(|item| match item {
            syn::Item::Macro(item) => Some(item.mac.tokens),
            _ => None,
        });
        text.expect("the file holds a model")
    }

    /// The parts of what a model file becomes, by file, and the pages that only rustdoc reads.
    fn expanded(file: &str) -> (BTreeMap<String, String>, String) {
        let items: syn::File = syn::parse2(expand(model_text(file))).expect("the expansion is Rust");
        let mut pages = String::new();
        let mut take = |attributes: &mut Vec<syn::Attribute>| {
            attributes.retain(|attribute| {
                let page = page(attribute);
                pages += &page.clone().unwrap_or_default();
                page.is_none()
            });
        };
        let mut parts: BTreeMap<String, Vec<syn::Item>> = BTreeMap::new();
        for item in items.items {
            let syn::Item::Mod(mut module) = item else { panic!("a model becomes a module") };
            take(&mut module.attrs);
            for mut item in module.content.take().into_iter().flat_map(|(_, items)| items) {
                if let syn::Item::Struct(scene) = &mut item {
                    take(&mut scene.attrs);
                }
                parts.entry(part(&item)).or_default().push(item);
            }
            module.content = Some(Default::default());
            parts.entry("module.rs".to_owned()).or_default().insert(0, syn::Item::Mod(module));
        }
        let text = |items: Vec<syn::Item>| {
            let file = syn::parse2(quote::quote!(#(#items)*)).expect("items are a file");
            prettyplease::unparse(&file)
        };
        (parts.into_iter().map(|(name, items)| (name, text(items))).collect(), pages)
    }

    /// The file of an item: scene, and trait where it implements one.
    fn part(item: &syn::Item) -> String {
        let last = |path: &syn::Path| path.segments.last().map(|last| snake_case(&last.ident.to_string()));
        let (scene, of) = match item {
            syn::Item::Struct(scene) => (Some(snake_case(&scene.ident.to_string())), None),
            syn::Item::Impl(block) => {
                let syn::Type::Path(scene) = &*block.self_ty else { panic!("scenes are named") };
                let of = block.trait_.as_ref().and_then(|(.., path, _)| last(path)).filter(|of| of != "default");
                (last(&scene.path), of)
            }
            _ => (None, None),
        };
        scene.map_or("module.rs".to_owned(), |scene| format!("{scene}/{}.rs", of.as_deref().unwrap_or("info")))
    }

    /// The text of `#[cfg_attr(doc, doc = "…")]`.
    fn page(attribute: &syn::Attribute) -> Option<String> {
        let syn::Meta::List(list) = &attribute.meta else { return None };
        let text = list.path.is_ident("cfg_attr").then(|| list.tokens.clone().into_iter().last())??;
        syn::parse2::<syn::LitStr>(text.into()).ok().map(|text| text.value())
    }

    fn golden(file: &str) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/answers/expanded").join(file)
    }

    /// `UPDATE_GOLDEN=1 cargo test -p ezy-derive` writes the file anew.
    fn compare_with_golden(file: &str, now: &str) {
        let golden = golden(file);
        if std::env::var_os("UPDATE_GOLDEN").is_some() {
            std::fs::create_dir_all(golden.parent().expect("goldens are in a folder")).expect("it can be made");
            std::fs::write(&golden, now).expect("the golden file can be written");
        }
        let before = std::fs::read_to_string(&golden).unwrap_or_default();
        assert!(now == before, "the expansion changed; see {} and UPDATE_GOLDEN", golden.display());
    }

    /// Every part, and no file besides.
    fn compare_parts_with_golden(folder: &str, parts: &BTreeMap<String, String>) {
        parts.iter().for_each(|(name, now)| compare_with_golden(&format!("{folder}/{name}"), now));
        let mut files = 0;
        let mut open = vec![golden(folder)];
        while let Some(path) = open.pop() {
            match std::fs::read_dir(&path) {
                Ok(entries) => open.extend(entries.map(|entry| entry.expect("it can be read").path())),
                Err(_) => files += 1,
            }
        }
        assert_eq!(files, parts.len(), "{folder} holds files that the macro does not make");
    }

    #[test]
    fn regress_expansion_of_the_ezy_roller_is_unchanged() {
        compare_parts_with_golden("ezy_roller", &expanded("vehicles/ezy_roller.rs").0);
    }

    #[test]
    fn regress_expansion_of_the_chain_is_unchanged() {
        compare_parts_with_golden("chain", &expanded("mechanisms/chain.rs").0);
    }

    #[test]
    fn invariant_expansion_does_not_depend_on_the_count() {
        let text = model_text("mechanisms/chain.rs").to_string();
        let with = |n: &str| {
            let text = text.replace("count n = 10", &format!("count n = {n}"));
            expand(text.parse().expect("the text has tokens")).to_string()
        };
        let (small, large) = (with("3"), with("777777"));
        assert!(large.contains("777777") && !large.contains("compile_error"), "{large}");
        assert!(large.len() - small.len() < 100, "{} and {} signs", small.len(), large.len());
        assert_eq!(with("777777"), with("555555").replace("555555", "777777"));
    }

    #[test]
    fn regress_pages_of_the_ezy_roller_are_unchanged() {
        compare_with_golden("ezy_roller.md", &expanded("vehicles/ezy_roller.rs").1);
    }

    /// Messages for a model with the given rows between a body `one`, a body `two` and the ground.
    fn messages(rows: &str) -> String {
        let text = format!(
            "model Trial {{ param a: m = 1.0; param b: m = 2.0; body one {{ mass: 1, inertia: 1 }} \
             body two {{ mass: 1, inertia: 1 }} {rows} start s {{ at rest; }} scene run {{ start s; until 1 s; }} }}"
        );
        expand(text.parse().expect("the text has tokens")).to_string()
    }

    #[test]
    fn analytic_row_that_repeats_others_is_named() {
        let found = messages("skate left: at one(a, b) along one(1, 0); skate right: at one(a, -b) along one(1, 0);");
        assert!(found.contains("row `right` repeats what `left` already demands"), "{found}");
        let found = messages("hinge P: one(a, 0) ~ two(0, 0); hinge Q: one(a, 0) ~ two(0, 0);");
        assert!(found.contains("row `Q.x` repeats what `P.x` already demands"), "{found}");
    }

    #[test]
    fn analytic_row_with_long_derivatives_is_named() {
        let found = messages(
            "point P = one(a, b); point Q = two(b, a);
             constraint g: norm(P.r) / (2 + smooth_step(norm(P.r), 1, norm(Q.r))) = a;",
        );
        assert!(found.contains("row `g` is too long to be differentiated twice"), "{found}");
        let found = messages(
            "point P = one(a, b); point Q = two(b, a);
             stop g: norm(P.r) / (2 + smooth_step(norm(P.r), 1, norm(Q.r))) to a;",
        );
        assert!(found.contains("stop `g` is too long to be differentiated twice"), "{found}");
    }

    #[test]
    fn analytic_faults_inside_a_for_are_found() {
        let array = "count n = 4; body link[n] { mass: 1, inertia: 1 }";
        let found = messages(&format!(
            "{array} for i in 1..n {{ weld w[i]: link[i-1](a, 0) ~ link[i](0, 0); \
             velocity constraint fast[i]: link[i].vx * link[i].vy = 0; constraint empty[i]: 0 * link[i].x = 0; }}"
        ));
        assert!(found.contains("`fast` is not linear") && found.contains("`empty` restricts no motion"), "{found}");
        let found = messages(&format!(
            "{array} weld first: one(0, 0) ~ link[n-1](0, 0); gear second: one ~ link[n-1] ratio 1;"
        ));
        assert!(found.contains("row `second` repeats what `first.angle` already demands"), "{found}");
    }

    #[test]
    fn analytic_row_that_repeats_others_once_assembled_is_a_warning() {
        let found = messages("hinge P: one(0, 0) ~ two(0, 0); hinge Q: one(a, 0) ~ two(a, 0);");
        assert!(found.contains("with the declared parameters row `Q.y` repeats what"));
        assert!(!found.contains("compile_error"));
        let found = messages("rod P: one(0, 0) ~ two(0, 0) length b; rod Q: one(a, 0) ~ two(a, 0) length b;");
        assert!(!found.contains("repeats what"));
    }

    #[test]
    fn analytic_more_rows_than_coordinates_are_counted() {
        let rows = "hinge P: ground(0, 0) ~ one(a, 0); hinge Q: ground(b, 0) ~ one(0, a); hinge R: one(0, 0) ~ two(a, 0); \
                    hinge S: two(b, 0) ~ ground(0, 1);";
        assert!(
            messages(rows).contains("constraint rows but only 6 coordinates") || messages(rows).contains("repeats")
        );
    }

    #[test]
    fn analytic_independent_rows_are_accepted() {
        let found = messages(
            "hinge P: ground(0, 0) ~ one(a, 0); hinge Q: one(0, b) ~ two(0, 0); skate s: at two(b, 0) along two(1, 0);",
        );
        assert!(!found.contains("compile_error"), "{found}");
    }

    #[test]
    fn analytic_rows_of_velocities_that_integrate_are_reported() {
        for row in [
            "velocity constraint r: one.omega = 2 * two.omega;",
            "velocity constraint r: one.vx = a * cos(one.phi) * one.omega;",
            "velocity constraint r: one.x * one.vx + one.y * one.vy = 0;",
            "velocity constraint r: one.vx = 3 * t;",
            "hinge P: ground(0, 0) ~ one(a, 0); velocity constraint r: cos(one.phi) * one.vx = 0.1 * two.vx;",
        ] {
            let found = messages(row);
            assert!(found.contains("`r` integrates"), "{row}: {found}");
        }
    }

    #[test]
    fn analytic_rows_of_velocities_that_do_not_integrate_are_silent() {
        for row in [
            "skate r: at one(a, 0) along one(1, 0);",
            "roll r: at one(0, 0) along one(1, 0) = a * two.omega;",
            "velocity constraint r: one.vx = one.y * one.omega;",
            "velocity constraint r: one.vx = a * cos(t) * one.omega;",
            "hinge P: one(b, 0) ~ two(-b, 0); skate r: at one(-a, 0) along one(1, 0);",
        ] {
            let found = messages(row);
            assert!(!found.contains("integrates") && !found.contains("compile_error"), "{row}: {found}");
        }
    }

    #[test]
    fn invariant_expansion_is_the_same_twice() {
        assert_eq!(expanded("vehicles/ezy_roller.rs"), expanded("vehicles/ezy_roller.rs"));
    }

    /// The equations of the scene `coast` of a roller with more items: `impl Equations` and `impl Scene`, as emitted.
    fn equations_of_coast(more: &str) -> String {
        let text = format!(
            "model Roller {{ param a: m = 0.2; param b: m = 0.6; param m: kg = 46; param i: kg*m^2 = 10; \
             body seat {{ mass: m, inertia: i }} body bar {{ mass: 1, inertia: 0.005 }} point A = seat(-a, 0); \
             hinge B: seat(b, 0) ~ bar(-0.1, 0); skate rear: at A along seat(1, 0); \
             skate front: at bar(0.1, 0) along bar(1, 0); {more} \
             start folded {{ bar angle pi; at rest; }} scene coast {{ start folded; until 1 s; }} }}"
        );
        let file: syn::File = syn::parse2(expand(text.parse().expect("the text has tokens"))).expect("it is Rust");
        let items = file.items.into_iter().filter_map(|item| match item {
            syn::Item::Mod(module) => module.content,
            _ => None,
        });
        let blocks = items.flat_map(|(_, items)| items).filter_map(|item| match item {
            syn::Item::Impl(block) if block.trait_.is_some() => Some(quote::quote!(#block).to_string()),
            _ => None,
        });
        let ends =
            ["ezy :: Equations < T > for self :: Coast {", "ezy :: Derived for Coast {", "ezy :: Scene for Coast {"];
        let blocks: Vec<String> = blocks.filter(|block| ends.iter().any(|end| block.contains(end))).collect();
        assert_eq!(blocks.len(), ends.len(), "the scene is emitted");
        blocks.concat()
    }

    #[test]
    fn invariant_effects_that_a_scene_does_not_name_leave_its_code_as_it_is() {
        let with_effects = equations_of_coast(
            "effect pump { param m0: N*m = 2; torque seat ~ bar: m0 * cos(3 * t); } \
             effect slip { param c: N = 400; release rear; tyre at A along seat(1, 0): stiffness c; } \
             effect tie { rod tie: A ~ ground(0, 0) length 1; } \
             scene driven { start folded; until 1 s; with pump, slip, tie; }",
        );
        assert!(with_effects == equations_of_coast(""), "{with_effects}");
    }

    #[test]
    fn invariant_scene_without_an_effect_has_no_cosine_of_time() {
        let (parts, _) = expanded("vehicles/ezy_roller.rs");
        let of_coast = parts.iter().filter(|(name, _)| name.starts_with("coast/") && *name != "coast/info.rs");
        let coast: String = of_coast.map(|(_, code)| code.as_str()).collect();
        assert!(coast.contains("fn accelerations") && !coast.contains("cos(product"), "{coast}");
    }
}
