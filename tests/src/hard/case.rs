//! A case, and what was found when it was run.

/// A model with its bounds, and the program that measures what is reached.
pub struct Case {
    /// Name in the reference.
    pub name: String,
    /// What makes it hard.
    pub why: &'static str,
    /// Whether a build without optimisation runs it in a second or two.
    pub is_quick: bool,
    /// Runs it; with `true` the naive program, too.
    pub examine: Box<dyn Fn(bool) -> Findings>,
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
}

impl Check {
    /// A quantity that the naive program has nothing to say about.
    pub fn new(what: impl Into<String>, bound: f64, reached: f64) -> Self {
        Self { what: what.into(), bound, reached, naive: None, is_time: false }
    }

    /// A quantity that is made of times.
    pub fn of_times(what: impl Into<String>, bound: f64, reached: f64) -> Self {
        Self { is_time: true, ..Self::new(what, bound, reached) }
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
