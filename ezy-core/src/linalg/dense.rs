//! Dense K with partial pivoting, or with complete pivoting where its entries differ too much for that.

use super::complete::{self, Swap};
use super::refinement::Refinement;
use super::scaled::{Entry, assemble, scale};
use super::{KktFactorization, LARGEST_DIAGNOSED, VanishedPivot};
use crate::model::{PIVOT_TOLERANCE, SparsityPattern};
use nalgebra::{DMatrix, DVectorViewMut, linalg};

/// Largest n_q + n_c for which a dense K is made: 70 MB and some seconds a factorisation.
pub(crate) const LARGEST_DENSE: usize = 3_000;

/// Share of the terms of an equation that counts as their rounding.
const ENOUGH: f64 = 4.0 * f64::EPSILON;

/// Corrections of a solution: the first squares its relative error, the second is for ratios of masses of 1e12.
const MAX_REFINEMENTS: usize = 2;

/// Corrections where pivots are as small as 1e-13: each leaves a thousandth.
const MAX_REFINEMENTS_IN_DOUBT: usize = 6;

/// Smallest of the complete pivots of K, of the largest: entries that are rounded to 1e-16 leave three digits of what it
/// decides, and below it soon none.
const DECIDED: f64 = 1e-13;

/// Smallest of the complete pivots of G, rows and columns scaled to one, with which rows are no neighbours of dependent
/// ones: what positions that are rounded to 1e-16 do to accelerations, 1e-16/σ³, is below 1e-11.
const INDEPENDENT: f64 = 0.03;

/// Masses, kg or kg·m², in whose own units K looks as it does in these.
const OF_ORDER_ONE: std::ops::Range<f64> = 1e-6..1e6;

/// LU factors of the scaled K. M may be singular as long as K is not: massless bodies that are held by rows.
///
/// K is scaled on both sides by one diagonal, so that pivots of heavy and light bodies, of metres and radians,
/// compare with one tolerance. Solutions are refined: where a light body carries the load of a heavy one, elimination mixes
/// its acceleration with the multipliers and keeps 7e-8 of it at a ratio of 1e10.
pub(crate) struct DenseKkt {
    entries: Vec<Entry>,
    factors: DMatrix<f64>,
    scale: Vec<f64>,
    largest: Vec<f64>,
    pivot_rows: Vec<usize>,
    refinement: Refinement,
    form: Form,
    /// Swaps of a complete pivoting.
    swaps: Vec<Swap>,
    no_mass: Vec<f64>,
}

/// What stands in the factors.
#[derive(Clone, Copy, PartialEq)]
enum Form {
    Partial,
    Complete,
    Damped,
}

impl DenseKkt {
    /// Storage for `n_q` coordinates and the first `n_rows` rows of `pattern`; everything is allocated here.
    pub(crate) fn new(n_q: usize, pattern: &SparsityPattern, n_rows: usize) -> Self {
        let n = n_q + n_rows;
        Self {
            refinement: Refinement::new(n_q, n_rows, pattern),
            entries: pattern.entries().filter(|(_, row, _)| *row < n_rows).collect(),
            factors: DMatrix::zeros(n, n),
            scale: vec![1.0; n],
            largest: vec![0.0; n],
            pivot_rows: vec![0; n],
            form: Form::Partial,
            swaps: vec![Swap::default(); n],
            no_mass: vec![0.0; n_q],
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
        let n = self.scale.len();
        let pivots = (0..n).map(|i| (self.factors[(i, i)].abs(), i));
        let (pivot, i) = pivots.min_by(|(x, _), (y, _)| x.total_cmp(y)).unwrap_or((1.0, 0));
        (pivot, if self.form == Form::Complete { complete::original_column(&self.swaps, i) } else { i })
    }

    /// Factors K by complete pivoting, down to pivots that rounding of its entries leaves of nothing; for systems of up to
    /// [`LARGEST_DIAGNOSED`] equations, since every pivot is searched for in all that is left of K.
    ///
    /// # Errors
    /// As [`KktFactorization::factor`].
    pub(crate) fn factor_completely(&mut self, mass: &[f64], jacobian: &[f64]) -> Result<(), VanishedPivot> {
        self.refinement.keep(mass, jacobian);
        self.scale_from(mass, jacobian, 1.0);
        self.form = Form::Complete;
        let n = self.scale.len();
        let relative = complete::eliminate(self.factors.view_mut((0, 0), (n, n)), &mut self.swaps);
        if relative > DECIDED { Ok(()) } else { Err(VanishedPivot { relative, row: None }) }
    }

    /// Whether G alone, whatever the masses are, has rows that are far from dependent.
    fn has_independent_rows(&mut self, jacobian: &[f64]) -> bool {
        let n_q = self.no_mass.len();
        let n_rows = self.scale.len() - n_q;
        if n_rows > n_q || self.scale.len() > LARGEST_DIAGNOSED {
            return false;
        }
        self.scale.fill(1.0);
        scale(&self.entries, &self.no_mass, jacobian, &mut self.scale, &mut self.largest);
        let mut G = self.factors.view_mut((0, 0), (n_rows, n_q));
        G.fill(0.0);
        for &(k, row, column) in &self.entries {
            G[(row, column)] += self.scale[n_q + row] * jacobian[k] * self.scale[column];
        }
        complete::eliminate(G, &mut self.swaps) > INDEPENDENT
    }
}

/// Smallest pivot of a damped K: damping leaves no pivot of a row below its share, unless a number is not finite or
/// nothing moves a coordinate.
const DAMPED_TOLERANCE: f64 = 1e-15;

impl KktFactorization for DenseKkt {
    fn factor(&mut self, mass: &[f64], jacobian: &[f64]) -> Result<(), VanishedPivot> {
        self.refinement.keep(mass, jacobian);
        self.form = Form::Partial;
        let partial = self.scale_and_eliminate(mass, jacobian, 1.0).or_else(|vanished| {
            let heaviest = mass.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
            let lightest = mass.iter().copied().filter(|m| *m > 0.0).fold(heaviest, f64::min);
            // light bodies that rows hold leave pivots in units of the heaviest, those that swing freely in their own
            let units = [heaviest, lightest].into_iter().filter(|unit| !OF_ORDER_ONE.contains(unit));
            let in_these = |unit| self.scale_and_eliminate(mass, jacobian, unit).ok();
            units.into_iter().find_map(in_these).ok_or(vanished)
        });
        match partial {
            Err(_) if self.has_independent_rows(jacobian) => self.factor_completely(mass, jacobian),
            outcome => outcome,
        }
    }

    fn factor_damped(&mut self, mass: &[f64], jacobian: &[f64], damping: &[f64]) -> Result<(), VanishedPivot> {
        self.scale_from(mass, jacobian, 1.0);
        for (i, damping) in (mass.len()..).zip(damping) {
            self.factors[(i, i)] = -self.scale[i] * damping * self.scale[i];
        }
        self.form = Form::Damped;
        self.eliminate(DAMPED_TOLERANCE)
    }

    fn smallest_pivot(&self) -> f64 {
        self.weakest_unknown().0
    }

    fn solve(&mut self, right_side: &mut [f64]) {
        let max_refinements = match self.form {
            // whoever damps goes on from what is left
            Form::Damped => return self.substitute(right_side),
            Form::Partial => MAX_REFINEMENTS,
            Form::Complete => MAX_REFINEMENTS_IN_DOUBT,
        };
        self.refinement.begin(right_side);
        self.substitute(right_side);
        for _ in 0..max_refinements {
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
        match self.form {
            Form::Complete => complete::swap_rows(&self.swaps, right_side),
            _ => self.pivot_rows.iter().enumerate().for_each(|(i, &i_pivot)| right_side.swap(i, i_pivot)),
        }
        let n = right_side.len();
        let mut x = DVectorViewMut::from_slice(right_side, n);
        self.factors.solve_lower_triangular_with_diag_mut(&mut x, 1.0);
        // every pivot is non-zero after a successful factor
        self.factors.solve_upper_triangular_mut(&mut x);
        if self.form == Form::Complete {
            complete::restore_columns(&self.swaps, right_side);
        }
        for (x, d) in right_side.iter_mut().zip(&self.scale) {
            *x *= d;
        }
    }
}
