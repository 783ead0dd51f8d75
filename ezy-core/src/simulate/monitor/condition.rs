//! The condition number of the equations of motion over a run.

use crate::dynamics::{State, System};
use crate::linalg::{ConditionEstimator, Conditioning};
use crate::model::{Name, SceneInfo, SceneRef};
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
    /// What rounding makes of accelerations or multipliers at most, relative to one more than each: the condition times the rounding of a number, or the
    /// difference of a multiplier from a solution to the last digits. A smaller tolerance is not kept. Not looked at where constraints depend on each other.
    pub rounding: f64,
}

/// The estimates of a run under way.
pub(super) struct ConditionWatch {
    estimator: ConditionEstimator,
    /// Accelerations and multipliers.
    found: [Vec<f64>; 2],
    /// Rows at the start.
    n_rows: usize,
    n_between: u64,
    at_start: f64,
    largest: Conditioning,
    /// Time of the largest, s.
    t: f64,
    rounding: f64,
}

impl ConditionWatch {
    /// None for a scene without rows or one that is too large.
    pub(super) fn new<P: SceneRef>(system: &mut System<P>, start: &State) -> Option<Box<Self>> {
        let info = system.info();
        let (n, n_rows) = (info.n_unknowns(), system.active().n_on()[1]);
        if n_rows == 0 || n > LARGEST_WATCHED {
            return None;
        }
        let mut estimator = system.diagnosis().condition_estimator();
        let largest = system.diagnosis().conditioning(start.t, &start.q, &mut estimator);
        let (at_start, t) = (largest.condition, start.t);
        let found = [start.v.len(), system.info().n_rows()].map(|n| vec![0.0; n]);
        let n_between = FEWEST_BETWEEN.max((n * n) as u64);
        let mut watch = Box::new(Self { estimator, found, n_rows, n_between, at_start, largest, t, rounding: 0.0 });
        watch.see_rounding(system, start, at_start);
        Some(watch)
    }

    fn see_rounding<P: SceneRef>(&mut self, system: &mut System<P>, state: &State, condition: f64) {
        if !condition.is_finite() {
            return;
        }
        let Self { estimator, found: [a, lambda], rounding, .. } = self;
        let State { t, q, v, z, .. } = state;
        system.place_states(z);
        let of_multipliers = system.diagnosis().rounding_of_multipliers(*t, q, v, (a, lambda), estimator);
        *rounding = rounding.max(of_multipliers).max(condition * f64::EPSILON);
    }

    /// Estimates after step `n_steps` when it is due, or at the end; only with the constraints of the start.
    pub(super) fn look<P: SceneRef>(&mut self, system: &mut System<P>, state: &State, n_steps: u64, last: bool) {
        if !last && !n_steps.is_multiple_of(self.n_between) || system.active().n_on()[1] != self.n_rows {
            return;
        }
        let found = system.diagnosis().conditioning(state.t, &state.q, &mut self.estimator);
        let condition = found.condition;
        if condition > self.largest.condition {
            (self.largest, self.t) = (found, state.t);
        }
        self.see_rounding(system, state, condition);
    }

    pub(super) fn peak(&self, info: &SceneInfo) -> ConditionPeak {
        let Self { at_start, largest: Conditioning { condition, pivot, row }, t, rounding, .. } = *self;
        let unknown = row.map(|row| info.rows.item(row).name);
        ConditionPeak { at_start, largest: condition, pivot, unknown, t, rounding }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::linalg::Backend;

    crate::model! {
        /// A puck in a guide that nearly follows a wall: slopes (1, 0, 0) and (1, 0, w φ).
        pub model Guided {
            param w: m = 1;
            body puck { mass: 1, inertia: 1 }
            constraint wall: puck.x = 0;
            constraint guide: puck.x + w * puck.phi^2 / 2 = 0;
            start here { puck at (0, 0) angle 0; at rest; }
            scene turns { start here; until 1 s; }
        }
    }

    fn at(t: f64, phi: f64) -> State {
        let mut state = State::zero(3, 0);
        (state.t, state.q[2]) = (t, phi);
        state
    }

    /// One step in 4096 is looked at, and the last one; the worst condition so far is kept, with its time and row.
    #[test]
    fn invariant_worst_condition_of_the_steps_that_are_looked_at() {
        let scene = guided::Turns::default();
        let mut system = system_of(&scene, Backend::Dense).unwrap();
        let mut watch = ConditionWatch::new(&mut system, &at(0.0, 0.5)).unwrap();
        let at_start = watch.peak(system.info());
        assert!(
            at_start.largest == at_start.at_start && at_start.t == 0.0 && at_start.unknown.is_some(),
            "{at_start:?}"
        );
        for (t, phi, n_steps, last, peak_at) in [
            (1.0, 0.1, 4095, false, 0.0),
            (2.0, 0.1, 4096, false, 2.0),
            (3.0, 0.2, 8192, false, 2.0),
            (4.0, 0.05, 8193, false, 2.0),
            (5.0, 0.05, 8194, true, 5.0),
        ] {
            watch.look(&mut system, &at(t, phi), n_steps, last);
            assert_eq!(watch.t, peak_at, "at {t}");
            assert_eq!(watch.at_start, at_start.at_start);
        }
        // it goes with the square of the angle: 100 times as large, but for a factor of three of the estimate
        let grown = watch.largest.condition / at_start.largest;
        assert!((30.0..300.0).contains(&grown) && watch.peak(system.info()).pivot < 0.2 * at_start.pivot, "{grown}");
    }

    crate::model! {
        /// Pucks that two rows each hold: five equations a puck.
        pub model Row {
            count n = 3;
            body puck[n] { mass: 1, inertia: 1 }
            for i in 0..n {
                constraint x[i]: puck[i].x = 0;
                constraint y[i]: puck[i].y = 0;
            }
            start here { for i in 0..n { puck[i] at (0, 0) angle 0; } at rest; }
            scene rests { start here; until 1 s; }
        }
    }

    #[test]
    fn regress_scenes_of_up_to_two_hundred_equations_are_watched() {
        for (n, is_watched) in [(40, true), (41, false)] {
            let scene = row::Rests { n };
            let mut system = system_of(&scene, Backend::Auto).unwrap();
            assert_eq!(ConditionWatch::new(&mut system, &State::zero(3 * n, 0)).is_some(), is_watched, "{n}");
        }
    }
}
