//! The caller of a run, while it is under way.

use crate::simulate::tolerances::samples::N_PROGRESS;
use std::sync::atomic::{AtomicBool, Ordering};

/// Who may end a run, and is told how far it is.
#[derive(Default)]
pub(in crate::simulate) struct Caller<'s> {
    /// One that is true ends the run.
    pub interrupts: Vec<&'s AtomicBool>,
    pub on_progress: Option<Box<dyn FnMut(f64) + Send + 's>>,
    /// Hundredths of the run that were reported.
    told: f64,
}

impl<'s> Caller<'s> {
    pub(in crate::simulate) fn interrupted_by(interrupts: Vec<&'s AtomicBool>) -> Self {
        Self { interrupts, ..Self::default() }
    }

    /// Whether the run is to end.
    pub(in crate::simulate) fn interrupts(&self) -> bool {
        self.interrupts.iter().any(|flag| flag.load(Ordering::Relaxed))
    }

    /// Tells that this part of the run is done.
    pub(in crate::simulate) fn tell(&mut self, done: f64) {
        if let Some(progress) = &mut self.on_progress
            && (done * N_PROGRESS >= self.told + 1.0 || done >= 1.0)
        {
            self.told = (done * N_PROGRESS).floor();
            progress(done);
        }
    }
}
