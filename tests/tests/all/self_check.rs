//! The checks that a user runs on a scene, run on every scene.

use crate::scenes::{Case, all};
use ezy_core::testing::check_scene;
use ezy_models::ezy_roller;

#[test]
fn fd_every_scene_of_the_model_passes_its_checks() {
    for entry in ezy_roller::MODEL.scenes {
        if let Err(error) = check_scene(&*(entry.new)()) {
            panic!("{error}");
        }
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
