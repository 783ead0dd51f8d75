//! Modes: the motions exp(s t) that small deviations are made of.

use super::eigenvectors::{Eigenvectors, real_times};
use super::tolerances::mode::{ALIKE, VISIBLE};
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

    /// Those of the eigenvalues of A, in their order; none where no equations can be solved with one. `n_q`, `n_v`: numbers of coordinates
    /// and velocities among the rows of `basis`.
    pub(super) fn all(
        a: &DMatrix<f64>,
        basis: &DMatrix<f64>,
        n: [usize; 2],
        eigenvalues: impl Iterator<Item = Complex<f64>>,
    ) -> Option<Vec<Self>> {
        let vectors = Eigenvectors::of(a);
        eigenvalues.enumerate().map(|(i, s)| Self::of(vectors.of_eigenvalue(s, i)?, basis, n, s)).collect()
    }

    fn of(
        mut vector: DVector<Complex<f64>>,
        basis: &DMatrix<f64>,
        [n_q, n_v]: [usize; 2],
        s: Complex<f64>,
    ) -> Option<Self> {
        let mut deviation = real_times(basis, &vector);
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
