//! All cores on a list of cases, with results in order.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{SyncSender, TryRecvError, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::thread;
use std::time::Duration;

/// Results that may wait for an earlier one: memory stays bounded where one case takes long.
const MOST_WAITING: usize = 1 << 16;
/// How long a worker sleeps that is so far ahead.
const PAUSE: Duration = Duration::from_millis(1);

/// Does `work` on each of `cases` by `n_threads` threads, and hands the results to `take` in the order of the cases, in this thread.
///
/// No case is begun any more once `over` is set, `work` has returned `None` or `take` has failed; both set `over`. Results behind a case
/// without one are dropped. `take` gets `None` whenever no result waits, and in the end: what it gathered until then is written.
///
/// # Errors
/// The first error of `take`.
pub(super) fn in_order<C: Send, R: Send, E>(
    cases: impl Iterator<Item = C> + Send,
    n_threads: usize,
    over: &AtomicBool,
    work: impl Fn(C) -> Option<R> + Sync,
    mut take: impl FnMut(Option<R>) -> Result<(), E>,
) -> Result<(), E> {
    let cases = Mutex::new(cases.fuse().enumerate());
    let n_taken = AtomicUsize::new(0);
    let (send, receive) = sync_channel(n_threads);
    let worker = |send: SyncSender<_>| {
        while !over.load(Ordering::Relaxed) {
            let Some((i, case)) = cases.lock().unwrap_or_else(PoisonError::into_inner).next() else { break };
            while i >= n_taken.load(Ordering::Relaxed) + MOST_WAITING && !over.load(Ordering::Relaxed) {
                thread::sleep(PAUSE);
            }
            // nobody receives after a failure
            if work(case).is_none_or(|result| send.send((i, result)).is_err()) {
                over.store(true, Ordering::Relaxed);
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..n_threads {
            let send = send.clone();
            scope.spawn(|| worker(send));
        }
        drop(send);
        let mut waiting = BTreeMap::new();
        let mut hand_over = || {
            loop {
                let received = match receive.try_recv() {
                    Err(TryRecvError::Empty) => {
                        take(None)?;
                        receive.recv().ok()
                    }
                    received => received.ok(),
                };
                let Some((i, result)) = received else { return take(None) };
                waiting.insert(i, result);
                while let Some(result) = waiting.remove(&n_taken.load(Ordering::Relaxed)) {
                    take(Some(result))?;
                    n_taken.fetch_add(1, Ordering::Relaxed);
                }
            }
        };
        let done = hand_over();
        if done.is_err() {
            over.store(true, Ordering::Relaxed);
        }
        // workers that wait to send are let go
        drop(receive);
        done
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::convert::Infallible;
    use std::time::Instant;

    /// What `take` gets of `n` cases, of which each hundredth takes long.
    fn taken(n: u64, n_threads: usize, work: impl Fn(u64) -> Option<u64> + Sync) -> Vec<u64> {
        let mut all = Vec::new();
        let slow = |i: u64| {
            if i.is_multiple_of(100) {
                thread::sleep(2 * PAUSE);
            }
            work(i)
        };
        in_order(0..n, n_threads, &AtomicBool::new(false), slow, |i| {
            all.extend(i);
            Ok::<(), Infallible>(())
        })
        .unwrap_or_else(|never| match never {});
        all
    }

    #[test]
    fn invariant_results_come_in_order_by_any_number_of_threads() {
        for n_threads in [1, 2, 3, 16] {
            assert_eq!(taken(1000, n_threads, Some), (0..1000).collect::<Vec<_>>());
            assert!(taken(0, n_threads, Some).is_empty());
        }
    }

    #[test]
    fn invariant_what_is_taken_ends_before_the_first_case_without_a_result() {
        for n_threads in [1, 2, 16] {
            let found = taken(1000, n_threads, |i| (i != 500).then_some(i));
            assert_eq!(found, (0..500).collect::<Vec<_>>());
        }
    }

    #[test]
    fn invariant_worker_far_ahead_waits_for_the_slowest() {
        let first_is_done = AtomicBool::new(false);
        let most = AtomicUsize::new(0);
        taken(2 * MOST_WAITING as u64 + 1, 2, |i| {
            if i == 0 {
                thread::sleep(Duration::from_millis(300));
                first_is_done.store(true, Ordering::Relaxed);
            } else if !first_is_done.load(Ordering::Relaxed) {
                most.fetch_max(i as usize, Ordering::Relaxed);
            }
            Some(i)
        });
        let most = most.load(Ordering::Relaxed);
        assert!(most < MOST_WAITING, "{most}");
    }

    /// What is gathered is written before the thread waits, and in the end: each case waits here until all before it are written.
    #[test]
    fn invariant_what_is_gathered_is_written_while_none_comes() {
        let n_written = AtomicUsize::new(0);
        let mut n_gathered = 0;
        let work = |i: usize| {
            let most = Instant::now() + Duration::from_secs(60);
            while n_written.load(Ordering::Relaxed) < i && Instant::now() < most {
                thread::sleep(PAUSE);
            }
            (n_written.load(Ordering::Relaxed) == i).then_some(i)
        };
        in_order(0..50, 1, &AtomicBool::new(false), work, |result| {
            n_gathered += usize::from(result.is_some());
            if result.is_none() {
                n_written.store(n_gathered, Ordering::Relaxed);
            }
            Ok::<(), Infallible>(())
        })
        .unwrap_or_else(|never| match never {});
        assert_eq!(n_written.into_inner(), 50);
    }

    #[test]
    fn invariant_error_of_the_taker_ends_the_work() {
        let n_begun = AtomicUsize::new(0);
        let over = AtomicBool::new(false);
        let work = |i: u64| {
            n_begun.fetch_add(1, Ordering::Relaxed);
            Some(i)
        };
        let done = in_order(0..1_000_000u64, 4, &over, work, |i| if i == Some(10) { Err("full") } else { Ok(()) });
        assert_eq!((done, over.into_inner()), (Err("full"), true));
        // each thread may hold one case that waits for room
        assert!(n_begun.into_inner() <= 10 + MOST_WAITING + 4);
    }
}
