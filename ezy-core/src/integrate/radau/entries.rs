//! Entries of the matrices of the simplified Newton iteration, before they are factored.

use super::convergence::ROUNDING;
use super::factors::Factors;
use crate::dynamics::Jacobians;
use crate::linalg::{SparseKktError, SparseNumber};
use crate::model::{JacobianPlaces, SceneInfo};
use nalgebra::{ComplexField, DMatrix};

/// K, R_v and R_q of `N(μ) = K − [R_v/μ + R_q/μ² | 0]` at common places.
///
/// The unit of force is chosen so that no mass, and no stiffness that is added to one, exceeds one. Rows and columns are then
/// equilibrated: their largest entries are one. The rows of G get a small diagonal, [`DAMPING`], so that N is regular with
/// redundant constraints. The iteration converges as before, since its residual is exact.
///
/// A row that holds the heaviest body by light ones leaves a pivot of 1/m, which is one in the unit of that mass: the small
/// diagonal stays small beside it at any ratio of masses. Small masses lose nothing by that unit: beside entries of G they are
/// no pivots, and no entry of G is added to them.
pub(super) struct Entries {
    n_q: usize,
    /// Sparsity pattern by rows.
    starts: Vec<usize>,
    columns: Vec<usize>,
    /// K, R_v and R_q.
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
}

/// Diagonal entry of the rows of G, relative to the largest entry of the scaled row: far above the rounding of redundant rows,
/// far below what would slow the iteration.
const DAMPING: f64 = 1e-11;

impl Entries {
    pub(super) fn new(info: &SceneInfo, jacobians: &JacobianPlaces) -> Self {
        let (n_q, n) = (info.n_coordinates(), info.n_unknowns());
        let jacobian = || info.jacobian.entries().map(|(_, row, column)| (row, column));
        let mass: Vec<_> = (0..n_q).map(|i| (i, i)).collect();
        let rows: Vec<_> = jacobian().map(|(row, column)| (n_q + row, column)).collect();
        let transposed: Vec<_> = jacobian().map(|(row, column)| (column, n_q + row)).collect();
        let JacobianPlaces { by_q, by_v } = jacobians;
        let damped: Vec<_> = (n_q..n).map(|i| (i, i)).collect();
        let mut all = [&mass[..], &rows, &transposed, &damped, by_q, by_v].concat();
        all.sort_unstable();
        all.dedup();
        let places = |entries: &[(usize, usize)]| {
            entries.iter().map(|entry| all.partition_point(|other| other < entry)).collect()
        };
        Self {
            n_q,
            places: Places {
                mass: places(&mass),
                jacobian: places(&rows),
                transposed: places(&transposed),
                by_q: places(by_q),
                by_v: places(by_v),
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
    }

    /// Chooses the scales for μ: the unit of forces, then columns, then rows.
    pub(super) fn scale(&mut self, mu: f64) {
        let Self { n_q, starts, columns, fixed, by_v, by_q, row_scale, column_scale, sizes, .. } = self;
        for (size, ((fixed, by_v), by_q)) in sizes.iter_mut().zip(fixed.iter().zip(by_v).zip(by_q)) {
            *size = (*fixed - (*by_v + *by_q / mu) / mu).abs();
        }
        let of_motion = starts[*n_q];
        let masses = sizes[..of_motion].iter().zip(&*columns).filter(|(_, column)| **column < *n_q);
        let unit = reciprocal(masses.fold(0.0, |largest: f64, (size, _)| largest.max(*size)));
        column_scale.fill(0.0);
        for (place, (size, &column)) in sizes.iter().zip(&*columns).enumerate() {
            let size = if place < of_motion { unit * size } else { *size };
            column_scale[column] = size.max(column_scale[column]);
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
                let damping = if i == j && i >= self.n_q { DAMPING } else { 0.0 };
                ((i, j), entry - T::from_real(damping))
            })
        }));
    }

    /// Writes `K·own − R_v·of_v − R_q·of_q` into block (row, column) of a matrix of several such blocks, not scaled; the columns
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
        let is_motion = |i: usize| i % n < self.n_q;
        let mut heaviest: f64 = 0.0;
        for j in (0..matrix.ncols()).filter(|&j| is_motion(j)) {
            let masses = matrix.column(j).into_iter().enumerate().filter(|(i, _)| is_motion(*i));
            heaviest = masses.fold(heaviest, |m, (_, x)| m.max(x.abs()));
        }
        let unit = reciprocal(heaviest);
        for (j, scale) in column_scale.iter_mut().enumerate() {
            let sizes = matrix.column(j).into_iter().enumerate();
            let sizes = sizes.map(|(i, x)| if is_motion(i) { unit * x.abs() } else { x.abs() });
            *scale = reciprocal(sizes.fold(0.0, f64::max));
            matrix.column_mut(j).scale_mut(*scale);
        }
        for (i, scale) in row_scale.iter_mut().enumerate() {
            *scale = reciprocal(matrix.row(i).amax());
            matrix.row_mut(i).scale_mut(*scale);
        }
        for i in (0..matrix.nrows()).filter(|&i| !is_motion(i)) {
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

    /// What rounding of q, v, a and λ leaves at most of the equations of motion, `n_q`: the sum of the magnitudes of their terms.
    pub(super) fn rounding_along(&self, q: &[f64], v: &[f64], a: &[f64], lambda: &[f64], out: &mut [f64]) {
        for (x, ends) in out.iter_mut().zip(self.starts.windows(2)) {
            let terms = (ends[0]..ends[1]).map(|place| match self.columns[place] {
                j if j < self.n_q => {
                    (self.by_q[place] * q[j]).abs() + (self.by_v[place] * v[j]).abs() + (self.fixed[place] * a[j]).abs()
                }
                j => (self.fixed[place] * lambda[j - self.n_q]).abs(),
            });
            *x = ROUNDING * terms.sum::<f64>();
        }
    }

    /// `R_q of_q + R_v of_v` (`n_q + n_c`).
    pub(super) fn slope_along(&self, of_q: &[f64], of_v: &[f64], out: &mut [f64]) {
        for (x, ends) in out.iter_mut().zip(self.starts.windows(2)) {
            let places = (ends[0]..ends[1]).filter(|&place| self.columns[place] < self.n_q);
            *x = places.fold(0.0, |sum, place| {
                let j = self.columns[place];
                sum + self.by_q[place] * of_q[j] + self.by_v[place] * of_v[j]
            });
        }
    }
}

/// Scale that brings the largest entry to one.
fn reciprocal(largest: f64) -> f64 {
    if largest > 0.0 { 1.0 / largest } else { 1.0 }
}
