//! K scaled on both sides by one diagonal, so that heavy and light bodies, metres and radians compare.

use nalgebra::DMatrix;

/// Index of the value, row and column of an entry of G.
pub type Entry = (usize, usize, usize);

/// Writes D K D for the diagonal `d` of [`scale`].
pub fn assemble(entries: &[Entry], mass: &[f64], jacobian: &[f64], d: &[f64], K: &mut DMatrix<f64>) {
    let n_q = mass.len();
    K.fill(0.0);
    for i in 0..n_q {
        K[(i, i)] = d[i] * mass[i] * d[i];
    }
    for &(k, row, column) in entries {
        let g = d[n_q + row] * jacobian[k] * d[column];
        K[(n_q + row, column)] = g;
        K[(column, n_q + row)] = g;
    }
}

/// D such that D K D has entries near one: `1/√m` for a coordinate with mass; `1/√(g M⁻¹ gᵀ)` for a row g, over
/// the coordinates with mass (without any, `1/|g|`); `1/|D Gᵀ|` for a coordinate without mass.
pub fn scale(entries: &[Entry], mass: &[f64], jacobian: &[f64], d: &mut [f64]) {
    let (d_q, d_rows) = d.split_at_mut(mass.len());
    for (d, m) in d_q.iter_mut().zip(mass) {
        *d = if *m > 0.0 { 1.0 / m.sqrt() } else { 0.0 };
    }
    d_rows.fill(0.0);
    for &(k, row, column) in entries {
        d_rows[row] += (jacobian[k] * d_q[column]).powi(2);
    }
    for (row, d) in d_rows.iter_mut().enumerate() {
        if *d == 0.0 {
            *d = entries.iter().filter(|e| e.1 == row).map(|e| jacobian[e.0].powi(2)).sum();
        }
        *d = if *d == 0.0 { 1.0 } else { 1.0 / d.sqrt() };
    }
    if d_q.contains(&0.0) {
        for (column, d) in d_q.iter_mut().enumerate().filter(|(_, d)| **d == 0.0) {
            let s: f64 = entries.iter().filter(|e| e.2 == column).map(|e| (jacobian[e.0] * d_rows[e.1]).powi(2)).sum();
            *d = if s == 0.0 { 1.0 } else { 1.0 / s.sqrt() };
        }
    }
}
