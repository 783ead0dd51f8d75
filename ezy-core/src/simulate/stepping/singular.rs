//! Prediction of singular positions, in which the rank of G drops.

use super::snapshot::Snapshot;
use crate::dynamics::{Rows, State, System};
use crate::model::SceneRef;
use crate::simulate::tolerances::singular::{N_AHEAD, N_SECTIONS, NEAR, VANISHES};
use std::ops::Range;

/// The last two states of a motion. The square root of the smallest pivot is proportional to the distance from a singular position.
pub(in crate::simulate) struct Approach<'m> {
    pub now: &'m Snapshot,
    pub before: &'m Snapshot,
}

/// Where the smallest pivot vanishes on a predicted path.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::simulate) struct Vanishing {
    /// Time until then, s.
    pub within_s: f64,
    /// How near the path comes to the singular position, as a part of the distance from it now.
    pub nearest: f64,
}

/// The golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// Times about a distance, s.
pub(in crate::simulate) fn about(distance: f64) -> Range<f64> {
    0.0..NEAR * distance
}

impl Approach<'_> {
    /// Where a singular position may be, as times from now, s; none where it is far. `usual_s` is the length of the steps before, zero when
    /// there were none; `q` is a buffer.
    pub(in crate::simulate) fn ahead<P: SceneRef>(
        &self,
        system: &mut System<P>,
        usual_s: f64,
        q: &mut Vec<f64>,
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
    fn dip_ahead<P: SceneRef>(&self, system: &mut System<P>, far: f64, q: &mut Vec<f64>) -> Option<Range<f64>> {
        q.resize(self.now.state.q.len(), 0.0);
        let mut lowest = (None, self.now.end.smallest_pivot);
        for i in 1..=N_AHEAD {
            let s = far * 0.5_f64.powi(N_AHEAD - i);
            self.foresee(s, q);
            let pivot = system.at_with(self.now.state.t + s, q, Rows::Held).smallest_pivot();
            if pivot < lowest.1 {
                lowest = (Some(s), pivot);
            }
        }
        lowest.0.map(|s| 0.5 * s..2.0 * s)
    }

    /// Where the smallest pivot vanishes on the predicted path, within times from now, s; `q` is a buffer.
    pub(in crate::simulate) fn find<P: SceneRef>(
        &self,
        system: &mut System<P>,
        q: &mut [f64],
        within: Range<f64>,
    ) -> Option<Vanishing> {
        let mut pivot = |s: f64| {
            self.foresee(s, q);
            system.at_with(self.now.state.t + s, q, Rows::Held).smallest_pivot()
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
        let of_pivots = at_left.min(at_right) / self.now.end.smallest_pivot;
        if of_pivots > VANISHES {
            return None;
        }
        // where masses are far apart, pivots fall although constraints are independent
        let State { t, q: from, .. } = &self.now.state;
        let before = system.diagnosis().independence(*t, from);
        self.foresee(way, q);
        let there = system.diagnosis().independence(t + way, q);
        let left = before.zip(there).map_or(of_pivots, |(before, there)| there / before);
        // pivots fall with the square of the distance
        (left <= VANISHES).then(|| Vanishing { within_s: way, nearest: left.max(0.0).sqrt() })
    }

    /// Predicted positions at `s` from now, with accelerations extrapolated linearly; with constant rates where not all bodies are planar.
    fn foresee(&self, s: f64, q: &mut [f64]) {
        let Self { now, before } = self;
        if !now.q_rate.is_empty() {
            // the direction in which rows may come to depend on each other
            q.iter_mut().zip(&now.state.q).zip(&now.q_rate).for_each(|((q, now), rate)| *q = now + s * rate);
            return;
        }
        let passed = now.state.t - before.state.t;
        let bend = if passed > 0.0 { s / (3.0 * passed) } else { 0.0 };
        for (i, q) in q.iter_mut().enumerate() {
            let a = now.a[i] + bend * (now.a[i] - before.a[i]);
            *q = now.state.q[i] + s * (now.state.v[i] + 0.5 * s * a);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::linalg::Backend;
    use crate::model::Scene;

    crate::model! {
        /// A puck in a guide that follows a wall at the angle Ω t of the puck: slopes (1, 0, 0) and (1, 0, w (φ − Ω t)).
        pub model Guided {
            param w: m = 1;
            param rate: rad/s = 0;
            body puck { mass: 1, inertia: 1 }
            constraint wall: puck.x = 0;
            constraint guide: puck.x + w * (puck.phi^2 / 2 - rate * t * puck.phi) = 0;
            start here { puck at (0, 0) angle 0; at rest; }
            scene turns { start here; until 1 s; }
        }
    }

    /// At `t` at the angle `phi`, turning at `rate`, with the smallest pivot `pivot`.
    fn at(info: &crate::model::SceneInfo, t: f64, phi: f64, rate: f64, pivot: f64) -> Snapshot {
        let mut at = Snapshot::zero(info, false);
        (at.state.t, at.state.q[2], at.state.v[2], at.end.smallest_pivot) = (t, phi, rate, pivot);
        at
    }

    /// Accelerations that fall from 6 rad/s² to 4 rad/s² in 0.5 s go on doing so.
    #[test]
    fn analytic_positions_foreseen_lie_on_a_cubic() {
        let scene = guided::Turns::default();
        let info = scene.info();
        let (mut before, mut now) = (at(&info, 1.0, 0.0, 0.0, 1.0), at(&info, 1.5, 2.0, -3.0, 1.0));
        (before.a[2], now.a[2]) = (6.0, 4.0);
        let mut q = [0.0; 3];
        let s = 0.2_f64;
        Approach { now: &now, before: &before }.foresee(s, &mut q);
        assert!((q[2] - (2.0 - 3.0 * s + 2.0 * s * s - 4.0 * s.powi(3) / 6.0)).abs() <= 1e-15, "{q:?}");
        // without a step before, accelerations stay
        Approach { now: &now, before: &now }.foresee(s, &mut q);
        assert!((q[2] - (2.0 - 3.0 * s + 2.0 * s * s)).abs() <= 1e-15, "{q:?}");
    }

    /// A pivot that falls from 0.2² to 0.1² in 0.5 s vanishes in 0.5 s: near when that is less than 1.6 usual steps.
    #[test]
    fn analytic_root_of_the_pivot_falls_in_proportion_to_the_distance() {
        let scene = guided::Turns::default();
        let mut system = system_of(&scene, Backend::Dense).unwrap();
        let info = scene.info();
        let ahead = |system: &mut System<&_>, pivots: [f64; 2], usual_s: f64| {
            let (before, now) = (at(&info, 1.0, 0.2, -0.2, pivots[0]), at(&info, 1.5, 0.1, -0.2, pivots[1]));
            Approach { now: &now, before: &before }.ahead(system, usual_s, &mut Vec::new())
        };
        let near = ahead(&mut system, [0.04, 0.01], 0.32).unwrap();
        assert!(near.start == 0.0 && (near.end - 0.8).abs() <= 1e-14, "{near:?}");
        assert_eq!(ahead(&mut system, [0.04, 0.01], 0.31), None, "too far");
        assert_eq!(ahead(&mut system, [0.04, 0.01], 0.0), None, "nothing is usual before the first step");
        assert_eq!(ahead(&mut system, [0.01, 0.04], 0.5), None, "it rises");
        assert_eq!(ahead(&mut system, [0.04, 0.0], 0.5), None, "it has vanished");
    }

    /// From 0.1 rad beside Ω t, and towards it by 1 rad/s, the guide follows the wall after 0.1 s, as the square of the pivot there tells.
    #[test]
    fn analytic_singular_position_is_found_where_the_pivot_vanishes() {
        let q = &mut vec![0.0; 3];
        // sixteen golden sections
        let located = 0.25 * GOLDEN.powi(16);
        for rate in [0.5, 0.0] {
            let scene = guided::Turns { rate, ..Default::default() };
            let mut system = system_of(&scene, Backend::Dense).unwrap();
            let info = scene.info();
            let pivot = system.at_with(3.0, &[0.0, 0.0, 3.0 * rate + 0.1], Rows::Held).smallest_pivot();
            let now = at(&info, 3.0, 3.0 * rate + 0.1, rate - 1.0, pivot);
            let approach = Approach { now: &now, before: &now };
            for within in [0.0..0.25, 0.02..0.16, 0.05..0.25] {
                let Vanishing { within_s, nearest } = approach.find(&mut system, q, within.clone()).unwrap();
                assert!((within_s - 0.1).abs() <= located, "{within:?}: {within_s}");
                assert!(nearest <= located / 0.1, "{within:?}: {nearest}");
            }
        }
        let scene = guided::Turns::default();
        let mut system = system_of(&scene, Backend::Dense).unwrap();
        let info = scene.info();
        let pivot = system.at_with(0.0, &[0.0, 0.0, 0.1], Rows::Held).smallest_pivot();
        let mut now = at(&info, 3.0, 0.1, -1.0, pivot);
        let before = at(&info, 2.9, 0.2, -1.0, 4.0 * pivot);
        let approach = Approach { now: &now, before: &before };
        // at a fifth of the angle the pivot is 4 % of what it was: it does not vanish up to there
        assert_eq!(approach.find(&mut system, q, 0.0..0.08), None);
        // at the end of the search a tenth of it is left
        let Vanishing { nearest, .. } = approach.find(&mut system, q, 0.0..0.09).unwrap();
        assert!((nearest - 0.1).abs() <= 0.001, "{nearest}");
        // where rows are redundant anyway, the lowest pivot ahead tells: of 1.6 usual steps and halves of it
        now.solved.is_rank_deficient = true;
        let approach = Approach { now: &now, before: &before };
        let dip = approach.ahead(&mut system, 0.1, q).unwrap();
        assert!((dip.start - 0.04).abs() <= 1e-15 && (dip.end - 0.16).abs() <= 1e-15, "{dip:?}");
        now.state.v[2] = 1.0;
        assert_eq!(Approach { now: &now, before: &before }.ahead(&mut system, 0.1, q), None, "it rises");
    }
}
