//! What has no source text says why.

use crate::mechanisms::{hung, rope};
use ezy_core::export::{ExportError, Language, Start, source};
use ezy_core::prelude::*;

#[test]
fn invariant_dependent_rows_are_refused() {
    let scene = hung::Sways::default();
    let start = Start { t: 0.0, q: &[0.0, -1.0, 0.0], v: &[0.0; 3] };
    let refused = source(&scene, Language::C, start).expect_err("three rods of one length");
    assert!(matches!(&refused, ExportError::Dependent { loss, .. } if loss.n_redundant == Some(1)), "{refused}");
    assert!(refused.to_string().contains("leave the redundant ones out"), "{refused}");
}

#[test]
fn invariant_a_scene_that_is_too_large_is_refused() {
    let mut scene = rope::Swings::default();
    scene.set_count(0, 61);
    let n_q = scene.info().n_coordinates();
    let zero = vec![0.0; n_q];
    let refused = source(&scene, Language::C, Start { t: 0.0, q: &zero, v: &zero }).expect_err("too large");
    assert_eq!(refused, ExportError::TooLarge { scene: "swings", n: 61 * 5 });
    scene.set_count(0, 60);
    let zero = vec![0.0; scene.info().n_coordinates()];
    assert!(source(&scene, Language::C, Start { t: 0.0, q: &zero, v: &zero }).is_ok());
}
