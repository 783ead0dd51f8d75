//! The one question of rank: which rows of G depend on which, and how far the others are from it.

use super::tolerances::rank::{INDEPENDENT, PIVOT_SHARE};
use crate::model::SparsityPattern;
use nalgebra::{DMatrix, DMatrixView, DVectorViewMut, linalg};

/// Gauss elimination of G with full pivoting, rows scaled by their largest entries, columns by their units.
///
/// `P G Q = [L₁; L₂] [U₁ U₂]` on the `rank` independent rows. In place of U₂ and L₂ stand `Z = −U₁⁻¹ U₂`, the dependent coordinates
/// by the independent ones, and `T = L₂ L₁⁻¹`, the redundant rows by the independent ones.
///
/// Rounding ε of positions changes accelerations by ε/p³ where p is the smallest pivot. Below p = 1e-5, about ε^(1/3), no digit
/// of what a row decides is left, and it counts as dependent. p² is comparable with the pivots of eliminations of G M⁻¹ Gᵀ:
/// [`INDEPENDENT`] is the root of [`PIVOT_TOLERANCE`](crate::model::PIVOT_TOLERANCE).
pub(crate) struct RankRevealing {
    entries: Vec<(usize, usize, usize)>,
    factors: DMatrix<f64>,
    row_scale: Vec<f64>,
    /// Row and column of G at each place; rows that are off come last.
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// Rows that are not off.
    n_on: usize,
    rank: usize,
    smallest_pivot: f64,
    weakest_row: usize,
}

/// Which rows a factorisation takes for independent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Independent<'r> {
    /// Those whose pivots exceed this.
    Above(f64),
    /// These, whatever their pivots are.
    Rows(&'r [usize]),
}

/// Rows that depend on each other.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Dependencies {
    /// Rows that take part in a dependency, in declared order.
    pub(crate) rows: Vec<usize>,
    /// How many rows are redundant.
    pub(crate) n: usize,
}

impl RankRevealing {
    /// Storage for the first `n_rows` rows of a pattern with `n_columns` columns.
    pub(crate) fn new(n_rows: usize, n_columns: usize, pattern: &SparsityPattern) -> Self {
        Self {
            entries: pattern.entries().take_while(|(_, row, _)| *row < n_rows).collect(),
            factors: DMatrix::zeros(n_rows, n_columns),
            row_scale: vec![1.0; n_rows],
            rows: vec![0; n_rows],
            columns: vec![0; n_columns],
            n_on: n_rows,
            rank: 0,
            smallest_pivot: 1.0,
            weakest_row: 0,
        }
    }

    /// Factors G without the rows that are `off`; its columns are divided by `unit`. Of columns that would do as well the one of least
    /// `mass` is made dependent, so that heavy and light bodies are not mixed.
    ///
    /// False when a number is not finite, or a pivot of rows that are asked for vanishes.
    pub(crate) fn factor(
        &mut self,
        jacobian: &[f64],
        unit: &[f64],
        mass: &[f64],
        independent: Independent<'_>,
        off: &[usize],
    ) -> bool {
        let (n_rows, n_columns) = self.factors.shape();
        self.write(jacobian, unit);
        self.n_on = n_rows;
        // from the last one on, so that each is still at its own place
        for &row in off.iter().rev().filter(|row| **row < n_rows) {
            self.n_on -= 1;
            self.swap_rows(row, self.n_on);
        }
        let (n_candidates, tolerance) = match independent {
            Independent::Above(tolerance) => (self.n_on, tolerance),
            Independent::Rows(rows) => {
                for (place, row) in rows.iter().enumerate() {
                    let from = self.rows.iter().position(|at| at == row).unwrap_or(place);
                    self.swap_rows(place, from);
                }
                (rows.len(), f64::EPSILON)
            }
        };
        (self.smallest_pivot, self.weakest_row, self.rank) = (1.0, self.rows.first().copied().unwrap_or(0), 0);
        let felt = |column: usize| mass[column] / unit[column] / unit[column];
        while self.rank < n_candidates.min(n_columns) {
            let i = self.rank;
            let candidates = self.factors.view((i, i), (n_candidates - i, n_columns - i));
            let largest = candidates.camax();
            if !largest.is_finite() {
                return false;
            }
            if largest <= tolerance {
                break;
            }
            let mut best = (0, 0, f64::INFINITY, 0.0);
            for (column, entries) in candidates.column_iter().enumerate() {
                let mass = felt(self.columns[i + column]);
                for (row, entry) in entries.iter().enumerate() {
                    let size = entry.abs();
                    if size >= PIVOT_SHARE * largest && (mass < best.2 || mass == best.2 && size > best.3) {
                        best = (row, column, mass, size);
                    }
                }
            }
            let (row, column, _, pivot) = best;
            self.swap_rows(i, i + row);
            self.factors.swap_columns(i, i + column);
            self.columns.swap(i, i + column);
            if pivot < self.smallest_pivot {
                (self.smallest_pivot, self.weakest_row) = (pivot, self.rows[i]);
            }
            let pivot = self.factors[(i, i)];
            linalg::gauss_step(&mut self.factors, pivot, i);
            self.rank += 1;
        }
        if matches!(independent, Independent::Rows(rows) if self.rank < rows.len()) {
            return false;
        }
        self.express_dependent();
        true
    }

    fn write(&mut self, jacobian: &[f64], unit: &[f64]) {
        self.factors.fill(0.0);
        for &(k, row, column) in &self.entries {
            self.factors[(row, column)] += jacobian[k] / unit[column];
        }
        for (mut row, scale) in self.factors.row_iter_mut().zip(&mut self.row_scale) {
            let largest = row.camax();
            *scale = if largest > 0.0 { largest.recip() } else { 1.0 };
            row *= *scale;
        }
        self.rows.iter_mut().enumerate().for_each(|(i, row)| *row = i);
        self.columns.iter_mut().enumerate().for_each(|(i, column)| *column = i);
    }

    fn swap_rows(&mut self, i: usize, j: usize) {
        self.factors.swap_rows(i, j);
        self.rows.swap(i, j);
    }

    /// Z in place of U₂, T in place of L₂.
    fn express_dependent(&mut self) {
        let (r, n_on, n_columns) = (self.rank, self.n_on, self.factors.ncols());
        if r == 0 {
            return;
        }
        let (triangles, mut right) = self.factors.columns_range_pair_mut(0..r, r..n_columns);
        let mut Z = right.rows_mut(0, r);
        triangles.rows(0, r).solve_upper_triangular_mut(&mut Z);
        Z.neg_mut();
        for row in r..n_on {
            for j in (0..r).rev() {
                let above: f64 = (j + 1..r).map(|i| self.factors[(row, i)] * self.factors[(i, j)]).sum();
                self.factors[(row, j)] -= above;
            }
        }
    }

    /// Entries of G, as of its pattern.
    pub(crate) fn entries(&self) -> &[(usize, usize, usize)] {
        &self.entries
    }

    /// Number of independent rows.
    pub(crate) fn rank(&self) -> usize {
        self.rank
    }

    /// Number of rows that depend on others.
    pub(crate) fn n_redundant(&self) -> usize {
        self.n_on - self.rank
    }

    /// The independent rows.
    pub(crate) fn independent_rows(&self) -> &[usize] {
        &self.rows[..self.rank]
    }

    /// The smallest pivot of an independent row, of rows scaled to one.
    pub(crate) fn smallest_pivot(&self) -> f64 {
        self.smallest_pivot
    }

    /// The row that it belongs to.
    pub(crate) fn weakest_row(&self) -> usize {
        self.weakest_row
    }

    /// The row of G at a place; independent ones first, then redundant ones, last those that are off.
    pub(crate) fn row(&self, place: usize) -> usize {
        self.rows[place]
    }

    /// The column of G at a place; dependent coordinates first.
    pub(crate) fn column(&self, place: usize) -> usize {
        self.columns[place]
    }

    /// What a row of G was multiplied by.
    pub(crate) fn row_scale(&self, row: usize) -> f64 {
        self.row_scale[row]
    }

    /// Z, `rank × (n_columns − rank)`: the dependent coordinates by the independent ones.
    pub(crate) fn dependent_by_independent(&self) -> DMatrixView<'_, f64> {
        self.factors.view((0, self.rank), (self.rank, self.columns.len() - self.rank))
    }

    /// T, `n_redundant × rank`: the redundant rows by the independent ones.
    pub(crate) fn redundant_by_independent(&self) -> DMatrixView<'_, f64> {
        self.factors.view((self.rank, 0), (self.n_redundant(), self.rank))
    }

    /// Replaces s (`rank`) by `U₁⁻¹ L₁⁻¹ s`.
    pub(crate) fn solve(&self, s: &mut [f64]) {
        if self.rank == 0 {
            return;
        }
        let triangles = self.factors.view((0, 0), (self.rank, self.rank));
        let mut x = DVectorViewMut::from_slice(s, self.rank);
        triangles.solve_lower_triangular_with_diag_mut(&mut x, 1.0);
        // every pivot is beyond the tolerance
        triangles.solve_upper_triangular_mut(&mut x);
    }

    /// Replaces r (`rank`) by `(L₁ U₁)⁻ᵀ r`.
    pub(crate) fn solve_transposed(&self, r: &mut [f64]) {
        if self.rank == 0 {
            return;
        }
        let triangles = self.factors.view((0, 0), (self.rank, self.rank));
        triangles.tr_solve_upper_triangular_mut(&mut DVectorViewMut::from_slice(r, self.rank));
        for j in (0..self.rank).rev() {
            let above: f64 = (j + 1..self.rank).map(|i| triangles[(i, j)] * r[i]).sum();
            r[j] -= above;
        }
    }

    /// Rows that take part in dependencies: `[−T I] P G = 0`. A row whose share is below [`INDEPENDENT`] could be left out: what it leaves
    /// counts as zero.
    pub(crate) fn dependencies(&self) -> Dependencies {
        let T = self.redundant_by_independent();
        let takes_part = |place: usize| T.column(place).iter().any(|share| share.abs() > INDEPENDENT);
        let mut rows: Vec<usize> =
            (0..self.rank).filter(|&place| takes_part(place)).map(|place| self.rows[place]).collect();
        rows.extend(&self.rows[self.rank..self.n_on]);
        rows.sort_unstable();
        Dependencies { rows, n: self.n_redundant() }
    }
}

/// Massless coordinates that take part in a motion which no row sees. `None` when G is not finite.
pub(crate) fn undetermined_coordinates(
    mass: &[f64],
    pattern: &SparsityPattern,
    jacobian: &[f64],
) -> Option<Vec<usize>> {
    if !jacobian.iter().all(|x| x.is_finite()) {
        return None;
    }
    let massless: Vec<usize> = (0..mass.len()).filter(|&i| mass[i] == 0.0).collect();
    let held = pattern.entries().filter_map(|(k, row, column)| Some((k, massless.binary_search(&column).ok()?, row)));
    // coordinates that depend on each other are rows that do, of the transposed matrix
    let mut rank = RankRevealing {
        entries: held.collect(),
        factors: DMatrix::zeros(massless.len(), pattern.n_rows()),
        row_scale: vec![1.0; massless.len()],
        rows: vec![0; massless.len()],
        columns: vec![0; pattern.n_rows()],
        n_on: massless.len(),
        rank: 0,
        smallest_pivot: 1.0,
        weakest_row: 0,
    };
    let ones = vec![1.0; pattern.n_rows()];
    rank.factor(jacobian, &ones, &ones, Independent::Above(INDEPENDENT), &[]);
    Some(rank.dependencies().rows.into_iter().map(|i| massless[i]).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const DENSE_3X4: SparsityPattern = SparsityPattern::new(&[0, 4, 8, 12], &[0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3]);
    const ONES: [f64; 4] = [1.0; 4];

    fn factored(jacobian: &[f64; 12], independent: Independent<'_>) -> RankRevealing {
        let mut rank = RankRevealing::new(3, 4, &DENSE_3X4);
        assert!(rank.factor(jacobian, &ONES, &ONES, independent, &[]));
        rank
    }

    /// The sum of the first two rows is redundant beside both of them, and not without one of them; a row that is off is neither.
    #[test]
    fn invariant_rows_that_are_off_take_no_part() {
        let jacobian = [1.0, 2.0, 0.0, 1.0, 0.0, 1.0, 3.0, 0.0, 1.0, 3.0, 3.0, 1.0];
        let mut rank = RankRevealing::new(3, 4, &DENSE_3X4);
        for (off, counts) in [(&[][..], (2, 1)), (&[0], (2, 0)), (&[1], (2, 0)), (&[2], (2, 0)), (&[0, 2], (1, 0))] {
            assert!(rank.factor(&jacobian, &ONES, &ONES, Independent::Above(INDEPENDENT), off));
            assert_eq!((rank.rank(), rank.n_redundant()), counts, "{off:?}");
            assert!(off.iter().all(|row| !rank.independent_rows().contains(row)), "{off:?}");
            assert!(off.iter().all(|row| !rank.dependencies().rows.contains(row)), "{off:?}");
        }
    }

    #[test]
    fn analytic_a_row_that_is_a_sum_of_others_is_redundant() {
        let jacobian = [1.0, 2.0, 0.0, 1.0, 0.0, 1.0, 3.0, 0.0, 2.0, 6.0, 6.0, 2.0];
        let rank = factored(&jacobian, Independent::Above(INDEPENDENT));
        assert_eq!((rank.rank(), rank.dependencies().rows), (2, vec![0, 1, 2]));
    }

    #[test]
    fn analytic_null_space_and_solutions_of_the_independent_rows() {
        let jacobian = [1.0, 2.0, 0.0, 1.0, 0.0, 1.0, 3.0, 0.0, 2.0, 5.0, 6.0, 2.5];
        let rank = factored(&jacobian, Independent::Above(INDEPENDENT));
        assert_eq!(rank.rank(), 3);
        // each column of [Z; I] is met by every row
        let Z = rank.dependent_by_independent();
        for row in 0..3 {
            let entry = |place: usize| jacobian[4 * row + rank.column(place)];
            let sum: f64 = (0..3).map(|i| entry(i) * Z[(i, 0)]).sum::<f64>() + entry(3);
            assert!(sum.abs() <= 1e-14, "{sum:e}");
        }
        let exact = [0.3, -1.0, 2.0];
        let mut s: Vec<f64> = (0..3)
            .map(|place| {
                let row = rank.row(place);
                let scale = rank.row_scale(row);
                (0..3).map(|j| scale * jacobian[4 * row + rank.column(j)] * exact[j]).sum()
            })
            .collect();
        rank.solve(&mut s);
        let mut r: Vec<f64> = (0..3)
            .map(|j| {
                (0..3)
                    .map(|place| {
                        let row = rank.row(place);
                        rank.row_scale(row) * jacobian[4 * row + rank.column(j)] * exact[place]
                    })
                    .sum()
            })
            .collect();
        rank.solve_transposed(&mut r);
        for (x, expected) in s.iter().chain(&r).zip(exact.iter().chain(&exact)) {
            assert!((x - expected).abs() <= 1e-13, "{x} {expected}");
        }
    }

    #[test]
    fn invariant_rows_that_are_asked_for_are_the_independent_ones() {
        let jacobian = [1.0, 2.0, 0.0, 1.0, 0.0, 1.0, 3.0, 0.0, 2.0, 6.0, 6.0, 2.0];
        for among in [[0, 1], [0, 2], [2, 1]] {
            let rank = factored(&jacobian, Independent::Rows(&among));
            let mut rows = rank.independent_rows().to_vec();
            rows.sort_unstable();
            let mut expected = among;
            expected.sort_unstable();
            assert_eq!((rows.as_slice(), rank.dependencies().n), (&expected[..], 1));
        }
    }

    #[test]
    fn invariant_the_lighter_of_two_equal_columns_is_dependent() {
        let pattern = SparsityPattern::new(&[0, 2], &[0, 1]);
        for (mass, dependent) in [([1.0, 1e-6], 1), ([1e-6, 1.0], 0)] {
            let mut rank = RankRevealing::new(1, 2, &pattern);
            assert!(rank.factor(&[1.0, 0.5], &[1.0, 1.0], &mass, Independent::Above(INDEPENDENT), &[]));
            assert_eq!(rank.column(0), dependent);
        }
    }

    #[test]
    fn invariant_no_dependent_coordinate_multiplies_rounding_by_more_than_ten() {
        // the light column would do, but for its lever
        let pattern = SparsityPattern::new(&[0, 2], &[0, 1]);
        let mut rank = RankRevealing::new(1, 2, &pattern);
        assert!(rank.factor(&[1.0, 0.01], &[1.0, 1.0], &[1.0, 1e-6], Independent::Above(INDEPENDENT), &[]));
        assert!(rank.dependent_by_independent()[(0, 0)].abs() <= 10.0);
    }

    #[test]
    fn analytic_a_massless_coordinate_in_no_row_is_undetermined() {
        let pattern = SparsityPattern::new(&[0, 2], &[0, 1]);
        assert_eq!(undetermined_coordinates(&[0.0, 1.0, 0.0], &pattern, &[1.0, 1.0]), Some(vec![2]));
        assert_eq!(undetermined_coordinates(&[0.0, 0.0, 1.0], &pattern, &[1.0, 1.0]), Some(vec![0, 1]));
        assert_eq!(undetermined_coordinates(&[0.0, 1.0, 1.0], &pattern, &[1.0, 1.0]), Some(vec![]));
    }

    /// Of two coordinates in a row the lighter one is made dependent: 6 kg m² on a lever of 2 m are felt like 1.5 kg.
    #[test]
    fn analytic_the_coordinate_that_feels_lightest_depends_on_others() {
        const ROW: SparsityPattern = SparsityPattern::new(&[0, 2], &[0, 1]);
        for (mass, dependent) in [([2.0, 6.0], 1), ([1.0, 6.0], 0)] {
            let mut rank = RankRevealing::new(1, 2, &ROW);
            assert!(rank.factor(&[1.0, 1.0], &[1.0, 2.0], &mass, Independent::Above(INDEPENDENT), &[]));
            assert_eq!(rank.columns[0], dependent, "{mass:?}");
        }
    }
}
