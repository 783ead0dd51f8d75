//! The checks that a user runs on a scene, run on every scene.

use crate::scenes::{Case, all};
use ezy_core::testing::{check_model, check_scene};
use ezy_models::registry::MODELS;
use ezy_tests::{random_models, shapes};

#[test]
fn fd_every_scene_of_the_registry_passes_its_checks() {
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        if let Err(error) = check_scene(&*(entry.new)()) {
            panic!("{error}");
        }
    }
}

#[test]
fn fd_models_of_other_shapes_pass_their_checks() {
    for entry in shapes::MODELS.iter().flat_map(|model| model.scenes) {
        if let Err(error) = check_scene(&*(entry.new)()) {
            panic!("{error}");
        }
    }
}

#[test]
fn fd_random_models_pass_their_checks() {
    for model in random_models::MODELS {
        check_model(model).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn fd_every_route_passes_its_checks() {
    for Case { route, scene } in all() {
        match check_scene(&*scene) {
            Ok(report) => println!("{route} {report}"),
            Err(error) => panic!("{route}: {error}"),
        }
    }
}
