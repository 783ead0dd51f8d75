//! Intervals of a run in which constraints were redundant.

use super::snapshot::Snapshot;
use super::tolerances::monitors::MAX_INTERVALS;
use crate::dynamics::{RankLoss, System};
use crate::model::Scene;

/// A stretch of a run in which constraints depended on each other: from the first state at which they did to the last.
#[derive(Debug, Clone, PartialEq)]
pub struct RankDeficientInterval {
    /// Time of the first state, s.
    pub from_s: f64,
    /// Time of the last one, s.
    pub to_s: f64,
    /// What was lost at the first.
    pub loss: RankLoss,
}

/// Rank of the rows along a run.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RankRecord {
    /// Stretches in which constraints depended on each other, the first 16 of them.
    pub intervals: Vec<RankDeficientInterval>,
    /// How many came after those.
    pub n_more: u64,
    is_open: bool,
}

impl RankRecord {
    /// Registers an accepted state.
    pub(super) fn see<S: Scene + ?Sized>(&mut self, system: &mut System<'_, S>, at: &Snapshot) {
        let was_open = std::mem::replace(&mut self.is_open, at.solved.is_rank_deficient);
        if !at.solved.is_rank_deficient {
            return;
        }
        let (t, n_known) = (at.state.t, self.intervals.len());
        match self.intervals.last_mut() {
            Some(interval) if was_open && self.n_more == 0 => interval.to_s = t,
            _ if was_open => {}
            _ if n_known == MAX_INTERVALS => self.n_more += 1,
            _ => self.intervals.push(RankDeficientInterval {
                from_s: t,
                to_s: t,
                loss: system.rank_loss(t, &at.state.q),
            }),
        }
    }
}

/// `constraints depended on each other from 0 s to 2 s: rank 17 of 20 (…)`, a line for each stretch; empty where there was none.
impl std::fmt::Display for RankRecord {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for RankDeficientInterval { from_s, to_s, loss } in &self.intervals {
            if from_s == to_s {
                write!(f, "constraints depended on each other at t = {from_s} s: {loss}")?;
            } else {
                write!(f, "constraints depended on each other from t = {from_s} s to {to_s} s: {loss}")?;
            }
            writeln!(f)?;
        }
        match self.n_more {
            0 => Ok(()),
            n => writeln!(f, "and {n} times more"),
        }
    }
}
