//! Runs that Ctrl-C ends.

use crate::error::{StoppedError, wrong};
use ezy_core::model::Scene;
use ezy_core::simulate::{Run, SetupError, Simulation};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How long a run may go on before Python is asked for signals: nobody notices it, and it costs nothing.
const BETWEEN_SIGNALS: Duration = Duration::from_millis(50);

/// Runs on a thread of its own, without Python, while this one asks for signals: Ctrl-C ends the run.
pub(crate) fn simulate<'f>(
    py: Python<'_>,
    simulation: Simulation<'f, Arc<dyn Scene>>,
    flag: &'f AtomicBool,
) -> PyResult<Run> {
    let (is_done, done) = (Mutex::new(false), Condvar::new());
    let (run, signal) = std::thread::scope(|scope| {
        let running = scope.spawn(|| {
            let run = simulation.run();
            *lock(&is_done) = true;
            done.notify_all();
            run
        });
        let mut signal = None;
        while !py.detach(|| *wait(&done, lock(&is_done))) {
            if let Err(error) = py.check_signals() {
                signal = Some(error);
                flag.store(true, Ordering::Relaxed);
                break;
            }
        }
        (py.detach(|| running.join()), signal)
    });
    let run = run.map_err(|_| PyRuntimeError::new_err("the run ended by a fault of EZY: please report it"))?;
    match (signal, run) {
        (Some(error), _) => Err(error),
        (None, Err(error @ (SetupError::Motion(_) | SetupError::Record(_)))) => {
            Err(StoppedError::new_err(error.to_string()))
        }
        (None, run) => run.map_err(wrong),
    }
}

fn lock(of: &Mutex<bool>) -> MutexGuard<'_, bool> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Waits for the end, or for the time between signals.
fn wait<'m>(done: &Condvar, is_done: MutexGuard<'m, bool>) -> MutexGuard<'m, bool> {
    let waited = done.wait_timeout_while(is_done, BETWEEN_SIGNALS, |is_done| !*is_done);
    waited.map_or_else(|poisoned| poisoned.into_inner().0, |(is_done, _)| is_done)
}
