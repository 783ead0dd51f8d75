//! The unknowns of a step: accelerations, multipliers and rates of first-order states at its stages, with the increments that follow from them.

use super::tableau::{A, A_SQUARED, N_STAGES, NODES, Triple, through_nodes};
use crate::archive::Archive;
use crate::dynamics::State;
use crate::integrate::family::Sizes;

/// Accelerations, multipliers and rates at the three stages, and the increments of velocities, positions and first-order states over the
/// start of the step that belong to them: `v_i = v_0 + h Σ A_ij a_j`, `q_i = q_0 + c_i h v_0 + h² Σ A²_ij a_j`, `z_i = z_0 + h Σ A_ij z'_j`.
#[derive(Debug, Clone)]
pub(super) struct Stages {
    /// `n_q` each.
    pub a: Triple<Vec<f64>>,
    /// `n_c` each.
    pub lambda: Triple<Vec<f64>>,
    /// Rates of first-order states, `n_z` each.
    pub rates: Triple<Vec<f64>>,
    /// Increments of positions and velocities, `n_q` each.
    pub q: Triple<Vec<f64>>,
    pub v: Triple<Vec<f64>>,
    /// Increments of first-order states, `n_z` each.
    pub z: Triple<Vec<f64>>,
    /// Increments of works.
    pub work: Triple<Vec<f64>>,
}

impl Stages {
    /// Everything zero.
    pub(super) fn zero(Sizes { n_q, n_c, n_z, n_works, .. }: Sizes) -> Self {
        let zero = |n: usize| std::array::from_fn(|_| vec![0.0; n]);
        Self {
            a: zero(n_q),
            lambda: zero(n_c),
            rates: zero(n_z),
            q: zero(n_q),
            v: zero(n_q),
            z: zero(n_z),
            work: zero(n_works),
        }
    }

    /// Writes them, or reads others over them.
    pub(super) fn remember(&mut self, archive: &mut Archive) {
        let Self { a, lambda, rates, q, v, z, work } = self;
        [a, lambda, rates, q, v, z, work].into_iter().flatten().for_each(|stage| archive.numbers(stage));
    }

    /// Everything as at the start.
    pub(super) fn hold(&mut self, a: &[f64], lambda: &[f64], rates: &[f64]) {
        self.a.iter_mut().for_each(|stage| stage.copy_from_slice(a));
        self.rates.iter_mut().for_each(|stage| stage.copy_from_slice(rates));
        self.hold_multipliers(lambda);
    }

    /// Multipliers as at the start.
    pub(super) fn hold_multipliers(&mut self, lambda: &[f64]) {
        self.lambda.iter_mut().for_each(|stage| stage.copy_from_slice(lambda));
    }

    /// Accelerations, multipliers and rates go on as in the step before, which was `1/ratio` times as long.
    pub(super) fn extrapolate(&mut self, before: &Self, ratio: f64) {
        for (i, c) in NODES.iter().enumerate() {
            let weights = through_nodes(1.0 + ratio * c);
            combine(&weights, &before.a, &mut self.a[i]);
            combine(&weights, &before.lambda, &mut self.lambda[i]);
            combine(&weights, &before.rates, &mut self.rates[i]);
        }
    }

    /// Increments of positions, velocities and states that belong to the accelerations and rates.
    pub(super) fn follow(&mut self, start_v: &[f64], h: f64) {
        for i in 0..N_STAGES {
            combine(&A[i].map(|weight| h * weight), &self.a, &mut self.v[i]);
            combine(&A[i].map(|weight| h * weight), &self.rates, &mut self.z[i]);
            combine(&A_SQUARED[i].map(|weight| h * h * weight), &self.a, &mut self.q[i]);
            self.q[i].iter_mut().zip(start_v).for_each(|(q, v)| *q += NODES[i] * h * v);
        }
    }

    /// Increments of works from the powers at the stages.
    pub(super) fn add_works(&mut self, powers: &Triple<Vec<f64>>, h: f64) {
        for (weights, work) in A.iter().zip(&mut self.work) {
            combine(&weights.map(|weight| h * weight), powers, work);
        }
    }

    /// Positions, velocities and first-order states of stage `i`.
    pub(super) fn write_state(&self, i: usize, start: &State, [q, v, z]: [&mut [f64]; 3]) {
        q.iter_mut().zip(&start.q).zip(&self.q[i]).for_each(|((q, start), by)| *q = start + by);
        v.iter_mut().zip(&start.v).zip(&self.v[i]).for_each(|((v, start), by)| *v = start + by);
        z.iter_mut().zip(&start.z).zip(&self.z[i]).for_each(|((z, start), by)| *z = start + by);
    }
}

/// `out = Σ weight x`
pub(super) fn combine(weights: &Triple, x: &Triple<Vec<f64>>, out: &mut [f64]) {
    out.fill(0.0);
    add_combination(weights, x, out);
}

/// `out += Σ weight x`
pub(super) fn add_combination(weights: &Triple, x: &Triple<Vec<f64>>, out: &mut [f64]) {
    let [first, second, third] = x;
    for (((out, first), second), third) in out.iter_mut().zip(first).zip(second).zip(third) {
        *out += weights[0] * first + weights[1] * second + weights[2] * third;
    }
}
