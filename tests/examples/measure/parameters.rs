//! Random parameters for every scene, as many as one likes.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use ezy_tests::fuzz::{Scenes, Tally, trial};

use super::{Outcome, Random, outcome};

/// Longer than any trial takes by thousands of times: it hangs.
const HANG: Duration = Duration::from_secs(600);
/// Trials between two lines of the report.
const REPORT: u64 = 10_000;

pub(crate) fn run(random: &Random) -> Outcome {
    let tally = tried(random);
    tally.faults.iter().for_each(|fault| println!("{fault}\n"));
    println!("{tally}");
    outcome(tally.faults.len())
}

fn tried(random: &Random) -> Tally {
    let scenes = Scenes::all();
    println!("{} scenes", scenes.n_scenes());
    let mut tally = Tally::default();
    let (current, done) = (AtomicU64::new(random.first), AtomicBool::new(false));
    let mut slowest = (Duration::ZERO, random.first);
    std::thread::scope(|scope| {
        scope.spawn(|| watch(&current, &done));
        for i in random.cases() {
            current.store(i, Ordering::Relaxed);
            let begin = Instant::now();
            trial(&scenes, random.seed, i, &mut tally);
            slowest = slowest.max((begin.elapsed(), i));
            if (i + 1 - random.first).is_multiple_of(REPORT) {
                let n_faults = tally.faults.len();
                println!("{} trials, {n_faults} faults, slowest: {:?}, trial {}", i + 1, slowest.0, slowest.1);
            }
        }
        done.store(true, Ordering::Relaxed);
    });
    tally
}

/// Ends the process, with the number of the trial, when one takes too long.
fn watch(current: &AtomicU64, done: &AtomicBool) {
    let mut last = (u64::MAX, Instant::now());
    while !done.load(Ordering::Relaxed) {
        let i = current.load(Ordering::Relaxed);
        if i != last.0 {
            last = (i, Instant::now());
        } else if last.1.elapsed() > HANG {
            eprintln!("trial {i} takes longer than {HANG:?}");
            std::process::abort();
        }
        std::thread::sleep(Duration::from_millis(50));
    }
}
