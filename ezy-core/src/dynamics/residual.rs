//! What accelerations and multipliers that are not the solution leave of the equations of motion.

use super::System;
use crate::model::{Derived as _, Equations as _, JacobianPlaces, SceneInfo, SceneRef};

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
}

impl<P: SceneRef> System<P> {
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
    /// entries are zero: a method that solves by Jacobians checks its solution by the residual.
    pub(crate) fn jacobians(&self, t: f64, q: &[f64], v: &[f64], a: &[f64], lambda: &[f64], out: &mut Jacobians) {
        let Self { scene, fixed, .. } = self;
        scene.jacobians(fixed, t, q, v, a, lambda, &mut out.by_q, &mut out.by_v);
        scene.velocity_jacobian(fixed, t, q, &mut out.jacobian);
        out.by_q.iter_mut().chain(&mut out.by_v).filter(|entry| !entry.is_finite()).for_each(|entry| *entry = 0.0);
    }

    /// A factorisation that a method makes by itself counts like those of K.
    pub(crate) fn count_factorization(&mut self) {
        self.counters.factorizations += 1;
    }
}
