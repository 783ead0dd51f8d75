//! Back onto the constraints: positions first, then velocities at the projected positions.

use super::euclidean::Euclidean;
use super::factors::Factors;
use super::solved::{Rows, Solved};
use super::tolerances::projection::{
    LARGEST_LEFT, MAX_PASSES, NEAR_RANK_LOSS, PASSES_NEAR_RANK_LOSS, PASSES_TO_ROUNDING,
};
use super::{MotionError, Projected, System, Worst, max_abs};
use crate::linalg::{INDEPENDENT, Independent};
use crate::model::{Derived as _, Equations as _, SceneRef, body_kind};

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
    pub(crate) fn positions(self) -> bool {
        matches!(self, Self::Positions | Self::Both)
    }

    /// Whether velocities are projected.
    pub(crate) fn velocities(self) -> bool {
        matches!(self, Self::Velocities | Self::Both)
    }
}

/// In which metric a correction is smallest.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Metric {
    /// δᵀ M δ. A velocity projection then never adds kinetic energy when the constraints do not depend on time, and
    /// a position correction [C; 0] violates no velocity constraint to first order.
    #[default]
    Mass,
    /// δᵀ δ, which adds metres to radians: the least-squares projection of the report (`docs/notation.md`), for comparison.
    /// Positions are corrected along the position constraints only, as there.
    Euclidean,
}

/// What a projection of velocities is followed by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Next {
    /// The rows of both.
    pub rows: Rows,
    /// Whether accelerations at the projected state are asked for.
    pub accelerates: bool,
}

/// Brings positions and velocities back onto the rows.
pub(crate) struct Projector<'s, P: SceneRef> {
    system: &'s mut System<P>,
}

impl<P: SceneRef> System<P> {
    /// Brings `q` and `v` back onto the rows: positions, then velocities at the projected positions.
    ///
    /// Near rank loss, at the distance σ, what a position constraint leaves is a displacement 1/σ times as large along a motion
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
    ) -> Result<Projected, MotionError> {
        self.projector().project_with(t, q, v, projection, metric, Next { rows: Rows::Projected, accelerates: false })
    }

    /// Largest |C(q, t)| over the position constraints; zero without any.
    pub fn position_residual(&mut self, t: f64, q: &[f64]) -> f64 {
        self.projector().worst_position(t, q).value
    }

    /// Largest residual of all rows at velocity level: C_q v + C_t and S v + s_t.
    pub fn velocity_residual(&mut self, t: f64, q: &[f64], v: &[f64]) -> f64 {
        self.projector().worst_velocity(t, q, v).value
    }

    /// Moves `q` onto C = 0 by Gauss–Newton, each pass at the corrected point, and returns the number of passes.
    /// A `q` that fulfils the rows to 1e-12 of their size (at most 1e-12 m or rad), or to the rounding of large coordinates,
    /// is left as it is. The size of a row is what it changes by when bodies move by the longest lever and turn by 1 rad.
    ///
    /// # Errors
    /// [`MotionError::ProjectionStalled`] when that is not reached in 10 passes, and those of
    /// [`System::accelerations`].
    pub fn project_positions(&mut self, t: f64, q: &mut [f64], metric: Metric) -> Result<usize, MotionError> {
        self.projector().move_onto_rows(t, q, metric).map(|(_, passes)| passes)
    }

    /// Moves `v` onto all rows at velocity level, at the positions `q`, by one linear solve.
    ///
    /// # Errors
    /// As [`System::accelerations`].
    pub fn project_velocities(
        &mut self,
        t: f64,
        q: &[f64],
        v: &mut [f64],
        metric: Metric,
    ) -> Result<Solved, MotionError> {
        let next = Next { rows: Rows::Projected, accelerates: false };
        self.projector().move_velocities(t, q, v, metric, next).map(|(_, solved)| solved)
    }

    /// What brings positions and velocities back onto the rows.
    #[inline]
    pub(crate) fn projector(&mut self) -> Projector<'_, P> {
        Projector { system: self }
    }
}

/// |C| that the last pass may leave. The tolerance of a row grows with the longest lever of all bodies; this does not.
fn largest_left(q: &[f64]) -> f64 {
    LARGEST_LEFT * max_abs(q).max(1.0)
}

impl<P: SceneRef> Projector<'_, P> {
    /// The position constraint that is farthest from being met, m or rad.
    pub(crate) fn worst_position(&mut self, t: f64, q: &[f64]) -> Worst {
        let System { scene, info, fixed, residual, sines, .. } = &mut *self.system;
        let residual = &mut residual[..info.n_position_rows];
        scene.position_constraint_with_sines(fixed, t, q, sines.at(q), residual);
        Worst::of(residual)
    }

    /// The row that is farthest from being met at velocity level, m/s or rad/s.
    pub(crate) fn worst_velocity(&mut self, t: f64, q: &[f64], v: &[f64]) -> Worst {
        let System { scene, fixed, residual, sines, .. } = &mut *self.system;
        scene.velocity_constraint_with_sines(fixed, t, q, v, sines.at(q), residual);
        Worst::of(residual)
    }

    /// As [`System::project`], for the end of a step whose accelerations are asked for next.
    #[inline]
    pub(crate) fn project_end(
        &mut self,
        t: f64,
        q: &mut [f64],
        v: &mut [f64],
        projection: Projection,
        metric: Metric,
    ) -> Result<Projected, MotionError> {
        self.project_with(t, q, v, projection, metric, Next { rows: Rows::Projected, accelerates: true })
    }

    /// As [`System::project`], with these rows at the projected positions.
    #[inline]
    pub(super) fn project_with(
        &mut self,
        t: f64,
        q: &mut [f64],
        v: &mut [f64],
        projection: Projection,
        metric: Metric,
        next: Next,
    ) -> Result<Projected, MotionError> {
        let mut projected = Projected::default();
        if projection.positions() {
            [projected.positions_before, projected.positions_after] = self.move_onto_rows(t, q, metric)?.0;
        }
        if projection.velocities() {
            let mut solved;
            (projected.velocities_before, solved) = self.move_velocities(t, q, v, metric, next)?;
            let (removed, correction) = (projected.velocities_before.value, max_abs(&self.system.factors.delta));
            if correction > NEAR_RANK_LOSS * removed
                && projection.positions()
                && let Some(again) = self.correct_near_rank_loss(t, q, v, metric, next, removed)?
            {
                solved = again;
            }
            projected.solved = Some(solved);
        }
        Ok(projected)
    }

    /// Corrects positions and velocities again where the velocity correction just made is one near rank loss.
    #[cold]
    #[inline(never)]
    fn correct_near_rank_loss(
        &mut self,
        t: f64,
        q: &mut [f64],
        v: &mut [f64],
        metric: Metric,
        next: Next,
        removed: f64,
    ) -> Result<Option<Solved>, MotionError> {
        // levers of a millimetre alone make angles a thousand times as large
        if self.system.geometry.length_of(&self.system.factors.delta) <= NEAR_RANK_LOSS * removed {
            return Ok(None);
        }
        v.iter_mut().zip(&self.system.factors.delta).for_each(|(v, delta)| *v -= delta);
        for _ in 0..PASSES_NEAR_RANK_LOSS {
            self.polish_positions_in(t, q, metric)?;
        }
        Ok(Some(self.move_velocities(t, q, v, metric, next)?.1))
    }

    /// [`System::project_positions`], with the worst row before and after.
    #[inline]
    fn move_onto_rows(&mut self, t: f64, q: &mut [f64], metric: Metric) -> Result<([Worst; 2], usize), MotionError> {
        let n_h = self.system.info.n_position_rows;
        body_kind::normalize(&self.system.info.kinds, q);
        let before = self.worst_position(t, q);
        let (mut worst, mut passes, mut solved) = (before, 0, Solved::default());
        loop {
            let norm = worst.value;
            let residual = &self.system.residual[..n_h];
            if self.system.geometry.is_met(residual)
                || self.system.geometry.is_nearly_met(residual, q)
                    && (passes == MAX_PASSES && norm <= largest_left(q) || self.is_rounding(t, q, passes))
            {
                return Ok(([before, worst], passes));
            }
            if !norm.is_finite() {
                return Err(MotionError::NotFinite { t, quantity: "a position constraint".into() });
            }
            if passes == MAX_PASSES {
                if solved.is_rank_deficient && norm <= LARGEST_LEFT {
                    return Ok(([before, worst], passes));
                }
                let tolerance = self.system.geometry.position_tolerance(worst.row, self.system.geometry.extent(q));
                let tolerance = tolerance.min(largest_left(q));
                return Err(if solved.is_rank_deficient && self.independent_rows_are_met(t, q) {
                    self.system.diagnosis().disagreement(t, q, "the positions", norm, tolerance)
                } else {
                    let row = self.system.info.rows.item(worst.row).name;
                    MotionError::ProjectionStalled { t, residual: norm, row, passes, tolerance }
                });
            }
            solved = self.correct_positions(t, q, metric)?;
            passes += 1;
            worst = self.worst_position(t, q);
        }
    }

    /// Whether only redundant rows leave a part of the residual in the buffer: they contradict the others then.
    fn independent_rows_are_met(&mut self, t: f64, q: &[f64]) -> bool {
        let n_h = self.system.info.n_position_rows;
        let Some(rank) = self.system.at(t, q).rank(Independent::Above(INDEPENDENT)) else { return true };
        let rows: Vec<usize> = rank.independent_rows().iter().copied().filter(|row| *row < n_h).collect();
        let (extent, largest_left) = (self.system.geometry.extent(q), largest_left(q));
        let tolerance = |row| self.system.geometry.position_tolerance(row, extent).min(largest_left);
        rows.iter().all(|&row| self.system.residual[row].abs() <= tolerance(row))
    }

    /// Whether the residual in the buffer is met row by row but for what rounding of its own coordinates leaves: of each one, by its slope. Sine and
    /// cosine are rounded as 1 is. A rate of 1e4 rad/s makes large angles, but on short levers: these count as they are when x and y have taken
    /// of their rounding what they can.
    fn is_rounding(&mut self, t: f64, q: &[f64], passes: usize) -> bool {
        let System { scene, info, fixed, factors, residual, geometry, sines, .. } = &mut *self.system;
        let jacobian = factors.jacobian_at(scene, fixed, sines, t, q);
        let size = |column: usize| {
            let x = q[geometry.coordinate_of(column)].abs();
            match geometry.turns[column] {
                true if passes < PASSES_TO_ROUNDING => 1.0,
                true => x.max(1.0),
                false => x,
            }
        };
        residual[..info.n_position_rows].iter().enumerate().all(|(row, c)| {
            c.abs() <= geometry.position_tolerance(row, 0.0) || {
                let entries = jacobian[info.jacobian.row(row)].iter().zip(info.jacobian.columns_of(row));
                let sum: f64 = entries.map(|(g, column)| g.abs() * size(column)).sum();
                c.abs() <= 2.0 * f64::EPSILON * sum
            }
        })
    }

    /// One pass beyond the tolerance, for positions that are projected.
    pub(crate) fn polish_positions(&mut self, t: f64, q: &mut [f64]) -> Result<(), MotionError> {
        self.polish_positions_in(t, q, Metric::Mass)
    }

    fn polish_positions_in(&mut self, t: f64, q: &mut [f64], metric: Metric) -> Result<(), MotionError> {
        self.worst_position(t, q);
        self.correct_positions(t, q, metric).map(|_| ())
    }

    /// One pass, for the residual of the position constraints in the buffer.
    fn correct_positions(&mut self, t: f64, q: &mut [f64], metric: Metric) -> Result<Solved, MotionError> {
        let n_h = self.system.info.n_position_rows;
        self.system.residual[n_h..].fill(0.0);
        let solved = match metric {
            Metric::Mass => self.correct(t, q, metric, Rows::Held)?,
            Metric::Euclidean => self.correct_first(t, q, n_h)?,
        };
        body_kind::retract(&self.system.info.kinds, q, &self.system.factors.delta);
        Ok(solved)
    }

    /// [`System::project_velocities`], with the worst row before; leaves the correction in the buffer.
    #[inline]
    fn move_velocities(
        &mut self,
        t: f64,
        q: &[f64],
        v: &mut [f64],
        metric: Metric,
        next: Next,
    ) -> Result<(Worst, Solved), MotionError> {
        let accelerates =
            next.accelerates && metric == Metric::Mass && self.system.at_with(t, q, next.rows).may_eliminate();
        if accelerates && let Some(smallest) = self.eliminate_ahead(t, q, v) {
            let (residual, projected) = self.system.factors.ahead.velocities();
            self.system.factors.delta.iter_mut().zip(v).zip(projected).for_each(|((delta, v), projected)| {
                *delta = projected - *v;
                *v = *projected;
            });
            return Ok((Worst::of(residual), Solved::regular(smallest)));
        }
        let worst = self.worst_velocity(t, q, v);
        let solved = if accelerates {
            self.correct_by_factors(t, q, metric, next.rows)?
        } else {
            self.correct(t, q, metric, next.rows)?
        };
        self.system.diagnosis().check_velocities(t, q, v, solved)?;
        v.iter_mut().zip(&self.system.factors.delta).for_each(|(v, delta)| *v += delta);
        Ok((worst, solved))
    }

    /// The projected velocities and the accelerations there, by one elimination of the scene; what is found is kept. Returns the smallest
    /// pivot; none where one vanished.
    #[inline]
    fn eliminate_ahead(&mut self, t: f64, q: &[f64], v: &[f64]) -> Option<f64> {
        let System { scene, fixed, factors, counters, .. } = &mut *self.system;
        let pivots = scene.projected_accelerations(fixed, t, q, v, factors.ahead.begin());
        let smallest = counters.eliminated(pivots)?;
        factors.ahead.keep(t, q, smallest);
        Some(smallest)
    }

    /// Correction for the residual in the buffer, into the buffer.
    #[inline]
    pub(super) fn correct(&mut self, t: f64, q: &[f64], metric: Metric, rows: Rows) -> Result<Solved, MotionError> {
        if metric == Metric::Mass && self.system.at_with(t, q, rows).may_eliminate() {
            let System { scene, fixed, residual, factors, counters, .. } = &mut *self.system;
            let pivots = scene.correction(fixed, t, q, residual, &mut factors.delta);
            if let Some(smallest) = counters.eliminated(pivots) {
                return Ok(Solved::regular(smallest));
            }
        }
        self.correct_by_factors(t, q, metric, rows)
    }

    fn correct_by_factors(&mut self, t: f64, q: &[f64], metric: Metric, rows: Rows) -> Result<Solved, MotionError> {
        let mut residual = std::mem::take(&mut self.system.residual);
        let outcome = match metric {
            Metric::Mass => {
                let mut delta = std::mem::take(&mut self.system.factors.delta);
                let solved = self.system.at_with(t, q, rows).solve_correction(&mut residual, &mut delta);
                self.system.factors.delta = delta;
                solved
            }
            Metric::Euclidean => self.euclidean_correction(t, q, &residual),
        };
        self.system.residual = residual;
        outcome
    }

    /// The same for the first rows only, in the Euclidean metric.
    fn correct_first(&mut self, t: f64, q: &[f64], n_rows: usize) -> Result<Solved, MotionError> {
        let residual = std::mem::take(&mut self.system.residual);
        let outcome = self.euclidean_correction(t, q, &residual[..n_rows]);
        self.system.residual = residual;
        outcome
    }

    /// For the residual of the position constraints, or of all, into the buffer.
    pub(super) fn euclidean_correction(&mut self, t: f64, q: &[f64], residual: &[f64]) -> Result<Solved, MotionError> {
        self.system.counters.factorizations += 1;
        let System { scene, info, fixed, geometry, active, factors, euclidean, sines, .. } = &mut *self.system;
        factors.jacobian_at(scene, fixed, sines, t, q);
        let Factors { jacobian, delta, .. } = factors;
        let euclidean = Euclidean::of(euclidean, info, &geometry.units)?;
        let solved = euclidean.correction(jacobian, residual, active.off(), delta);
        solved.ok_or(MotionError::NotFinite { t, quantity: "the constraint Jacobian".into() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dynamics::system_of;
    use crate::dynamics::tests::linkage;
    use crate::linalg::Backend;

    crate::model! {
        /// A rod about a fixed point, and a stone far away that nothing holds.
        pub model RodAndStone {
            body rod { mass: 1, inertia: 1/12 }
            body stone { mass: 1, inertia: 1 }
            hinge A: ground(0, 0) ~ rod(-0.5, 0);
            start here { rod angle 0; stone at (0, 0) angle 0; at rest; }
            scene rests { start here; until 1 s; }
        }
    }

    crate::model! {
        /// A bead whose row has the slope of a cube.
        pub model Cube {
            body bead { mass: 1, inertia: 1 }
            constraint flat: bead.x * bead.x * bead.x = 0;
            start there { bead near at (1, 0) angle 0; at rest; }
            scene waits { start there; until 1 s; }
        }
    }

    crate::model! {
        /// The same beside a sled whose wheel is far out.
        pub model CubeAndSled {
            param far: m = 1;
            body bead { mass: 1, inertia: 1 }
            body sled { mass: 1, inertia: 1 }
            constraint flat: bead.x * bead.x * bead.x = 0;
            skate wheel: at sled(far, 0) along sled(1, 0);
            start there { bead near at (1, 0) angle 0; sled at (0, 0) angle 1; at rest; }
            scene waits { start there; until 1 s; }
        }
    }

    /// Ten passes from 0.2 m leave a residual of 4e-8, whatever the lever of another body is.
    #[test]
    fn analytic_row_that_comes_too_slowly_is_refused_beside_a_long_lever() {
        for far in [1.0, 1e20, -2e50] {
            let scene = cube_and_sled::Waits { far };
            let mut system = system_of(&scene, Backend::Auto).unwrap();
            let mut q = [0.2, 0.0, 0.0, 0.0, 0.0, 1.0];
            let stalled = system.project_positions(0.0, &mut q, Metric::Mass).unwrap_err();
            let MotionError::ProjectionStalled { residual, tolerance, .. } = stalled else {
                panic!("{far:e}: {stalled:?}")
            };
            let expected = (0.2 * (2.0_f64 / 3.0).powi(10)).powi(3);
            assert!(
                (residual / expected - 1.0).abs() <= 1e-12 && tolerance <= 1e-10,
                "{far:e}: {residual:e}, {tolerance:e}"
            );
        }
    }

    crate::model! {
        /// The same beside an arm whose hinge is far out.
        pub model CubeAndArm {
            param far: m = 1;
            body bead { mass: 1, inertia: 1 }
            body arm { mass: 1, inertia: 1 }
            constraint flat: bead.x * bead.x * bead.x = 0;
            hinge pin: ground(far, 0) ~ arm(far, 0);
            start there { bead near at (1, 0) angle 0; arm at (0, 0) angle 0; at rest; }
            scene waits { start there; until 1 s; }
        }
    }

    /// After a turn the sine of the arm's angle leaves 1e-16 of its lever in its row, which only that row may have.
    #[test]
    fn invariant_rounding_of_one_row_excuses_no_other() {
        for far in [1.0, 1e20] {
            let scene = cube_and_arm::Waits { far };
            let mut system = system_of(&scene, Backend::Auto).unwrap();
            let mut q = [0.2, 0.0, 0.0, 0.0, 0.0, std::f64::consts::TAU];
            let stalled = system.project_positions(0.0, &mut q, Metric::Mass).unwrap_err();
            assert!(
                matches!(stalled, MotionError::ProjectionStalled { passes: MAX_PASSES, .. }),
                "{far:e}: {stalled:?}"
            );
        }
    }

    /// A pass leaves 2/3 of x, ten of them of 0.02 m a residual of 4e-11: that would do for redundant rows, but there are none.
    #[test]
    fn analytic_independent_row_that_comes_too_slowly_is_refused() {
        let scene = cube::Waits::default();
        for metric in [Metric::Mass, Metric::Euclidean] {
            let mut system = system_of(&scene, Backend::Dense).unwrap();
            let mut q = [0.02, 0.0, 0.0];
            let stalled = system.project_positions(0.0, &mut q, metric).unwrap_err();
            let MotionError::ProjectionStalled { residual, passes, .. } = stalled else { panic!("{stalled:?}") };
            let expected = (0.02 * (2.0_f64 / 3.0).powi(10)).powi(3);
            assert!((residual / expected - 1.0).abs() <= 1e-12 && residual <= LARGEST_LEFT, "{residual:e}");
            assert_eq!(passes, MAX_PASSES);
        }
    }

    /// Newton's method: what one pass leaves is of the order of the square of the error.
    #[test]
    fn order_a_pass_squares_the_error_of_positions() {
        let scene = linkage::Turns::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let start = system.scene_start();
        let q = system.consistent_start(&start).unwrap().q;
        for error in [1e-3, 1e-6] {
            let mut moved: Vec<f64> = q.iter().enumerate().map(|(i, q)| q + error * (1.0 + i as f64).sin()).collect();
            assert!(system.position_residual(0.0, &moved) >= 0.1 * error);
            system.projector().polish_positions(0.0, &mut moved).unwrap();
            assert!(system.position_residual(0.0, &moved) <= 10.0 * error * error, "{error}");
        }
    }

    crate::model! {
        /// A rod of a tenth of a millimetre, a metre away.
        pub model ShortRod {
            body rod { mass: 1, inertia: 1e-9 }
            hinge A: ground(1, 0) ~ rod(-5e-5, 0);
            start here { rod angle 0; at rest; }
            scene hangs { start here; until 1 s; }
        }
    }

    /// The row has 1e-12 of its size within 5e-17 m, and x the rounding of 1 m. What is more is taken away.
    #[test]
    fn invariant_rounding_of_a_place_that_is_far_away_takes_no_pass() {
        let scene = short_rod::Hangs::default();
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        for i in 0..100 {
            let phi = 0.1 * f64::from(i);
            let there = [1.0 + 5e-5 * phi.cos(), 5e-5 * phi.sin(), phi];
            let mut q = there;
            assert_eq!(system.project_positions(0.0, &mut q, Metric::Mass).unwrap(), 0, "{phi}");
            assert_eq!(q, there);
            q[0] += 1e-9;
            assert!(system.project_positions(0.0, &mut q, Metric::Mass).unwrap() > 0, "{phi}");
            assert!(system.position_residual(0.0, &q) <= 2.0 * f64::EPSILON, "{phi}");
        }
    }

    /// The stone 1e8 m away allows hinges to be 1.8e-7 m off, but rounding of the rod's own coordinates is less than 1e-15 m.
    #[test]
    fn invariant_rod_is_projected_as_well_beside_a_stone_that_is_far_away() {
        let scene = rod_and_stone::Rests::default();
        for error in [0.1, 0.2, 0.3, 0.5, 0.7, 1.0] {
            let residuals = [0.0, 1e8].map(|x| {
                let mut system = system_of(&scene, Backend::Auto).unwrap();
                let mut q = [0.5, 0.0, error, x, 0.0, 0.0];
                let passes = system.project_positions(0.0, &mut q, Metric::Mass).unwrap();
                (system.position_residual(0.0, &q), passes)
            });
            assert!(residuals[0].0 <= 1e-12 && residuals[1] == residuals[0], "{error} {residuals:?}");
        }
    }
}
