//! Models that are hard on purpose: they are what their references say, and the naive program beside them is what it says.

mod bounds;
mod methods_page;
mod page;
mod symptoms;

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::double_pendulum;
use ezy_tests::hard::block::difference;
use ezy_tests::hard::naive::Naive;
use ezy_tests::hard::subject::{Entry, SUBJECTS, subject};

/// Rounding of sums of a few terms of the size of the largest, which a stiff spring makes 1e9.
const SAME_MODEL: f64 = 1e-12;

#[test]
fn cross_every_model_is_the_one_of_its_reference() {
    for Entry { file, case, .. } in SUBJECTS {
        let subject = subject(file, case);
        let error = difference(&subject.block, &*subject.scene, subject.names);
        assert!(error <= SAME_MODEL, "{file} {case}: {error:.1e}");
    }
}

/// The same method and the same equations, solved by two factorisations.
const ROUNDING: f64 = 1e-12;

#[test]
fn cross_naive_program_is_rk4_without_projection() {
    const N: u32 = 200;
    let scene = double_pendulum::Swing::default();
    let h = 1e-3;
    let order = simulation(&scene).method(Method::rk4(h)).project(Projection::None);
    let run = order.until(f64::from(N) * h).run().unwrap();
    let mut naive = Naive::new(&scene, run.first().coordinates, run.first().velocities);
    for i in 0..N {
        naive.step(f64::from(i) * h, h).unwrap();
    }
    let last = [run.last().coordinates, run.last().velocities].concat();
    let error = crate::scenes::distance(&naive.state, &last);
    assert!(error <= ROUNDING, "{error:.1e}");
}
