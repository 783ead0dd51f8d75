//! Random parameters, starts and inputs; many more by the example `measure`.

use std::path::Path;
use std::time::UNIX_EPOCH;

use ezy_core::prelude::Method;
use ezy_core::simulate::SetupError;
use ezy_core_tests::simulation;
use ezy_models::registry::MODELS;
use ezy_models::tractor_trailers;
use ezy_tests::fuzz::estimates::{Estimated, SMALLEST, estimated};
use ezy_tests::fuzz::methods::{Case, Judgement, Told};
use ezy_tests::fuzz::{Scenes, Tally, Verdict, compare, trial};
use ezy_tests::garage::set;

/// Some for every scene.
const N_TRIALS: u64 = 200;
const SEED: u64 = 1;

#[test]
fn cross_random_parameters_are_refused_or_confirmed() {
    let (scenes, mut tally) = (Scenes::all(), Tally::default());
    (0..N_TRIALS).for_each(|i| trial(&scenes, SEED, i, &mut tally));
    assert!(tally.faults.is_empty(), "{}", tally.faults.join("\n"));
    assert!(tally.of(Verdict::AccelerationsConfirmed) > N_TRIALS / 2, "too few are compared:\n{tally}");
    assert_eq!(tally.of(Verdict::AccelerationsLoseDigits), 0, "{tally}");
    assert!(tally.of(Verdict::RunEnded) > N_TRIALS / 8, "too few runs:\n{tally}");
}

/// Lengths and masses so far apart that pivots are small although rows are independent, or that constraints depend on each other
/// within rounding although they are not; found by random trials.
const FAR_APART: [(&str, &[(&str, f64)]); 22] = [
    (
        "Andrews/squeeze",
        &[("m2", 6.6e-13), ("i1", 0.84), ("i4", 1.7e-6), ("i5", 2.0e-5), ("i7", 4.3e4), ("rr", 3.5e-4), ("ra", 5.6e-4)],
    ),
    ("Train/pull", &[("l", 6.2e-192)]),
    ("Train/pull", &[("l", -8.7e-81)]),
    ("Train/pull", &[("l", 4e-6)]),
    ("Tethered/circle", &[("l", 6.1e222)]),
    ("Pendulum/mirrored", &[("l", 3.9e93)]),
    ("Pendulum/mirrored", &[("l", 3.1e19), ("m", 124.0)]),
    ("Pendulum/swing", &[("l", 9e8), ("m", 3e3)]),
    ("Pendulum/swing", &[("l", 2.2e-308), ("g", 5e-324)]),
    ("SliderCrank/pushed", &[("l_centre", 8.3e8), ("k", 1e5), ("tip", 6.9e-10)]),
    ("SliderCrank/falling", &[("l_centre", -1.3e72), ("i1", 0.02)]),
    ("WheeledSnake/slithering", &[("l", 1e-7), ("i", 1.4e-3)]),
    ("WheeledSnake/slithering", &[("l", 2.4e-8), ("m", 1e-299)]),
    ("WheeledSnake/floating", &[("l", 1.1e9)]),
    ("DifferentialRobot/prescribed", &[("w", 0.039), ("r", 3.1e8)]),
    ("DifferentialRobot/prescribed", &[("w", 1900.0), ("j", 4.3e150)]),
    ("DifferentialRobot/prescribed", &[("w", 0.0024), ("a", 2.4), ("m", 4.0), ("j", 0.039)]),
    ("DifferentialRobot/prescribed", &[("a", 2.1e5), ("j", 551.0), ("m_wheel", 0.12), ("right_rate", 24.0)]),
    ("Skateboard/ridden", &[("m_rider", 3.1e11), ("j_truck", 8.4e-10)]),
    ("Hub/spin", &[("l", 2.2e14)]),
    ("RollerRacer/coast", &[("h", 5.2e28), ("m1", 1e-300)]),
    ("FourBar/driven", &[("l1", 1.6e-9)]),
];

/// An inertia whose square vanishes, beside metres: the library that decomposes the matrix of the start panicked.
#[test]
fn regress_start_with_an_inertia_whose_square_vanishes_is_refused() {
    let mut scene = tractor_trailers::Locked::default();
    set(&mut scene, &[("front", -6.2279801943842365e-279), ("rear", -0.4), ("m_steer", 0.4), ("i_steer", 5e-324)]);
    set(&mut scene, &[("m_second", 2.843710921014777), ("delta_rate", 0.004555580813629171), ("nu", -1.0)]);
    let order = simulation(&scene).start("first.vy", 1.0).start("second.omega", -1.0).until(0.0);
    assert!(matches!(order.run(), Err(SetupError::Start(_))));
}

#[test]
fn regress_parameters_far_apart_are_refused_or_confirmed() {
    let (scenes, mut tally) = (Scenes::all(), Tally::default());
    FAR_APART.iter().for_each(|(name, parameters)| compare(&scenes, name, parameters, &mut tally));
    assert!(tally.faults.is_empty(), "{}", tally.faults.join("\n"));
    assert!(tally.of(Verdict::AccelerationsConfirmed) > FAR_APART.len() as u64, "too few are solved:\n{tally}");
}

/// Motions by every method, of which each takes some fifteen runs; many more by the example `measure`.
const N_MOTIONS: u64 = 12;

/// As many again with a seed of the day.
#[test]
fn cross_random_motions_are_the_same_by_every_method() {
    let scenes = Scenes::all();
    for seed in [SEED, seed_of_the_day()] {
        let mut n_right = 0;
        let mut tell = |told: Told| n_right += u64::from(told.judgement == Judgement::Right);
        let faults = (0..N_MOTIONS).flat_map(|i| Case::new(&scenes, seed, i).judge(&mut tell));
        let faults: Vec<String> = faults.map(|fault| fault.shrunk().to_string()).collect();
        keep("methods", seed, &faults);
        assert!(faults.is_empty(), "seed {seed}: {}", faults.join("\n"));
        assert!(n_right > 4 * N_MOTIONS, "seed {seed}: too few are compared: {n_right}");
    }
}

/// A knock parts velocities of two runs from the time of one to that of the other, however near both are.
#[test]
fn cross_samples_between_the_times_of_a_knock_are_not_compared() {
    let pendulum = MODELS.iter().find(|model| model.name == "Pendulum").unwrap();
    let knocking = pendulum.scenes.iter().find(|scene| scene.name == "knocking").unwrap();
    let scene = (knocking.new)();
    let first_knock = |method| {
        let run = simulation(&*scene).method(method).run().unwrap();
        run.events().iter().find(|event| event.event.name == "post hits").unwrap().state.t
    };
    let [coarse, exact] = [Method::taylor(1e-4), Method::dop853(1e-13)].map(first_knock);
    assert!((coarse - exact).abs() > 1e-8, "{coarse} {exact}");
    // the third of 32 samples
    let case = Case::shipped(pendulum, knocking, 1.0).over(32.0 / 3.0 * (0.5 * (coarse + exact)));
    let mut n_skipped = 0;
    let faults = case.judge(|told| n_skipped += told.n_skipped);
    assert!(faults.is_empty(), "{}", faults[0]);
    assert!(n_skipped > 0);
}

/// Runs whose estimated error is compared with the true one; many more by the example `measure`.
const N_ESTIMATES: u64 = 60;

#[test]
fn cross_random_estimates_are_not_below_the_error() {
    let scenes = Scenes::all();
    for seed in [SEED, seed_of_the_day()] {
        let mut n_judged = 0;
        let mut low = Vec::new();
        for i in 0..N_ESTIMATES {
            if let Estimated::Judged { command, judged } = estimated(&scenes, seed, i) {
                n_judged += u64::from(!judged.is_empty());
                low.extend(judged.iter().filter(|of| of.ratio() < SMALLEST).map(|of| format!("{of:?}: {command}")));
            }
        }
        keep("estimates", seed, &low);
        assert!(low.is_empty(), "seed {seed}: {}", low.join("\n"));
        assert!(n_judged > N_ESTIMATES / 6, "seed {seed}: too few are judged: {n_judged}");
    }
}

/// Days since 1970, or `EZY_SEED`: what one day finds is found again on the next with it.
fn seed_of_the_day() -> u64 {
    let given = std::env::var("EZY_SEED").ok().and_then(|seed| seed.parse().ok());
    let seed = given.unwrap_or_else(|| UNIX_EPOCH.elapsed().expect("a clock").as_secs() / 86_400);
    println!("EZY_SEED={seed}");
    seed
}

/// Writes what a seed found where it outlives the day.
fn keep(what: &str, seed: u64, faults: &[String]) {
    if !faults.is_empty() {
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("fuzz-{what}-{seed}.txt"));
        std::fs::write(&file, faults.join("\n")).expect("a folder for temporary files");
        println!("kept in {}", file.display());
    }
}
