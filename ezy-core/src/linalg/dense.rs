//! Dense K with partial pivoting.

use super::refinement::Refinement;
use super::scaled::{Entry, assemble, scale};
use super::{KktFactorization, VanishedPivot};
use crate::model::{PIVOT_TOLERANCE, SparsityPattern};
use nalgebra::{DMatrix, DVectorViewMut, linalg};

/// Largest n_q + n_c for which a dense K is made: 70 MB and some seconds a factorisation.
pub const LARGEST_DENSE: usize = 3_000;

/// Share of the terms of an equation that counts as their rounding.
const ENOUGH: f64 = 4.0 * f64::EPSILON;

/// Corrections of a solution: the first squares its relative error, the second is for ratios of masses of 1e12.
const MAX_REFINEMENTS: usize = 2;

/// Masses, kg or kg·m², in whose own units K looks as it does in these.
const OF_ORDER_ONE: std::ops::Range<f64> = 1e-6..1e6;

/// LU factors of the scaled K. M may be singular as long as K is not: massless bodies that are held by rows.
///
/// K is scaled on both sides by one diagonal, so that pivots of heavy and light bodies, of metres and radians,
/// compare with one tolerance. Solutions are refined: where a light body carries the load of a heavy one, elimination mixes
/// its acceleration with the multipliers and keeps 7e-8 of it at a ratio of 1e10.
pub struct DenseKkt {
    entries: Vec<Entry>,
    factors: DMatrix<f64>,
    scale: Vec<f64>,
    largest: Vec<f64>,
    pivot_rows: Vec<usize>,
    refinement: Refinement,
    is_damped: bool,
}

impl DenseKkt {
    /// Storage for `n_q` coordinates and the first `n_rows` rows of `pattern`; everything is allocated here.
    pub fn new(n_q: usize, pattern: &SparsityPattern, n_rows: usize) -> Self {
        let n = n_q + n_rows;
        Self {
            refinement: Refinement::new(n_q, n_rows, pattern),
            entries: pattern.entries().filter(|(_, row, _)| *row < n_rows).collect(),
            factors: DMatrix::zeros(n, n),
            scale: vec![1.0; n],
            largest: vec![0.0; n],
            pivot_rows: vec![0; n],
            is_damped: false,
        }
    }
}

impl DenseKkt {
    /// D of the last factorisation of D K D.
    pub(super) fn scale(&self) -> &[f64] {
        &self.scale
    }

    /// Smallest pivot of the last successful factorisation, and its unknown.
    pub(super) fn weakest_unknown(&self) -> (f64, usize) {
        let pivots = (0..self.scale.len()).map(|i| (self.factors[(i, i)].abs(), i));
        pivots.min_by(|(x, _), (y, _)| x.total_cmp(y)).unwrap_or((1.0, 0))
    }
}

/// Smallest pivot of a damped K: damping leaves no pivot of a row below its share, unless a number is not finite or
/// nothing moves a coordinate.
const DAMPED_TOLERANCE: f64 = 1e-15;

impl KktFactorization for DenseKkt {
    fn factor(&mut self, mass: &[f64], jacobian: &[f64]) -> Result<(), VanishedPivot> {
        self.refinement.keep(mass, jacobian);
        self.is_damped = false;
        self.scale_and_eliminate(mass, jacobian, 1.0).or_else(|vanished| {
            let heaviest = mass.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
            let lightest = mass.iter().copied().filter(|m| *m > 0.0).fold(heaviest, f64::min);
            // light bodies that rows hold leave pivots in units of the heaviest, those that swing freely in their own
            let units = [heaviest, lightest].into_iter().filter(|unit| !OF_ORDER_ONE.contains(unit));
            let in_these = |unit| self.scale_and_eliminate(mass, jacobian, unit).ok();
            units.into_iter().find_map(in_these).ok_or(vanished)
        })
    }

    fn factor_damped(&mut self, mass: &[f64], jacobian: &[f64], damping: &[f64]) -> Result<(), VanishedPivot> {
        self.scale_from(mass, jacobian, 1.0);
        for (i, damping) in (mass.len()..).zip(damping) {
            self.factors[(i, i)] = -self.scale[i] * damping * self.scale[i];
        }
        self.is_damped = true;
        self.eliminate(DAMPED_TOLERANCE)
    }

    fn smallest_pivot(&self) -> f64 {
        self.weakest_unknown().0
    }

    fn solve(&mut self, right_side: &mut [f64]) {
        if self.is_damped {
            // whoever damps goes on from what is left
            return self.substitute(right_side);
        }
        self.refinement.begin(right_side);
        self.substitute(right_side);
        for _ in 0..MAX_REFINEMENTS {
            if self.refinement.residual(&self.entries, right_side) <= ENOUGH {
                return;
            }
            let mut correction = std::mem::take(&mut self.refinement.residual);
            self.substitute(&mut correction);
            right_side.iter_mut().zip(&correction).for_each(|(x, dx)| *x += dx);
            self.refinement.residual = correction;
        }
    }
}

impl DenseKkt {
    /// Writes K, scaled from a unit of mass on.
    fn scale_from(&mut self, mass: &[f64], jacobian: &[f64], unit: f64) {
        let (coordinates, rows) = self.scale.split_at_mut(mass.len());
        coordinates.fill(1.0 / unit.sqrt());
        rows.fill(unit.sqrt());
        scale(&self.entries, mass, jacobian, &mut self.scale, &mut self.largest);
        assemble(&self.entries, mass, jacobian, &self.scale, &mut self.factors);
    }

    fn scale_and_eliminate(&mut self, mass: &[f64], jacobian: &[f64], unit: f64) -> Result<(), VanishedPivot> {
        self.scale_from(mass, jacobian, unit);
        self.eliminate(PIVOT_TOLERANCE)
    }

    /// Factors the scaled K, which stands in `factors`.
    fn eliminate(&mut self, tolerance: f64) -> Result<(), VanishedPivot> {
        let n = self.scale.len();
        for i in 0..n {
            let i_pivot = i + self.factors.view((i, i), (n - i, 1)).column(0).icamax();
            let pivot = self.factors[(i_pivot, i)];
            if pivot.is_nan() || pivot.abs() <= tolerance {
                return Err(VanishedPivot { relative: pivot.abs(), row: None });
            }
            self.pivot_rows[i] = i_pivot;
            if i_pivot != i {
                self.factors.columns_mut(0, i).swap_rows(i, i_pivot);
                linalg::gauss_step_swap(&mut self.factors, pivot, i, i_pivot);
            } else {
                linalg::gauss_step(&mut self.factors, pivot, i);
            }
        }
        Ok(())
    }

    /// Solves with the factors alone.
    fn substitute(&self, right_side: &mut [f64]) {
        for (x, d) in right_side.iter_mut().zip(&self.scale) {
            *x *= d;
        }
        for (i, &i_pivot) in self.pivot_rows.iter().enumerate() {
            right_side.swap(i, i_pivot);
        }
        let n = right_side.len();
        let mut x = DVectorViewMut::from_slice(right_side, n);
        self.factors.solve_lower_triangular_with_diag_mut(&mut x, 1.0);
        // every pivot is non-zero after a successful factor
        self.factors.solve_upper_triangular_mut(&mut x);
        for (x, d) in right_side.iter_mut().zip(&self.scale) {
            *x *= d;
        }
    }
}
