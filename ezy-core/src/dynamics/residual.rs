//! What accelerations and multipliers that are not the solution leave of the equations of motion.

use super::System;
use super::configuration::Configuration;
use crate::model::{Derived as _, Equations as _, JacobianPlaces, Scene, SceneInfo, SceneRef};

/// Row and column of each entry of [`Jacobians`].
#[derive(Debug)]
pub(crate) struct ResidualPlaces {
    /// Of R_q and R_v.
    pub by_motion: JacobianPlaces,
    /// Of R_z.
    pub by_z: Vec<(usize, usize)>,
}

impl ResidualPlaces {
    /// Those of a scene; none when it does not know its Jacobians.
    pub(crate) fn of<S: Scene + ?Sized>(scene: &S) -> Option<Self> {
        let by_motion = scene.jacobian_places()?;
        Some(Self { by_motion, by_z: scene.state_jacobian_places() })
    }
}

/// Jacobians of [`Configuration::residual`] in the order of [`ResidualPlaces`], and G at the same state.
#[derive(Debug, Clone)]
pub(crate) struct Jacobians {
    /// R_q.
    pub by_q: Vec<f64>,
    /// R_v.
    pub by_v: Vec<f64>,
    /// R_z.
    pub by_z: Vec<f64>,
    /// Entries of G in the order of [`SceneInfo::jacobian`].
    pub jacobian: Vec<f64>,
}

impl Jacobians {
    /// Zeros at these places.
    pub(crate) fn zero(info: &SceneInfo, places: &ResidualPlaces) -> Self {
        let zeros = |n: usize| vec![0.0; n];
        Self {
            by_q: zeros(places.by_motion.by_q.len()),
            by_v: zeros(places.by_motion.by_v.len()),
            by_z: zeros(places.by_z.len()),
            jacobian: zeros(info.jacobian.n_nonzeros()),
        }
    }
}

impl<P: SceneRef> Configuration<'_, P> {
    /// `R = [F − M a − Gᵀ λ; −(G a + [h; s]); r − z']` (`n_q + n_c + n_z`), which vanishes at the accelerations, multipliers and `rates` z' of a
    /// state; r are the rates of the first-order states that were set.
    ///
    /// # Cost
    /// Less than that of the accelerations; no factorisation, no allocation.
    pub(crate) fn residual(&mut self, v: &[f64], a: &[f64], lambda: &[f64], rates: &[f64], out: &mut [f64]) {
        let (t, q) = (self.t, self.q);
        let System { scene, info, fixed, mass, factors, counters, sines, .. } = &mut *self.system;
        counters.evaluations += 1;
        let (forces, rest) = out.split_at_mut(q.len());
        let (rows, states) = rest.split_at_mut(lambda.len());
        let jacobian = factors.jacobian_at(scene, fixed, sines, t, q);
        let sines = sines.at(q);
        scene.applied_force_with_sines(fixed, t, q, v, sines, forces);
        scene.convective_term_with_sines(fixed, t, q, v, sines, rows);
        for ((force, m), a) in forces.iter_mut().zip(mass.iter()).zip(a) {
            *force -= m * a;
        }
        let pattern = &info.jacobian;
        for (i, row) in rows.iter_mut().enumerate() {
            for (g, j) in jacobian[pattern.row(i)].iter().zip(pattern.columns_of(i)) {
                forces[j] -= g * lambda[i];
                *row += g * a[j];
            }
            *row = -*row;
        }
        if !states.is_empty() {
            scene.state_rates(fixed, t, q, v, states);
            states.iter_mut().zip(rates).for_each(|(state, rate)| *state -= rate);
        }
    }

    /// Jacobians of [`Configuration::residual`] at fixed accelerations and multipliers, and G. Where a law has no derivative, such as `norm(v)` at rest,
    /// entries are zero: a method that solves by Jacobians checks its solution by the residual.
    pub(crate) fn jacobians(&mut self, v: &[f64], a: &[f64], lambda: &[f64], out: &mut Jacobians) {
        let (t, q, System { scene, fixed, sines, .. }) = (self.t, self.q, &mut *self.system);
        scene.jacobians(fixed, t, q, v, a, lambda, &mut out.by_q, &mut out.by_v);
        scene.velocity_jacobian_with_sines(fixed, t, q, sines.at(q), &mut out.jacobian);
        if !out.by_z.is_empty() {
            scene.state_jacobians(fixed, t, q, v, &mut out.by_z);
        }
        let Jacobians { by_q, by_v, by_z, .. } = out;
        by_q.iter_mut().chain(by_v).chain(by_z).filter(|entry| !entry.is_finite()).for_each(|entry| *entry = 0.0);
    }
}
