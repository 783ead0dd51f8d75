//! A rigid body in space, free or pinned at a point, written by hand.

use crate::described::{EMPTY, coordinate, row};
#[cfg(feature = "analysis")]
use ezy_core::model::EquationsWithDerivatives;
use ezy_core::model::{BodyKind, Derived, Equations, Scene, SceneInfo, SparsityPattern, Start};
use ezy_core::scalar::Scalar;
use std::sync::{Arc, LazyLock};

/// Mass, kg.
pub const MASS: f64 = 1.0;

/// A body with its attitude as a quaternion; velocities are along the axes of the ground, turns about those of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Top {
    /// Principal moments of inertia about the centre of mass, kg m².
    pub inertia: [f64; 3],
    /// The point of the body that is pinned to the origin, m; none of a free body.
    pub pin: Option<[f64; 3]>,
    /// Gravity along −z, m/s².
    pub gravity: f64,
    /// Quaternion and angular velocity at the start, which may move the centre.
    pub start: ([f64; 4], [f64; 3]),
}

fn info(is_pinned: bool) -> SceneInfo {
    let names = [("x", "m"), ("y", "m"), ("z", "m"), ("s", "1"), ("i", "1"), ("j", "1"), ("k", "1")];
    assert!(names.iter().zip(BodyKind::Spatial.positions()).all(|(name, of)| *name == (of.name, of.unit)));
    let rows = ["pin.x", "pin.y", "pin.z"].map(|name| row(name, "hinge", "", ""));
    SceneInfo {
        model: "Top",
        name: if is_pinned { "pinned" } else { "free" },
        bodies: vec!["top".into()].into(),
        kinds: vec![BodyKind::Spatial].into(),
        coordinates: [
            coordinate("top.x", "m"),
            coordinate("top.y", "m"),
            coordinate("top.z", "m"),
            coordinate("top.s", "1"),
            coordinate("top.i", "1"),
            coordinate("top.j", "1"),
            coordinate("top.k", "1"),
        ]
        .to_vec()
        .into(),
        velocities: [
            coordinate("top.vx", "m/s"),
            coordinate("top.vy", "m/s"),
            coordinate("top.vz", "m/s"),
            coordinate("top.omega_x", "rad/s"),
            coordinate("top.omega_y", "rad/s"),
            coordinate("top.omega_z", "rad/s"),
        ]
        .to_vec()
        .into(),
        rows: if is_pinned { rows.to_vec().into() } else { Vec::new().into() },
        n_position_rows: if is_pinned { 3 } else { 0 },
        until_s: 10.0,
        jacobian: if is_pinned {
            SparsityPattern::new(&[0, 4, 8, 12], &[0, 3, 4, 5, 1, 3, 4, 5, 2, 3, 4, 5])
        } else {
            SparsityPattern::new(&[0], &[])
        },
        ..EMPTY
    }
}

static INFOS: LazyLock<[Arc<SceneInfo>; 2]> =
    LazyLock::new(|| [false, true].map(|is_pinned| Arc::new(info(is_pinned))));

/// Columns are the axes of the body, for a quaternion of any length but zero.
pub fn attitude<T: Scalar>(p: &[T]) -> [[T; 3]; 3] {
    let [s, i, j, k] = [p[0], p[1], p[2], p[3]];
    let two = T::from_f64(2.0);
    let n = s * s + i * i + j * j + k * k;
    let rows = [
        [s * s + i * i - j * j - k * k, two * (i * j - s * k), two * (i * k + s * j)],
        [two * (i * j + s * k), s * s - i * i + j * j - k * k, two * (j * k - s * i)],
        [two * (i * k - s * j), two * (j * k + s * i), s * s - i * i - j * j + k * k],
    ];
    rows.map(|row| row.map(|x| x / n))
}

fn times<T: Scalar>(r: &[[T; 3]; 3], x: [T; 3]) -> [T; 3] {
    r.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2])
}

fn cross<T: Scalar>(a: &[T], b: [T; 3]) -> [T; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

impl<T: Scalar> Equations<T> for Top {
    fn constants(&self, _parameters: &[T], _c: &mut [T]) {}

    fn mass_matrix(&self, _c: &[T], m: &mut [T]) {
        m[..3].fill(T::from_f64(MASS));
        m[3..].copy_from_slice(&self.inertia.map(T::from_f64));
    }

    fn position_constraint(&self, _c: &[T], _t: T, q: &[T], out: &mut [T]) {
        if let Some(pin) = self.pin.map(|pin| pin.map(T::from_f64)) {
            let arm = times(&attitude(&q[3..]), pin);
            out.iter_mut().zip(q).zip(arm).for_each(|((out, q), arm)| *out = *q + arm);
        }
    }

    fn velocity_constraint(&self, _c: &[T], _t: T, q: &[T], v: &[T], out: &mut [T]) {
        if let Some(pin) = self.pin.map(|pin| pin.map(T::from_f64)) {
            let rate = times(&attitude(&q[3..]), cross(&v[3..], pin));
            out.iter_mut().zip(v).zip(rate).for_each(|((out, v), rate)| *out = *v + rate);
        }
    }

    fn velocity_jacobian(&self, _c: &[T], _t: T, q: &[T], out: &mut [T]) {
        if let Some(pin) = self.pin.map(|pin| pin.map(T::from_f64)) {
            let r = attitude(&q[3..]);
            let [o, one] = [0.0, 1.0].map(T::from_f64);
            let axes = [[one, o, o], [o, one, o], [o, o, one]];
            let columns = axes.map(|axis| times(&r, cross(&axis, pin)));
            for (i, row) in out.chunks_exact_mut(4).enumerate() {
                row.copy_from_slice(&[one, columns[0][i], columns[1][i], columns[2][i]]);
            }
        }
    }

    fn convective_term(&self, _c: &[T], _t: T, q: &[T], v: &[T], out: &mut [T]) {
        if let Some(pin) = self.pin.map(|pin| pin.map(T::from_f64)) {
            out.copy_from_slice(&times(&attitude(&q[3..]), cross(&v[3..], cross(&v[3..], pin))));
        }
    }

    fn applied_force(&self, _c: &[T], _t: T, _q: &[T], v: &[T], out: &mut [T]) {
        out[..3].copy_from_slice(&[0.0, 0.0, -MASS * self.gravity].map(T::from_f64));
        let omega = &v[3..];
        let momentum = std::array::from_fn(|i| T::from_f64(self.inertia[i]) * omega[i]);
        out[3..].copy_from_slice(&cross(omega, momentum).map(|x| -x));
    }
}

impl Derived for Top {
    #[cfg(feature = "analysis")]
    fn with_derivatives(&self) -> Option<&dyn EquationsWithDerivatives> {
        Some(self)
    }
}

impl Scene for Top {
    fn info(&self) -> Arc<SceneInfo> {
        Arc::clone(&INFOS[usize::from(self.pin.is_some())])
    }

    fn parameter(&self, _index: usize) -> f64 {
        f64::NAN
    }

    fn set_parameter(&mut self, _index: usize, _value: f64) {}

    /// The attitude and its rate are given; of a pinned body the centre follows.
    fn start(&self, _c: &[f64], start: &mut Start) {
        let (p, omega) = self.start;
        p.iter().enumerate().for_each(|(i, p)| start.give_position(3 + i, *p));
        omega.iter().enumerate().for_each(|(i, omega)| start.give_velocity(3 + i, *omega));
    }

    fn power(&self, _c: &[f64], _t: f64, _q: &[f64], _v: &[f64], _lambda: &[f64], _out: &mut [f64]) {}

    fn potential_energy(&self, _c: &[f64], _t: f64, q: &[f64]) -> f64 {
        MASS * self.gravity * q[2]
    }

    fn points(&self, _c: &[f64], _t: f64, _q: &[f64], _out: &mut [f64]) {}
}
