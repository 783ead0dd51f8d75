//! What a first program does: RK4 with a fixed step on accelerations from a dense LU factorisation of K, without
//! projection and without a look at the rank. It calls the kernels of the scene, so that only the method differs.

use ezy_core::model::Scene;
use ezy_core::prelude::Backend;
use ezy_core_tests::system_of;
use nalgebra::{DMatrix, DVector};

/// A scene in the hands of that program.
pub struct Naive<'s> {
    scene: &'s dyn Scene,
    /// What kernels read as `c`.
    fixed: Vec<f64>,
    mass: Vec<f64>,
    /// q, then v.
    pub state: Vec<f64>,
    /// Multipliers of the last evaluation.
    pub lambda: Vec<f64>,
}

impl<'s> Naive<'s> {
    /// At a state, consistent or not.
    ///
    /// # Panics
    /// When the scene cannot be set up.
    pub fn new(scene: &'s dyn Scene, q: &[f64], v: &[f64]) -> Self {
        let system = system_of(scene, Backend::Auto).expect("a scene that can be set up");
        let (fixed, mass) = (system.fixed().to_vec(), system.mass_matrix().to_vec());
        Self { scene, fixed, mass, state: [q, v].concat(), lambda: vec![0.0; system.info().n_rows()] }
    }

    /// Accelerations; `None` where LU meets a pivot that is exactly zero.
    pub fn accelerations(&mut self, t: f64, state: &[f64]) -> Option<Vec<f64>> {
        let (info, n_q) = (self.scene.info(), self.mass.len());
        let (q, v) = state.split_at(n_q);
        let mut entries = vec![0.0; info.jacobian.n_nonzeros()];
        self.scene.velocity_jacobian(&self.fixed, t, q, &mut entries);
        let mut k = DMatrix::zeros(n_q + info.n_rows(), n_q + info.n_rows());
        self.mass.iter().enumerate().for_each(|(i, m)| k[(i, i)] = *m);
        for (entry, i, j) in info.jacobian.entries() {
            k[(n_q + i, j)] += entries[entry];
            k[(j, n_q + i)] += entries[entry];
        }
        let mut right_side = DVector::zeros(n_q + info.n_rows());
        let (force, convective) = right_side.as_mut_slice().split_at_mut(n_q);
        self.scene.applied_force(&self.fixed, t, q, v, force);
        self.scene.convective_term(&self.fixed, t, q, v, convective);
        convective.iter_mut().for_each(|h| *h = -*h);
        let solution = k.lu().solve(&right_side)?;
        let (a, lambda) = solution.as_slice().split_at(n_q);
        self.lambda.copy_from_slice(lambda);
        Some(a.to_vec())
    }

    /// A step of length `h`.
    ///
    /// # Errors
    /// In words, when LU gives up or what it gives is no number.
    pub fn step(&mut self, t: f64, h: f64) -> Result<(), &'static str> {
        let start = self.state.clone();
        let n_q = self.mass.len();
        let mut sum = vec![0.0; start.len()];
        let mut at = start.clone();
        for (part, weight) in [(0.0, 1.0), (0.5, 2.0), (0.5, 2.0), (1.0, 1.0)] {
            if part > 0.0 {
                at.iter_mut()
                    .zip(&start)
                    .zip(&self.state)
                    .for_each(|((at, start), slope)| *at = start + part * h * slope);
            }
            let a = self.accelerations(t + part * h, &at).ok_or("a pivot is zero")?;
            self.state[..n_q].copy_from_slice(&at[n_q..]);
            self.state[n_q..].copy_from_slice(&a);
            sum.iter_mut().zip(&self.state).for_each(|(sum, slope)| *sum += weight * slope);
        }
        self.state.iter_mut().zip(&start).zip(&sum).for_each(|((y, start), sum)| *y = start + h / 6.0 * sum);
        if self.state.iter().all(|x| x.is_finite()) { Ok(()) } else { Err("not a number") }
    }

    /// Largest |C|.
    pub fn gap(&self, t: f64) -> f64 {
        let mut rows = vec![0.0; self.scene.info().n_position_rows];
        self.scene.position_constraint(&self.fixed, t, &self.state[..self.mass.len()], &mut rows);
        rows.into_iter().fold(0.0, crate::garage::worse)
    }

    /// Kinetic and potential energy, J.
    pub fn energy(&self, t: f64) -> f64 {
        let (q, v) = self.state.split_at(self.mass.len());
        let kinetic: f64 = self.mass.iter().zip(v).map(|(m, v)| 0.5 * m * v * v).sum();
        kinetic + self.scene.potential_energy(&self.fixed, t, q)
    }
}
