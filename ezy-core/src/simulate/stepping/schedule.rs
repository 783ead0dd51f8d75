//! The times at which steps of a run end.

use crate::integrate::Clock;

/// The steps of a run: those of a clock, or one to the end, before which a method that chooses its steps may stop.
pub(in crate::simulate) struct Schedule {
    /// None when the method chooses its steps.
    clock: Option<Clock>,
    /// End of the run, s.
    pub end: f64,
    /// Steps that ended at their times.
    n_on_time: u64,
    /// Whether the last step ended before its time: the next one goes on to it.
    pub is_cut: bool,
}

impl Schedule {
    pub(in crate::simulate) fn new(clock: Option<Clock>, end: f64) -> Self {
        Self { clock, end, n_on_time: 0, is_cut: false }
    }

    /// Length and end of the next step, which starts at `t`, s.
    pub(in crate::simulate) fn next(&self, t: f64) -> (f64, f64) {
        match &self.clock {
            Some(clock) if !self.is_cut => (clock.step(self.n_on_time), clock.time(self.n_on_time + 1)),
            Some(clock) => (clock.time(self.n_on_time + 1) - t, clock.time(self.n_on_time + 1)),
            None => (self.end - t, self.end),
        }
    }

    /// Counts a step that was to end at `t_next` and ended at `t`, s.
    pub(in crate::simulate) fn count(&mut self, t: f64, t_next: f64) {
        self.is_cut = t < t_next;
        self.n_on_time += u64::from(!self.is_cut);
    }
}
