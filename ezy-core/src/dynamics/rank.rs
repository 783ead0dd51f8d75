//! What there is to tell about rows that depend on each other.

use super::diagnosis::Diagnosis;
use super::error::rows_or_unknown;
use super::solved::{Rows, Solved};
use super::tolerances::rank::{ACCELERATIONS_AGREE, NEARLY_DEPENDENT, VELOCITIES_AGREE};
use super::{MotionError, System};
use crate::linalg::{INDEPENDENT, Independent, LARGEST_DIAGNOSED, Left};
use crate::model::{Name, SceneRef};
use std::sync::Arc;

/// Which constraints depend on each other at one state.
#[derive(Debug, Clone, PartialEq)]
pub struct RankLoss {
    /// Number of coordinates.
    pub n_coordinates: usize,
    /// Number of rows.
    pub n_rows: usize,
    /// How many of them are redundant: rows beyond the rank. `None` in a system too large to tell.
    pub n_redundant: Option<usize>,
    /// Names of the rows that take part in a dependency, in declared order; in a system too large to find them one that does.
    pub rows: Vec<Name>,
}

impl RankLoss {
    /// Whether there is any; in a system too large to tell, whether a pivot vanished.
    pub(crate) fn is_lost(&self) -> bool {
        self.n_redundant.map_or(!self.rows.is_empty(), |n| n > 0)
    }

    /// Velocities that are independent of each other there: coordinates less the rank.
    pub fn freedom(&self) -> Option<usize> {
        self.n_redundant.map(|n| self.n_coordinates.saturating_sub(self.n_rows - n))
    }
}

/// `rank 17 of 20, degrees of freedom: 1; these depend on each other: …`
impl std::fmt::Display for RankLoss {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let rows = rows_or_unknown(&self.rows);
        match (self.n_redundant, self.freedom()) {
            (Some(n), Some(freedom)) => {
                let (rank, of) = (self.n_rows - n, self.n_rows);
                write!(f, "rank {rank} of {of}, degrees of freedom: {freedom}; these depend on each other: {rows}")
            }
            _ => write!(f, "of {} rows these, and others, depend on each other: {rows}", self.n_rows),
        }
    }
}

impl<P: SceneRef> System<P> {
    /// The rows that depend on each other at a state. Slow, for reports.
    pub fn rank_loss(&mut self, t: f64, q: &[f64]) -> RankLoss {
        self.diagnosis().rank_loss(t, q)
    }
}

impl<P: SceneRef> Diagnosis<'_, P> {
    /// Whether rows that a step goes on with nearly depend on each other.
    pub(crate) fn is_nearly_singular(&mut self, t: f64, q: &[f64]) -> bool {
        self.independence(t, q).is_some_and(|independence| independence <= NEARLY_DEPENDENT * NEARLY_DEPENDENT)
    }

    /// Whether the rows that a step goes on with are certainly far from depending on each other. Slow.
    pub(crate) fn is_far_from_singular(&mut self, t: f64, q: &[f64]) -> bool {
        self.independence(t, q).is_some_and(|independence| independence > NEARLY_DEPENDENT * NEARLY_DEPENDENT)
    }

    /// Square of the smallest pivot of G, rows scaled to one and angles in units of their levers: how far rows are from depending on each
    /// other, whatever the masses are. Masses far apart make small pivots of G M⁻¹ Gᵀ everywhere, and no position singular.
    /// `None` in a system too large to tell. Slow.
    pub(crate) fn independence(&mut self, t: f64, q: &[f64]) -> Option<f64> {
        self.system.at(t, q).pivot_of_rows()
    }

    /// What to say when a motion cannot be continued from a state: where constraints nearly depend on each other, that they do.
    #[cold]
    pub(crate) fn locked_up(&mut self, t: f64, q: &[f64], cause: MotionError) -> MotionError {
        let may_lock = matches!(cause, MotionError::StepCollapsed { .. } | MotionError::ProjectionStalled { .. });
        if !may_lock || !self.is_nearly_singular(t, q) {
            return cause;
        }
        let smallest_pivot = self.independence(t, q);
        let near = self.system.at(t, q).rank(Independent::Above(NEARLY_DEPENDENT));
        match near.map(|rank| rank.dependencies()).filter(|found| found.n > 0) {
            None => cause,
            Some(found) => MotionError::LockedUp {
                t,
                rows: found.rows.iter().map(|&i| self.system.info.rows[i].name.clone()).collect(),
                smallest_pivot: smallest_pivot.unwrap_or(0.0),
                cause: Box::new(cause),
            },
        }
    }

    /// As [`System::rank_loss`].
    pub(super) fn rank_loss(&mut self, t: f64, q: &[f64]) -> RankLoss {
        let (info, [_, n_rows]) = (Arc::clone(&self.system.info), self.system.active.n_on());
        let n_coordinates = info.n_velocities();
        let name = |i: usize| info.rows[i].name.clone();
        match self.system.at(t, q).rank(Independent::Above(INDEPENDENT)).map(|rank| rank.dependencies()) {
            Some(found) => {
                let rows = found.rows.into_iter().map(name).collect();
                RankLoss { n_coordinates, n_rows, n_redundant: Some(found.n), rows }
            }
            None => {
                let is_large = info.n_unknowns() > LARGEST_DIAGNOSED;
                let row = if is_large { self.system.at_with(t, q, Rows::Projected).vanished_row() } else { None };
                RankLoss { n_coordinates, n_rows, n_redundant: None, rows: row.map(name).into_iter().collect() }
            }
        }
    }

    /// Whether redundant rows agree about accelerations.
    ///
    /// # Errors
    /// [`MotionError::ContradictoryRows`].
    #[inline]
    pub(crate) fn check_accelerations(&mut self, t: f64, q: &[f64], solved: Solved) -> Result<(), MotionError> {
        match solved.is_rank_deficient {
            true => self.check_agreement(t, q, solved.left, "the accelerations", ACCELERATIONS_AGREE),
            false => Ok(()),
        }
    }

    /// Whether redundant rows agree about a correction of velocities that were `v`.
    #[inline]
    pub(super) fn check_velocities(&mut self, t: f64, q: &[f64], v: &[f64], solved: Solved) -> Result<(), MotionError> {
        if !solved.is_rank_deficient {
            return Ok(());
        }
        let before = self.system.geometry.units.iter().zip(v).map(|(unit, v)| (unit * v).abs());
        let scale = before.fold(solved.left.scale, f64::max);
        self.check_agreement(t, q, Left { scale, ..solved.left }, "the velocities", VELOCITIES_AGREE)
    }

    fn check_agreement(
        &mut self,
        t: f64,
        q: &[f64],
        left: Left,
        level: &'static str,
        tolerance: f64,
    ) -> Result<(), MotionError> {
        if left.rows <= tolerance * left.scale {
            return Ok(());
        }
        let (rows, residual) = (self.rank_loss(t, q).rows, left.rows / left.scale);
        // next to a singular position of the independent rows it is rounding by which redundant ones differ
        let near = self.system.at(t, q).rank(Independent::Above(INDEPENDENT)).map(|rank| rank.smallest_pivot());
        match near.filter(|pivot| *pivot <= NEARLY_DEPENDENT) {
            Some(pivot) => Err(MotionError::LostInRounding { t, rows, smallest_pivot: Some(pivot * pivot), residual }),
            None => Err(self.disagreement(t, q, level, residual, tolerance)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::linalg::Backend;

    crate::model! {
        /// A puck that is held along two lines.
        pub model Tilted {
            param angle: rad = 0.1;
            body puck { mass: 3, inertia: 1 }
            constraint first: puck.x = 0;
            constraint second: 5 * cos(angle) * puck.x + 5 * sin(angle) * puck.y = 0;
            start here { puck at (0, 0) angle 0; at rest; }
            scene rests { start here; until 1 s; }
        }
    }

    /// At an angle of δ the second row, its largest entry made one, keeps tan δ beside the first: below 0.1 they nearly depend on each other.
    #[test]
    fn analytic_independence_of_two_directions() {
        for (angle, is_near) in [(0.01_f64, true), (0.098, true), (0.102, false), (0.3, false)] {
            let scene = tilted::Rests { angle };
            let mut system = system_of(&scene, Backend::Dense).unwrap();
            let q = [0.0; 3];
            let independence = system.diagnosis().independence(0.0, &q).unwrap();
            assert!((independence / angle.tan().powi(2) - 1.0).abs() <= 1e-12, "{angle}: {independence}");
            assert_eq!(
                (system.diagnosis().is_nearly_singular(0.0, &q), system.diagnosis().is_far_from_singular(0.0, &q)),
                (is_near, !is_near),
                "{angle}"
            );
            let stalled = || MotionError::ProjectionStalled {
                t: 0.0,
                residual: 1.0,
                row: "first".into(),
                passes: 10,
                tolerance: 1e-12,
            };
            let locked = system.diagnosis().locked_up(0.0, &q, stalled());
            match &locked {
                MotionError::LockedUp { rows, smallest_pivot, cause, .. } => {
                    assert!(is_near && rows[..] == ["first", "second"] && **cause == stalled(), "{locked}");
                    assert_eq!(*smallest_pivot, independence);
                }
                other => assert!(!is_near && *other == stalled(), "{angle}: {other}"),
            }
        }
    }

    /// Rows are lost where some are redundant; where that is not known, where one is named.
    #[test]
    fn invariant_rank_is_lost_where_rows_are_redundant_or_named() {
        let loss = |n_redundant, rows: &[&'static str]| RankLoss {
            n_coordinates: 9,
            n_rows: 8,
            n_redundant,
            rows: rows.iter().map(|row| (*row).into()).collect(),
        };
        for (n, rows, is_lost, freedom) in [
            (Some(0), &[][..], false, Some(1)),
            (Some(2), &["A.x", "B.x"], true, Some(3)),
            (None, &[], false, None),
            (None, &["A.x"], true, None),
        ] {
            let loss = loss(n, rows);
            assert_eq!((loss.is_lost(), loss.freedom()), (is_lost, freedom), "{loss:?}");
        }
    }
}
