//! `[M Gᵀ; G 0] [x; y] = [f; r]` by `G M⁻¹ Gᵀ y = G M⁻¹ f − r` and LDLᵀ, in any numbers.

use ezy_core::__private::{PIVOT_TOLERANCE, Pivots};
use ezy_core::scalar::Scalar;

/// Entries of the factors: row by row L below the diagonal, D on it.
pub const N_FACTORS: usize = 16;

/// M and G.
pub struct Schur<T> {
    pub mass: [T; 6],
    pub jacobian: [[T; 6]; 4],
}

impl<T: Scalar> Schur<T> {
    pub fn factor(&self, l: &mut [T]) -> Pivots {
        let (g, m, zero) = (&self.jacobian, &self.mass, T::from_f64(0.0));
        for i in 0..4 {
            for j in 0..=i {
                l[4 * i + j] = (0..6).fold(zero, |sum, k| sum + g[i][k] * g[j][k] / m[k]);
            }
        }
        let mut pivots = Pivots::default();
        for j in 0..4 {
            let start = l[5 * j];
            for k in 0..j {
                l[5 * j] = l[5 * j] - l[4 * j + k] * l[4 * j + k] * l[5 * k];
            }
            pivots = pivots.see(&[j], l[5 * j].least_ratio(T::from_f64(PIVOT_TOLERANCE) * start));
            for i in j + 1..4 {
                for k in 0..j {
                    l[4 * i + j] = l[4 * i + j] - l[4 * i + k] * l[4 * j + k] * l[5 * k];
                }
                l[4 * i + j] = l[4 * i + j] / l[5 * j];
            }
        }
        pivots
    }

    pub fn solve(&self, l: &[T], f: &[T], r: &[T], x: &mut [T], y: &mut [T]) {
        let (g, m) = (&self.jacobian, &self.mass);
        for i in 0..4 {
            y[i] = (0..6).fold(-r[i], |sum, k| sum + g[i][k] * f[k] / m[k]);
            y[i] = (0..i).fold(y[i], |sum, j| sum - l[4 * i + j] * y[j]);
        }
        for (i, y) in y.iter_mut().enumerate() {
            *y = *y / l[5 * i];
        }
        for i in (0..4).rev() {
            y[i] = (i + 1..4).fold(y[i], |sum, j| sum - l[4 * j + i] * y[j]);
        }
        for k in 0..6 {
            x[k] = (0..4).fold(f[k], |sum, i| sum - g[i][k] * y[i]) / m[k];
        }
    }
}
