//! What accelerations and multipliers that are not the solution leave of the equations of motion.

use super::System;
use crate::model::{JacobianPlaces, Scene, SceneInfo};

/// Jacobians of [`System::residual`] in the order of [`Derived::jacobian_places`](crate::model::Derived::jacobian_places), and G at the same state.
#[derive(Debug, Clone)]
pub(crate) struct Jacobians {
    /// R_q.
    pub by_q: Vec<f64>,
    /// R_v.
    pub by_v: Vec<f64>,
    /// Entries of G in the order of [`SceneInfo::jacobian`].
    pub jacobian: Vec<f64>,
}

impl Jacobians {
    /// Zeros at these places.
    pub(crate) fn zero(info: &SceneInfo, places: &JacobianPlaces) -> Self {
        let zeros = |n: usize| vec![0.0; n];
        Self {
            by_q: zeros(places.by_q.len()),
            by_v: zeros(places.by_v.len()),
            jacobian: zeros(info.jacobian.n_nonzeros()),
        }
    }

    /// Whether every law has its derivatives.
    pub(crate) fn are_finite(&self) -> bool {
        self.by_q.iter().chain(&self.by_v).all(|entry| entry.is_finite())
    }
}

/// So much later a law is looked at that has no derivative at a state, s: far below a step, and so long that squares of small velocities are numbers.
const MOMENT_S: f64 = 1e-6;

impl<S: Scene + ?Sized> System<'_, S> {
    /// `R = [F − M a − Gᵀ λ; −(G a + [h; s])]` (`n_q + n_c`), which vanishes at the accelerations and multipliers of a state.
    ///
    /// # Cost
    /// Less than that of the accelerations; no factorisation, no allocation.
    pub(crate) fn residual(&mut self, t: f64, q: &[f64], v: &[f64], a: &[f64], lambda: &[f64], out: &mut [f64]) {
        self.counters.evaluations += 1;
        let Self { scene, info, fixed, mass, buffers, .. } = self;
        let (forces, rows) = out.split_at_mut(q.len());
        scene.velocity_jacobian(fixed, t, q, &mut buffers.jacobian);
        scene.applied_force(fixed, t, q, v, forces);
        scene.convective_term(fixed, t, q, v, rows);
        for ((force, m), a) in forces.iter_mut().zip(mass.iter()).zip(a) {
            *force -= m * a;
        }
        let pattern = &info.jacobian;
        for (i, row) in rows.iter_mut().enumerate() {
            let places = pattern.starts[i]..pattern.starts[i + 1];
            for (g, &j) in buffers.jacobian[places.clone()].iter().zip(&pattern.columns[places]) {
                forces[j] -= g * lambda[i];
                *row += g * a[j];
            }
            *row = -*row;
        }
    }

    /// Jacobians of [`System::residual`] at fixed accelerations and multipliers, and G. Where a law has no derivative, such as `norm(v)` at rest,
    /// that along the motion.
    pub(crate) fn jacobians(&self, t: f64, q: &[f64], v: &[f64], a: &[f64], lambda: &[f64], out: &mut Jacobians) {
        let Self { scene, fixed, .. } = self;
        scene.jacobians(fixed, t, q, v, a, lambda, &mut out.by_q, &mut out.by_v);
        scene.velocity_jacobian(fixed, t, q, &mut out.jacobian);
        if !out.are_finite() {
            self.jacobians_along_motion(t, q, v, a, lambda, out);
        }
    }

    /// Replaces entries that are not finite by those a moment later on the motion: the limit at which the law arrives. Where there is no motion,
    /// or the limit is not finite either, they are zero: a method that solves by Jacobians checks its solution by the residual.
    #[cold]
    fn jacobians_along_motion(&self, t: f64, q: &[f64], v: &[f64], a: &[f64], lambda: &[f64], out: &mut Jacobians) {
        let later =
            |x: &[f64], rate: &[f64]| -> Vec<f64> { x.iter().zip(rate).map(|(x, r)| x + MOMENT_S * r).collect() };
        let v_later = later(v, a);
        let q_later = later(q, &v_later);
        let mut limit = out.clone();
        let (by_q, by_v) = (&mut limit.by_q, &mut limit.by_v);
        self.scene.jacobians(&self.fixed, t + MOMENT_S, &q_later, &v_later, a, lambda, by_q, by_v);
        for (values, limits) in [(&mut out.by_q, &limit.by_q), (&mut out.by_v, &limit.by_v)] {
            for (value, limit) in values.iter_mut().zip(limits).filter(|(value, _)| !value.is_finite()) {
                *value = if limit.is_finite() { *limit } else { 0.0 };
            }
        }
    }

    /// A factorisation that a method makes by itself counts like those of K.
    pub(crate) fn count_factorization(&mut self) {
        self.counters.factorizations += 1;
    }
}
