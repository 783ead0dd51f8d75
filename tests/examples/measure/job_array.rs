//! A sweep of a billion runs as a job array on a hundred nodes that fail: hours, and what failures cost. Simulated event by event.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

const N_NODES: usize = 100;
const CORES_OF_A_NODE: f64 = 64.0;
const N_CASES: f64 = 1e9;
/// Time of a core for a run, s: the EzyRoller over a minute, and a scene that takes long.
const RUNS_S: [f64; 2] = [1.5e-3, 0.1];
const N_TASKS: usize = 1000;
/// From the failure of a node until its task is queued again, s (`SlurmdTimeout`).
const NOTICED_S: f64 = 300.0;
/// From the failure of a node until it works again, s.
const REPAIRED_S: f64 = 3600.0;
/// From the start of a task to its first run: the program starts, parts are looked at, s.
const STARTED_S: f64 = 5.0;

/// What a task finds when it goes on.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Kept {
    /// Every row but those under way: what `ezy sweep` keeps.
    Rows,
    /// Whole parts, of so many cases.
    Parts(f64),
    /// Nothing: results are written when the task ends.
    Nothing,
}

/// What became of an array.
#[derive(Debug)]
struct Done {
    hours: f64,
    n_failures: usize,
    /// Cases that were computed, over those that were asked for.
    computed: f64,
}

/// SplitMix64 (Steele, Lea, Flood, OOPSLA 2014), as a number above 0 and up to 1.
fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64 + f64::EPSILON
}

/// A time that orders events.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Time(f64);

impl Eq for Time {}

impl PartialOrd for Time {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Time {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

/// What happens at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Event {
    NodeIsFree(usize),
    TaskIsQueued(usize),
}

/// An array of runs of `run_s` whose nodes work `between_s` on the average before they fail.
fn array(run_s: f64, between_s: f64, kept: Kept, seed: u64) -> Done {
    let mut state = seed;
    let of_a_task = N_CASES / N_TASKS as f64;
    let speed = CORES_OF_A_NODE / run_s;
    let mut missing = vec![of_a_task; N_TASKS];
    let mut waiting: Vec<usize> = (0..N_TASKS).rev().collect();
    let mut events: BinaryHeap<Reverse<(Time, Event)>> =
        (0..N_NODES).map(|node| Reverse((Time(0.0), Event::NodeIsFree(node)))).collect();
    let mut idle = Vec::new();
    let (mut end_s, mut n_failures, mut computed) = (0.0_f64, 0, 0.0);
    while let Some(Reverse((Time(now), event))) = events.pop() {
        match event {
            Event::NodeIsFree(node) => idle.push(node),
            Event::TaskIsQueued(task) => waiting.push(task),
        }
        while let (Some(&node), Some(&task)) = (idle.last(), waiting.last()) {
            idle.pop();
            waiting.pop();
            let needed_s = STARTED_S + missing[task] / speed;
            // failures have no memory
            let fails_s = -between_s * random(&mut state).ln();
            if fails_s >= needed_s {
                computed += missing[task];
                missing[task] = 0.0;
                end_s = end_s.max(now + needed_s);
                events.push(Reverse((Time(now + needed_s), Event::NodeIsFree(node))));
                continue;
            }
            n_failures += 1;
            let done = (fails_s - STARTED_S).max(0.0) * speed;
            computed += done;
            missing[task] -= match kept {
                // one run on each core is under way
                Kept::Rows => (done - CORES_OF_A_NODE).max(0.0).floor(),
                Kept::Parts(n) => (done / n).floor() * n,
                Kept::Nothing => 0.0,
            };
            events.push(Reverse((Time(now + fails_s + NOTICED_S), Event::TaskIsQueued(task))));
            events.push(Reverse((Time(now + fails_s + REPAIRED_S), Event::NodeIsFree(node))));
        }
    }
    assert!(missing.iter().all(|left| *left == 0.0), "a task did not end");
    assert!(computed >= N_CASES, "cases are missing");
    Done { hours: end_s / 3600.0, n_failures, computed: computed / N_CASES }
}

pub(crate) fn run() {
    for run_s in RUNS_S {
        let ideal = N_CASES * run_s / CORES_OF_A_NODE / N_NODES as f64 / 3600.0;
        println!("Runs of {run_s} s; without failures and starts: {ideal:.2} h\n");
        println!("| a node works on the average | failures | rows kept | parts of 100,000 kept | nothing kept |");
        println!("|---|---|---|---|---|");
        let lives = [("for ever", 1e18), ("30 days", 30.0 * 86400.0), ("a day", 86400.0), ("an hour", 3600.0)];
        for (name, between_s) in lives {
            let done = [Kept::Rows, Kept::Parts(1e5), Kept::Nothing].map(|kept| array(run_s, between_s, kept, 1));
            let told =
                done.iter().map(|done| format!("{:.2} h, {:.2} % twice", done.hours, 100.0 * (done.computed - 1.0)));
            println!("| {name} | {} | {} |", done[0].n_failures, told.collect::<Vec<_>>().join(" | "));
        }
        println!();
    }
}
