//! The unknowns of a step: accelerations and multipliers of its stages, with the increments that follow from them.

use super::tableau::{A, A_SQUARED, N_STAGES, NODES, Triple, through_nodes};
use crate::archive::Archive;
use crate::dynamics::State;

/// Accelerations and multipliers at the three stages, and the increments of velocities and positions over the start of the
/// step that belong to them: `v_i = v_0 + h Σ A_ij a_j`, `q_i = q_0 + c_i h v_0 + h² Σ A²_ij a_j`.
#[derive(Debug, Clone)]
pub(super) struct Stages {
    /// `n_q` each.
    pub a: Triple<Vec<f64>>,
    /// `n_c` each.
    pub lambda: Triple<Vec<f64>>,
    /// Increments of positions and velocities, `n_q` each.
    pub q: Triple<Vec<f64>>,
    pub v: Triple<Vec<f64>>,
    /// Increments of works.
    pub work: Triple<Vec<f64>>,
}

impl Stages {
    /// Everything zero.
    pub(super) fn zero(n_coordinates: usize, n_rows: usize, n_works: usize) -> Self {
        let zero = |n: usize| std::array::from_fn(|_| vec![0.0; n]);
        Self {
            a: zero(n_coordinates),
            lambda: zero(n_rows),
            q: zero(n_coordinates),
            v: zero(n_coordinates),
            work: zero(n_works),
        }
    }

    /// Writes them, or reads others over them.
    pub(super) fn remember(&mut self, archive: &mut Archive) {
        let Self { a, lambda, q, v, work } = self;
        [a, lambda, q, v, work].into_iter().flatten().for_each(|stage| archive.numbers(stage));
    }

    /// Everything as at the start.
    pub(super) fn hold(&mut self, a: &[f64], lambda: &[f64]) {
        self.a.iter_mut().for_each(|stage| stage.copy_from_slice(a));
        self.hold_multipliers(lambda);
    }

    /// Multipliers as at the start.
    pub(super) fn hold_multipliers(&mut self, lambda: &[f64]) {
        self.lambda.iter_mut().for_each(|stage| stage.copy_from_slice(lambda));
    }

    /// Accelerations and multipliers go on as in the step before, which was `1/ratio` times as long.
    pub(super) fn extrapolate(&mut self, before: &Self, ratio: f64) {
        for (i, c) in NODES.iter().enumerate() {
            let weights = through_nodes(1.0 + ratio * c);
            combine(&weights, &before.a, &mut self.a[i]);
            combine(&weights, &before.lambda, &mut self.lambda[i]);
        }
    }

    /// Increments of positions and velocities that belong to the accelerations.
    pub(super) fn follow(&mut self, start_v: &[f64], h: f64) {
        for i in 0..N_STAGES {
            combine(&A[i].map(|weight| h * weight), &self.a, &mut self.v[i]);
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

    /// Positions and velocities of stage `i`.
    pub(super) fn write_state(&self, i: usize, start: &State, q: &mut [f64], v: &mut [f64]) {
        q.iter_mut().zip(&start.q).zip(&self.q[i]).for_each(|((q, start), by)| *q = start + by);
        v.iter_mut().zip(&start.v).zip(&self.v[i]).for_each(|((v, start), by)| *v = start + by);
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
