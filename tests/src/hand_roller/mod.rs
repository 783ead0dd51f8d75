//! The EzyRoller written by hand from Newton's laws: the same scenes as the model file, by another route.
//!
//! Body 1 is the seat, body 2 the bar; `e = (cos φ, sin φ)`, `n = (−sin φ, cos φ)`. Wheel A is at `−a e₁` from the
//! seat's centre of mass, hinge B at `+b e₁`; the bar's centre of mass is at `+d e₂` from B, wheel C at `+c e₂` from
//! there.

mod info;
mod schur;
mod series;

use ezy_core::__private::{Pivots, Series};
use ezy_core::model::{Derived, Equations, Scene, SceneInfo, Start};
use ezy_core::scalar::Scalar;
use schur::{N_FACTORS, Schur};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

/// The scene `coast` or `driven`, with every parameter free.
#[derive(Debug, Clone)]
pub struct HandRoller {
    /// a, b, c, d, m1, i1, m2, i2, and m0, omega when driven.
    parameters: Vec<f64>,
    driven: bool,
}

impl HandRoller {
    /// Rolling freely at 1 m/s, the hinge at a right angle.
    pub fn coast() -> Self {
        Self { parameters: vec![0.2, 0.6, 0.1, 0.1, 46.0, 10.0, 1.0, 0.005], driven: false }
    }

    /// From rest, folded, driven by a torque in the hinge.
    pub fn driven() -> Self {
        Self { parameters: vec![0.2, 0.6, 0.1, 0.1, 46.0, 10.0, 1.0, 0.005, 2.0, PI], driven: true }
    }
}

/// Torque on the seat; the bar gets the opposite.
fn torque(c: &[f64], t: f64) -> f64 {
    if c.len() > 8 { c[8] * (c[9] * t).cos() } else { 0.0 }
}

/// Sines and cosines of both angles: s₁, c₁, s₂, c₂.
fn trig<T: Scalar>(q: &[T]) -> [T; 4] {
    let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
    [s1, c1, s2, c2]
}

/// M, and G as a full matrix with the rows B.x, B.y, rear, front.
fn schur<T: Scalar>(p: &[T], trig: &[T]) -> Schur<T> {
    let [s1, c1, s2, c2] = [trig[0], trig[1], trig[2], trig[3]];
    let [a, b, c, d] = [p[0], p[1], p[2], p[3]];
    let [o, i] = [0.0, 1.0].map(T::from_f64);
    Schur {
        mass: [p[4], p[4], p[5], p[6], p[6], p[7]],
        jacobian: [
            [i, o, -b * s1, -i, o, -d * s2],
            [o, i, b * c1, o, -i, d * c2],
            [-s1, c1, -a, o, o, o],
            [o, o, o, -s2, c2, c],
        ],
    }
}

impl Equations<f64> for HandRoller {
    fn constants(&self, parameters: &[f64], c: &mut [f64]) {
        c.copy_from_slice(parameters);
    }

    fn mass_matrix(&self, c: &[f64], m: &mut [f64]) {
        m.copy_from_slice(&[c[4], c[4], c[5], c[6], c[6], c[7]]);
    }

    fn position_constraint(&self, c: &[f64], _t: f64, q: &[f64], out: &mut [f64]) {
        let (b, d) = (c[1], c[3]);
        out[0] = q[0] + b * q[2].cos() - q[3] + d * q[5].cos();
        out[1] = q[1] + b * q[2].sin() - q[4] + d * q[5].sin();
    }

    fn velocity_constraint(&self, c: &[f64], _t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        for (out, row) in out.iter_mut().zip(schur(c, &trig(q)).jacobian) {
            *out = row.iter().zip(v).map(|(g, v)| g * v).sum();
        }
    }

    fn velocity_jacobian(&self, c: &[f64], _t: f64, q: &[f64], out: &mut [f64]) {
        let g = schur(c, &trig(q)).jacobian;
        for (k, row, column) in self.info().jacobian.entries() {
            out[k] = g[row][column];
        }
    }

    fn convective_term(&self, c: &[f64], _t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let (b, d) = (c[1], c[3]);
        let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
        let (w1, w2) = (v[2], v[5]);
        out[0] = -b * c1 * w1 * w1 - d * c2 * w2 * w2;
        out[1] = -b * s1 * w1 * w1 - d * s2 * w2 * w2;
        out[2] = -(v[0] * c1 + v[1] * s1) * w1;
        out[3] = -(v[3] * c2 + v[4] * s2) * w2;
    }

    fn applied_force(&self, c: &[f64], t: f64, _q: &[f64], _v: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        out[2] = torque(c, t);
        out[5] = -torque(c, t);
    }

    fn accelerations(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], a: &mut [f64], lambda: &mut [f64]) -> Pivots {
        let mut f = [0.0; 6];
        self.applied_force(c, t, q, v, &mut f);
        let mut h = [0.0; 4];
        self.convective_term(c, t, q, v, &mut h);
        let (schur, mut factors) = (schur(c, &trig(q)), [0.0; N_FACTORS]);
        let pivots = schur.factor(&mut factors);
        schur.solve(&factors, &f, &h.map(|h| -h), a, lambda);
        pivots
    }

    fn correction(&self, c: &[f64], _t: f64, q: &[f64], residual: &[f64], delta: &mut [f64]) -> Pivots {
        let (schur, mut factors) = (schur(c, &trig(q)), [0.0; N_FACTORS]);
        let pivots = schur.factor(&mut factors);
        let r = [-residual[0], -residual[1], -residual[2], -residual[3]];
        schur.solve(&factors, &[0.0; 6], &r, delta, &mut [0.0; 4]);
        pivots
    }
}

impl Derived for HandRoller {
    fn series(&self) -> Option<&dyn Series<f64>> {
        Some(self)
    }
}

impl Scene for HandRoller {
    fn info(&self) -> Arc<SceneInfo> {
        Arc::clone(if self.driven { &info::DRIVEN } else { &info::COAST })
    }

    fn parameter(&self, index: usize) -> f64 {
        self.parameters[index]
    }

    fn set_parameter(&mut self, index: usize, value: f64) {
        self.parameters[index] = value;
    }

    fn start(&self, c: &[f64], start: &mut Start) {
        start.give_position(0, if self.driven { 0.0 } else { c[0] });
        start.give_position(1, 0.0);
        start.give_position(2, 0.0);
        start.give_position(5, if self.driven { PI } else { FRAC_PI_2 });
        if !self.driven {
            start.give_velocity(0, 1.0);
            start.give_velocity(1, 0.0);
            start.give_velocity(2, 0.0);
        }
    }

    fn power(&self, c: &[f64], t: f64, _q: &[f64], v: &[f64], _lambda: &[f64], out: &mut [f64]) {
        out.fill(torque(c, t) * (v[2] - v[5]));
    }

    fn potential_energy(&self, _c: &[f64], _t: f64, _q: &[f64]) -> f64 {
        0.0
    }

    fn points(&self, c: &[f64], _t: f64, q: &[f64], out: &mut [f64]) {
        let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
        out[0] = q[0] - c[0] * c1;
        out[1] = q[1] - c[0] * s1;
        out[2] = q[3] + c[2] * c2;
        out[3] = q[4] + c[2] * s2;
        out[4] = q[0] + c[1] * c1;
        out[5] = q[1] + c[1] * s1;
    }
}
