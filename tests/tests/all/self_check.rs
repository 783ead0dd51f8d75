//! The checks that a user runs on a scene, run on every scene.

use crate::scenes::{all, assert_checks};
use ezy_core::model::ModelInfo;
use ezy_core::testing::{check_model, check_scene};
use ezy_models::registry::MODELS;
use ezy_tests::{random_models, shapes};

#[test]
fn fd_every_scene_of_the_registry_passes_its_checks() {
    assert_models_pass(MODELS);
}

#[test]
fn fd_models_of_other_shapes_pass_their_checks() {
    assert_models_pass(&shapes::MODELS);
}

#[test]
fn fd_random_models_pass_their_checks() {
    assert_models_pass(&random_models::MODELS);
}

fn assert_models_pass(models: &[&ModelInfo]) {
    for model in models {
        check_model(model).unwrap_or_else(|error| panic!("{error}"));
    }
}

/// A right model with states at which differences are no oracle: it passes without them, and tells how many they are.
#[test]
fn fd_states_next_to_a_corner_are_left_out_and_counted() {
    let report = check_scene(&shapes::cornered::Shake::default()).unwrap_or_else(|error| panic!("{error}"));
    let n_left_out: usize = report.checks.iter().map(|check| check.n_left_out).sum();
    assert!((1..100).contains(&n_left_out), "{report}");
    assert!(report.to_string().contains("left out next to singular points"), "{report}");
}

#[test]
fn fd_every_route_passes_its_checks() {
    all().iter().for_each(|case| assert_checks(&*case.scene));
}
