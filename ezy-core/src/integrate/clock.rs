//! The times of a run with a fixed step.

/// `t_n = t_0 + n h`, computed from n each time: adding h up sixty thousand times would cost 5e-11 s. The last
/// step is shortened to land on the end, and the last time is the end to the last bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    start: f64,
    end: f64,
    step: f64,
    n_steps: u64,
}

/// A remainder of the run below this fraction of a step is rounding of `n h`, not a step.
const REST: f64 = 1e-9;

impl Clock {
    /// From `start` to `end ≥ start`, s, with `step > 0`.
    pub fn new(start: f64, end: f64, step: f64) -> Self {
        let n_steps = ((end - start) / step - REST).ceil().max(0.0) as u64;
        Self { start, end, step, n_steps }
    }

    /// Number of steps.
    pub fn n_steps(&self) -> u64 {
        self.n_steps
    }

    /// `t_n`, s.
    pub fn time(&self, n: u64) -> f64 {
        if n >= self.n_steps { self.end } else { self.start + n as f64 * self.step }
    }

    /// Length of the step that starts at `t_n`, s.
    pub fn step(&self, n: u64) -> f64 {
        if n + 1 < self.n_steps { self.step } else { self.end - self.time(n) }
    }
}
