//! Energies and powers.

use super::System;
use crate::model::Scene;

impl<S: Scene + ?Sized> System<'_, S> {
    /// ½ vᵀ M v, J.
    pub fn kinetic_energy(&self, v: &[f64]) -> f64 {
        0.5 * self.mass.iter().zip(v).map(|(m, v)| m * v * v).sum::<f64>()
    }

    /// Potential energy, J; zero where no force has a potential.
    pub fn potential_energy(&self, t: f64, q: &[f64]) -> f64 {
        self.scene.potential_energy(&self.constants, t, q)
    }

    /// Power of each effect, W; writes `n_e`.
    #[inline]
    pub fn power(&self, t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        if !out.is_empty() {
            self.scene.power(&self.constants, t, q, v, out);
        }
    }
}
