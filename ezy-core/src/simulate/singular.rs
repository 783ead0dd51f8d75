//! Prediction of singular positions, in which the rank of G drops.

use super::instantaneous::Instantaneous;
use crate::dynamics::{State, System};
use crate::model::Scene;

/// The last two states of a motion. The square root of the smallest pivot is proportional to the distance from a singular position.
pub(super) struct Approach<'m> {
    pub now: &'m Instantaneous,
    pub before: &'m Instantaneous,
}

/// Singular positions are searched for within this many usual steps.
const NEAR: f64 = 1.6;

/// A pivot vanishes where it falls below this part of its present value on the predicted path.
const VANISHES: f64 = 0.02;

/// Length of the searched path, in distances predicted by the last two pivots.
const FARTHEST: f64 = 1.6;

/// Golden sections: they reduce the path to 1/2000.
const N_SECTIONS: usize = 16;

const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Approach<'_> {
    /// Time to a singular position as predicted by the last two pivots, s; none when it is far. `usual_s` is the usual step length,
    /// zero before the first step.
    pub fn distance(&self, usual_s: f64) -> Option<f64> {
        let (now, before) = (self.now.pivot, self.before.pivot);
        if now >= before || now <= 0.0 || usual_s == 0.0 {
            return None;
        }
        let (now, before) = (now.sqrt(), before.sqrt());
        let distance = now * (self.now.state.t - self.before.state.t) / (before - now);
        (distance < NEAR * usual_s).then_some(distance)
    }

    /// Time until the smallest pivot vanishes on the predicted path, about `guess` from now, s; `q` is a buffer.
    pub fn find<S: Scene + ?Sized>(&self, system: &mut System<'_, S>, q: &mut [f64], guess: f64) -> Option<f64> {
        let mut pivot = |s: f64| {
            self.foresee(s, q);
            system.pivot_at(self.now.state.t + s, q)
        };
        let (mut from, mut to) = (0.0, FARTHEST * guess);
        let (mut left, mut right) = (to - GOLDEN * to, GOLDEN * to);
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
        if at_left.min(at_right) > VANISHES * self.now.pivot {
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

    /// Positions at `s` from now, with accelerations extrapolated linearly.
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
