//! Every model that is held against a reference with a `model` block is the model of that block.

use ezy_tests::hard::block::difference;
use ezy_tests::hard::subject::{SUBJECTS, subject};

/// Rounding of sums of a few terms of the size of the largest, which a stiff spring makes 1e9.
const SAME_MODEL: f64 = 1e-12;

#[test]
fn cross_every_model_is_the_one_of_its_reference() {
    for (file, names) in SUBJECTS {
        for name in *names {
            let subject = subject(file, name);
            let error = difference(&subject.block, &*subject.scene, subject.names);
            assert!(error <= SAME_MODEL, "{file} {name}: {error:.1e}");
        }
    }
}
