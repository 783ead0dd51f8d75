//! What came out of many trials.

use std::collections::BTreeMap;

/// What a part of a trial ends with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// The scene refuses the parameters.
    ParametersRefused,
    /// The scene refuses the start.
    StartRefused,
    /// There are no accelerations, and the scene says so.
    AccelerationsRefused,
    /// Accelerations that the oracle confirms, to what rounding explains.
    AccelerationsConfirmed,
    /// Accelerations with fewer digits than rounding explains, but as many as the elimination promises.
    AccelerationsLoseDigits,
    /// Accelerations that overflow, or a system that is too large for the oracle.
    AccelerationsNotCompared,
    /// The run does not begin, and says why.
    RunRefused,
    /// The run ends early and says why; what it keeps is finite.
    RunStopped,
    /// The run comes to its end on its rows, all numbers finite, energy and work fit.
    RunEnded,
    /// The same, but energy and work do not fit, which stands in its last sample.
    RunEndedUnbalanced,
}

/// Verdicts by their number, and the faults.
#[derive(Debug, Default)]
pub struct Tally {
    /// How often each verdict was given.
    pub verdicts: BTreeMap<Verdict, u64>,
    /// What must not be: the trial, and what it did.
    pub faults: Vec<String>,
}

impl Tally {
    /// Counts a verdict.
    pub fn count(&mut self, verdict: Verdict) {
        *self.verdicts.entry(verdict).or_default() += 1;
    }

    /// How often a verdict was given.
    pub fn of(&self, verdict: Verdict) -> u64 {
        self.verdicts.get(&verdict).copied().unwrap_or_default()
    }
}

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (verdict, n) in &self.verdicts {
            writeln!(f, "{n:>9} {verdict:?}")?;
        }
        writeln!(f, "{:>9} faults", self.faults.len())
    }
}
