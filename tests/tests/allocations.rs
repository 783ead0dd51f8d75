//! No step of a run allocates: a run of ten times the steps allocates as often.

use ezy_core::prelude::*;
use ezy_models::{chain, ezy_roller};
use ezy_tests::hand_roller::HandRoller;
use ezy_tests::piloted::piloted;

fn allocations(scene: &dyn Scene, backend: Backend, metric: Metric, n_steps: u32) -> u64 {
    let mut n_done = 0;
    let info = allocation_counter::measure(|| {
        let order = Simulation::new(scene).backend(backend).metric(metric).method(Method::rk4(1e-3));
        n_done = order.until(f64::from(n_steps) * 1e-3).run().unwrap().cost.steps;
    });
    assert_eq!(n_done, u64::from(n_steps));
    info.count_total
}

#[test]
fn invariant_steps_do_not_allocate() {
    let scenes: [(&str, &dyn Scene); 3] = [
        ("hand", &HandRoller::driven()),
        ("generated", &ezy_roller::Driven::default()),
        ("generated coast", &ezy_roller::Coast::default()),
    ];
    for (route, scene) in scenes {
        for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
            for metric in [Metric::Mass, Metric::Euclidean] {
                let [few, many] = [100, 1000].map(|n| allocations(scene, backend, metric, n));
                assert_eq!(few, many, "{route} {backend:?} {metric:?}");
            }
        }
    }
}

#[test]
fn invariant_taylor_steps_do_not_allocate() {
    let scene = HandRoller::driven();
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        let allocations = |until_s: f64| {
            let order = Simulation::new(&scene).method(Method::taylor(1e-12)).backend(backend).work().until(until_s);
            allocation_counter::measure(|| assert!(order.run().unwrap().cost.steps >= 2)).count_total
        };
        assert_eq!(allocations(1.0), allocations(10.0), "{backend:?}");
    }
}

#[test]
fn invariant_steps_of_a_scene_with_counts_do_not_allocate() {
    let scene = chain::Swing { n: 5, ..Default::default() };
    // the description of a chain of five is made once
    assert_eq!(scene.info().bodies.len(), 5);
    let [few, many] = [100, 1000].map(|n| allocations(&scene, Backend::Auto, Metric::Mass, n));
    assert_eq!(few, many);
}

#[test]
fn invariant_stepper_does_not_allocate() {
    let scene = piloted::Pushed::default();
    for backend in [Backend::Generated, Backend::Dense, Backend::Sparse] {
        let mut stepper = Simulation::new(&scene).backend(backend).work().stepper().unwrap();
        let mut episode = |given: &[(&str, f64)], n: u64| {
            stepper.reset_with(given).unwrap();
            for _ in 0..n {
                let seen = stepper.outputs()[0] + stepper.state().q[2] + stepper.energy().kinetic;
                let reaction = stepper.multipliers().unwrap()[0] + stepper.accelerations().unwrap()[0];
                stepper.inputs_mut().fill((seen + reaction).sin());
                stepper.step(2).unwrap();
            }
            stepper.reset();
            stepper.step(1).unwrap();
        };
        // the first reset to a start assembles it
        episode(&[("bar.phi", 1.2)], 10);
        let info = allocation_counter::measure(|| episode(&[("bar.phi", 1.2)], 100));
        assert_eq!(info.count_total, 0, "{backend:?}");
    }
}

#[test]
fn invariant_controlled_steps_do_not_allocate() {
    let scene = piloted::Pushed::default();
    let allocations = |n_steps: u32| {
        let table = InputTable::new(vec![0.0, 1.0], vec![0.0, 5.0]).unwrap();
        let law = |t: f64, state: &State, inputs: &mut [f64]| inputs[0] = t - state.v[5];
        let order = Simulation::new(&scene).work().input("pull", table).control(law).until(f64::from(n_steps) * 1e-3);
        allocation_counter::measure(|| assert!(order.run().unwrap().outcome.reached_end())).count_total
    };
    assert_eq!(allocations(100), allocations(1000));
}

#[test]
fn invariant_radau_steps_do_not_allocate() {
    let scene = ezy_roller::Driven::default();
    let allocations = |until_s: f64| {
        let order = Simulation::new(&scene).method(Method::radau(1e-9)).work().until(until_s);
        allocation_counter::measure(|| assert!(order.run().unwrap().cost.steps >= 20)).count_total
    };
    assert_eq!(allocations(1.0), allocations(10.0));
}
