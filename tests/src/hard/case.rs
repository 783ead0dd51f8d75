//! A case, and what was found when it was run.

use ezy_core::prelude::{Method, MethodKind};

/// A model with its bounds, and the program that measures what is reached.
pub struct Case {
    /// Name in the reference.
    pub name: String,
    /// What makes it hard.
    pub why: &'static str,
    /// At which its reference states the bounds.
    pub tolerance: f64,
    /// What runs it.
    pub by: By,
    /// How long its runs take.
    pub pace: Pace,
    /// Runs it.
    pub examine: Box<dyn Fn(How) -> Findings>,
}

/// What runs a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum By {
    /// Every method.
    Methods,
    /// The method of this name alone: the others take hours.
    Only(&'static str),
    /// None: it is no motion.
    Nothing,
}

/// How long the runs of a case take.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Pace {
    /// A second or two without optimisation: the tests run it.
    Quick,
    /// Seconds: `--check` runs it.
    Slow,
    /// Minutes: `--check --long` runs it.
    Long,
}

/// A method of a tolerance.
pub type WithTolerance = fn(f64) -> Method;

/// The methods, by name. RK4 takes the steps that [`How::by`] makes of a tolerance.
pub const METHODS: [(&str, Option<WithTolerance>); 4] =
    [("rk4", None), ("dop853", Some(Method::dop853)), ("taylor", Some(Method::taylor)), ("radau", Some(Method::radau))];

/// By what a case is run.
#[derive(Debug, Clone, Copy)]
pub struct How {
    /// Of a tolerance; none for RK4, whose step follows from it.
    pub method: Option<WithTolerance>,
    /// Relative and absolute.
    pub tolerance: f64,
    /// What for.
    pub purpose: Purpose,
}

/// What a run is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// One of many: steps are limited to some seconds.
    Matrix,
    /// The page: limited to some minutes.
    Page,
    /// The same with the naive program beside it.
    PageWithNaive,
}

/// What runs a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Program {
    /// Of EZY.
    pub method: Method,
    /// Step of the naive program, s, where it runs.
    pub naive_step_s: Option<f64>,
    /// Steps times unknowns that the run may take.
    pub most: Option<u64>,
}

/// At this tolerance RK4 takes the step of the naive program; at others in proportion to the fourth root.
pub const TOLERANCE_OF_STEP: f64 = 1e-9;

/// Steps times unknowns of some seconds, and of a stage that is solved for.
const MOST: u64 = 2_000_000;
const MOST_IMPLICIT: u64 = 400_000;
/// The page allows this many times as many to explicit methods.
const OF_PAGE: u64 = 10;

impl How {
    /// The naive program takes steps of `step_s`.
    pub fn by(self, step_s: f64) -> Program {
        let method = match self.method {
            Some(method) => method(self.tolerance),
            // two digits, as one would give it
            None => {
                let step_s = step_s * (self.tolerance / TOLERANCE_OF_STEP).powf(0.25);
                Method::rk4(format!("{step_s:.1e}").parse().expect("a number"))
            }
        };
        let most = match (self.purpose, method.kind()) {
            (_, MethodKind::Radau) => Some(MOST_IMPLICIT),
            (Purpose::Matrix, _) => Some(MOST),
            // as many as the naive program
            (_, MethodKind::Rk4) => None,
            _ => Some(OF_PAGE * MOST),
        };
        let naive_step_s = (self.purpose == Purpose::PageWithNaive).then_some(step_s);
        Program { method, naive_step_s, most }
    }

    /// Whether it is one cell of the matrix of methods.
    pub fn is_of_matrix(self) -> bool {
        self.purpose == Purpose::Matrix
    }
}

impl Program {
    /// The same without the naive program.
    pub fn without_naive(self) -> Self {
        Self { naive_step_s: None, ..self }
    }
}

impl Case {
    /// What each method of [`METHODS`] finds at the tolerance of the reference, RK4 by the steps of the naive program, which runs
    /// beside it when asked; of a case without methods one.
    pub fn at_its_tolerance(&self, with_naive: bool) -> Vec<Findings> {
        let page = |i: usize| if i == 0 && with_naive { Purpose::PageWithNaive } else { Purpose::Page };
        let examine = |(i, &(name, method)): (usize, &(&str, Option<WithTolerance>))| match self.by {
            By::Only(only) if only != name => Findings::default(),
            _ => (self.examine)(How {
                method,
                tolerance: method.map_or(TOLERANCE_OF_STEP, |_| self.tolerance),
                purpose: page(i),
            }),
        };
        let n = if self.by == By::Nothing { 1 } else { METHODS.len() };
        METHODS.iter().enumerate().take(n).map(examine).collect()
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

/// What was found in a case by one method.
#[derive(Debug, Clone, Default)]
pub struct Findings {
    /// Each quantity with its bound.
    pub checks: Vec<Check>,
    /// Steps that it took.
    pub steps: u64,
    /// How its run ended; none where no method ran.
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
