//! Solving with K whatever the rank of its rows, and what there is to tell about that.

use super::error::rows_or_unknown;
use super::system::Solver;
use super::{MotionError, System};
use crate::linalg::{
    COARSE, DampedKkt, DenseKkt, Dependencies, FINE, KktFactorization, LARGEST_DIAGNOSED, Left, dependencies,
    undetermined_coordinates, weights,
};
use crate::model::{Scene, SceneInfo};

/// How the last factorisation went.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Rank {
    /// Whether rows depend on each other, so that solutions come by [`DampedKkt`].
    pub deficient: bool,
    /// What the first solution left of the rows; later ones with the same factors are orders of a series.
    pub left: Option<Left>,
}

/// Which rows depend on each other at one state.
#[derive(Debug, Clone, PartialEq)]
pub struct RankLoss {
    /// Number of coordinates.
    pub n_coordinates: usize,
    /// Number of rows.
    pub n_rows: usize,
    /// How many of them are redundant: rows beyond the rank. `None` in a system too large to tell.
    pub n_redundant: Option<usize>,
    /// Names of the rows that take part in a dependency, in declared order; in a system too large to find them one that does.
    pub rows: Vec<&'static str>,
}

impl RankLoss {
    /// Velocities that are independent of each other there: coordinates less the rank.
    pub fn freedom(&self) -> Option<usize> {
        self.n_redundant.map(|n| self.n_coordinates.saturating_sub(self.n_rows - n))
    }
}

/// `rank 17 of 20, which leaves a freedom of 1; these depend on each other: …`
impl std::fmt::Display for RankLoss {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let rows = rows_or_unknown(&self.rows);
        match (self.n_redundant, self.freedom()) {
            (Some(n), Some(freedom)) => {
                let (rank, of) = (self.n_rows - n, self.n_rows);
                write!(
                    f,
                    "rank {rank} of {of}, which leaves a freedom of {freedom}; these depend on each other: {rows}"
                )
            }
            _ => write!(f, "of {} rows these, and others, depend on each other: {rows}", self.n_rows),
        }
    }
}

/// What rows may leave of the length of the accelerations: where a step ends next to a singular position, rounding of
/// positions over σ³ and what the damping passes over are far below this, rows that differ far above.
const ACCELERATIONS_AGREE: f64 = 1e-2;

/// The same of velocities, in which two factors of σ less are noise.
const VELOCITIES_AGREE: f64 = 1e-6;

/// Square of σ = 0.03: sixteen digits of positions leave eleven of accelerations there.
const NEARLY_DEPENDENT: f64 = 1e-3;

/// What nearly dependent rows can tell is lost below this σ, for positions a finer one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Threshold {
    Motion,
    Position,
}

impl Threshold {
    /// ε of [`DampedKkt`].
    pub(super) const fn share(self) -> f64 {
        match self {
            Self::Motion => COARSE,
            Self::Position => FINE,
        }
    }
}

impl<S: Scene + ?Sized> System<'_, S> {
    /// Whether the rows depended on each other in the last accelerations, correction or factorisation.
    pub fn lost_rank(&self) -> bool {
        self.rank.deficient
    }

    /// Whether rows nearly depend on each other at a state, whatever the masses are: [`System::independence`] is below 1e-3. Slow.
    pub(crate) fn is_near_rank_loss(&mut self, t: f64, q: &[f64]) -> bool {
        match self.independence(t, q) {
            Some(independence) => independence <= NEARLY_DEPENDENT,
            None => self.rank.deficient,
        }
    }

    /// The smallest eigenvalue of the scaled `G W⁻¹ Gᵀ`, W one for lengths and the square of its lever for an angle: how far rows are
    /// from depending on each other, whatever the masses are. Masses far apart make small pivots everywhere, and no position
    /// singular. `None` in a system too large to tell, or where G is not finite. Slow.
    pub(crate) fn independence(&mut self, t: f64, q: &[f64]) -> Option<f64> {
        self.geometric_dependencies(t, q).map(|found| found.smallest_pivot)
    }

    /// Rows that nearly depend on each other where only lengths count.
    fn geometric_dependencies(&mut self, t: f64, q: &[f64]) -> Option<Dependencies> {
        self.dependencies_in(t, q, &self.geometry.weights())
    }

    /// Rows that nearly depend on each other in the metric of a positive diagonal, `n_q`.
    pub(super) fn dependencies_in(&mut self, t: f64, q: &[f64], weight: &[f64]) -> Option<Dependencies> {
        if self.info.n_unknowns() > LARGEST_DIAGNOSED {
            return None;
        }
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        dependencies(weight, &self.info.jacobian, &self.buffers.jacobian, NEARLY_DEPENDENT)
    }

    /// What to say when a motion cannot be continued from a state: where rows nearly depend on each other, that they do.
    #[cold]
    pub(crate) fn locked_up(&mut self, t: f64, q: &[f64], cause: MotionError) -> MotionError {
        let may_lock = matches!(cause, MotionError::StepCollapsed { .. } | MotionError::ProjectionStalled { .. });
        if !may_lock {
            return cause;
        }
        match self.geometric_dependencies(t, q).filter(|found| found.n > 0) {
            None => cause,
            Some(found) => MotionError::LockedUp {
                t,
                rows: found.rows.iter().map(|&i| self.info.rows[i].name).collect(),
                smallest_pivot: found.smallest_pivot,
                cause: Box::new(cause),
            },
        }
    }

    /// The rows that depend on each other at a state. Slow, for reports.
    pub fn rank_loss(&mut self, t: f64, q: &[f64]) -> RankLoss {
        let (info, weight, n_rows) = (self.info, weights(&self.mass), self.info.n_rows());
        let n_coordinates = info.n_coordinates();
        let jacobian = &mut self.buffers.jacobian;
        self.scene.velocity_jacobian(&self.fixed, t, q, jacobian);
        let found = match info.n_unknowns() <= LARGEST_DIAGNOSED {
            true => dependencies(&weight, &info.jacobian, jacobian, COARSE).and_then(|found| match found.n {
                // a pivot can vanish a little before the eigenvalue does
                0 => dependencies(&weight, &info.jacobian, jacobian, found.smallest_pivot),
                _ => Some(found),
            }),
            false => None,
        };
        let name = |i: usize| info.rows[i].name;
        match found {
            Some(found) => {
                let rows = found.rows.into_iter().map(name).collect();
                RankLoss { n_coordinates, n_rows, n_redundant: Some(found.n), rows }
            }
            None => {
                let row = self.vanished_row.filter(|_| self.rank.deficient).map(name);
                RankLoss { n_coordinates, n_rows, n_redundant: None, rows: row.into_iter().collect() }
            }
        }
    }

    /// Whether dependent rows agree about the accelerations that were computed last.
    ///
    /// # Errors
    /// [`MotionError::ContradictoryRows`].
    pub(crate) fn check_accelerations(&mut self, t: f64, q: &[f64]) -> Result<(), MotionError> {
        self.check_agreement(t, q, "the accelerations", 0.0, ACCELERATIONS_AGREE)
    }

    /// Whether dependent rows agree about a correction of velocities that were `v`.
    pub(super) fn check_velocities(&mut self, t: f64, q: &[f64], v: &[f64]) -> Result<(), MotionError> {
        let before = self.mass.iter().zip(v).fold(0.0, |sum, (m, v)| sum + m * v * v);
        self.check_agreement(t, q, "the velocities", before.sqrt(), VELOCITIES_AGREE)
    }

    /// Compares what is left with `scale`, or the scale of the solution where that is larger.
    fn check_agreement(
        &mut self,
        t: f64,
        q: &[f64],
        level: &'static str,
        scale: f64,
        tolerance: f64,
    ) -> Result<(), MotionError> {
        let Some(left) = self.rank.left.filter(|_| self.rank.deficient) else { return Ok(()) };
        let scale = scale.max(left.scale);
        if left.rows <= tolerance * scale {
            return Ok(());
        }
        let rows = self.rank_loss(t, q).rows;
        Err(MotionError::ContradictoryRows { t, rows, level, residual: left.rows / scale, tolerance })
    }

    /// Factors K, whatever its rank.
    ///
    /// # Errors
    /// [`MotionError`] when a number is not finite or a coordinate is undetermined.
    pub(super) fn factor(&mut self, t: f64, q: &[f64], threshold: Threshold) -> Result<(), MotionError> {
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        let generated = self.uses_elimination();
        let kkt = factored(&mut self.solver, &mut self.second_opinion, self.info);
        self.rank = Rank::default();
        let Err(vanished) = kkt.factor(&self.mass, &self.buffers.jacobian) else {
            if !generated {
                let smallest = kkt.smallest_pivot();
                self.see_pivot(smallest);
            }
            return Ok(());
        };
        self.vanished_row = vanished.row;
        self.rank.deficient = true;
        (self.smallest_pivot, self.least_pivot) = (0.0, 0.0);
        let damped = self.damped.get_or_insert_with(|| Box::new(DampedKkt::new(&self.mass, self.info.n_rows())));
        let outcome = damped.factor(kkt, &self.info.jacobian, &self.mass, &self.buffers.jacobian, threshold.share());
        outcome.map_err(|_| self.why_singular(t, q))
    }

    /// Solves for what stands in the buffer of right sides, with the last factors.
    pub(super) fn solve_in_buffer(&mut self) {
        let kkt = factored(&mut self.solver, &mut self.second_opinion, self.info);
        let x = &mut self.buffers.right_side;
        match &mut self.damped {
            Some(damped) if self.rank.deficient => {
                let left = damped.solve(kkt, &self.info.jacobian, &self.mass, &self.buffers.jacobian, x);
                self.rank.left.get_or_insert(left);
            }
            _ => kkt.solve(x),
        }
    }

    /// Names what makes K singular although rows are damped. Slow; only for reports.
    #[cold]
    fn why_singular(&mut self, t: f64, q: &[f64]) -> MotionError {
        let (scene, info) = (self.scene, self.info);
        scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        match undetermined_coordinates(&self.mass, &info.jacobian, &self.buffers.jacobian) {
            Some(found) if !found.is_empty() => MotionError::UndeterminedMotion {
                t,
                coordinates: found.iter().map(|&i| info.coordinates[i].name).collect(),
            },
            _ => MotionError::NotFinite { t, quantity: "the constraint Jacobian or an entry of its factors" },
        }
    }
}

/// The factorisation of a run that has one; else the dense one that decides when a generated pivot vanished.
fn factored<'k>(
    solver: &'k mut Solver,
    second_opinion: &'k mut Option<Box<DenseKkt>>,
    info: &SceneInfo,
) -> &'k mut dyn KktFactorization {
    match solver {
        Solver::Factored(kkt) => kkt.as_mut(),
        Solver::Generated => self::second_opinion(second_opinion, info),
    }
}

/// The dense solver beside that of a run, made when it is first asked for.
pub(super) fn second_opinion<'k>(made: &'k mut Option<Box<DenseKkt>>, info: &SceneInfo) -> &'k mut DenseKkt {
    made.get_or_insert_with(|| Box::new(DenseKkt::new(info.n_coordinates(), &info.jacobian, info.n_rows())))
}
