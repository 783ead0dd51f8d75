//! A case, and what was found when it was run.

use ezy_core::prelude::Method;

/// A model with its bounds, and the program that measures what is reached.
pub struct Case {
    /// Name in the reference.
    pub name: String,
    /// What makes it hard.
    pub why: &'static str,
    /// Whether a build without optimisation runs it in a second or two.
    pub is_quick: bool,
    /// Runs it.
    pub examine: Box<dyn Fn(How) -> Findings>,
}

/// By what a case is run.
#[derive(Debug, Clone, Copy)]
pub enum How {
    /// By its own method, and by the naive program.
    Compared,
    /// By its own method.
    Alone,
    /// By this one.
    By(Setting),
}

/// A method of a tolerance.
pub type WithTolerance = fn(f64) -> Method;

/// A method with the tolerance that it is to keep.
#[derive(Debug, Clone, Copy)]
pub struct Setting {
    /// Of a tolerance; none for RK4, whose step follows from it.
    pub method: Option<WithTolerance>,
    /// Relative and absolute.
    pub tolerance: f64,
}

/// What runs a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Program {
    /// Of EZY.
    pub method: Method,
    /// Step of the naive program, s, where it runs.
    pub naive_step_s: Option<f64>,
    /// Whether the method is not the case's own: then its steps are limited.
    is_given: bool,
}

/// At this tolerance RK4 takes the step of the naive program; at others in proportion to the fourth root.
const TOLERANCE_OF_STEP: f64 = 1e-9;

impl How {
    /// By the case's own method, or by the given one; the naive program takes steps of `step_s`.
    pub fn by(self, own: Method, step_s: f64) -> Program {
        match self {
            Self::Compared => Program { method: own, naive_step_s: Some(step_s), is_given: false },
            Self::Alone => Program { method: own, naive_step_s: None, is_given: false },
            Self::By(Setting { method, tolerance }) => {
                let method = match method {
                    Some(method) => method(tolerance),
                    // two digits, as one would give it
                    None => {
                        let step_s = step_s * (tolerance / TOLERANCE_OF_STEP).powf(0.25);
                        Method::rk4(format!("{step_s:.1e}").parse().expect("a number"))
                    }
                };
                Program { method, naive_step_s: None, is_given: true }
            }
        }
    }
}

impl Program {
    /// The same without the naive program.
    pub fn without_naive(self) -> Self {
        Self { naive_step_s: None, ..self }
    }

    /// Whether the method is not the case's own.
    pub fn is_given(self) -> bool {
        self.is_given
    }
}

/// How a run of EZY ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// At its time.
    Reached,
    /// At the limit of steps.
    Cut,
    /// Before, or as not to be trusted: why, in a word.
    Refused(&'static str),
}

/// What was found in a case.
#[derive(Debug, Clone, Default)]
pub struct Findings {
    /// Each quantity with its bound.
    pub checks: Vec<Check>,
    /// How EZY ran it: method, setting, steps.
    pub by: String,
    /// Steps that it took.
    pub steps: u64,
    /// How its run ended; none where no method runs.
    pub ended: Option<Ended>,
    /// Why EZY did not come to the end.
    pub stopped: Option<String>,
    /// How the naive program ran it, when it did.
    pub naive_by: Option<String>,
}

/// A quantity that must not exceed its bound.
#[derive(Debug, Clone)]
pub struct Check {
    /// The quantity, with its unit.
    pub what: String,
    /// What it may be.
    pub bound: f64,
    /// What EZY reached; NaN when it did not get there.
    pub reached: f64,
    /// What the naive program reached; NaN when it did not get there, `None` when it does not apply.
    pub naive: Option<f64>,
    /// Whether it is made of times: then the machine decides, and nothing is asserted.
    pub is_time: bool,
    /// Whether its bound holds by every method, whatever the tolerance: gaps, what is reported, what is refused.
    pub is_for_all: bool,
}

impl Check {
    /// A quantity that the naive program has nothing to say about.
    pub fn new(what: impl Into<String>, bound: f64, reached: f64) -> Self {
        Self { what: what.into(), bound, reached, naive: None, is_time: false, is_for_all: false }
    }

    /// A quantity that is made of times.
    pub fn of_times(what: impl Into<String>, bound: f64, reached: f64) -> Self {
        Self { is_time: true, ..Self::new(what, bound, reached) }
    }

    /// A quantity whose bound holds by every method.
    pub fn for_all(what: impl Into<String>, bound: f64, reached: f64) -> Self {
        Self { is_for_all: true, ..Self::new(what, bound, reached) }
    }

    /// Whether the bound is kept.
    pub fn is_met(&self) -> bool {
        self.reached <= self.bound
    }
}

/// Cases of one kind, with a table of their own on the page.
pub struct Family {
    /// Name of the table in the page.
    pub name: &'static str,
    /// Its cases.
    pub cases: Vec<Case>,
}
