//! A chain of equal rods under gravity, hung from the origin: as many rows as one likes.
//!
//! Without a generated elimination: its kernels answer through a dense solution, so that the dense and the sparse
//! backend can be compared with it at any size.

use crate::leaked::{Description, info};
use ezy_core::model::{DeficientRows, EffectInfo, Scene, SceneInfo, Start};
use nalgebra::{DMatrix, DVector};

const LENGTH: f64 = 1.0;
const MASS: f64 = 1.0;
const INERTIA: f64 = MASS * LENGTH * LENGTH / 12.0;
const GRAVITY: f64 = 9.81;
const EFFECTS: [EffectInfo; 1] = [EffectInfo { name: "gravity", documentation: "" }];

/// `n` rods; hinge `i` joins rod `i − 1` (the ground for the first) and rod `i`.
pub struct Chain {
    n: usize,
    info: &'static SceneInfo,
}

impl Chain {
    /// A chain of `n` rods.
    pub fn new(n: usize) -> Self {
        let axes = |i: usize| ["x", "y"].map(|axis| format!("pin{i}.{axis}"));
        let columns = |i: usize| {
            [0, 1].map(|axis| {
                let before = if i == 0 { vec![] } else { vec![3 * i - 3 + axis, 3 * i - 1] };
                [before, vec![3 * i + axis, 3 * i + 2]].concat()
            })
        };
        let description = Description {
            model: "Chain",
            n_bodies: n,
            rows: (0..n).flat_map(axes).collect(),
            n_position_rows: 2 * n,
            columns: (0..n).flat_map(columns).collect(),
            parameters: &[],
            effects: &EFFECTS,
            until_s: 1.0,
        };
        Self { n, info: info(description) }
    }

    /// Rows of C at position level for angles and their first and second time derivatives: the end of rod `i − 1`
    /// less the beginning of rod `i`, of which `f` gives the half rod as a vector.
    fn rows(&self, f: impl Fn(usize) -> [f64; 2], centres: &[f64], out: &mut [f64]) {
        for i in 0..self.n {
            for axis in 0..2 {
                let end = if i == 0 { 0.0 } else { centres[3 * i - 3 + axis] + f(i - 1)[axis] };
                out[2 * i + axis] = end - (centres[3 * i + axis] - f(i)[axis]);
            }
        }
    }

    fn solve(&self, q: &[f64], f: &[f64], r: &[f64], x: &mut [f64], y: &mut [f64]) -> DeficientRows {
        let (n_q, n_c) = (3 * self.n, 2 * self.n);
        let mut entries = vec![0.0; self.info.jacobian.n_nonzeros()];
        self.velocity_jacobian(&[], 0.0, q, &mut entries);
        let mut kkt = DMatrix::zeros(n_q + n_c, n_q + n_c);
        let mut mass = vec![0.0; n_q];
        self.mass_matrix(&[], &mut mass);
        (0..n_q).for_each(|i| kkt[(i, i)] = mass[i]);
        for (k, row, column) in self.info.jacobian.entries() {
            kkt[(n_q + row, column)] = entries[k];
            kkt[(column, n_q + row)] = entries[k];
        }
        let right_side = DVector::from_iterator(n_q + n_c, f.iter().chain(r).copied());
        match kkt.full_piv_lu().solve(&right_side) {
            None => DeficientRows(u64::MAX),
            Some(solution) => {
                x.copy_from_slice(&solution.as_slice()[..n_q]);
                y.copy_from_slice(&solution.as_slice()[n_q..]);
                DeficientRows::default()
            }
        }
    }
}

/// Half a rod along its axis.
fn half(phi: f64) -> [f64; 2] {
    [0.5 * LENGTH * phi.cos(), 0.5 * LENGTH * phi.sin()]
}

impl Scene for Chain {
    fn info(&self) -> &'static SceneInfo {
        self.info
    }

    fn parameter(&self, _index: usize) -> f64 {
        f64::NAN
    }

    fn set_parameter(&mut self, _index: usize, _value: f64) {}

    fn constants(&self, _c: &mut [f64]) {}

    fn start(&self, _c: &[f64], start: &mut Start) {
        (0..self.n).for_each(|i| start.give_position(3 * i + 2, 0.1 * i as f64));
    }

    fn mass_matrix(&self, _c: &[f64], m: &mut [f64]) {
        m.chunks_exact_mut(3).for_each(|m| m.copy_from_slice(&[MASS, MASS, INERTIA]));
    }

    fn position_constraint(&self, _c: &[f64], _t: f64, q: &[f64], out: &mut [f64]) {
        self.rows(|i| half(q[3 * i + 2]), q, out);
    }

    fn velocity_constraint(&self, _c: &[f64], _t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let turning = |i: usize| {
            let ([x, y], w) = (half(q[3 * i + 2]), v[3 * i + 2]);
            [-w * y, w * x]
        };
        self.rows(turning, v, out);
    }

    fn velocity_jacobian(&self, _c: &[f64], _t: f64, q: &[f64], out: &mut [f64]) {
        for (k, row, column) in self.info.jacobian.entries() {
            let (i, axis) = (row / 2, row % 2);
            let [x, y] = half(q[3 * (column / 3) + 2]);
            // on the angle: the half rod, turned; the same sign on both sides of a hinge
            let angle = [-y, x][axis];
            out[k] = match (column % 3 == 2, column / 3 == i) {
                (true, _) => angle,
                (false, true) => -1.0,
                (false, false) => 1.0,
            };
        }
    }

    fn convective_term(&self, _c: &[f64], _t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        let centripetal = |i: usize| half(q[3 * i + 2]).map(|x| -x * v[3 * i + 2] * v[3 * i + 2]);
        self.rows(centripetal, &vec![0.0; 3 * self.n], out);
    }

    fn applied_force(&self, _c: &[f64], _t: f64, _q: &[f64], _v: &[f64], out: &mut [f64]) {
        out.chunks_exact_mut(3).for_each(|f| f.copy_from_slice(&[0.0, -MASS * GRAVITY, 0.0]));
    }

    fn power(&self, _c: &[f64], _t: f64, _q: &[f64], v: &[f64], _lambda: &[f64], out: &mut [f64]) {
        out[0] = v.chunks_exact(3).map(|v| -MASS * GRAVITY * v[1]).sum();
    }

    fn potential_energy(&self, _c: &[f64], _t: f64, _q: &[f64]) -> f64 {
        0.0
    }

    fn points(&self, _c: &[f64], _t: f64, _q: &[f64], _out: &mut [f64]) {}

    fn outputs(&self, _c: &[f64], _t: f64, _q: &[f64], _v: &[f64], _out: &mut [f64]) {}

    fn accelerations(
        &self,
        c: &[f64],
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> DeficientRows {
        let (mut f, mut h) = (vec![0.0; 3 * self.n], vec![0.0; 2 * self.n]);
        self.applied_force(c, t, q, v, &mut f);
        self.convective_term(c, t, q, v, &mut h);
        h.iter_mut().for_each(|h| *h = -*h);
        self.solve(q, &f, &h, a, lambda)
    }

    fn correction(&self, _c: &[f64], _t: f64, q: &[f64], residual: &[f64], delta: &mut [f64]) -> DeficientRows {
        let minus: Vec<f64> = residual.iter().map(|r| -r).collect();
        self.solve(q, &vec![0.0; 3 * self.n], &minus, delta, &mut vec![0.0; 2 * self.n])
    }
}
