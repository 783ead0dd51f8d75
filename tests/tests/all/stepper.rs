//! Scenes that the caller steps.

use ezy_core::prelude::*;
use ezy_core::simulate::CheckpointError;
use ezy_models::ezy_roller;
use ezy_models::registry::MODELS;
use ezy_tests::piloted::piloted;
use std::sync::Arc;

const STEP: f64 = 1e-3;

/// The numbers of a run, step by step.
#[test]
fn cross_stepper_gives_the_numbers_of_a_run() {
    let scene = piloted::Pushed::default();
    let law = |now: &Now<piloted::Pushed>, set: &mut Inputs<piloted::Pushed>| {
        set.torque = 100.0 * now.t - now.bar.omega;
        set.pull = 20.0 * (3.0 * now.t).sin();
    };
    let order = || Simulation::new(&scene).method(Method::rk4(STEP)).until(0.5).work().outputs();
    let run = order().every(STEP).control(law).run().unwrap();
    let mut stepper = order().stepper().unwrap();
    // the last step of a run is as long as is left, which is STEP but for rounding
    for s in run.samples().take(500) {
        let state = stepper.state().clone();
        let mut set = *stepper.set();
        law(&stepper.now(), &mut set);
        *stepper.set() = set;
        assert_eq!((s.t, s.coordinates, s.velocities), (state.t, &state.q[..], &state.v[..]));
        assert_eq!((s.inputs, s.work), (stepper.inputs(), &state.work[..]));
        assert_eq!(s.multipliers, stepper.multipliers().unwrap());
        assert_eq!(s.outputs, stepper.outputs());
        assert_eq!(s.energy, stepper.energy());
        stepper.step(1).unwrap();
    }
}

#[test]
fn invariant_stepper_repeats_to_the_bit() {
    let scene = piloted::Ridden::default();
    let mut stepper = Simulation::new(&scene).method(Method::rk4(1e-3)).stepper().unwrap();
    let mut episode = |given: &[(&str, f64)]| {
        stepper.reset_with(given).unwrap();
        stepper.set().torque = -20.0;
        stepper.step(300).unwrap();
        stepper.state().clone()
    };
    let (first, other) = (episode(&[]), episode(&[("bar.phi", 1.0)]));
    assert_ne!(first, other);
    assert_eq!(episode(&[]), first);
    assert_eq!(episode(&[("bar.phi", 1.0)]), other);
}

#[test]
fn invariant_reset_brings_start_inputs_and_time_back() {
    let scene = piloted::Ridden::default();
    let mut stepper = Simulation::new(&scene).method(Method::rk4(1e-3)).work().stepper().unwrap();
    let (state, a) = (stepper.state().clone(), stepper.accelerations().unwrap().to_vec());
    stepper.set().torque = 7.0;
    stepper.step(10).unwrap();
    stepper.reset();
    assert_eq!((stepper.state(), stepper.inputs()), (&state, &[50.0][..]));
    assert_eq!(stepper.accelerations().unwrap(), a);
    assert_eq!((stepper.energy().work, stepper.energy().balance), (0.0, 0.0));
}

#[test]
fn invariant_reset_to_an_impossible_start_leaves_the_state() {
    let scene = piloted::Ridden::default();
    let mut stepper = Simulation::new(&scene).method(Method::rk4(1e-3)).stepper().unwrap();
    stepper.step(5).unwrap();
    let before = stepper.state().clone();
    assert!(stepper.reset_with(&[("seat.vy", 3.0)]).unwrap_err().to_string().contains("contradicts"));
    assert!(stepper.reset_with(&[("seat.z", 3.0)]).unwrap_err().to_string().contains("is not known"));
    assert_eq!(stepper.state(), &before);
    stepper.step(1).unwrap();
}

#[test]
fn invariant_stepper_without_inputs_is_a_run() {
    let scene = ezy_roller::Driven::default();
    let run = Simulation::new(&scene).method(Method::rk4(1e-3)).until(0.1).every(STEP).run().unwrap();
    let mut stepper = Simulation::new(&scene).method(Method::rk4(1e-3)).stepper().unwrap();
    stepper.step(99).unwrap();
    let s = run.sample(99).unwrap();
    assert_eq!((s.coordinates, s.velocities), (&stepper.state().q[..], &stepper.state().v[..]));
}

#[test]
fn invariant_steppers_on_threads_give_the_same_bits() {
    let scene = piloted::Ridden::default();
    let episode = || {
        let mut stepper =
            Simulation::new(&scene).method(Method::rk4(1e-3)).control(|now, set| set.torque = now.t).stepper().unwrap();
        stepper.step(200).unwrap();
        stepper.state().clone()
    };
    let alone = episode();
    std::thread::scope(|scope| {
        let mut stepper =
            Simulation::new(&scene).method(Method::rk4(1e-3)).control(|now, set| set.torque = now.t).stepper().unwrap();
        let others = [scope.spawn(episode), scope.spawn(episode)];
        // one that is made here and stepped there
        let moved = scope.spawn(move || stepper.step(200).map(|()| stepper.state().clone()).unwrap());
        others.into_iter().for_each(|other| assert_eq!(other.join().unwrap(), alone));
        assert_eq!(moved.join().unwrap(), alone);
    });
}

#[test]
fn invariant_number_of_the_order_is_where_inputs_start() {
    let scene = piloted::Ridden::default();
    let mut stepper = Simulation::new(&scene).method(Method::rk4(1e-3)).input("torque", 5.0).stepper().unwrap();
    assert_eq!(stepper.inputs(), [5.0]);
    stepper.set().torque = 8.0;
    stepper.step(3).unwrap();
    assert_eq!(stepper.inputs(), [8.0]);
    stepper.reset();
    assert_eq!(stepper.inputs(), [5.0]);
}

/// Another stepper of each scene of the garage goes on from a checkpoint with the numbers of the first one, wherever it is
/// made: also where rows are redundant, across singular positions, behind discontinuities.
#[test]
fn invariant_restored_stepper_goes_on_to_the_last_bit() {
    let mut n_scenes = 0;
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        let scene: Arc<dyn Scene> = Arc::from((entry.new)());
        for method in [Method::rk4(scene.info().until_s / 400.0), Method::midpoint(scene.info().until_s / 1600.0)] {
            let new = || Simulation::new(Arc::clone(&scene)).method(method).work().stepper();
            let Ok(mut first) = new() else { continue };
            let push = |stepper: &mut Stepper<'_, Arc<dyn Scene>>, n: u32| {
                stepper.inputs_mut().iter_mut().for_each(|input| *input += 1e-3 * f64::from(n % 3));
                stepper.step(7).ok().map(|()| numbers(stepper))
            };
            let mut checkpoints = Vec::new();
            for n in 0..40 {
                checkpoints.push((n, first.save(), Vec::new()));
                let Some(numbers) = push(&mut first, n) else { break };
                checkpoints.last_mut().unwrap().2 = numbers;
            }
            n_scenes += 1;
            for (i, (n, checkpoint, _)) in checkpoints.iter().enumerate().step_by(6) {
                first.restore(checkpoint).unwrap();
                let mut other = new().unwrap();
                other.restore(checkpoint).unwrap();
                for (k, n) in (*n..*n + 9).enumerate() {
                    let [one, two] = [&mut first, &mut other].map(|stepper| push(stepper, n));
                    assert_eq!(one, two, "{} by {method:?}, {n}", scene.info().name);
                    // as the motion went on that nobody restored
                    let went_on =
                        checkpoints.get(i + k).map(|(.., numbers)| numbers).filter(|numbers| !numbers.is_empty());
                    assert!(went_on.is_none() || one.as_ref() == went_on, "{} by {method:?}, {n}", scene.info().name);
                }
            }
        }
    }
    assert!(n_scenes >= 40, "{n_scenes}");
}

/// Bits of all that a caller sees.
fn numbers(stepper: &mut Stepper<'_, Arc<dyn Scene>>) -> Vec<u64> {
    let State { t, q, v, z, work } = stepper.state().clone();
    let multipliers = stepper.multipliers().map_or_else(|_| Vec::new(), <[f64]>::to_vec);
    let all = [&[t][..], &q, &v, &z, &work, &multipliers, stepper.outputs()].concat();
    all.into_iter().map(f64::to_bits).collect()
}

/// What was changed is named.
#[test]
fn invariant_checkpoint_of_another_simulation_is_refused() {
    let scene = piloted::Ridden::default();
    let step = |step_s| Simulation::new(&scene).method(Method::rk4(step_s));
    let checkpoint = step(1e-3).stepper().unwrap().save();
    let differs =
        |error: CheckpointError| if let CheckpointError::OfAnother { what, .. } = error { what } else { "".into() };
    for (simulation, what) in [
        (step(2e-3), "step"),
        (step(1e-3).method(Method::midpoint(1e-3)), "method"),
        (step(1e-3).work(), "works"),
        (step(1e-3).project(Projection::None), "projection"),
        (step(1e-3).metric(Metric::Euclidean), "metric"),
        (step(1e-3).backend(Backend::Dense), "backend"),
    ] {
        let error = simulation.stepper().unwrap().restore(&checkpoint).unwrap_err();
        assert_eq!(differs(error), what);
    }
    let roller = ezy_roller::Coast::default();
    let mut stepper = Simulation::new(&roller).method(Method::rk4(1e-3)).stepper().unwrap();
    assert_eq!(differs(stepper.restore(&checkpoint).unwrap_err()), "scene");
    let of = stepper.save();
    let other = ezy_roller::Coast { b: 0.7, ..Default::default() };
    let mut stepper = Simulation::new(&other).method(Method::rk4(1e-3)).stepper().unwrap();
    let error = stepper.restore(&of).unwrap_err();
    let text = "the checkpoint is of b 0.6, and the stepper has 0.7; make the stepper as it was made then";
    assert_eq!(error.to_string(), text);
}
