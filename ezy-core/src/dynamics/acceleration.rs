//! Accelerations and multipliers; corrections with the same matrix.

use super::deficient::{Rank, Threshold};
use super::system::Solver;
use super::{Metric, MotionError, System};
use crate::linalg::{ConditionEstimator, Conditioning};
use crate::model::{Pivots, Scene, Series, SeriesStore};

impl<S: Scene + ?Sized> System<'_, S> {
    /// Accelerations and multipliers at one state: solves `[M Gᵀ; G 0] [a; λ] = [F; −[h; s]]`.
    ///
    /// | name | shape | unit |
    /// |---|---|---|
    /// | `q`, `v` | `n_q` | m, rad; m/s, rad/s |
    /// | `a` (written) | `n_q` | m/s², rad/s² |
    /// | `lambda` (written) | `n_c` | N, N·m |
    ///
    /// # Errors
    /// [`MotionError`] when a number is not finite, nothing moves a coordinate, rows contradict each other or the numbers of
    /// the scene are too far apart for what they decide to be told from rounding; `a` and `lambda` are then unspecified.
    /// Rows that depend on each other and agree are no error: `a` is unique, `lambda` the smallest that belongs to it (each
    /// in units of the root of its entry of `G M⁻¹ Gᵀ`), and [`System::lost_rank`] tells. Where rank is in doubt, what is
    /// returned leaves at most 1e-12 of the terms of each equation.
    /// # Cost
    /// One factorisation and one solve. Where a pivot of the generated elimination vanishes, a pivoted factorisation
    /// besides, which decides, and where rows depend on each other one more; where these nearly do, one with complete
    /// pivoting. What does not come from the elimination is put into the equations once. No allocation but for the first of
    /// those.
    pub fn accelerations(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), MotionError> {
        if self.eliminate_accelerations(t, q, v, a, lambda) {
            return Ok(());
        }
        self.factor_accelerations(t, q, v, a, lambda)?;
        self.settle_accelerations(t, q, v, a, lambda)
    }

    /// As [`System::accelerations`] within a run: where rows nearly depend on each other, what they differ by is rounding of
    /// a state that was projected onto them, and is left. [`System::check_accelerations`] tells when it is more than that.
    ///
    /// # Errors
    /// As [`System::accelerations`], but for rows that contradict each other.
    pub(crate) fn accelerations_in_passing(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), MotionError> {
        match self.eliminate_accelerations(t, q, v, a, lambda) {
            true => Ok(()),
            false => self.factor_accelerations(t, q, v, a, lambda),
        }
    }

    /// By the elimination of the scene; false where there is none or a pivot vanishes.
    fn eliminate_accelerations(&mut self, t: f64, q: &[f64], v: &[f64], a: &mut [f64], lambda: &mut [f64]) -> bool {
        self.counters.evaluations += 1;
        self.counters.factorizations += 1;
        self.uses_elimination() && self.kept(self.scene.accelerations(&self.fixed, t, q, v, a, lambda))
    }

    fn factor_accelerations(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), MotionError> {
        self.factor(t, q, Threshold::Motion)?;
        self.write_right_side(t, q, v);
        self.solve_in_buffer();
        self.read_solution(a, lambda);
        Ok(())
    }

    pub(super) fn read_solution(&self, a: &mut [f64], lambda: &mut [f64]) {
        let (solved_a, solved_lambda) = self.buffers.right_side.split_at(a.len());
        a.copy_from_slice(solved_a);
        lambda.copy_from_slice(solved_lambda);
    }

    /// `[F; −[h; s]]` into the buffer.
    pub(super) fn write_right_side(&mut self, t: f64, q: &[f64], v: &[f64]) {
        let (scene, c) = (self.scene, &self.fixed);
        let (F, gamma) = self.buffers.right_side.split_at_mut(q.len());
        scene.applied_force(c, t, q, v, F);
        scene.convective_term(c, t, q, v, gamma);
        gamma.iter_mut().for_each(|h| *h = -*h);
    }

    /// The smallest `delta` (`n_q`) with `G(q, t) delta = −residual` (`n_c`), smallest in the mass matrix or, with
    /// [`Metric::Euclidean`], in plain numbers.
    ///
    /// # Errors
    /// As [`System::accelerations`].
    /// # Cost
    /// One factorisation and one solve; no allocation but for the first Euclidean correction.
    pub fn correction(
        &mut self,
        t: f64,
        q: &[f64],
        residual: &[f64],
        metric: Metric,
        delta: &mut [f64],
    ) -> Result<(), MotionError> {
        self.correction_from(t, q, residual, metric, Threshold::Motion, delta)
    }

    pub(super) fn correction_from(
        &mut self,
        t: f64,
        q: &[f64],
        residual: &[f64],
        metric: Metric,
        threshold: Threshold,
        delta: &mut [f64],
    ) -> Result<(), MotionError> {
        self.counters.factorizations += 1;
        if metric == Metric::Euclidean {
            return self.euclidean_correction(t, q, residual, threshold, delta);
        }
        if self.uses_elimination() && self.kept(self.scene.correction(&self.fixed, t, q, residual, delta)) {
            return Ok(());
        }
        self.factor(t, q, threshold)?;
        let right_side = &mut self.buffers.right_side;
        right_side[..q.len()].fill(0.0);
        right_side[q.len()..].iter_mut().zip(residual).for_each(|(x, r)| *x = -r);
        self.solve_in_buffer();
        delta.copy_from_slice(&self.buffers.right_side[..q.len()]);
        Ok(())
    }

    /// Begins a series from orders 0 and 1 of q in `store` ([`Series::begin`]); true when the scene's own elimination can
    /// solve for it. Otherwise K is factored, for [`System::solve_factored`].
    ///
    /// # Errors
    /// As [`System::accelerations`].
    pub(crate) fn begin_series(
        &mut self,
        series: &dyn Series<f64>,
        t: f64,
        store: &mut SeriesStore<f64>,
    ) -> Result<bool, MotionError> {
        self.counters.evaluations += 1;
        self.counters.factorizations += 1;
        let pivots = series.begin(&self.fixed, t, store);
        if self.uses_elimination() && self.kept(pivots) {
            return Ok(true);
        }
        self.factorize(t, &store.q[..self.info.n_coordinates()]).map(|()| false)
    }

    /// Whether the elimination found what it was to find.
    #[inline]
    fn kept(&mut self, pivots: Pivots) -> bool {
        self.see_pivot(pivots.smallest());
        if !pivots.all_keep() {
            return false;
        }
        self.rank = Rank::default();
        true
    }

    /// Factors K at one state, for [`System::solve_factored`].
    ///
    /// # Errors
    /// As [`System::accelerations`].
    pub(crate) fn factorize(&mut self, t: f64, q: &[f64]) -> Result<(), MotionError> {
        self.factor(t, q, Threshold::Motion)
    }

    /// Whether the scene's own elimination solves, as long as no pivot vanishes.
    pub fn uses_elimination(&self) -> bool {
        matches!(self.solver, Solver::Generated)
    }

    /// Solves `[M Gᵀ; G 0] [a; λ] = [force; row]` with the factors of [`System::factorize`].
    pub(crate) fn solve_factored(&mut self, force: &[f64], row: &[f64], a: &mut [f64], lambda: &mut [f64]) {
        let right_side = &mut self.buffers.right_side;
        right_side[..force.len()].copy_from_slice(force);
        right_side[force.len()..].copy_from_slice(row);
        self.solve_in_buffer();
        self.read_solution(a, lambda);
    }

    /// Takes from `x` (`n_q`) its part across the rows, in the mass matrix: G x = 0 afterwards.
    ///
    /// # Errors
    /// As [`System::accelerations`].
    /// # Cost
    /// One correction; no allocation.
    pub(crate) fn make_tangential(&mut self, t: f64, q: &[f64], x: &mut [f64]) -> Result<(), MotionError> {
        self.buffers.residual.fill(0.0);
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        self.take_residual_from(t, q, x)
    }

    /// [`System::smallest_pivot`] at positions that no row has to hold.
    ///
    /// # Cost
    /// One correction; no allocation.
    pub(crate) fn pivot_at(&mut self, t: f64, q: &[f64]) -> f64 {
        let seen = self.least_pivot;
        let mut residual = std::mem::take(&mut self.buffers.residual);
        let mut delta = std::mem::take(&mut self.buffers.delta);
        residual.fill(0.0);
        let outcome = self.correction(t, q, &residual, Metric::Mass, &mut delta);
        self.buffers.residual = residual;
        self.buffers.delta = delta;
        self.least_pivot = seen;
        if outcome.is_ok() { self.smallest_pivot } else { 0.0 }
    }

    /// How well K can be solved with at a state, by an estimator for this scene.
    pub(crate) fn conditioning(&mut self, t: f64, q: &[f64], estimator: &mut ConditionEstimator) -> Conditioning {
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        estimator.estimate(&self.mass, &self.info.jacobian, &self.buffers.jacobian)
    }

    /// Removes from accelerations `a` what rounding left of `G a + [h; s]`, by one correction in the mass matrix.
    ///
    /// The elimination finds the multipliers to their last digits and divides by masses: a bar of 0.005 kg·m² under
    /// reactions of 10 N keeps 1e-13 rad/s². Reading the light coordinates off the rows instead keeps 1e-15.
    ///
    /// # Errors
    /// As [`System::accelerations`].
    /// # Cost
    /// One correction; no allocation.
    pub(crate) fn refine_accelerations(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
    ) -> Result<(), MotionError> {
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        self.scene.convective_term(&self.fixed, t, q, v, &mut self.buffers.residual);
        self.take_residual_from(t, q, a)
    }

    /// Corrects `x` so that `G x` plus what stands in the buffer of residuals is zero, with G in its buffer.
    fn take_residual_from(&mut self, t: f64, q: &[f64], x: &mut [f64]) -> Result<(), MotionError> {
        let mut residual = std::mem::take(&mut self.buffers.residual);
        let mut delta = std::mem::take(&mut self.buffers.delta);
        for (k, row, column) in self.info.jacobian.entries() {
            residual[row] += self.buffers.jacobian[k] * x[column];
        }
        let outcome = self.correction(t, q, &residual, Metric::Mass, &mut delta);
        if outcome.is_ok() {
            x.iter_mut().zip(&delta).for_each(|(x, delta)| *x += delta);
        }
        self.buffers.residual = residual;
        self.buffers.delta = delta;
        outcome
    }
}
