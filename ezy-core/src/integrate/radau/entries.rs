//! Entries of the matrices of the simplified Newton iteration, before they are factored.

use super::factors::Factors;
use crate::dynamics::{Jacobians, ResidualPlaces, State};
use crate::integrate::tolerances::radau::{DAMPING, ROUNDING};
use crate::linalg::{SparseKktError, SparseNumber};
use crate::model::{JacobianPlaces, SceneInfo};
use nalgebra::{ComplexField, DMatrix};
use std::ops::Range;

/// K, R_v, R_q and R_z of `N(μ) = [K 0; 0 1] − [R_v/μ + R_q/μ² | 0 | R_z/μ]` at common places. Rows and columns of accelerations and multipliers
/// come first, then those of the rates of first-order states.
///
/// The unit of force is chosen so that no mass, and no stiffness that is added to one, exceeds one. Rows and columns are then
/// equilibrated: their largest entries are one. The rows of G get a small diagonal, [`DAMPING`], so that N is regular with
/// redundant constraints. The iteration converges as before, since its residual is exact.
///
/// A row that holds the heaviest body by light ones leaves a pivot of 1/m, which is one in the unit of that mass: the small
/// diagonal stays small beside it at any ratio of masses. Small masses lose nothing by that unit: beside entries of G they are
/// no pivots, and no entry of G is added to them.
///
/// A state may have any unit, and a rate may follow a velocity by any number over a second. So columns of accelerations are scaled without the rows
/// of rates, and those of rates by the forces that read their states.
pub(super) struct Entries {
    n_q: usize,
    /// Of rows of G, between those of motion and those of rates.
    rows: Range<usize>,
    /// Sparsity pattern by rows.
    starts: Vec<usize>,
    columns: Vec<usize>,
    /// [K 0; 0 1], R_v with R_z, and R_q.
    fixed: Vec<f64>,
    by_v: Vec<f64>,
    by_q: Vec<f64>,
    places: Places,
    row_scale: Vec<f64>,
    column_scale: Vec<f64>,
    /// Magnitudes of the entries of N(μ), for the time of a call.
    sizes: Vec<f64>,
}

/// Places of what is written.
struct Places {
    mass: Vec<usize>,
    jacobian: Vec<usize>,
    transposed: Vec<usize>,
    by_q: Vec<usize>,
    by_v: Vec<usize>,
    rates: Vec<usize>,
    by_z: Vec<usize>,
}

impl Entries {
    pub(super) fn new(info: &SceneInfo, jacobians: &ResidualPlaces) -> Self {
        let (n_q, first_rate) = (info.n_coordinates(), info.n_unknowns());
        let n = first_rate + info.n_states();
        let jacobian = || info.jacobian.entries().map(|(_, row, column)| (row, column));
        let mass: Vec<_> = (0..n_q).map(|i| (i, i)).collect();
        let rows: Vec<_> = jacobian().map(|(row, column)| (n_q + row, column)).collect();
        let transposed: Vec<_> = jacobian().map(|(row, column)| (column, n_q + row)).collect();
        let ResidualPlaces { by_motion: JacobianPlaces { by_q, by_v }, by_z } = jacobians;
        let by_z: Vec<_> = by_z.iter().map(|&(row, column)| (row, first_rate + column)).collect();
        let damped: Vec<_> = (n_q..first_rate).map(|i| (i, i)).collect();
        let rates: Vec<_> = (first_rate..n).map(|i| (i, i)).collect();
        let mut all = [&mass[..], &rows, &transposed, &damped, by_q, by_v, &rates, &by_z].concat();
        all.sort_unstable();
        all.dedup();
        let places = |entries: &[(usize, usize)]| {
            entries.iter().map(|entry| all.partition_point(|other| other < entry)).collect()
        };
        Self {
            n_q,
            rows: n_q..first_rate,
            places: Places {
                mass: places(&mass),
                jacobian: places(&rows),
                transposed: places(&transposed),
                by_q: places(by_q),
                by_v: places(by_v),
                rates: places(&rates),
                by_z: places(&by_z),
            },
            starts: (0..=n).map(|row| all.partition_point(|entry| entry.0 < row)).collect(),
            sizes: vec![0.0; all.len()],
            fixed: vec![0.0; all.len()],
            by_v: vec![0.0; all.len()],
            by_q: vec![0.0; all.len()],
            columns: all.into_iter().map(|(_, column)| column).collect(),
            row_scale: vec![1.0; n],
            column_scale: vec![1.0; n],
        }
    }

    /// Number of rows and columns.
    pub(super) fn n(&self) -> usize {
        self.row_scale.len()
    }

    /// Takes M, G and the Jacobians at one state.
    pub(super) fn write(&mut self, mass: &[f64], jacobians: &Jacobians) {
        let Self { fixed, by_v, by_q, places, .. } = self;
        for values in [&mut *fixed, by_v, by_q] {
            values.fill(0.0);
        }
        let add = |values: &mut [f64], places: &[usize], terms: &[f64]| {
            places.iter().zip(terms).for_each(|(place, term)| values[*place] += term);
        };
        add(fixed, &places.mass, mass);
        add(fixed, &places.jacobian, &jacobians.jacobian);
        add(fixed, &places.transposed, &jacobians.jacobian);
        add(by_v, &places.by_v, &jacobians.by_v);
        add(by_q, &places.by_q, &jacobians.by_q);
        places.rates.iter().for_each(|place| fixed[*place] += 1.0);
        add(by_v, &places.by_z, &jacobians.by_z);
    }

    /// Chooses the scales for μ: the unit of forces, then columns, then rows.
    pub(super) fn scale(&mut self, mu: f64) {
        let Self { n_q, rows, starts, columns, fixed, by_v, by_q, row_scale, column_scale, sizes, .. } = self;
        for (size, ((fixed, by_v), by_q)) in sizes.iter_mut().zip(fixed.iter().zip(by_v).zip(by_q)) {
            *size = (*fixed - (*by_v + *by_q / mu) / mu).abs();
        }
        let (of_motion, first_rate) = (starts[*n_q], starts[rows.end]);
        let masses = sizes[..of_motion].iter().zip(&*columns).filter(|(_, column)| **column < *n_q);
        let unit = reciprocal(masses.fold(0.0, |largest: f64, (size, _)| largest.max(*size)));
        column_scale.fill(0.0);
        for (place, (size, &column)) in sizes[..first_rate].iter().zip(&*columns).enumerate() {
            let size = if place < of_motion { unit * size } else { *size };
            column_scale[column] = size.max(column_scale[column]);
        }
        for column in (0..column_scale.len()).filter(|_| first_rate < sizes.len()) {
            if column_scale[column] == 0.0 {
                let own = sizes[first_rate..].iter().zip(&columns[first_rate..]).filter(|(_, other)| **other == column);
                column_scale[column] = own.fold(0.0, |largest: f64, (size, _)| largest.max(*size));
            }
        }
        column_scale.iter_mut().for_each(|scale| *scale = reciprocal(*scale));
        for (scale, ends) in row_scale.iter_mut().zip(starts.windows(2)) {
            let (sizes, columns) = (&sizes[ends[0]..ends[1]], &columns[ends[0]..ends[1]]);
            let scaled = sizes.iter().zip(columns).map(|(size, column)| size * column_scale[*column]);
            *scale = reciprocal(scaled.fold(0.0, f64::max));
        }
    }

    /// Storage for the factors of a matrix with these entries.
    ///
    /// # Errors
    /// [`SparseKktError`] when there is no memory for an analysis.
    pub(super) fn factors<T>(&self) -> Result<Factors<T>, SparseKktError>
    where
        T: ComplexField<RealField = f64> + SparseNumber,
    {
        Factors::new(&self.starts, &self.columns)
    }

    /// Writes the scaled N(μ).
    pub(super) fn assemble<T>(&self, mu: T, factors: &mut Factors<T>)
    where
        T: ComplexField<RealField = f64> + SparseNumber,
    {
        let length = nalgebra::one::<T>() / mu;
        let rows = self.row_scale.iter().zip(self.starts.windows(2)).enumerate();
        factors.write(rows.flat_map(|(i, (row_scale, ends))| {
            (ends[0]..ends[1]).map(move |place| {
                let j = self.columns[place];
                let slope = length * (T::from_real(self.by_v[place]) + length.scale(self.by_q[place]));
                let entry = (T::from_real(self.fixed[place]) - slope).scale(row_scale * self.column_scale[j]);
                let damping = if i == j && self.rows.contains(&i) { DAMPING } else { 0.0 };
                ((i, j), entry - T::from_real(damping))
            })
        }));
    }

    /// Writes `K·own − R_v·of_v − R_q·of_q` into block (row, column) of a matrix of several such blocks, not scaled, and R_z as R_v; the columns
    /// of R_v and R_q are those of the accelerations.
    pub(super) fn write_block(
        &self,
        [row, column]: [usize; 2],
        own: f64,
        of_v: f64,
        of_q: f64,
        matrix: &mut DMatrix<f64>,
    ) {
        let n = self.n();
        matrix.view_mut((row * n, column * n), (n, n)).fill(0.0);
        for i in 0..n {
            for place in self.starts[i]..self.starts[i + 1] {
                matrix[(row * n + i, column * n + self.columns[place])] =
                    own * self.fixed[place] - of_v * self.by_v[place] - of_q * self.by_q[place];
            }
        }
    }

    /// Scales a matrix of several blocks as [`Self::scale`] does, and puts the small diagonal on its rows of G.
    pub(super) fn scale_blocks(&self, matrix: &mut DMatrix<f64>, row_scale: &mut [f64], column_scale: &mut [f64]) {
        let n = self.n();
        let (is_motion, is_rate) = (|i: usize| i % n < self.n_q, |i: usize| i % n >= self.rows.end);
        let mut heaviest: f64 = 0.0;
        for j in (0..matrix.ncols()).filter(|&j| is_motion(j)) {
            let masses = matrix.column(j).into_iter().enumerate().filter(|(i, _)| is_motion(*i));
            heaviest = masses.fold(heaviest, |m, (_, x)| m.max(x.abs()));
        }
        let unit = reciprocal(heaviest);
        for (j, scale) in column_scale.iter_mut().enumerate() {
            let sizes = matrix.column(j).into_iter().enumerate().filter(|(i, _)| !is_rate(*i));
            let sizes = sizes.map(|(i, x)| if is_motion(i) { unit * x.abs() } else { x.abs() });
            let largest = sizes.fold(0.0, f64::max);
            *scale = reciprocal(if largest > 0.0 { largest } else { matrix.column(j).amax() });
            matrix.column_mut(j).scale_mut(*scale);
        }
        for (i, scale) in row_scale.iter_mut().enumerate() {
            *scale = reciprocal(matrix.row(i).amax());
            matrix.row_mut(i).scale_mut(*scale);
        }
        for i in (0..matrix.nrows()).filter(|&i| !is_motion(i) && !is_rate(i)) {
            matrix[(i, i)] -= DAMPING;
        }
    }

    /// Solves N(μ) x = right side in place with factors of the scaled one.
    pub(super) fn solve<T>(&self, factors: &mut Factors<T>, x: &mut [T])
    where
        T: ComplexField<RealField = f64> + SparseNumber,
    {
        x.iter_mut().zip(&self.row_scale).for_each(|(x, scale)| *x = x.scale(*scale));
        factors.solve(x);
        x.iter_mut().zip(&self.column_scale).for_each(|(x, scale)| *x = x.scale(*scale));
    }

    /// What rounding of q, v, z and the unknowns a, λ and z' leaves at most of the equations of motion, `n_q`, and of the rates, `n_z`: the sum of
    /// the magnitudes of their terms.
    pub(super) fn rounding_along(&self, at: &State, [a, lambda, rates]: [&[f64]; 3], out: &mut [f64]) {
        let State { q, v, z, .. } = at;
        let first_rate = self.rows.end;
        let of_row = |row: usize| {
            let terms = (self.starts[row]..self.starts[row + 1]).map(|place| match self.columns[place] {
                j if j < self.n_q => {
                    (self.by_q[place] * q[j]).abs() + (self.by_v[place] * v[j]).abs() + (self.fixed[place] * a[j]).abs()
                }
                j if j < first_rate => (self.fixed[place] * lambda[j - self.n_q]).abs(),
                j => {
                    let i = j - first_rate;
                    (self.by_v[place] * z[i]).abs() + (self.fixed[place] * rates[i]).abs()
                }
            });
            ROUNDING * terms.sum::<f64>()
        };
        let rows = (0..self.n_q).chain(first_rate..self.n());
        out.iter_mut().zip(rows).for_each(|(x, row)| *x = of_row(row));
    }

    /// `R_q q + R_v v + R_z z` (`n_q + n_c + n_z`) of these changes of a state.
    pub(super) fn slope_along(&self, of: &State, out: &mut [f64]) {
        for (x, ends) in out.iter_mut().zip(self.starts.windows(2)) {
            *x = (ends[0]..ends[1]).fold(0.0, |sum, place| match self.columns[place] {
                j if j < self.n_q => sum + self.by_q[place] * of.q[j] + self.by_v[place] * of.v[j],
                j if j < self.rows.end => sum,
                j => sum + self.by_v[place] * of.z[j - self.rows.end],
            });
        }
    }
}

/// Scale that brings the largest entry to one.
fn reciprocal(largest: f64) -> f64 {
    if largest > 0.0 { 1.0 / largest } else { 1.0 }
}
