//! Runs that step together in lanes, against the same runs one by one.

use ezy_core::prelude::*;
use ezy_core::simulate::{Alone, EndOfRun, SetupError, WaitingRun, run_together};
use ezy_core_tests::{simulation, system_of};
use ezy_models::{chain, ezy_roller};
use std::sync::atomic::AtomicBool;

/// Rounding of 5000 steps of the driven roller, whose sensitivity is 50 after 5 s; sines differ in their last bit.
const ROUNDING: f64 = 2e-12;
/// Both keep to 1e-10 a step, by other steps.
const TOLERANCE: f64 = 1e-7;

type Roller = ezy_roller::Driven;

/// A run of a driven roller by `dop853` that waits for others.
fn waiting(m0: f64, tolerance: f64, until_s: f64) -> WaitingRun {
    let scene = Roller { m0, ..Roller::default() };
    simulation(&scene).method(Method::dop853(tolerance)).until(until_s).waiting().unwrap()
}

/// Runs of another scene, with another tolerance or another end are told; the others go on without them.
#[test]
fn invariant_runs_that_are_different_do_not_step_together() {
    let (driven, coast) = (Roller::default(), ezy_roller::Coast::default());
    let other = simulation(&coast).method(Method::dop853(1e-6)).until(0.1).waiting().unwrap();
    let mut runs = vec![waiting(2.0, 1e-6, 0.1); 9];
    let ends = run_together(&driven, &runs, &[]);
    assert_eq!(ends.len(), 9);
    assert!(ends.iter().all(|end| end.as_ref().is_ok_and(|end| end.t == 0.1)));
    runs.splice(3..6, [other, waiting(2.0, 1e-7, 0.1), waiting(2.0, 1e-6, 0.2)]);
    let ends = run_together(&driven, &runs, &[]);
    assert_eq!(ends[3], Err("they are of different scenes"));
    assert_eq!(
        ends[4..6],
        [Err("they have different times or tolerances"), Err("they have different times or tolerances")]
    );
    assert_eq!(ends.iter().filter(|end| end.is_ok()).count(), 6);
    assert!(run_together(&coast, &runs[..1], &[])[0].is_err());
    let over = AtomicBool::new(true);
    assert!(run_together(&driven, &runs, &[&over]).iter().all(Result::is_err));
}

/// Torques from nothing to 9 N·m, the strong ones scattered among the weak ones. Each torque takes steps of its own length: in the order in which they stand, eight runs take those of
/// the strongest among them.
#[test]
fn invariant_runs_with_steps_of_similar_length_go_together() {
    let scene = Roller::default();
    let runs: Vec<WaitingRun> = (0..40).map(|i| waiting(0.225 * f64::from(7 * i % 40), 1e-9, 10.0)).collect();
    let steps = |ends: &[Result<EndOfRun, Alone>]| ends.iter().map(|end| end.as_ref().unwrap().n_steps).sum::<u64>();
    let sorted = run_together(&scene, &runs, &[]);
    let by_eights: Vec<_> = runs.chunks(8).flat_map(|eight| run_together(&scene, eight, &[])).collect();
    let alone: u64 = runs.iter().map(|run| steps(&run_together(&scene, std::slice::from_ref(run), &[]))).sum();
    let found = [alone, steps(&sorted), steps(&by_eights)];
    // between what they take alone and what they take as they stand, sorted runs are nearer to the first
    assert!(found[1] - found[0] < found[2] - found[1], "{found:?}");
    for (one, other) in sorted.iter().zip(&by_eights) {
        let (one, other) = (one.as_ref().unwrap(), other.as_ref().unwrap());
        assert_eq!((one.t, other.t), (10.0, 10.0));
        one.numbers
            .iter()
            .zip(&other.numbers)
            .for_each(|(x, y)| assert!((x - y).abs() <= TOLERANCE * x.abs().max(1.0)));
    }
}

/// Rollers of eight torques.
fn rollers() -> [Roller; 8] {
    std::array::from_fn(|i| Roller { m0: 2.0 + 0.05 * i as f64, ..Roller::default() })
}

/// Consistent starts, each with the bar at another angle.
fn starts<const L: usize>(scenes: &[Roller; L]) -> [State; L] {
    std::array::from_fn(|i| {
        let mut system = system_of(&scenes[i], Backend::Auto).unwrap();
        let mut start = system.scene_start();
        start.give_position(5, 3.0 - 0.02 * i as f64);
        system.consistent_start(&start).unwrap()
    })
}

/// Largest difference of positions and velocities at `until_s` between runs that step together and the same ones alone.
fn difference<const L: usize>(scenes: &[Roller; L], method: Method, until_s: f64) -> f64 {
    let starts = starts(scenes);
    let mut ensemble = Ensemble::new(scenes, starts.each_ref(), method).unwrap();
    ensemble.advance(until_s).unwrap();
    assert_eq!(ensemble.time(), until_s);
    let mut worst: f64 = 0.0;
    for (lane, scene) in scenes.iter().enumerate() {
        let run = simulation(scene).method(method).start("bar.phi", starts[lane].q[5]).until(until_s).run().unwrap();
        let (alone, together) = (run.last(), ensemble.state(lane));
        let pairs = alone.coordinates.iter().zip(&together.q).chain(alone.velocities.iter().zip(&together.v));
        worst = pairs.fold(worst, |worst, (x, y)| worst.max((x - y).abs()));
    }
    assert!(!worst.is_nan());
    worst
}

#[test]
fn cross_eight_runs_of_rk4_together_are_those_alone() {
    let error = difference(&rollers(), Method::rk4(1e-3), 5.0);
    assert!(error <= ROUNDING, "{error:.1e}");
}

#[test]
fn cross_four_runs_of_rk4_together_are_those_alone() {
    let scenes = rollers();
    let error = difference(&[scenes[0], scenes[2], scenes[5], scenes[7]], Method::rk4(1e-3), 5.0);
    assert!(error <= ROUNDING, "{error:.1e}");
}

#[test]
fn cross_eight_runs_of_dop853_share_steps_that_keep_to_the_tolerance() {
    let error = difference(&rollers(), Method::dop853(1e-10), 5.0);
    assert!(error <= TOLERANCE, "{error:.1e}");
}

/// Relative tolerances below 1e-15 are rounding: an ensemble takes 1e-15 in their place, as a single run does.
#[test]
fn invariant_relative_tolerances_below_rounding_are_lifted() {
    let scenes = rollers();
    let starts = starts(&scenes);
    let end = |relative: f64| {
        let method = Method::dop853(1e-9).with_tolerance(Tolerance::new(relative, 1e-9));
        let mut ensemble = Ensemble::new(&scenes, starts.each_ref(), method).unwrap();
        ensemble.advance(5.0).unwrap();
        ensemble.state(0)
    };
    assert_eq!(end(1e-18), end(1e-15));
    assert_ne!(end(1e-9), end(1e-15));
}

#[test]
fn invariant_runs_in_two_parts_end_where_they_end_in_one() {
    let scenes = rollers();
    let starts = starts(&scenes);
    let order = || Ensemble::new(&scenes, starts.each_ref(), Method::rk4(0.01)).unwrap();
    let (mut whole, mut parts) = (order(), order());
    whole.advance(2.0).unwrap();
    [0.5, 2.0, 1.0].into_iter().for_each(|until_s| parts.advance(until_s).unwrap());
    assert_eq!(whole.time(), parts.time());
    let error = (0..8).flat_map(|lane| {
        let (a, b) = (whole.state(lane), parts.state(lane));
        a.q.into_iter().zip(b.q).map(|(a, b)| (a - b).abs()).collect::<Vec<_>>()
    });
    let error = error.fold(0.0, f64::max);
    assert!(error <= ROUNDING, "{error:.1e}");
}

#[test]
fn analytic_what_cannot_run_in_lanes_is_told() {
    let scenes: [Roller; 4] = std::array::from_fn(|_| Roller::default());
    let mut starts = starts(&scenes);
    let refused = Ensemble::new(&scenes, starts.each_ref(), Method::taylor(1e-9)).err();
    assert!(matches!(refused, Some(SetupError::SingleNumbers { method: "taylor" })));
    let refused = Ensemble::new(&scenes, starts.each_ref(), Method::rk4(0.0)).err();
    assert!(matches!(refused, Some(SetupError::Step { .. })));
    let chains: [chain::Swing; 4] = std::array::from_fn(|_| chain::Swing::default());
    let refused = Ensemble::new(&chains, starts.each_ref(), Method::rk4(1e-3)).err();
    assert!(matches!(refused, Some(SetupError::System(_))));
    starts[2].t = 1.0;
    let refused = Ensemble::new(&scenes, starts.each_ref(), Method::rk4(1e-3)).err();
    assert!(matches!(refused, Some(SetupError::DifferentTimes { .. })));
}

/// Of the scenes behind the first only constants are made; what is wrong with them is told as of a system.
#[test]
fn invariant_later_scenes_are_checked_as_by_themselves() {
    let good = Roller::default();
    let starts = starts(&[good; 4]);
    for bad in [
        Roller { a: f64::NAN, ..good },
        Roller { m2: -1.0, ..good },
        Roller { m2: 0.0, ..good },
        Roller { i2: 1e-300, ..good },
        Roller { i2: f64::INFINITY, ..good },
    ] {
        let alone = System::new(&bad, Backend::Generated).err().expect("it cannot be used");
        let refused = Ensemble::new(&[good, good, bad, good], starts.each_ref(), Method::dop853(1e-9)).err();
        assert!(
            matches!(&refused, Some(SetupError::System(error)) if error.to_string() == alone.to_string()),
            "{alone} {refused:?}"
        );
    }
}

#[test]
fn analytic_starts_and_ends_that_cannot_be_are_told() {
    let scenes: [Roller; 4] = std::array::from_fn(|i| rollers()[i]);
    let starts = starts(&scenes);
    let short = State { t: 0.0, q: vec![0.0; 3], v: vec![0.0; 3], z: Vec::new(), work: Vec::new() };
    let mixed = [&starts[0], &short, &starts[2], &starts[3]];
    let refused = Ensemble::new(&scenes, mixed, Method::dop853(1e-9)).err().expect("a start of another scene");
    assert!(matches!(refused, SetupError::StartLength { expected: 6, found: 3 }), "{refused}");
    let mut ensemble = Ensemble::new(&scenes, starts.each_ref(), Method::dop853(1e-9)).unwrap();
    assert!(ensemble.advance(f64::INFINITY).is_err());
    assert_eq!(ensemble.time(), 0.0);
}
