//! A scene that counts what is asked of it.

use ezy_core::__private::Pivots;
use ezy_core::model::{Derived, Equations, Scene, SceneInfo, Start};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Another scene, with counters.
#[derive(Default)]
pub struct Counted<S> {
    scene: S,
    /// Evaluations of the powers.
    pub powers: AtomicU64,
    /// Evaluations of the outputs.
    pub outputs: AtomicU64,
}

impl<S: Scene> Equations<f64> for Counted<S> {
    fn constants(&self, parameters: &[f64], c: &mut [f64]) {
        self.scene.constants(parameters, c);
    }

    fn mass_matrix(&self, c: &[f64], m: &mut [f64]) {
        self.scene.mass_matrix(c, m);
    }

    fn position_constraint(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        self.scene.position_constraint(c, t, q, out);
    }

    fn velocity_constraint(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.scene.velocity_constraint(c, t, q, v, out);
    }

    fn velocity_jacobian(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        self.scene.velocity_jacobian(c, t, q, out);
    }

    fn convective_term(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.scene.convective_term(c, t, q, v, out);
    }

    fn applied_force(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.scene.applied_force(c, t, q, v, out);
    }

    fn accelerations(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], a: &mut [f64], lambda: &mut [f64]) -> Pivots {
        self.scene.accelerations(c, t, q, v, a, lambda)
    }

    fn correction(&self, c: &[f64], t: f64, q: &[f64], residual: &[f64], delta: &mut [f64]) -> Pivots {
        self.scene.correction(c, t, q, residual, delta)
    }

    fn projected_accelerations(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) -> Pivots {
        self.scene.projected_accelerations(c, t, q, v, out)
    }
}

impl<S: Scene> Derived for Counted<S> {
    fn events(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.scene.events(c, t, q, v, out);
    }
}

impl<S: Scene> Scene for Counted<S> {
    fn info(&self) -> &'static SceneInfo {
        self.scene.info()
    }

    fn parameter(&self, index: usize) -> f64 {
        self.scene.parameter(index)
    }

    fn set_parameter(&mut self, index: usize, value: f64) {
        self.scene.set_parameter(index, value);
    }

    fn start(&self, c: &[f64], start: &mut Start) {
        self.scene.start(c, start);
    }

    fn power(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], lambda: &[f64], out: &mut [f64]) {
        self.powers.fetch_add(1, Relaxed);
        self.scene.power(c, t, q, v, lambda, out);
    }

    fn potential_energy(&self, c: &[f64], t: f64, q: &[f64]) -> f64 {
        self.scene.potential_energy(c, t, q)
    }

    fn points(&self, c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        self.scene.points(c, t, q, out);
    }

    fn outputs(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        self.outputs.fetch_add(1, Relaxed);
        self.scene.outputs(c, t, q, v, out);
    }
}
