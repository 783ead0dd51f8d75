//! The checks that a user runs on a scene, run on every scene.

use crate::scenes::{Case, all};
use ezy_core::testing::check_scene;

#[test]
fn fd_every_scene_passes_its_checks() {
    for Case { route, scene } in all() {
        match check_scene(&*scene) {
            Ok(report) => println!("{route} {report}"),
            Err(error) => panic!("{route}: {error}"),
        }
    }
}
