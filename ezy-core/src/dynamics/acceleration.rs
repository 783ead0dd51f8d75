//! Accelerations and multipliers; corrections with the same matrix.

use super::projection::Euclidean;
use super::system::Solver;
use super::{Metric, MotionError, System};
use crate::linalg::{ConditionEstimator, Conditioning, DenseKkt, KktFactorization, LARGEST_DIAGNOSED, diagnose};
use crate::model::{Scene, SceneInfo, Series, SeriesStore};

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
    /// [`MotionError`] when K is singular, with the rows or coordinates to blame; `a` and `lambda` are then
    /// unspecified.
    /// # Cost
    /// One factorisation and one solve. Where a pivot of the generated elimination vanishes, a pivoted factorisation
    /// besides, which decides. No allocation but for the first of those.
    pub fn accelerations(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), MotionError> {
        self.counters.evaluations += 1;
        self.counters.factorizations += 1;
        let regular = match self.solver {
            Solver::Generated => {
                self.scene.accelerations(&self.fixed, t, q, v, a, lambda).none()
                    || self.factored_accelerations(t, q, v, a, lambda)
            }
            Solver::Factored(_) => self.factored_accelerations(t, q, v, a, lambda),
        };
        if regular { Ok(()) } else { Err(self.why_singular(t, q)) }
    }

    /// By a factorisation of K; false when it is singular.
    fn factored_accelerations(&mut self, t: f64, q: &[f64], v: &[f64], a: &mut [f64], lambda: &mut [f64]) -> bool {
        let regular = self.factor(t, q);
        if regular {
            let (scene, c) = (self.scene, &self.fixed);
            let (F, gamma) = self.buffers.right_side.split_at_mut(q.len());
            scene.applied_force(c, t, q, v, F);
            scene.convective_term(c, t, q, v, gamma);
            gamma.iter_mut().for_each(|h| *h = -*h);
            factored(&mut self.solver, &mut self.second_opinion, self.info).solve(&mut self.buffers.right_side);
            let (solved_a, solved_lambda) = self.buffers.right_side.split_at(q.len());
            a.copy_from_slice(solved_a);
            lambda.copy_from_slice(solved_lambda);
        }
        regular
    }

    /// As [`System::correction`], by a factorisation of K; false when it is singular.
    fn factored_correction(&mut self, t: f64, q: &[f64], residual: &[f64], delta: &mut [f64]) -> bool {
        let regular = self.factor(t, q);
        if regular {
            let right_side = &mut self.buffers.right_side;
            right_side[..q.len()].fill(0.0);
            right_side[q.len()..].iter_mut().zip(residual).for_each(|(x, r)| *x = -r);
            factored(&mut self.solver, &mut self.second_opinion, self.info).solve(right_side);
            delta.copy_from_slice(&self.buffers.right_side[..q.len()]);
        }
        regular
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
        self.counters.factorizations += 1;
        let regular = match (&self.solver, metric) {
            (Solver::Generated, Metric::Mass) => {
                self.scene.correction(&self.fixed, t, q, residual, delta).none()
                    || self.factored_correction(t, q, residual, delta)
            }
            (Solver::Factored(_), Metric::Mass) => self.factored_correction(t, q, residual, delta),
            (_, Metric::Euclidean) => {
                self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
                let euclidean = Euclidean::of(&mut self.euclidean, self.info)?;
                euclidean.velocity_correction(&self.buffers.jacobian, residual, delta)
            }
        };
        if regular { Ok(()) } else { Err(self.why_singular(t, q)) }
    }

    /// Begins a series from orders 0 and 1 of q in `store` ([`Series::begin`]); true when the scene's own elimination can
    /// solve for it. Otherwise K is factored, for [`System::solve_factored`].
    ///
    /// # Errors
    /// As [`System::accelerations`].
    pub fn begin_series(
        &mut self,
        series: &dyn Series<f64>,
        t: f64,
        store: &mut SeriesStore<f64>,
    ) -> Result<bool, MotionError> {
        self.counters.evaluations += 1;
        self.counters.factorizations += 1;
        let deficient = series.begin(&self.fixed, t, store);
        if deficient.none() && self.uses_elimination() {
            return Ok(true);
        }
        self.factorize(t, &store.q[..self.info.n_coordinates()]).map(|()| false)
    }

    /// Factors K at one state, for [`System::solve_factored`].
    ///
    /// # Errors
    /// As [`System::accelerations`].
    pub fn factorize(&mut self, t: f64, q: &[f64]) -> Result<(), MotionError> {
        if self.factor(t, q) { Ok(()) } else { Err(self.why_singular(t, q)) }
    }

    /// Whether the scene's own elimination solves, as long as no pivot vanishes.
    pub fn uses_elimination(&self) -> bool {
        matches!(self.solver, Solver::Generated)
    }

    /// Solves `[M Gᵀ; G 0] [a; λ] = [force; row]` with the factors of [`System::factorize`].
    pub fn solve_factored(&mut self, force: &[f64], row: &[f64], a: &mut [f64], lambda: &mut [f64]) {
        let right_side = &mut self.buffers.right_side;
        right_side[..force.len()].copy_from_slice(force);
        right_side[force.len()..].copy_from_slice(row);
        factored(&mut self.solver, &mut self.second_opinion, self.info).solve(right_side);
        a.copy_from_slice(&right_side[..force.len()]);
        lambda.copy_from_slice(&right_side[force.len()..]);
    }

    /// How well K can be solved with at a state, by an estimator for this scene.
    pub fn conditioning(&mut self, t: f64, q: &[f64], estimator: &mut ConditionEstimator) -> Conditioning {
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
    pub fn refine_accelerations(&mut self, t: f64, q: &[f64], v: &[f64], a: &mut [f64]) -> Result<(), MotionError> {
        let mut residual = std::mem::take(&mut self.buffers.residual);
        let mut delta = std::mem::take(&mut self.buffers.delta);
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        self.scene.convective_term(&self.fixed, t, q, v, &mut residual);
        for (k, row, column) in self.info.jacobian.entries() {
            residual[row] += self.buffers.jacobian[k] * a[column];
        }
        let outcome = self.correction(t, q, &residual, Metric::Mass, &mut delta);
        if outcome.is_ok() {
            a.iter_mut().zip(&delta).for_each(|(a, delta)| *a += delta);
        }
        self.buffers.residual = residual;
        self.buffers.delta = delta;
        outcome
    }

    /// Factors K; false when it is singular.
    fn factor(&mut self, t: f64, q: &[f64]) -> bool {
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        let kkt = factored(&mut self.solver, &mut self.second_opinion, self.info);
        let outcome = kkt.factor(&self.mass, &self.buffers.jacobian);
        self.vanished_row = outcome.err().and_then(|pivot| pivot.row);
        outcome.is_ok()
    }

    /// Names what makes K singular. Slow; only for reports.
    #[cold]
    pub(super) fn why_singular(&mut self, t: f64, q: &[f64]) -> MotionError {
        let (scene, info) = (self.scene, self.info);
        scene.velocity_jacobian(&self.fixed, t, q, &mut self.buffers.jacobian);
        if info.n_unknowns() > LARGEST_DIAGNOSED {
            let finite = self.buffers.jacobian.iter().all(|x| x.is_finite());
            return match self.vanished_row {
                Some(row) if finite => MotionError::VanishedRow { t, row: info.rows[row].name },
                _ => MotionError::NotFinite { t, quantity: "the constraint Jacobian or an entry of its factors" },
            };
        }
        match diagnose(&self.mass, &info.jacobian, &self.buffers.jacobian) {
            None => MotionError::NotFinite { t, quantity: "the constraint Jacobian" },
            Some(found) if found.rows.is_empty() => MotionError::UndeterminedMotion {
                t,
                coordinates: found.coordinates.iter().map(|&i| info.coordinates[i].name).collect(),
            },
            Some(found) => MotionError::DependentRows {
                t,
                rows: found.rows.iter().map(|&i| info.rows[i].name).collect(),
                smallest_singular_value: found.smallest_singular_value,
            },
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
        Solver::Generated => second_opinion
            .get_or_insert_with(|| Box::new(DenseKkt::new(info.n_coordinates(), &info.jacobian, info.n_rows())))
            .as_mut(),
    }
}
