//! Back onto the constraints: positions first, then velocities at the projected positions.

use super::deficient::{Rank, Threshold};
use super::system::Buffers;
use super::{MotionError, System, Worst, max_abs};
use crate::linalg::{DampedKkt, DenseKkt, KktFactorization, LARGEST_DENSE};
use crate::model::{Scene, SceneInfo, SparsityPattern};

/// What is projected after each step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Projection {
    /// Nothing.
    None,
    /// Velocities only.
    Velocities,
    /// Positions only; less accurate than nothing, for comparison.
    Positions,
    /// Positions, then velocities at the projected positions.
    #[default]
    Both,
}

impl Projection {
    /// Whether positions are projected.
    pub fn positions(self) -> bool {
        matches!(self, Self::Positions | Self::Both)
    }

    /// Whether velocities are projected.
    pub fn velocities(self) -> bool {
        matches!(self, Self::Velocities | Self::Both)
    }
}

/// In which metric a correction is smallest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Metric {
    /// δᵀ M δ. A velocity projection then never adds kinetic energy when the constraints do not depend on time, and
    /// a position correction [C; 0] violates no velocity row to first order.
    #[default]
    Mass,
    /// δᵀ δ, which adds metres to radians: the least-squares projection of the report (`docs/notation.md`), for comparison.
    /// Positions are corrected along the position rows only, as there.
    Euclidean,
}

/// Gauss–Newton passes; from the drift of one step two are plenty.
pub(super) const MAX_PASSES: usize = 10;

/// Passes before a residual may be taken for rounding: at 1e6 rad a correction of an angle is lost, but what x and y take of it
/// is not, so that each pass leaves a part.
const PASSES_TO_ROUNDING: usize = 3;

/// The first one converges quadratically, the second one removes its rounding.
const PASSES_NEAR_RANK_LOSS: usize = 2;

/// |C| that may stay where rows nearly depend on each other: there its square root is a displacement, and the next step,
/// farther away, removes both.
const TOLERANCE_AT_RANK_LOSS: f64 = 1e-10;

/// A velocity correction this many times as large as the residual that it removes shows rows that nearly depend on each
/// other; levers of a centimetre make it a hundred times as large.
const NEAR_RANK_LOSS: f64 = 1e3;

/// Velocity corrections below this fraction of the velocities are rounding, or harmless.
const NOTICEABLE: f64 = 1e-10;

impl<S: Scene + ?Sized> System<'_, S> {
    /// Brings `q` and `v` back onto the rows: positions, then velocities at the projected positions.
    ///
    /// Near rank loss, at the distance σ, what a position row leaves is a displacement 1/σ times as large along a motion
    /// that the rows hardly hold, and the velocities follow with 1/σ². There the positions are corrected to their last
    /// digits, beyond the tolerance, and the velocities again.
    ///
    /// # Errors
    /// As [`System::project_positions`].
    pub fn project(
        &mut self,
        t: f64,
        q: &mut [f64],
        v: &mut [f64],
        projection: Projection,
        metric: Metric,
    ) -> Result<(), MotionError> {
        if projection.positions() {
            self.project_positions(t, q, metric)?;
        }
        if projection.velocities() {
            self.project_velocities(t, q, v, metric)?;
            let (removed, correction) = (self.projected.velocities_before.value, max_abs(&self.buffers.delta));
            let near_rank_loss = correction > NEAR_RANK_LOSS * removed && correction > NOTICEABLE * max_abs(v);
            if near_rank_loss && projection.positions() {
                v.iter_mut().zip(&self.buffers.delta).for_each(|(v, delta)| *v -= delta);
                for _ in 0..PASSES_NEAR_RANK_LOSS {
                    self.position_residual(t, q);
                    self.correct_positions(t, q, metric)?;
                }
                self.project_velocities(t, q, v, metric)?;
            }
        }
        Ok(())
    }

    /// Largest |C(q, t)| over the position rows; zero without any.
    pub fn position_residual(&mut self, t: f64, q: &[f64]) -> f64 {
        self.worst_position(t, q).value
    }

    /// Largest residual of all rows at velocity level: C_q v + C_t and S v + s_t.
    pub fn velocity_residual(&mut self, t: f64, q: &[f64], v: &[f64]) -> f64 {
        self.worst_velocity(t, q, v).value
    }

    /// The position row that is farthest from being met, m or rad.
    pub(crate) fn worst_position(&mut self, t: f64, q: &[f64]) -> Worst {
        let residual = &mut self.buffers.residual[..self.info.n_position_rows];
        self.scene.position_constraint(&self.fixed, t, q, residual);
        Worst::of(residual)
    }

    /// The row that is farthest from being met at velocity level, m/s or rad/s.
    pub(crate) fn worst_velocity(&mut self, t: f64, q: &[f64], v: &[f64]) -> Worst {
        self.scene.velocity_constraint(&self.fixed, t, q, v, &mut self.buffers.residual);
        Worst::of(&self.buffers.residual)
    }

    /// Moves `q` onto C = 0 by Gauss–Newton, each pass at the corrected point, and returns the number of passes.
    /// A `q` that fulfils the rows to 1e-12 of their size (at most 1e-12 m or rad), or to the rounding of large coordinates,
    /// is left as it is. The size of a row is what it changes by when bodies move by the longest lever and turn by 1 rad.
    ///
    /// # Errors
    /// [`MotionError::ProjectionStalled`] when that is not reached in 10 passes, and those of
    /// [`System::accelerations`].
    pub fn project_positions(&mut self, t: f64, q: &mut [f64], metric: Metric) -> Result<usize, MotionError> {
        let n_h = self.info.n_position_rows;
        let mut passes = 0;
        loop {
            let worst = self.worst_position(t, q);
            let norm = worst.value;
            if passes == 0 {
                self.projected.positions_before = worst;
            }
            let residual = &self.buffers.residual[..n_h];
            if self.geometry.is_met(residual)
                || self.geometry.position_excess(residual, q) <= 1.0
                    && (passes == MAX_PASSES || passes >= PASSES_TO_ROUNDING && norm <= self.rounding(t, q))
            {
                self.projected.positions_after = worst;
                return Ok(passes);
            }
            if !norm.is_finite() {
                return Err(MotionError::NotFinite { t, quantity: "a position constraint" });
            }
            if passes == MAX_PASSES && self.rank.deficient {
                if norm <= TOLERANCE_AT_RANK_LOSS {
                    self.projected.positions_after = worst;
                    return Ok(passes);
                }
                let tolerance = self.geometry.position_tolerance(worst.row, self.geometry.extent(q));
                let (rows, level) = (self.rank_loss(t, q).rows, "the positions");
                return Err(MotionError::ContradictoryRows { t, rows, level, residual: norm, tolerance });
            }
            if passes == MAX_PASSES {
                let tolerance = self.geometry.position_tolerance(worst.row, self.geometry.extent(q));
                return Err(MotionError::ProjectionStalled {
                    t,
                    residual: norm,
                    row: self.info.rows[worst.row].name,
                    passes,
                    tolerance,
                });
            }
            self.correct_positions(t, q, metric)?;
            passes += 1;
        }
    }

    /// Rounding that coordinates leave in the position rows: of each one, by its slope. A rate of 1e4 rad/s makes large
    /// angles, but on short levers.
    fn rounding(&mut self, t: f64, q: &[f64]) -> f64 {
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        let Buffers { jacobian, right_side: rows, .. } = &mut self.buffers;
        rows.fill(0.0);
        for (k, row, column) in self.info.jacobian.entries() {
            rows[row] += (jacobian[k] * q[column]).abs();
        }
        2.0 * f64::EPSILON * max_abs(&rows[..self.info.n_position_rows])
    }

    /// One pass beyond the tolerance, for positions that are projected.
    pub(crate) fn polish_positions(&mut self, t: f64, q: &mut [f64]) -> Result<(), MotionError> {
        self.position_residual(t, q);
        self.correct_positions(t, q, Metric::Mass)
    }

    /// One pass, for the residual of the position rows in the buffer.
    fn correct_positions(&mut self, t: f64, q: &mut [f64], metric: Metric) -> Result<(), MotionError> {
        self.buffers.residual[self.info.n_position_rows..].fill(0.0);
        self.correct(t, q, metric, Level::Position)?;
        q.iter_mut().zip(&self.buffers.delta).for_each(|(q, delta)| *q += delta);
        Ok(())
    }

    /// Moves `v` onto all rows at velocity level, at the positions `q`, by one linear solve.
    ///
    /// # Errors
    /// As [`System::accelerations`].
    pub fn project_velocities(&mut self, t: f64, q: &[f64], v: &mut [f64], metric: Metric) -> Result<(), MotionError> {
        self.projected.velocities_before = self.worst_velocity(t, q, v);
        self.correct(t, q, metric, Level::Velocity)?;
        if self.rank.deficient {
            self.check_velocities(t, q, v)?;
        }
        v.iter_mut().zip(&self.buffers.delta).for_each(|(v, delta)| *v += delta);
        Ok(())
    }

    /// Correction for the residual in the buffer, into the buffer.
    fn correct(&mut self, t: f64, q: &[f64], metric: Metric, level: Level) -> Result<(), MotionError> {
        let residual = std::mem::take(&mut self.buffers.residual);
        let mut delta = std::mem::take(&mut self.buffers.delta);
        let outcome = match (metric, level) {
            (Metric::Euclidean, Level::Position) => {
                let n_h = self.info.n_position_rows;
                self.counters.factorizations += 1;
                self.euclidean_correction(t, q, &residual[..n_h], Threshold::Position, &mut delta)
            }
            (_, Level::Position) => self.correction_from(t, q, &residual, metric, Threshold::Position, &mut delta),
            (_, Level::Velocity) => self.correction(t, q, &residual, metric, &mut delta),
        };
        self.buffers.residual = residual;
        self.buffers.delta = delta;
        outcome
    }

    /// For the residual of the position rows, or of all.
    pub(super) fn euclidean_correction(
        &mut self,
        t: f64,
        q: &[f64],
        residual: &[f64],
        threshold: Threshold,
        delta: &mut [f64],
    ) -> Result<(), MotionError> {
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        let euclidean = Euclidean::of(&mut self.euclidean, self.info)?;
        let rank = euclidean.correction(&self.info.jacobian, &self.buffers.jacobian, residual, threshold, delta);
        self.rank = rank.ok_or(MotionError::NotFinite { t, quantity: "the constraint Jacobian" })?;
        Ok(())
    }
}

#[derive(Clone, Copy)]
enum Level {
    Position,
    Velocity,
}

/// `δ = −Gᵀ (G Gᵀ)⁻¹ r`, from K with M = 1: over the position rows for positions, over all rows for velocities.
pub(super) struct Euclidean {
    ones: Vec<f64>,
    positions: (DenseKkt, DampedKkt),
    velocities: (DenseKkt, DampedKkt),
    right_side: Vec<f64>,
}

impl Euclidean {
    /// The one of a system, made when it is first asked for.
    fn of<'e>(made: &'e mut Option<Box<Self>>, info: &SceneInfo) -> Result<&'e mut Self, MotionError> {
        let (n, limit) = (info.n_unknowns(), LARGEST_DENSE);
        if n > limit {
            return Err(MotionError::EuclideanTooLarge { n, limit });
        }
        Ok(made.get_or_insert_with(|| Box::new(Self::new(info))))
    }

    fn new(info: &SceneInfo) -> Self {
        let n_q = info.n_coordinates();
        let ones = vec![1.0; n_q];
        let solvers = |n_rows| (DenseKkt::new(n_q, &info.jacobian, n_rows), DampedKkt::new(&ones, n_rows));
        Self {
            positions: solvers(info.n_position_rows),
            velocities: solvers(info.n_rows()),
            ones,
            right_side: vec![0.0; n_q + info.n_rows()],
        }
    }

    /// For a residual of the position rows, or of all; `None` when a number is not finite.
    fn correction(
        &mut self,
        pattern: &SparsityPattern,
        jacobian: &[f64],
        residual: &[f64],
        threshold: Threshold,
        delta: &mut [f64],
    ) -> Option<Rank> {
        let Self { ones, positions, velocities, right_side } = self;
        let n_q = ones.len();
        let x = &mut right_side[..n_q + residual.len()];
        let (kkt, damped) = if residual.len() < velocities.1.n_rows() { positions } else { velocities };
        x[..n_q].fill(0.0);
        x[n_q..].iter_mut().zip(residual).for_each(|(x, r)| *x = -r);
        let rank = if kkt.factor(ones, jacobian).is_ok() {
            kkt.solve(x);
            Rank::default()
        } else {
            damped.factor(kkt, pattern, ones, jacobian, threshold.share()).ok()?;
            Rank { deficient: true, left: Some(damped.solve(kkt, pattern, ones, jacobian, x)) }
        };
        delta.copy_from_slice(&x[..n_q]);
        Some(rank)
    }
}
