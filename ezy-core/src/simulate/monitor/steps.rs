//! Number, lengths and pace of the steps of a run.

use super::{ExceededLimit, Limits};
use crate::simulate::tolerances::monitors::ATTEMPTS_OF_A_PACE;

/// The steps so far.
pub(super) struct StepWatch {
    pub n: u64,
    last_s: f64,
    shortest_s: f64,
    longest_s: f64,
    /// Attempted steps and time, s, from which the present pace counts.
    pace_from: (u64, f64),
}

impl StepWatch {
    /// Of a run that starts at `t`, s.
    pub(super) fn new(t: f64) -> Self {
        Self { n: 0, last_s: 0.0, shortest_s: f64::INFINITY, longest_s: 0.0, pace_from: (0, t) }
    }

    /// Whether another step may be taken from `t` towards `end`, s; `n_rejected` were rejected.
    pub(super) fn admit(
        &mut self,
        limits: &Limits,
        chooses_steps: bool,
        n_rejected: u64,
        t: f64,
        end: f64,
    ) -> Result<(), ExceededLimit> {
        let limit = limits.most_steps(chooses_steps);
        let attempts = self.n + n_rejected;
        if attempts >= limit {
            return Err(ExceededLimit::Steps { limit, step_s: self.last_s });
        }
        let (since, from) = self.pace_from;
        if limits.steps.is_some() || !chooses_steps || attempts - since < ATTEMPTS_OF_A_PACE {
            return Ok(());
        }
        self.pace_from = (attempts, t);
        let pace_s = (t - from) / (attempts - since) as f64;
        let needed = (end - t) / pace_s;
        if needed <= limit as f64 { Ok(()) } else { Err(ExceededLimit::Pace { attempts, pace_s, needed, limit }) }
    }

    /// Counts a step of this length, s.
    pub(super) fn count(&mut self, length_s: f64) {
        self.n += 1;
        self.last_s = length_s;
        self.shortest_s = self.shortest_s.min(length_s);
        self.longest_s = self.longest_s.max(length_s);
    }

    /// The shortest and the longest one, s; none without a step.
    pub(super) fn range_s(&self) -> Option<[f64; 2]> {
        (self.n > 0).then_some([self.shortest_s, self.longest_s])
    }
}
