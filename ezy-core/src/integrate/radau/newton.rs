//! One pass of the simplified Newton iteration over all three stages.

use super::matrix::Matrices;
use super::stages::Stages;
use super::tableau::{ALPHA, BETA, GAMMA, N_STAGES, T, T_INVERSE, Triple};
use nalgebra::Complex;

/// What one pass needs.
pub(super) struct Newton {
    /// Residuals of the equations of motion and of the rates at the stages, `n_q + n_c + n_z` each.
    pub residual: Triple<Vec<f64>>,
    real: Vec<f64>,
    complex: Vec<Complex<f64>>,
}

impl Newton {
    /// For `n` equations.
    pub(super) fn new(n: usize) -> Self {
        Self {
            residual: std::array::from_fn(|_| vec![0.0; n]),
            real: vec![0.0; n],
            complex: vec![Complex::new(0.0, 0.0); n],
        }
    }

    /// Improves the stages of a step of length `h`; returns the root mean square of the changes of positions,
    /// velocities and first-order states, each times its weight (`2 n_q + n_z`).
    pub(super) fn improve(&mut self, matrices: &mut Matrices, stages: &mut Stages, h: f64, weights: &[f64]) -> f64 {
        self.solve(matrices);
        let (n_q, n_c, n_z) = (stages.a[0].len(), stages.lambda[0].len(), stages.rates[0].len());
        let (real_length, complex_length) = (h / GAMMA, Complex::new(h, 0.0) / Complex::new(ALPHA, BETA));
        let (weights_q, weights_v) = weights.split_at(n_q);
        let mut squares = 0.0;
        for j in 0..n_q {
            let (a, z) = (self.real[j], self.complex[j]);
            let (v, z_v) = (real_length * a, complex_length * z);
            let (q, z_q) = (real_length * v, complex_length * z_v);
            for (i, row) in T.iter().enumerate() {
                let back = |real: f64, complex: Complex<f64>| row[0] * real + row[1] * complex.re + row[2] * complex.im;
                let (by_q, by_v) = (back(q, z_q), back(v, z_v));
                stages.a[i][j] += back(a, z);
                stages.v[i][j] += by_v;
                stages.q[i][j] += by_q;
                squares += (by_q * weights_q[j]).powi(2) + (by_v * weights_v[j]).powi(2);
            }
        }
        for (i, row) in T.iter().enumerate() {
            let solutions = self.real[n_q..].iter().zip(&self.complex[n_q..]);
            for (lambda, (real, z)) in stages.lambda[i].iter_mut().zip(solutions) {
                *lambda += row[0] * real + row[1] * z.re + row[2] * z.im;
            }
        }
        for j in 0..n_z {
            let (rate, transformed) = (self.real[n_q + n_c + j], self.complex[n_q + n_c + j]);
            let (by_real, by_complex) = (real_length * rate, complex_length * transformed);
            for (i, row) in T.iter().enumerate() {
                let by_z = row[0] * by_real + row[1] * by_complex.re + row[2] * by_complex.im;
                stages.rates[i][j] += row[0] * rate + row[1] * transformed.re + row[2] * transformed.im;
                stages.z[i][j] += by_z;
                squares += (by_z * weights_v[n_q + j]).powi(2);
            }
        }
        (squares / (N_STAGES * weights.len()).max(1) as f64).sqrt()
    }

    /// Changes of accelerations, multipliers and rates, transformed.
    fn solve(&mut self, matrices: &mut Matrices) {
        let [first, second, third] = &self.residual;
        let row =
            |i: usize, k: usize| T_INVERSE[i][0] * first[k] + T_INVERSE[i][1] * second[k] + T_INVERSE[i][2] * third[k];
        for (k, (real, complex)) in self.real.iter_mut().zip(&mut self.complex).enumerate() {
            *real = row(0, k);
            *complex = Complex::new(row(1, k), row(2, k));
        }
        matrices.solve_real(&mut self.real);
        matrices.solve_complex(&mut self.complex);
    }
}
