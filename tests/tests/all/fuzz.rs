//! Random parameters, starts and inputs; many more by the example `fuzz`.

use ezy_tests::fuzz::{Scenes, Tally, Verdict, trial};

/// Some for every scene.
const N_TRIALS: u64 = 200;
const SEED: u64 = 1;

#[test]
fn cross_random_parameters_are_refused_or_confirmed() {
    let (scenes, mut tally) = (Scenes::all(), Tally::default());
    (0..N_TRIALS).for_each(|i| trial(&scenes, SEED, i, &mut tally));
    assert!(tally.faults.is_empty(), "{}", tally.faults.join("\n"));
    assert!(tally.of(Verdict::AccelerationsConfirmed) > N_TRIALS / 2, "too few are compared:\n{tally}");
    assert!(tally.of(Verdict::RunEnded) > N_TRIALS / 8, "too few runs:\n{tally}");
}
