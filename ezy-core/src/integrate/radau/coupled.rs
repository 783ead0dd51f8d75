//! One pass of Newton's iteration with Jacobians at every stage.

use super::entries::Entries;
use super::stages::{Stages, add_combination};
use super::tableau::{A, A_SQUARED, N_STAGES, Triple};
use crate::dynamics::{Jacobians, ResidualPlaces};
use crate::integrate::tolerances::radau::LARGEST_COUPLED;
use crate::linalg::Lu;
use crate::model::SceneInfo;

/// All three stages as one system of 3 (n_q + n_c + n_z) equations, with the Jacobians of each stage in its rows.
///
/// The simplified iteration has one set of Jacobians for the step. Where a stiff force turns by the angle φ in it, what is left of
/// them is φ times its frequency times the step, and nothing is gained once that is one; with Jacobians of their own the stages
/// converge as fast as ever.
pub(super) struct Coupled {
    pub jacobians: Jacobians,
    entries: Entries,
    lu: Lu<f64>,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    solution: Vec<f64>,
    changes: Triple<Vec<f64>>,
    changes_of_rates: Triple<Vec<f64>>,
    of_q: Vec<f64>,
    of_v: Vec<f64>,
    of_z: Vec<f64>,
}

impl Coupled {
    /// None for a scene with too many equations.
    pub(super) fn new(info: &SceneInfo, places: &ResidualPlaces) -> Option<Self> {
        let (n_q, n_z, n_equations) = (info.n_coordinates(), info.n_states(), info.n_unknowns() + info.n_states());
        let n = N_STAGES * n_equations;
        let zeros = |n: usize| vec![0.0; n];
        (n_equations <= LARGEST_COUPLED).then(|| Self {
            jacobians: Jacobians::zero(info, places),
            entries: Entries::new(info, places),
            lu: Lu::new(n),
            row_scale: zeros(n),
            column_scale: zeros(n),
            solution: zeros(n),
            changes: std::array::from_fn(|_| zeros(n_q)),
            changes_of_rates: std::array::from_fn(|_| zeros(n_z)),
            of_q: zeros(n_q),
            of_v: zeros(n_q),
            of_z: zeros(n_z),
        })
    }

    /// Takes the Jacobians of stage `i` of a step of length `h` into its rows.
    pub(super) fn write(&mut self, i: usize, h: f64, mass: &[f64]) {
        self.entries.write(mass, &self.jacobians);
        for j in 0..N_STAGES {
            let own = if i == j { 1.0 } else { 0.0 };
            self.entries.write_block([i, j], own, h * A[i][j], h * h * A_SQUARED[i][j], self.lu.matrix_mut());
        }
    }

    /// Improves the stages, as [`Newton::improve`](super::newton::Newton::improve); not a number when the matrix is singular.
    pub(super) fn improve(&mut self, residual: &Triple<Vec<f64>>, stages: &mut Stages, h: f64, weights: &[f64]) -> f64 {
        let (n_q, n_c) = (self.of_q.len(), stages.lambda[0].len());
        let n = residual[0].len();
        self.entries.scale_blocks(self.lu.matrix_mut(), &mut self.row_scale, &mut self.column_scale);
        if !self.lu.factor() {
            return f64::NAN;
        }
        for (x, (r, scale)) in self.solution.iter_mut().zip(residual.iter().flatten().zip(&self.row_scale)) {
            *x = r * scale;
        }
        self.lu.solve(&mut self.solution);
        self.solution.iter_mut().zip(&self.column_scale).for_each(|(x, scale)| *x *= scale);
        for (i, solution) in self.solution.chunks_exact(n).enumerate() {
            let (a, rest) = solution.split_at(n_q);
            let (lambda, rates) = rest.split_at(n_c);
            self.changes[i].copy_from_slice(a);
            self.changes_of_rates[i].copy_from_slice(rates);
            stages.a[i].iter_mut().zip(a).for_each(|(x, change)| *x += change);
            stages.lambda[i].iter_mut().zip(lambda).for_each(|(x, change)| *x += change);
            stages.rates[i].iter_mut().zip(rates).for_each(|(x, change)| *x += change);
        }
        let mut squares = 0.0;
        for i in 0..N_STAGES {
            let Self { changes, changes_of_rates, of_q, of_v, of_z, .. } = self;
            for (table, factor, changes, of, weights, target) in [
                (&A, h, &*changes, of_v, &weights[n_q..], &mut stages.v[i]),
                (&A_SQUARED, h * h, changes, of_q, &weights[..n_q], &mut stages.q[i]),
                (&A, h, changes_of_rates, of_z, &weights[2 * n_q..], &mut stages.z[i]),
            ] {
                of.fill(0.0);
                add_combination(&table[i].map(|weight| factor * weight), changes, of);
                for ((change, weight), x) in of.iter().zip(weights).zip(target.iter_mut()) {
                    *x += change;
                    squares += (change * weight).powi(2);
                }
            }
        }
        (squares / (N_STAGES * weights.len()).max(1) as f64).sqrt()
    }
}
