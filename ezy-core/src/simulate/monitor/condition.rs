//! The condition number of the equations of motion over a run.

use crate::dynamics::{State, System};
use crate::linalg::{ConditionEstimator, Conditioning};
use crate::model::{Name, Scene, SceneInfo};
use crate::simulate::tolerances::monitors::{FEWEST_BETWEEN, LARGEST_WATCHED};

/// Condition of the equations of motion where a run looked at it: at its start and end, and on the way now and then, so that
/// looks take less than a hundredth of the time of steps. A singular position that is crossed in between is not seen.
#[derive(Debug, Clone, PartialEq)]
pub struct ConditionPeak {
    /// Condition number at the start, estimated from below, of the matrix scaled by its entries.
    pub at_start: f64,
    /// The largest one.
    pub largest: f64,
    /// Smallest pivot of the rows at that state, scaled to one.
    pub pivot: f64,
    /// Name of the row whose pivot it is; none where constraints depend on each other.
    pub unknown: Option<Name>,
    /// Time of that state, s.
    pub t: f64,
}

impl ConditionPeak {
    /// Becomes what was found. The name is written over the last one, since a step does not allocate.
    fn see(&mut self, info: &SceneInfo, found: Conditioning, t: f64) {
        (self.largest, self.pivot, self.t) = (found.condition, found.pivot, t);
        match found.row {
            Some(row) => self.unknown.get_or_insert_default().clone_from(&info.rows[row].name),
            None => self.unknown = None,
        }
    }
}

/// The estimates of a run under way.
pub(super) struct ConditionWatch {
    estimator: ConditionEstimator,
    n_between: u64,
    pub peak: ConditionPeak,
}

impl ConditionWatch {
    /// None for a scene without rows or one that is too large.
    pub(super) fn new<S: Scene + ?Sized>(system: &mut System<'_, S>, start: &State) -> Option<Box<Self>> {
        let info = system.info();
        let n = info.n_unknowns();
        if info.n_rows() == 0 || n > LARGEST_WATCHED {
            return None;
        }
        let mut estimator = system.condition_estimator();
        let found = system.conditioning(start.t, &start.q, &mut estimator);
        let at_start = found.condition;
        let mut peak = ConditionPeak { at_start, largest: at_start, pivot: found.pivot, unknown: None, t: start.t };
        peak.see(system.info(), found, start.t);
        Some(Box::new(Self { estimator, n_between: FEWEST_BETWEEN.max((n * n) as u64), peak }))
    }

    /// Estimates after step `n_steps` when it is due, or at the end.
    pub(super) fn look<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        state: &State,
        n_steps: u64,
        last: bool,
    ) {
        if !last && !n_steps.is_multiple_of(self.n_between) {
            return;
        }
        let found = system.conditioning(state.t, &state.q, &mut self.estimator);
        if found.condition > self.peak.largest {
            self.peak.see(system.info(), found, state.t);
        }
    }
}
