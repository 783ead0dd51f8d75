//! Work that Ctrl-C ends.

use crate::error::{StoppedError, wrong};
use ezy_core::model::Scene;
use ezy_core::simulate::{Run, SetupError, Simulation};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

/// How long work may go on before Python is asked for signals: nobody notices it, and it costs nothing.
pub(crate) const BETWEEN_SIGNALS: Duration = Duration::from_millis(50);

/// A run that Ctrl-C ends, by `flag`.
pub(crate) fn simulate<'f>(
    py: Python<'_>,
    simulation: Simulation<'f, Arc<dyn Scene>>,
    flag: &'f AtomicBool,
) -> PyResult<Run> {
    match watched(py, flag, || simulation.run())? {
        Err(error @ (SetupError::Motion(_) | SetupError::Record(_))) => Err(StoppedError::new_err(error.to_string())),
        run => run.map_err(wrong),
    }
}

/// Does `work` on a thread of its own, without Python, while this one asks for signals. One of them sets `flag`, at which the work has to end,
/// and is raised then.
pub(crate) fn watched<T: Send>(py: Python<'_>, flag: &AtomicBool, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let (done, waiting) = channel();
    let waiting = Mutex::new(waiting);
    let (found, signal) = thread::scope(|scope| {
        let working = scope.spawn(move || {
            let found = work();
            let _ = done.send(());
            found
        });
        let signal = wait(py, &waiting).err();
        if signal.is_some() {
            flag.store(true, Ordering::Relaxed);
        }
        (py.detach(|| working.join()), signal)
    });
    match (signal, found) {
        (Some(signal), _) => Err(signal),
        (None, found) => found.map_err(|_| fault()),
    }
}

/// The same of work that nothing can end: after a signal it goes on, and what it finds is dropped.
pub(crate) fn left_to_itself<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> T + Send + 'static,
) -> PyResult<T> {
    let (done, waiting) = channel();
    thread::spawn(move || {
        let _ = done.send(work());
    });
    wait(py, &Mutex::new(waiting))?.ok_or_else(fault)
}

fn fault() -> PyErr {
    PyRuntimeError::new_err("the work ended by a fault of EZY: please report it")
}

/// What is sent, or nothing where the sender has gone.
///
/// # Errors
/// The signal that came before.
fn wait<T: Send>(py: Python<'_>, waiting: &Mutex<Receiver<T>>) -> PyResult<Option<T>> {
    loop {
        let found = py.detach(|| {
            let Ok(waiting) = waiting.lock() else { return Err(RecvTimeoutError::Disconnected) };
            waiting.recv_timeout(BETWEEN_SIGNALS)
        });
        match found {
            Ok(found) => return Ok(Some(found)),
            Err(RecvTimeoutError::Disconnected) => return Ok(None),
            Err(RecvTimeoutError::Timeout) => py.check_signals()?,
        }
    }
}
