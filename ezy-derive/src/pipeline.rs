//! The stages in order; what they found wrong is flushed before equations are derived, and before they are emitted.
//! The file to read first.

use proc_macro2::TokenStream;

use crate::diag::Diagnostics;
use crate::mechanics::Derived;
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
    let scenes: Vec<Derived> = model.scenes.iter().map(|scene| Derived::new(&model, scene)).collect();
    let mut items = diag.into_compile_errors();
    items.extend(emit::model(&model, &scenes));
    items
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert!(found.contains("constraint `right` repeats what `left` already demands"), "{found}");
        let found = messages("hinge P: one(a, 0) ~ two(0, 0); hinge Q: one(a, 0) ~ two(0, 0);");
        assert!(found.contains("constraint `Q.x` repeats what `P.x` already demands"), "{found}");
    }

    #[test]
    fn analytic_row_with_long_derivatives_is_named() {
        let found = messages(
            "point P = one(a, b); point Q = two(b, a);
             constraint g: norm(P.r) / (2 + smooth_step(norm(P.r), 1, norm(Q.r))) = a;",
        );
        assert!(found.contains("constraint `g` is too long to be differentiated twice"), "{found}");
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
        assert!(found.contains("constraint `second` repeats what `first.angle` already demands"), "{found}");
    }

    #[test]
    fn analytic_row_that_repeats_others_once_assembled_is_a_warning() {
        let found = messages("hinge P: one(0, 0) ~ two(0, 0); hinge Q: one(a, 0) ~ two(a, 0);");
        assert!(found.contains("with the declared parameters constraint `Q.y` repeats what"));
        assert!(!found.contains("compile_error"));
        let found = messages("rod P: one(0, 0) ~ two(0, 0) length b; rod Q: one(a, 0) ~ two(a, 0) length b;");
        assert!(!found.contains("repeats what"));
    }

    #[test]
    fn analytic_more_rows_than_coordinates_are_counted() {
        let rows = "hinge P: ground(0, 0) ~ one(a, 0); hinge Q: ground(b, 0) ~ one(0, a); hinge R: one(0, 0) ~ two(a, 0); \
                    hinge S: two(b, 0) ~ ground(0, 1);";
        assert!(
            messages(rows).contains("constraint equations but only 6 coordinates")
                || messages(rows).contains("repeats")
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
    fn analytic_wheel_that_a_weld_holds_is_a_warning() {
        let rolls = |joint: &str| messages(&format!("{joint} roll r: at one(0, 0) along one(1, 0) = a * two.omega;"));
        let found = rolls("weld hub: one(0, b) ~ two(0, 0);");
        assert!(
            found.contains("weld `hub` keeps the wheel of `r` from turning") && found.contains("write `hinge hub: …`")
        );
        assert!(!rolls("hinge hub: one(0, b) ~ two(0, 0);").contains("hub` keeps"));
        assert!(!rolls("weld hub: ground(0, b) ~ one(0, 0);").contains("hub` keeps"));
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
}
