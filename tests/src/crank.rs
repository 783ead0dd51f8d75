//! A crank on the ground whose angle is prescribed in time: rows with C_t and C_tt, and no degree of freedom left.

use crate::described::{EMPTY, coordinate, f, row};
use ezy_core::__private::Pivots;
use ezy_core::model::{
    Derived, EffectInfo, EliminationStep, Equations, OutputInfo, Scene, SceneInfo, SparsityPattern, Start,
};
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Arc, LazyLock};

const RADIUS: f64 = 0.3;
const MASS: f64 = 2.0;
/// About the centre of mass, kg·m².
pub const INERTIA: f64 = 0.4;

/// The prescribed angle.
pub fn angle(t: f64) -> f64 {
    2.0 * t + 0.3 * (3.0 * t).sin()
}

/// Its rate.
pub fn rate(t: f64) -> f64 {
    2.0 + 0.9 * (3.0 * t).cos()
}

/// The rate of its rate.
pub fn acceleration(t: f64) -> f64 {
    -2.7 * (3.0 * t).sin()
}

static INFO: LazyLock<Arc<SceneInfo>> = LazyLock::new(|| {
    Arc::new(SceneInfo {
        model: "Crank",
        name: "turn",
        bodies: vec!["arm".into()].into(),
        coordinates: vec![coordinate("arm.x", "m"), coordinate("arm.y", "m"), coordinate("arm.phi", "rad")].into(),
        velocities: vec![coordinate("arm.vx", "m/s"), coordinate("arm.vy", "m/s"), coordinate("arm.omega", "rad/s")]
            .into(),
        rows: vec![row("pin.x", "hinge", "", ""), row("pin.y", "hinge", "", ""), row("angle", "drive", "", "")].into(),
        n_position_rows: 3,
        outputs: vec![OutputInfo { name: "height".into(), unit: "m", documentation: "", formula: f("arm.y") }].into(),
        effects: &[EffectInfo { name: "drives", documentation: "" }],
        until_s: 2.0,
        jacobian: SparsityPattern::new(&[0, 2, 4, 5], &[0, 2, 1, 2, 2]),
        elimination: &[EliminationStep { rows: &[0, 1, 2], constant_pivot: false }],
        ..EMPTY
    })
});

/// A body hinged to the origin at a distance from its centre of mass, with rows x, y and drive; it counts what it is asked for.
#[derive(Default)]
pub struct Crank {
    /// Evaluations of the power.
    pub powers: AtomicU64,
    /// Evaluations of the output.
    pub outputs: AtomicU64,
}

impl Equations<f64> for Crank {
    fn constants(&self, _parameters: &[f64], _c: &mut [f64]) {}

    fn mass_matrix(&self, _c: &[f64], m: &mut [f64]) {
        m.copy_from_slice(&[MASS, MASS, INERTIA]);
    }

    fn position_constraint(&self, _c: &[f64], t: f64, q: &[f64], out: &mut [f64]) {
        out.copy_from_slice(&[q[0] - RADIUS * q[2].cos(), q[1] - RADIUS * q[2].sin(), q[2] - angle(t)]);
    }

    fn velocity_constraint(&self, _c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let (s, c) = q[2].sin_cos();
        out.copy_from_slice(&[v[0] + RADIUS * s * v[2], v[1] - RADIUS * c * v[2], v[2] - rate(t)]);
    }

    fn velocity_jacobian(&self, _c: &[f64], _t: f64, q: &[f64], out: &mut [f64]) {
        let (s, c) = q[2].sin_cos();
        out.copy_from_slice(&[1.0, RADIUS * s, 1.0, -RADIUS * c, 1.0]);
    }

    fn convective_term(&self, _c: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let ((s, c), w2) = (q[2].sin_cos(), v[2] * v[2]);
        out.copy_from_slice(&[RADIUS * c * w2, RADIUS * s * w2, -acceleration(t)]);
    }

    fn applied_force(&self, _c: &[f64], _t: f64, _q: &[f64], _v: &[f64], out: &mut [f64]) {
        out.fill(0.0);
    }

    fn outputs(&self, _c: &[f64], _t: f64, q: &[f64], _v: &[f64], out: &mut [f64]) {
        self.outputs.fetch_add(1, Relaxed);
        out[0] = q[1];
    }

    /// Kinematics alone: a from the rows, then λ from M a + Gᵀ λ = 0.
    fn accelerations(&self, c: &[f64], t: f64, q: &[f64], v: &[f64], a: &mut [f64], lambda: &mut [f64]) -> Pivots {
        let mut h = [0.0; 3];
        self.convective_term(c, t, q, v, &mut h);
        self.correction(c, t, q, &h, a);
        let (s, co) = q[2].sin_cos();
        (lambda[0], lambda[1]) = (-MASS * a[0], -MASS * a[1]);
        lambda[2] = -INERTIA * a[2] - RADIUS * s * lambda[0] + RADIUS * co * lambda[1];
        Pivots::default()
    }

    fn correction(&self, _c: &[f64], _t: f64, q: &[f64], residual: &[f64], delta: &mut [f64]) -> Pivots {
        let (s, c) = q[2].sin_cos();
        delta[2] = -residual[2];
        delta[0] = -residual[0] - RADIUS * s * delta[2];
        delta[1] = -residual[1] + RADIUS * c * delta[2];
        Pivots::default()
    }
}

impl Derived for Crank {}

impl Scene for Crank {
    fn info(&self) -> Arc<SceneInfo> {
        Arc::clone(&INFO)
    }

    fn parameter(&self, _index: usize) -> f64 {
        f64::NAN
    }

    fn set_parameter(&mut self, _index: usize, _value: f64) {}

    fn start(&self, _c: &[f64], _start: &mut Start) {}

    /// The third row moves with −φ'(t).
    fn power(&self, _c: &[f64], t: f64, _q: &[f64], _v: &[f64], lambda: &[f64], out: &mut [f64]) {
        self.powers.fetch_add(1, Relaxed);
        out[0] = -lambda[2] * rate(t);
    }

    fn potential_energy(&self, _c: &[f64], _t: f64, _q: &[f64]) -> f64 {
        0.0
    }

    fn points(&self, _c: &[f64], _t: f64, _q: &[f64], _out: &mut [f64]) {}
}

/// Torque that the drive needs: the crank's inertia about the pin times the prescribed acceleration.
pub fn drive_torque(t: f64) -> f64 {
    (INERTIA + MASS * RADIUS * RADIUS) * acceleration(t)
}
