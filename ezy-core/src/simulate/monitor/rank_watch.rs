//! Where constraints of a run depended on each other: in stretches of time, and in singular positions that it crossed.

use crate::dynamics::RankLoss;
use crate::model::SceneRef;
use crate::scalar::{legible_time, rounded};
use crate::simulate::stepping::singularity_crossing::SingularityCrossed;
use crate::simulate::stepping::stepper_state::StepperState;
use crate::simulate::tolerances::monitors::MAX_INTERVALS;

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
    /// Stretches that were crossed by steps of another method, the first 16 of them.
    pub crossings: Vec<SingularityCrossed>,
    /// How many came after those.
    pub n_more_crossings: u64,
    is_open: bool,
    /// End of the last crossing, s.
    crossed_until_s: f64,
}

impl RankRecord {
    /// Registers an accepted state.
    pub(in crate::simulate) fn see<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) {
        if let Some(crossed) = stepper.singular_positions.crossed.take() {
            self.see_crossing(crossed);
        }
        let StepperState { system, now: at, .. } = stepper;
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

    fn see_crossing(&mut self, crossed: SingularityCrossed) {
        let (n_known, continues) = (self.crossings.len(), crossed.from_s == self.crossed_until_s);
        match self.crossings.last_mut() {
            Some(last) if continues && self.n_more_crossings == 0 => {
                *last = SingularityCrossed { from_s: last.from_s, ..crossed }
            }
            Some(_) if continues => {}
            _ if n_known == MAX_INTERVALS => self.n_more_crossings += 1,
            _ => self.crossings.push(crossed),
        }
        self.crossed_until_s = crossed.to_s;
    }
}

/// `constraints depended on each other from 0 s to 2 s: rank 17 of 20 (…)`, a line for each stretch and each crossing; empty where there was
/// none.
impl std::fmt::Display for RankRecord {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for RankDeficientInterval { from_s, to_s, loss } in &self.intervals {
            let [from_s, to_s] = [*from_s, *to_s].map(legible_time);
            if from_s == to_s {
                write!(f, "constraints depended on each other at t = {from_s} s: {loss}")?;
            } else {
                write!(f, "constraints depended on each other from t = {from_s} s to {to_s} s: {loss}")?;
            }
            writeln!(f)?;
        }
        if self.n_more > 0 {
            writeln!(f, "and {} times more", self.n_more)?;
        }
        for crossed in &self.crossings {
            let [from, to] = [crossed.from_s, crossed.to_s].map(|t| rounded(t, 6));
            let what = match crossed.is_beside() {
                true => "passed beside a singular position",
                false => "crossed a singular position",
            };
            writeln!(f, "{what} from t = {from} s to {to} s, in steps of dop853 with projected stages")?;
        }
        match self.n_more_crossings {
            0 => Ok(()),
            n => writeln!(f, "and {n} crossings more"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A crossing in several steps is one stretch; 16 of them are told, and how many came after.
    #[test]
    fn analytic_crossings_are_joined_and_counted() {
        let mut record = RankRecord::default();
        for i in 0..19 {
            let from = 10.0 * f64::from(i) + 1.0;
            record.see_crossing(SingularityCrossed { from_s: from, to_s: from + 1.0, nearest: 0.1 });
            record.see_crossing(SingularityCrossed { from_s: from + 1.0, to_s: from + 3.0, nearest: 0.0 });
        }
        let found: Vec<[f64; 2]> = record.crossings.iter().map(|crossing| [crossing.from_s, crossing.to_s]).collect();
        let expected: Vec<[f64; 2]> = (0..16).map(|i| 10.0 * f64::from(i) + 1.0).map(|t| [t, t + 3.0]).collect();
        assert_eq!((found, record.n_more_crossings), (expected, 3));
        assert!(record.to_string().ends_with("with projected stages\nand 3 crossings more\n"), "{record}");
    }
}
