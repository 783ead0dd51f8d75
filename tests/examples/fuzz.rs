//! Random parameters for every scene, as many as one likes.
//!
//! `cargo run --release -p ezy-tests --example fuzz -- parameters 100000 --seed 1`

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use ezy_tests::fuzz::{Scenes, Tally, trial};

/// Longer than any trial takes by thousands of times: it hangs.
const HANG: Duration = Duration::from_secs(600);
/// Trials between two lines of the report.
const REPORT: u64 = 10_000;

const USAGE: &str = "usage: fuzz parameters N [--seed S] [--first I]";

fn main() -> std::process::ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let option = |name: &str, otherwise: u64| match words.iter().position(|word| *word == name) {
        Some(i) => words.get(i + 1).and_then(|text| text.parse().ok()),
        None => Some(otherwise),
    };
    let n = words.get(1).and_then(|text| text.parse().ok());
    let (Some("parameters"), Some(n), Some(seed), Some(first)) =
        (words.first().copied(), n, option("--seed", 1), option("--first", 0))
    else {
        eprintln!("{USAGE}");
        return std::process::ExitCode::from(2);
    };
    let tally = run(n, seed, first);
    tally.faults.iter().for_each(|fault| println!("{fault}\n"));
    println!("{tally}");
    std::process::ExitCode::from(u8::from(!tally.faults.is_empty()))
}

/// `n` trials of a seed from `first` on.
fn run(n: u64, seed: u64, first: u64) -> Tally {
    let scenes = Scenes::all();
    println!("{} scenes", scenes.n_scenes());
    let mut tally = Tally::default();
    let (current, done) = (AtomicU64::new(first), AtomicBool::new(false));
    let mut slowest = (Duration::ZERO, first);
    std::thread::scope(|scope| {
        scope.spawn(|| watch(&current, &done));
        for i in first..first + n {
            current.store(i, Ordering::Relaxed);
            let begin = Instant::now();
            trial(&scenes, seed, i, &mut tally);
            slowest = slowest.max((begin.elapsed(), i));
            if (i + 1 - first).is_multiple_of(REPORT) {
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
