//! Accelerations and multipliers; corrections with the same matrix.

use super::configuration::Configuration;
use super::factors::Solver;
use super::solved::{Rows, Solved};
use super::tolerances::geometry::TOLERANCE;
use super::{Metric, MotionError, System};
use crate::linalg::{EquationResidual, INDEPENDENT_EXACTLY, Independent, LARGEST_DIAGNOSED, weights, write_diagonal};
use crate::model::{Equations as _, Pivots, SceneRef, Series, SeriesStore};
use std::sync::Arc;

impl<P: SceneRef> Configuration<'_, P> {
    /// Accelerations and multipliers at velocities `v` (`n_q`), as [`System::accelerations`] but not verified.
    ///
    /// # Errors
    /// [`MotionError`] when a number is not finite or nothing moves a coordinate; `a` and `lambda` are then unspecified.
    #[inline]
    pub(crate) fn accelerations(
        &mut self,
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<Solved, MotionError> {
        if self.may_eliminate() {
            let found = match self.system.factors.ahead.accelerations(self.t, self.q, v) {
                Some((smallest, solution)) => {
                    let (of_coordinates, of_rows) = solution.split_at(a.len());
                    a.copy_from_slice(of_coordinates);
                    lambda.copy_from_slice(of_rows);
                    self.system.counters.evaluations += 1;
                    Some(smallest)
                }
                None => self.system.eliminate_accelerations(self.t, self.q, v, a, lambda),
            };
            if let Some(smallest) = found {
                return Ok(Solved::regular(smallest));
            }
        }
        self.solve_accelerations(v, a, lambda)
    }

    /// The same by factors of K.
    fn solve_accelerations(&mut self, v: &[f64], a: &mut [f64], lambda: &mut [f64]) -> Result<Solved, MotionError> {
        self.system.counters.evaluations += 1;
        self.factor()?;
        self.write_right_side(v);
        let solved = self.solve_in_buffer();
        self.read_solution(a, lambda);
        Ok(solved)
    }

    /// The smallest `delta` (`n_q`) in the mass matrix with `G delta = −residual` (`n_c`).
    ///
    /// # Errors
    /// As [`Self::accelerations`].
    pub(crate) fn correction(&mut self, residual: &[f64], delta: &mut [f64]) -> Result<Solved, MotionError> {
        if self.may_eliminate()
            && let Some(smallest) = self.system.eliminate_correction(self.t, self.q, residual, delta)
        {
            return Ok(Solved::regular(smallest));
        }
        self.solve_correction(residual, delta)
    }

    /// The same by factors of K.
    pub(super) fn solve_correction(&mut self, residual: &[f64], delta: &mut [f64]) -> Result<Solved, MotionError> {
        self.factor()?;
        let right_side = &mut self.system.factors.right_side;
        right_side[..delta.len()].fill(0.0);
        right_side[delta.len()..].iter_mut().zip(residual).for_each(|(x, r)| *x = -r);
        let solved = self.solve_in_buffer();
        delta.copy_from_slice(&self.system.factors.right_side[..delta.len()]);
        Ok(solved)
    }

    /// `[F; −[h; s]]` into the buffer.
    fn write_right_side(&mut self, v: &[f64]) {
        let System { scene, fixed, factors, .. } = &mut *self.system;
        let (F, gamma) = factors.right_side.split_at_mut(v.len());
        scene.applied_force(fixed, self.t, self.q, v, F);
        scene.convective_term(fixed, self.t, self.q, v, gamma);
        gamma.iter_mut().for_each(|h| *h = -*h);
    }

    fn read_solution(&self, a: &mut [f64], lambda: &mut [f64]) {
        let (solved_a, solved_lambda) = self.system.factors.right_side.split_at(a.len());
        a.copy_from_slice(solved_a);
        lambda.copy_from_slice(solved_lambda);
    }

    /// Puts accelerations that were not eliminated, and that stand in the buffer, into the equations.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`], [`MotionError::ContradictoryRows`], [`MotionError::LostInRounding`].
    fn verify(&mut self, v: &[f64], solved: Solved) -> Result<(), MotionError> {
        let (t, q, info) = (self.t, self.q, Arc::clone(&self.system.info));
        let solution = self.system.factors.right_side.clone();
        self.write_right_side(v);
        let System { mass, factors, .. } = &*self.system;
        let weight = weights(mass);
        let mut diagonal = vec![0.0; info.n_rows()];
        write_diagonal(info.jacobian.entries(), &weight, &factors.jacobian, &mut diagonal);
        let mut equations = EquationResidual::new(info.n_velocities(), info.n_rows(), &info.jacobian);
        equations.write(mass, &factors.jacobian, &factors.right_side, &solution);
        let left = equations.share_of_what_matters(&weight, &diagonal);
        if left <= TOLERANCE {
            return Ok(());
        }
        if left.is_nan() {
            return Err(MotionError::NotFinite { t, quantity: "an acceleration or a multiplier".into() });
        }
        self.system.diagnosis().check_accelerations(t, q, solved)?;
        let smallest_pivot = self.system.diagnosis().independence(t, q);
        let rank = self.system.rank_at(t, q, Independent::Above(INDEPENDENT_EXACTLY));
        let found = rank.map(|rank| rank.dependencies()).filter(|found| found.n > 0);
        Err(MotionError::LostInRounding {
            t,
            smallest_pivot: found.as_ref().and(smallest_pivot),
            rows: found.iter().flat_map(|found| &found.rows).map(|&i| info.rows[i].name.clone()).collect(),
            residual: left,
        })
    }
}

impl<P: SceneRef> System<P> {
    /// Accelerations and multipliers at one state: solves `[M Gᵀ; G 0] [a; λ] = [F; −[h; s]]`.
    ///
    /// | name | shape | unit |
    /// |---|---|---|
    /// | `q`, `v` | `n_q` | m, rad; m/s, rad/s |
    /// | `a` (written) | `n_q` | m/s², rad/s² |
    /// | `lambda` (written) | `n_c` | N, N·m |
    ///
    /// # Errors
    /// [`MotionError`] when a number is not finite, nothing moves a coordinate, rows contradict each other or the matrix is too
    /// ill-conditioned for a correct digit; `a` and `lambda` are then unspecified.
    /// Redundant rows that agree are no error: `a` is unique, `lambda` the smallest that belongs to it (each in units of its
    /// row, scaled to one). What comes from factors of K leaves at most 1e-12 of the terms of each equation; above 500 equations
    /// that is verified only where rows are redundant.
    /// # Cost
    /// One factorisation and one solve; where a pivot of the generated elimination vanishes, a pivoted factorisation besides.
    /// To verify a solution, it is put into the equations once, which allocates.
    pub fn accelerations(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<Solved, MotionError> {
        let mut at = self.at(t, q);
        let solved = at.accelerations(v, a, lambda)?;
        let n = at.system.info.n_unknowns();
        // what the elimination gives is taken as it is, and large systems of full rank
        if !at.may_eliminate() && (n <= LARGEST_DIAGNOSED || solved.is_rank_deficient) {
            at.verify(v, solved)?;
        }
        Ok(solved)
    }

    /// As [`System::accelerations`] within a run, not verified: where constraints nearly depend on each other, what they differ by is
    /// rounding of a state that was projected onto them. [`System::check_accelerations`] tells when it is more than that.
    ///
    /// # Errors
    /// As [`System::accelerations`], but for rows that contradict each other.
    #[inline]
    pub(crate) fn accelerations_unchecked(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
        rows: Rows,
    ) -> Result<Solved, MotionError> {
        self.at_with(t, q, rows).accelerations(v, a, lambda)
    }

    /// [`System::accelerations_unchecked`] of a stage of a step.
    #[inline]
    pub(super) fn accelerations_of_stage(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), MotionError> {
        if self.uses_elimination()
            && !self.active.leaves_out_redundant()
            && self.eliminate_accelerations(t, q, v, a, lambda).is_some()
        {
            return Ok(());
        }
        self.at_with(t, q, Rows::Held).solve_accelerations(v, a, lambda).map(|_| ())
    }

    /// By the elimination of the scene: its smallest pivot; none where one vanished.
    #[inline]
    fn eliminate_accelerations(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Option<f64> {
        let pivots = self.scene.accelerations(&self.fixed, t, q, v, a, lambda);
        self.counters.evaluations += 1;
        self.eliminated(pivots)
    }

    /// As [`System::eliminate_accelerations`] at the projected velocities, which are found first; what is found is kept.
    #[inline]
    pub(super) fn eliminate_ahead(&mut self, t: f64, q: &[f64], v: &[f64]) -> Option<f64> {
        let Self { scene, fixed, factors, .. } = self;
        let pivots = scene.projected_accelerations(fixed, t, q, v, factors.ahead.begin());
        let smallest = self.eliminated(pivots)?;
        self.factors.ahead.keep(t, q, smallest);
        Some(smallest)
    }

    #[inline]
    fn eliminate_correction(&mut self, t: f64, q: &[f64], residual: &[f64], delta: &mut [f64]) -> Option<f64> {
        let pivots = self.scene.correction(&self.fixed, t, q, residual, delta);
        self.eliminated(pivots)
    }

    /// Takes note of an elimination.
    #[inline]
    pub(super) fn eliminated(&mut self, pivots: Pivots) -> Option<f64> {
        self.counters.factorizations += 1;
        let smallest = pivots.smallest();
        self.least_pivot = self.least_pivot.min(smallest);
        pivots.all_keep().then_some(smallest)
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
    ) -> Result<Solved, MotionError> {
        match metric {
            Metric::Mass => self.at_with(t, q, Rows::Projected).correction(residual, delta),
            Metric::Euclidean => self.projector().euclidean_correction(t, q, residual, delta),
        }
    }

    /// Begins a series from orders 0 and 1 of q in `store` ([`Series::begin`]). Where the scene's own elimination can solve for
    /// it, returns the smallest pivot; else K is factored, for [`System::solve_factored`].
    ///
    /// # Errors
    /// As [`System::accelerations`].
    #[inline]
    pub(crate) fn begin_series(
        &mut self,
        series: &dyn Series<f64>,
        t: f64,
        store: &mut SeriesStore<f64>,
    ) -> Result<Option<f64>, MotionError> {
        self.counters.evaluations += 1;
        let (pivots, n_q) = (series.begin(&self.fixed, t, store), self.info.n_coordinates());
        let (q, rows) = (&store.q[..n_q], Rows::Projected);
        if self.uses_elimination()
            && !self.factors.are_of(t, q, rows)
            && let Some(smallest) = self.eliminated(pivots)
        {
            return Ok(Some(smallest));
        }
        self.at_with(t, q, rows).factor().map(|()| None)
    }

    /// Factors K at one state, for [`System::solve_factored`].
    ///
    /// # Errors
    /// As [`System::accelerations`].
    pub(crate) fn factorize(&mut self, t: f64, q: &[f64]) -> Result<(), MotionError> {
        self.at_with(t, q, Rows::Projected).factor()
    }

    /// Whether the scene's own elimination solves, as long as no pivot vanishes.
    pub fn uses_elimination(&self) -> bool {
        matches!(self.solver, Solver::Generated)
    }

    /// Solves `[M Gᵀ; G 0] [a; λ] = [force; row]` with the factors that were made last, by [`System::factorize`] or
    /// [`System::begin_series`].
    pub(crate) fn solve_factored(&mut self, force: &[f64], row: &[f64], a: &mut [f64], lambda: &mut [f64]) -> Solved {
        let right_side = &mut self.factors.right_side;
        right_side[..force.len()].copy_from_slice(force);
        right_side[force.len()..].copy_from_slice(row);
        let mut at = self.at(f64::NAN, &[]);
        let solved = at.solve_in_buffer();
        at.read_solution(a, lambda);
        solved
    }

    /// Projects `x` (`n_q`) onto the null space of G, in the mass matrix: G x = 0 afterwards.
    ///
    /// # Errors
    /// As [`System::accelerations`].
    /// # Cost
    /// One correction; no allocation.
    pub(crate) fn project_onto_null_space(&mut self, t: f64, q: &[f64], x: &mut [f64]) -> Result<(), MotionError> {
        self.buffers.residual.fill(0.0);
        self.remove_residual_from(t, q, x)
    }

    /// Smallest pivot, as in [`Solved`], of the rows that a step goes on with, at positions that no row has to hold; zero where they
    /// depend on each other.
    pub(crate) fn pivot_at(&mut self, t: f64, q: &[f64]) -> f64 {
        let least = self.least_pivot;
        let at = self.at_with(t, q, Rows::Held);
        let pivot = if at.may_eliminate() {
            let System { scene, fixed, buffers, .. } = &mut *at.system;
            buffers.residual.fill(0.0);
            let pivots = scene.correction(fixed, t, q, &buffers.residual, &mut buffers.delta);
            at.system.eliminated(pivots).unwrap_or(0.0)
        } else {
            self.pivot_of_rows(t, q).unwrap_or_else(|| self.at_with(t, q, Rows::Projected).factored_pivot())
        };
        self.least_pivot = least;
        pivot
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
        self.scene.convective_term(&self.fixed, t, q, v, &mut self.buffers.residual);
        self.remove_residual_from(t, q, a)
    }

    /// Corrects `x` so that `G x` plus what stands in the buffer of residuals is zero.
    fn remove_residual_from(&mut self, t: f64, q: &[f64], x: &mut [f64]) -> Result<(), MotionError> {
        let Self { scene, info, fixed, buffers, .. } = self;
        scene.velocity_jacobian(fixed, t, q, &mut buffers.jacobian);
        for (k, row, column) in info.jacobian.entries() {
            buffers.residual[row] += buffers.jacobian[k] * x[column];
        }
        self.projector().correct(t, q, Metric::Mass, Rows::Projected)?;
        x.iter_mut().zip(&self.buffers.delta).for_each(|(x, delta)| *x += delta);
        Ok(())
    }
}
