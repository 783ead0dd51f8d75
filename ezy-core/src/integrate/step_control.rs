//! The lengths of steps: fixed, or from the error of the last one.

/// Steps are aimed at this part of the largest allowed error, so that few are rejected.
const SAFETY: f64 = 0.9;
/// A step changes at most by these factors.
const SHRINK: f64 = 1.0 / 3.0;
const GROW: f64 = 6.0;
/// Exponent of the integral part of the controller, which damps oscillations of the step length.
const BETA: f64 = 0.04;
/// Smallest error that is used for prediction.
const LEAST_ERROR: f64 = 1e-4;

/// Tolerated errors of a step: `absolute + relative · |y|` for each number of the state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Relative tolerance.
    pub relative: f64,
    /// Absolute tolerance, in m, rad, m/s, rad/s alike.
    pub absolute: f64,
}

impl Tolerance {
    /// The smallest relative tolerance: below it an error estimate is rounding.
    pub const SMALLEST_RELATIVE: f64 = 1e-15;
}

/// A proportional-integral controller for a method whose error goes with the power `order` of the step.
///
/// # Source
/// Gustafsson, ACM Trans. Math. Software 17 (1991); Hairer, Wanner, Solving Ordinary Differential Equations II (1996), IV.2.
#[derive(Debug, Clone)]
pub(crate) struct StepControl {
    order: f64,
    last_error: f64,
    just_rejected: bool,
}

impl StepControl {
    /// For a method of which an error estimate goes with `h^order`.
    pub(crate) fn new(order: i32) -> Self {
        Self { order: f64::from(order), last_error: LEAST_ERROR, just_rejected: false }
    }

    /// Factor for the step after one with this error, at most 1.
    pub(crate) fn accept(&mut self, error: f64) -> f64 {
        let proportional = error.powf(1.0 / self.order - 0.2 * BETA);
        let factor = (SAFETY * self.last_error.powf(BETA) / proportional).clamp(SHRINK, GROW);
        self.last_error = error.max(LEAST_ERROR);
        let factor = if self.just_rejected { factor.min(1.0) } else { factor };
        self.just_rejected = false;
        factor
    }

    /// Factor for the next try after a step with this error, above 1 or not a number.
    pub(crate) fn reject(&mut self, error: f64) -> f64 {
        self.just_rejected = true;
        if error.is_finite() { (SAFETY / error.powf(1.0 / self.order)).max(SHRINK) } else { SHRINK }
    }
}

/// `t_n = t_0 + n h`, computed from n each time: adding h up sixty thousand times would cost 5e-11 s. The last
/// step is shortened to land on the end, and the last time is the end to the last bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Clock {
    start: f64,
    end: f64,
    step: f64,
    n_steps: u64,
}

/// A remainder of the run below this fraction of a step is rounding of `n h`, not a step.
const REST: f64 = 1e-9;

impl Clock {
    /// From `start` to `end ≥ start`, s, with `step > 0`.
    pub(crate) fn new(start: f64, end: f64, step: f64) -> Self {
        let n_steps = ((end - start) / step - REST).ceil().max(0.0) as u64;
        Self { start, end, step, n_steps }
    }

    /// Number of steps.
    pub(crate) fn n_steps(&self) -> u64 {
        self.n_steps
    }

    /// `t_n`, s.
    pub(crate) fn time(&self, n: u64) -> f64 {
        if n >= self.n_steps { self.end } else { self.start + n as f64 * self.step }
    }

    /// Length of the step that starts at `t_n`, s.
    pub(crate) fn step(&self, n: u64) -> f64 {
        if n + 1 < self.n_steps { self.step } else { self.end - self.time(n) }
    }
}
