//! Energies, powers, and what else a scene says of its state.

use super::System;
use crate::model::{Equations as _, Scene as _, SceneRef};

impl<P: SceneRef> System<P> {
    /// ½ vᵀ M v, J.
    pub fn kinetic_energy(&self, v: &[f64]) -> f64 {
        0.5 * self.mass.iter().zip(v).map(|(m, v)| m * v * v).sum::<f64>()
    }

    /// Potential energy, J; zero where no force has a potential.
    pub fn potential_energy(&self, t: f64, q: &[f64]) -> f64 {
        self.scene.potential_energy(&self.fixed, t, q)
    }

    /// Power of each effect, W; `lambda` are the multipliers at this state. Writes `n_e`, or nothing into an empty
    /// `out`, which costs nothing.
    #[inline]
    pub fn power(&self, t: f64, q: &[f64], v: &[f64], lambda: &[f64], out: &mut [f64]) {
        if !out.is_empty() {
            self.scene.power(&self.fixed, t, q, v, lambda, out);
        }
    }

    /// Outputs of the scene; writes `n_o`.
    pub fn outputs(&self, t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.scene.outputs(&self.fixed, t, q, v, out);
    }
}
