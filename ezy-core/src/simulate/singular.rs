//! Prediction of singular positions, in which the rank of G drops.

use super::snapshot::Snapshot;
use super::tolerances::singular::{N_AHEAD, N_SECTIONS, NEAR, VANISHES};
use crate::dynamics::{State, System};
use crate::model::Scene;
use std::ops::Range;

/// The last two states of a motion. The square root of the smallest pivot is proportional to the distance from a singular position.
pub(super) struct Approach<'m> {
    pub now: &'m Snapshot,
    pub before: &'m Snapshot,
}

/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Times about a distance, s.
pub(super) fn about(distance: f64) -> Range<f64> {
    0.0..NEAR * distance
}

impl Approach<'_> {
    /// Where a singular position may be, as times from now, s; none where it is far. `usual_s` is the length of the steps before, zero when
    /// there were none; `q` is a buffer.
    pub(super) fn ahead<S: Scene + ?Sized>(
        &self,
        system: &mut System<'_, S>,
        usual_s: f64,
        q: &mut [f64],
    ) -> Option<Range<f64>> {
        if usual_s == 0.0 {
            return None;
        }
        if self.now.solved.is_rank_deficient {
            return self.dip_ahead(system, NEAR * usual_s, q);
        }
        let (now, before) = (self.now.end.smallest_pivot, self.before.end.smallest_pivot);
        if now >= before || now <= 0.0 {
            return None;
        }
        let (now, before) = (now.sqrt(), before.sqrt());
        let distance = now * (self.now.state.t - self.before.state.t) / (before - now);
        (distance < NEAR * usual_s).then(|| about(distance))
    }

    /// Times around the smallest pivot on the predicted path, up to `far` from now, s; none where it does not fall.
    fn dip_ahead<S: Scene + ?Sized>(&self, system: &mut System<'_, S>, far: f64, q: &mut [f64]) -> Option<Range<f64>> {
        let mut lowest = (None, self.now.end.smallest_pivot);
        for i in 1..=N_AHEAD {
            let s = far * 0.5_f64.powi(N_AHEAD - i);
            self.foresee(s, q);
            let pivot = system.pivot_at(self.now.state.t + s, q);
            if pivot < lowest.1 {
                lowest = (Some(s), pivot);
            }
        }
        lowest.0.map(|s| 0.5 * s..2.0 * s)
    }

    /// Time to where the smallest pivot vanishes on the predicted path, within times from now, s; `q` is a buffer.
    pub(super) fn find<S: Scene + ?Sized>(
        &self,
        system: &mut System<'_, S>,
        q: &mut [f64],
        within: Range<f64>,
    ) -> Option<f64> {
        let mut pivot = |s: f64| {
            self.foresee(s, q);
            system.pivot_at(self.now.state.t + s, q)
        };
        let (mut from, mut to) = (within.start, within.end);
        let section = GOLDEN * (to - from);
        let (mut left, mut right) = (to - section, from + section);
        let (mut at_left, mut at_right) = (pivot(left), pivot(right));
        for _ in 0..N_SECTIONS {
            if at_left <= at_right {
                (to, right, at_right) = (right, left, at_left);
                left = to - GOLDEN * (to - from);
                at_left = pivot(left);
            } else {
                (from, left, at_left) = (left, right, at_right);
                right = from + GOLDEN * (to - from);
                at_right = pivot(right);
            }
        }
        let way = 0.5 * (left + right);
        if at_left.min(at_right) > VANISHES * self.now.end.smallest_pivot {
            return None;
        }
        // where masses are far apart, pivots fall although constraints are independent
        let State { t, q: from, .. } = &self.now.state;
        let before = system.independence(*t, from);
        self.foresee(way, q);
        let there = system.independence(t + way, q);
        let is_singular = before.zip(there).is_none_or(|(before, there)| there <= VANISHES * before);
        is_singular.then_some(way)
    }

    /// Predicted positions at `s` from now, with accelerations extrapolated linearly.
    fn foresee(&self, s: f64, q: &mut [f64]) {
        let Self { now, before } = self;
        let passed = now.state.t - before.state.t;
        let bend = if passed > 0.0 { s / (3.0 * passed) } else { 0.0 };
        for (i, q) in q.iter_mut().enumerate() {
            let a = now.a[i] + bend * (now.a[i] - before.a[i]);
            *q = now.state.q[i] + s * (now.state.v[i] + 0.5 * s * a);
        }
    }
}
