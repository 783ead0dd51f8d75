//! Modes: the motions exp(s t) that small deviations are made of.

use super::tolerances::mode::{ALIKE, ITERATIONS, SHIFTS, VISIBLE};
use nalgebra::{Complex, DMatrix, DVector};

/// An eigenvalue with its eigenvector: the deviation Re(`deviation` exp(s t)).
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// s, 1/s.
    pub eigenvalue: Complex<f64>,
    /// The eigenvector in the coordinates x of [`Linearization`](super::Linearization): A x = s x.
    pub vector: DVector<Complex<f64>>,
    /// The same as deviations of `n_q` coordinates, `n_v` velocities and `n_z` states. The largest one of a coordinate or state is 1.
    pub deviation: DVector<Complex<f64>>,
    /// Places in `deviation` of the coordinates and states that move most, the largest first; a length and an angle are compared as m
    /// and rad. Those that move by less than a tenth of the first one are left out.
    pub largest: Vec<usize>,
}

impl Mode {
    /// −Re s / |s|: 1 and −1 without oscillation, 0 without damping.
    pub fn damping_ratio(&self) -> f64 {
        -self.eigenvalue.re / self.eigenvalue.norm()
    }

    /// Frequency of the damped oscillation, |Im s|/2π, Hz.
    pub fn frequency_hz(&self) -> f64 {
        self.eigenvalue.im.abs() / std::f64::consts::TAU
    }

    /// Time in which it doubles, s; below zero that in which it halves, with the sign changed. Infinite where it does neither.
    pub fn doubling_time_s(&self) -> f64 {
        std::f64::consts::LN_2 / self.eigenvalue.re
    }

    /// Of an eigenvalue of `a`; `i` tells equal eigenvalues apart. None where no equations can be solved with it. `n_q`, `n_v`: numbers of
    /// coordinates and velocities among the rows of `basis`.
    pub(super) fn of(
        a: &DMatrix<f64>,
        basis: &DMatrix<f64>,
        [n_q, n_v]: [usize; 2],
        s: Complex<f64>,
        i: usize,
    ) -> Option<Self> {
        let mut vector = eigenvector(a, s, i)?;
        let mut deviation = basis.map(|x| Complex::new(x, 0.0)) * &vector;
        let is_shown = |place: usize| !(n_q..n_q + n_v).contains(&place);
        let sizes: Vec<f64> =
            deviation.iter().enumerate().map(|(place, x)| if is_shown(place) { x.norm() } else { 0.0 }).collect();
        let most = sizes.iter().fold(0.0, |most: f64, size| most.max(*size));
        // rounding does not choose among equal ones
        let rank = |place: usize| (sizes[place] / most / ALIKE).round();
        let mut largest: Vec<usize> = (0..sizes.len()).filter(|&place| sizes[place] >= VISIBLE * most).collect();
        largest.sort_by(|&i, &j| rank(j).total_cmp(&rank(i)));
        let unit = deviation[*largest.first()?];
        vector /= unit;
        deviation /= unit;
        Some(Self { eigenvalue: s, vector, deviation, largest })
    }
}

/// A unit vector x with A x = s x, by inverse iteration: (A − σ) x⁺ = x with σ beside s by rounding. The first x depends on `i`, so that
/// equal eigenvalues with several eigenvectors get different ones.
///
/// # Source
/// Golub, Van Loan, Matrix Computations, section 7.6.1.
fn eigenvector(a: &DMatrix<f64>, s: Complex<f64>, i: usize) -> Option<DVector<Complex<f64>>> {
    let n = a.nrows();
    let size = a.norm();
    let complex = a.map(|x| Complex::new(x, 0.0));
    let first = DVector::from_fn(n, |row, _| Complex::new((1.0 + (row + n * i) as f64).sin(), 0.0));
    SHIFTS.into_iter().find_map(|shift| {
        let shifted = &complex - DMatrix::identity(n, n) * (s + shift * size);
        let factors = shifted.lu();
        let mut x = first.clone();
        for _ in 0..ITERATIONS {
            x = factors.solve(&x)?;
            let norm = x.norm();
            x /= Complex::new(norm, 0.0);
        }
        x.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then_some(x)
    })
}
