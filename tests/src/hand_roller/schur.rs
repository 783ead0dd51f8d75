//! `[M Gᵀ; G 0] [x; y] = [f; r]` by `G M⁻¹ Gᵀ y = G M⁻¹ f − r` and LDLᵀ.

use ezy_core::__private::{PIVOT_TOLERANCE, Pivots};

pub struct Schur {
    mass: [f64; 6],
    jacobian: [[f64; 6]; 4],
    /// L below the diagonal, D on it.
    factors: [[f64; 4]; 4],
    pub pivots: Pivots,
}

impl Schur {
    pub fn new(mass: [f64; 6], jacobian: [[f64; 6]; 4]) -> Self {
        let mut l = [[0.0; 4]; 4];
        for i in 0..4 {
            for j in 0..=i {
                l[i][j] = (0..6).map(|k| jacobian[i][k] * jacobian[j][k] / mass[k]).sum();
            }
        }
        let mut pivots = Pivots::default();
        for j in 0..4 {
            let start = l[j][j];
            for k in 0..j {
                l[j][j] -= l[j][k] * l[j][k] * l[k][k];
            }
            pivots = pivots.see(&[j], l[j][j] / (PIVOT_TOLERANCE * start));
            for i in j + 1..4 {
                for k in 0..j {
                    l[i][j] -= l[i][k] * l[j][k] * l[k][k];
                }
                l[i][j] /= l[j][j];
            }
        }
        Self { mass, jacobian, factors: l, pivots }
    }

    pub fn solve(&self, f: &[f64; 6], r: &[f64; 4], x: &mut [f64], y: &mut [f64]) {
        let (g, m, l) = (&self.jacobian, &self.mass, &self.factors);
        for i in 0..4 {
            y[i] = (0..6).map(|k| g[i][k] * f[k] / m[k]).sum::<f64>() - r[i];
        }
        for i in 0..4 {
            for j in 0..i {
                y[i] -= l[i][j] * y[j];
            }
        }
        for (i, y) in y.iter_mut().enumerate() {
            *y /= l[i][i];
        }
        for i in (0..4).rev() {
            for j in i + 1..4 {
                y[i] -= l[j][i] * y[j];
            }
        }
        for k in 0..6 {
            x[k] = (f[k] - (0..4).map(|i| g[i][k] * y[i]).sum::<f64>()) / m[k];
        }
    }
}
