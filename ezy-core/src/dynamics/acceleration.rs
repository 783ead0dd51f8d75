//! Accelerations and multipliers; corrections with the same matrix.

use super::configuration::Configuration;
use super::factors::Solver;
use super::solved::{Rows, Solved};
use super::tolerances::geometry::TOLERANCE;
use super::{Metric, MotionError, System};
use crate::linalg::{EquationResidual, INDEPENDENT_EXACTLY, Independent, LARGEST_DIAGNOSED, weights, write_diagonal};
use crate::model::{Equations as _, SceneRef, Series, SeriesStore};
use std::sync::Arc;

impl<'c, P: SceneRef> Configuration<'c, P> {
    /// Accelerations and multipliers at velocities `v` (`n_v`), as [`System::accelerations`] but not verified: where constraints nearly
    /// depend on each other, what they differ by is rounding of a state that was projected onto them.
    /// [`Diagnosis::check_accelerations`](super::diagnosis::Diagnosis::check_accelerations) tells when it is more than that.
    ///
    /// # Errors
    /// [`MotionError`] when a number is not finite or nothing moves a coordinate; `a` and `lambda` are then unspecified.
    /// # Cost
    /// One run of the elimination of the scene, or one factorisation and one solve; no allocation.
    #[inline]
    pub(crate) fn accelerations(
        &mut self,
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<Solved, MotionError> {
        if self.may_eliminate() {
            let System { scene, fixed, factors, counters, .. } = &mut *self.system;
            counters.evaluations += 1;
            let smallest = match factors.ahead.accelerations(self.t, self.q, v) {
                Some((smallest, solution)) => {
                    let (of_coordinates, of_rows) = solution.split_at(a.len());
                    a.copy_from_slice(of_coordinates);
                    lambda.copy_from_slice(of_rows);
                    Some(smallest)
                }
                None => counters.eliminated(scene.accelerations(fixed, self.t, self.q, v, a, lambda)),
            };
            if let Some(smallest) = smallest {
                return Ok(Solved::regular(smallest));
            }
        }
        self.solve_accelerations(v, a, lambda)
    }

    /// The same by factors of K.
    fn solve_accelerations(&mut self, v: &[f64], a: &mut [f64], lambda: &mut [f64]) -> Result<Solved, MotionError> {
        self.system.counters.evaluations += 1;
        self.write_right_side(v, a, lambda);
        self.factor_and_solve(a, lambda)
    }

    /// The smallest `delta` (`n_q`) in the mass matrix with `G delta = −residual` (`n_c`).
    ///
    /// # Errors
    /// As [`Self::accelerations`].
    pub(crate) fn correction(&mut self, residual: &[f64], delta: &mut [f64]) -> Result<Solved, MotionError> {
        if self.may_eliminate() {
            let System { scene, fixed, counters, .. } = &mut *self.system;
            if let Some(smallest) = counters.eliminated(scene.correction(fixed, self.t, self.q, residual, delta)) {
                return Ok(Solved::regular(smallest));
            }
        }
        let mut rows = std::mem::take(&mut self.system.residual);
        rows.copy_from_slice(residual);
        let solved = self.solve_correction(&mut rows, delta);
        self.system.residual = rows;
        solved
    }

    /// The same by factors of K; the residual is lost.
    pub(super) fn solve_correction(&mut self, residual: &mut [f64], delta: &mut [f64]) -> Result<Solved, MotionError> {
        delta.fill(0.0);
        residual.iter_mut().for_each(|r| *r = -*r);
        self.factor_and_solve(delta, residual)
    }

    /// F and `−[h; s]`.
    pub(super) fn write_right_side(&mut self, v: &[f64], F: &mut [f64], gamma: &mut [f64]) {
        let System { scene, fixed, sines, .. } = &mut *self.system;
        let sines = sines.at(self.q);
        scene.applied_force_with_sines(fixed, self.t, self.q, v, sines, F);
        scene.convective_term_with_sines(fixed, self.t, self.q, v, sines, gamma);
        gamma.iter_mut().for_each(|h| *h = -*h);
    }

    /// Puts accelerations that were not eliminated into the equations.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`], [`MotionError::ContradictoryRows`], [`MotionError::LostInRounding`].
    fn verify(&mut self, v: &[f64], a: &[f64], lambda: &[f64], solved: Solved) -> Result<(), MotionError> {
        let (t, q, info) = (self.t, self.q, Arc::clone(&self.system.info));
        let solution = [a, lambda].concat();
        let mut right_side = vec![0.0; solution.len()];
        let (r, s) = right_side.split_at_mut(a.len());
        self.write_right_side(v, r, s);
        let System { mass, factors, .. } = &*self.system;
        let weight = weights(mass);
        let mut diagonal = vec![0.0; info.n_rows()];
        write_diagonal(info.jacobian.entries(), &weight, &factors.jacobian, &mut diagonal);
        let mut equations = EquationResidual::new(info.n_velocities(), info.n_rows(), &info.jacobian);
        equations.write(mass, &factors.jacobian, &right_side, &solution);
        let left = equations.share_of_what_matters(&weight, &diagonal);
        if left <= TOLERANCE {
            return Ok(());
        }
        if left.is_nan() {
            return Err(MotionError::NotFinite { t, quantity: "an acceleration or a multiplier".into() });
        }
        self.system.diagnosis().check_accelerations(t, q, solved)?;
        let smallest_pivot = self.system.diagnosis().independence(t, q);
        let rank = self.system.at(t, q).rank(Independent::Above(INDEPENDENT_EXACTLY));
        let found = rank.map(|rank| rank.dependencies()).filter(|found| found.n > 0);
        Err(MotionError::LostInRounding {
            t,
            smallest_pivot: found.as_ref().and(smallest_pivot),
            rows: found.iter().flat_map(|found| &found.rows).map(|&i| info.rows[i].name.clone()).collect(),
            residual: left,
        })
    }

    /// Begins a series from orders 0 and 1 of q in `store` ([`Series::begin`]), which are those of this configuration. Where the scene's own
    /// elimination can solve for it, returns the smallest pivot; else K is factored, for [`Self::solve`].
    ///
    /// # Errors
    /// As [`Self::accelerations`].
    #[inline]
    pub(crate) fn begin_series(
        &mut self,
        series: &dyn Series<f64>,
        store: &mut SeriesStore<f64>,
    ) -> Result<Option<f64>, MotionError> {
        self.system.counters.evaluations += 1;
        let pivots = series.begin(&self.system.fixed, self.t, store);
        if self.may_eliminate()
            && let Some(smallest) = self.system.counters.eliminated(pivots)
        {
            return Ok(Some(smallest));
        }
        self.factor().map(|()| None)
    }

    /// Solves `[M Gᵀ; G 0] [a; λ] = [force; row]` with the factors that [`Self::factor`] or [`Self::begin_series`] made here.
    pub(crate) fn solve(&mut self, force: &[f64], row: &[f64], a: &mut [f64], lambda: &mut [f64]) -> Solved {
        a.copy_from_slice(force);
        lambda.copy_from_slice(row);
        self.solve_by_factors(a, lambda)
    }

    /// Projects `x` (`n_v`) onto the null space of G, in the mass matrix: G x = 0 afterwards.
    ///
    /// # Errors
    /// As [`Self::accelerations`].
    /// # Cost
    /// One correction; no allocation.
    pub(crate) fn project_onto_null_space(&mut self, x: &mut [f64]) -> Result<(), MotionError> {
        self.system.residual.fill(0.0);
        self.find_correction(x)?;
        x.iter_mut().zip(&self.system.factors.delta).for_each(|(x, delta)| *x += delta);
        Ok(())
    }

    /// Accelerations `a` at velocities `v` without what rounding left of `G a + [h; s]`, by one correction in the mass matrix; as they are where that
    /// fails.
    ///
    /// The elimination finds the multipliers to their last digits and divides by masses: a bar of 0.005 kg·m² under
    /// reactions of 10 N keeps 1e-13 rad/s². Reading the light coordinates off the rows instead keeps 1e-15.
    ///
    /// # Cost
    /// One correction; no allocation.
    pub(crate) fn refined_accelerations(mut self, v: &[f64], a: &[f64]) -> &'c [f64] {
        let System { scene, fixed, residual, sines, .. } = &mut *self.system;
        scene.convective_term_with_sines(fixed, self.t, self.q, v, sines.at(self.q), residual);
        let found = self.find_correction(a);
        let delta = &mut self.system.factors.delta;
        if found.is_err() {
            delta.fill(0.0);
        }
        delta.iter_mut().zip(a).for_each(|(delta, a)| *delta += a);
        delta
    }

    /// The correction of `x` after which `G x` plus what stands in the buffer of residuals is zero, into the buffer.
    fn find_correction(&mut self, x: &[f64]) -> Result<Solved, MotionError> {
        let System { scene, info, fixed, factors, residual, sines, .. } = &mut *self.system;
        let jacobian = factors.jacobian_at(scene, fixed, sines, self.t, self.q);
        for (k, row, column) in info.jacobian.entries() {
            residual[row] += jacobian[k] * x[column];
        }
        self.system.projector().correct(self.t, self.q, Metric::Mass, self.rows)
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
            at.verify(v, a, lambda, solved)?;
        }
        Ok(solved)
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
            Metric::Euclidean => {
                let solved = self.projector().euclidean_correction(t, q, residual)?;
                delta.copy_from_slice(&self.factors.delta);
                Ok(solved)
            }
        }
    }

    /// Whether the scene's own elimination solves, as long as no pivot vanishes.
    pub fn uses_elimination(&self) -> bool {
        matches!(self.solver, Solver::Generated)
    }
}
