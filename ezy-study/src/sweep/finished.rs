//! What became of a case that ran.

use std::fmt;
use std::io;
use std::path::PathBuf;

/// What is kept of a run.
#[derive(Debug)]
pub struct Finished {
    pub(super) numbers: Vec<f64>,
    pub(super) t: f64,
    pub(super) n_steps: u64,
    pub(super) outcome: Ended,
    pub(super) message: String,
    /// A file that could not be written.
    pub(super) unwritten: Option<(PathBuf, io::Error)>,
}

impl Finished {
    /// What a run is before its end.
    pub(super) fn under_way() -> Self {
        Self {
            numbers: Vec::new(),
            t: f64::NAN,
            n_steps: 0,
            outcome: Ended::Interrupted,
            message: String::new(),
            unwritten: None,
        }
    }

    /// At the end that was asked for.
    pub(super) fn at_end(numbers: Vec<f64>, t: f64, n_steps: u64) -> Self {
        Self { numbers, t, n_steps, outcome: Ended::ReachedEnd, message: String::new(), unwritten: None }
    }
}

/// How a case ended, in one word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ended {
    /// `end`: at the time that was asked for.
    ReachedEnd,
    /// `event:NAME`: at an event that ends the run.
    ReachedEvent(&'static str),
    /// `untrusted`: with fixed steps too long for the motion ([`Outcome::Untrusted`](ezy_core::simulate::Outcome::Untrusted)).
    Untrusted,
    /// `stopped`: before its end; its numbers are those of the last good state.
    Stopped,
    /// `refused`: it could not start; it has no numbers.
    Refused,
    /// It is run again when the sweep continues.
    Interrupted,
}

impl Ended {
    /// Whether the run is complete and nothing speaks against its result.
    pub const fn is_good(self) -> bool {
        matches!(self, Self::ReachedEnd | Self::ReachedEvent(_))
    }
}

impl fmt::Display for Ended {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ReachedEnd => f.write_str("end"),
            Self::ReachedEvent(name) => write!(f, "event:{name}"),
            Self::Untrusted => f.write_str("untrusted"),
            Self::Stopped => f.write_str("stopped"),
            Self::Refused => f.write_str("refused"),
            Self::Interrupted => f.write_str("interrupted"),
        }
    }
}
