//! The checks that every model can be given in one line: Jacobians by finite differences, two solvers against each other, energy.

use ezy_core::testing::check_model;

#[test]
fn fd_every_scene_passes_its_checks() {
    for report in check_model(&my_mechanism::MODEL).unwrap_or_else(|error| panic!("{error}")) {
        println!("{report}");
    }
}
