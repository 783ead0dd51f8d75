//! Which coordinates accelerations depend on.

use ezy_core::prelude::*;
use ezy_core_tests::system_of;
use ezy_models::registry::MODELS;

/// Accelerations and multipliers at a state, to the last bit.
fn solution(system: &mut System<&dyn Scene>, t: f64, q: &[f64], v: &[f64]) -> Vec<u64> {
    let (mut a, mut lambda) = (vec![0.0; q.len()], vec![0.0; system.info().n_rows()]);
    system.scene().accelerations(system.fixed(), t, q, v, &mut a, &mut lambda);
    a.iter().chain(&lambda).map(|x| x.to_bits()).collect()
}

/// Moving a coordinate that is not listed changes no bit of any acceleration or multiplier; of the listed ones some do.
#[test]
fn invariant_accelerations_depend_on_the_coordinates_that_are_listed() {
    let (mut n_listed, mut n_others) = (0, 0);
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        let scene = (entry.new)();
        let info = scene.info();
        let Some(feedback) = info.feedback else {
            assert!(!info.has_elimination(), "{}/{}", info.model, info.name);
            continue;
        };
        let mut system = system_of(&*scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let state = system.consistent_start(&start).unwrap();
        let v: Vec<f64> = (0..state.v.len()).map(|i| 0.3 + 0.1 * i as f64).collect();
        let base = solution(&mut system, state.t, &state.q, &v);
        for i in 0..state.q.len() {
            let mut q = state.q.clone();
            q[i] += 0.4;
            let is_same = solution(&mut system, state.t, &q, &v) == base;
            if feedback.contains(&i) {
                n_listed += usize::from(!is_same);
            } else {
                n_others += 1;
                assert!(is_same, "{}/{}: {}", info.model, info.name, info.coordinates[i].name);
            }
        }
    }
    assert!(n_listed > 50 && n_others > 50, "{n_listed} that matter, {n_others} that do not");
}
