//! K scaled on both sides by one diagonal, so that heavy and light bodies, metres and radians compare.

use nalgebra::DMatrix;

/// Index of the value, row and column of an entry of G.
pub(super) type Entry = (usize, usize, usize);

/// Writes D K D for the diagonal `d` of [`scale`]; entries of G at one place add up.
pub(super) fn assemble(entries: &[Entry], mass: &[f64], jacobian: &[f64], d: &[f64], K: &mut DMatrix<f64>) {
    let n_q = mass.len();
    K.fill(0.0);
    for i in 0..n_q {
        K[(i, i)] = d[i] * mass[i] * d[i];
    }
    for &(k, row, column) in entries {
        let g = d[n_q + row] * jacobian[k] * d[column];
        K[(n_q + row, column)] += g;
        K[(column, n_q + row)] += g;
    }
}

/// Passes of the equilibration: each takes the root of the exponent that is left, so that ratios of 1e10 end at 4.
const PASSES: usize = 4;

/// As many as any ratio of two doubles needs, 10^632, to end at 1.4.
const MOST_PASSES: usize = 12;

/// What the last pass may find; beyond it one more follows.
const NEAR_ONE: std::ops::Range<f64> = 1e-2..1e2;

/// From the `d` that it is given, D such that the largest entry of each row and column of D K D is near one. Only entries
/// decide, never reciprocals of masses: a body of negligible inertia is scaled like one without.
///
/// # Source
/// Ruiz, A scaling algorithm to equilibrate both rows and columns norms in matrices (2001), in the maximum norm.
pub(super) fn scale(entries: &[Entry], mass: &[f64], jacobian: &[f64], d: &mut [f64], largest: &mut [f64]) {
    let n_q = mass.len();
    for pass in 1..=MOST_PASSES {
        largest.fill(0.0);
        for (i, m) in mass.iter().enumerate() {
            largest[i] = d[i] * m * d[i];
        }
        for &(k, row, column) in entries {
            let g = (d[n_q + row] * jacobian[k] * d[column]).abs();
            largest[column] = largest[column].max(g);
            largest[n_q + row] = largest[n_q + row].max(g);
        }
        let mut is_even = true;
        for (d, largest) in d.iter_mut().zip(&*largest).filter(|(_, largest)| **largest > 0.0) {
            *d /= largest.sqrt();
            is_even &= NEAR_ONE.contains(largest);
        }
        if pass >= PASSES && is_even {
            return;
        }
    }
}
