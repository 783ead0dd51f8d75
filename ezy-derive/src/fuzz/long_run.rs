//! The long run: any number of texts.
//!
//! `EZY_FUZZ_TEXTS=1000000 cargo test --release -p ezy-derive --lib fuzz -- --ignored --nocapture`; `EZY_FUZZ_SEED` chooses
//! others, `EZY_FUZZ_FIRST` goes on where a run was ended.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use super::texts::Texts;
use super::trial::{self, Verdict};

/// Time after which the macro hangs: thousands of times what any text takes.
const HANG: Duration = Duration::from_secs(600);
/// One text in so many has its items read as Rust when it is a model; those of errors always are.
const READ: u64 = 8;
/// Texts between two lines of the report.
const REPORT: u64 = 50_000;

/// A number from the environment.
fn number(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).map_or(otherwise, |text| text.parse().expect("the variable is a whole number"))
}

/// Ends the process, with the number of the text, when one takes too long.
fn watch(current: &AtomicU64, done: &AtomicBool) {
    let mut last = (u64::MAX, Instant::now());
    while !done.load(Ordering::Relaxed) {
        let i = current.load(Ordering::Relaxed);
        if i != last.0 {
            last = (i, Instant::now());
        } else if last.1.elapsed() > HANG {
            eprintln!("text {i} takes longer than {HANG:?}");
            std::process::abort();
        }
        std::thread::sleep(Duration::from_millis(50));
    }
}

#[test]
#[ignore = "takes minutes; CONTRIBUTING.md says how to run it"]
fn invariant_very_many_random_texts_give_a_model_or_an_error() {
    let (seed, first) = (number("EZY_FUZZ_SEED", 1), number("EZY_FUZZ_FIRST", 0));
    let end = first + number("EZY_FUZZ_TEXTS", 100_000);
    let texts = Texts::new();
    let (current, done) = (AtomicU64::new(first), AtomicBool::new(false));
    let mut found = [0_u64; 3];
    let (mut faults, mut slowest) = (Vec::new(), (Duration::ZERO, first));
    std::thread::scope(|scope| {
        scope.spawn(|| watch(&current, &done));
        for i in first..end {
            current.store(i, Ordering::Relaxed);
            let text = texts.text(seed, i);
            let begin = Instant::now();
            match trial::verdict(&text, i.is_multiple_of(READ)) {
                Ok(verdict) => found[verdict as usize] += 1,
                Err(fault) => faults.push(format!("text {i}: {fault}\n{text}")),
            }
            slowest = slowest.max((begin.elapsed(), i));
            if (i + 1 - first).is_multiple_of(REPORT) || i + 1 == end {
                println!("{} texts, {} faults, slowest: {:?}, text {}", i + 1, faults.len(), slowest.0, slowest.1);
            }
        }
        done.store(true, Ordering::Relaxed);
    });
    let of = |verdict: Verdict| found[verdict as usize];
    let (models, refused, others) = (of(Verdict::Model), of(Verdict::Refused), of(Verdict::NoTokens));
    println!("{models} models, {refused} refused with a place, {others} that are no tokens of Rust");
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
}
