//! What a solution of `K [x; y] = [r; s]` leaves of each equation, measured by the terms of that equation.

use super::Left;
use super::tolerances::refinement::NEGLIGIBLE;
use crate::model::SparsityPattern;

/// `[r; s] − K [x; y]`, and the magnitudes of the terms of each equation.
///
/// # Source
/// Oettli, Prager, Numer. Math. 6 (1964), for the measure.
pub(crate) struct EquationResidual {
    entries: Vec<(usize, usize, usize)>,
    n_q: usize,
    /// What is left of each equation, `n_q + n_c`.
    pub(crate) left: Vec<f64>,
    /// Sum of the magnitudes of its terms.
    pub(crate) size: Vec<f64>,
    row_size: Vec<f64>,
}

impl EquationResidual {
    /// Storage for `n_q` coordinates and the first `n_rows` rows of `pattern`.
    pub(crate) fn new(n_q: usize, n_rows: usize, pattern: &SparsityPattern) -> Self {
        let entries = pattern.entries().take_while(|(_, row, _)| *row < n_rows).collect();
        Self { entries, n_q, left: vec![0.0; n_q + n_rows], size: vec![0.0; n_q + n_rows], row_size: vec![0.0; n_rows] }
    }

    /// Puts a solution into the equations.
    pub(crate) fn write(&mut self, mass: &[f64], jacobian: &[f64], right_side: &[f64], solution: &[f64]) {
        let Self { entries, n_q, left, size, .. } = self;
        left.copy_from_slice(right_side);
        size.iter_mut().zip(right_side).for_each(|(size, b)| *size = b.abs());
        let mut subtract = |i: usize, term: f64| {
            left[i] -= term;
            size[i] += term.abs();
        };
        for (i, (m, x)) in mass.iter().zip(solution).enumerate() {
            subtract(i, m * x);
        }
        for &(k, row, column) in &*entries {
            subtract(*n_q + row, jacobian[k] * solution[column]);
            subtract(column, jacobian[k] * solution[*n_q + row]);
        }
    }

    /// What is left of the counted rows, whose largest entries become one, with angles in units of `unit` (`n_q`).
    pub(crate) fn rows_left(
        &mut self,
        mass: &[f64],
        jacobian: &[f64],
        unit: &[f64],
        right_side: &[f64],
        solution: &[f64],
        counts: impl Fn(usize) -> bool,
    ) -> Left {
        let Self { entries, n_q, left, size, row_size } = self;
        row_size.fill(0.0);
        for &(k, row, column) in &*entries {
            row_size[row] = row_size[row].max((jacobian[k] / unit[column]).abs());
        }
        let mut of_rows = Left::default();
        for (row, &largest) in row_size.iter().enumerate() {
            let largest = if largest > 0.0 { largest } else { 1.0 };
            of_rows.scale = of_rows.scale.max(size[*n_q + row] / largest);
            if counts(row) {
                of_rows.rows = of_rows.rows.max(left[*n_q + row].abs() / largest);
            }
        }
        for ((x, force), (unit, mass)) in solution.iter().zip(right_side).zip(unit.iter().zip(mass)) {
            let free = if *mass > 0.0 { force / mass } else { 0.0 };
            of_rows.scale = of_rows.scale.max(x.abs().max(free.abs()) * unit);
        }
        of_rows
    }

    /// The largest part that is left of the terms of an equation.
    pub(crate) fn share(&self) -> f64 {
        largest(
            self.left.iter().zip(&self.size).filter(|(left, _)| **left != 0.0).map(|(left, size)| left.abs() / size),
        )
    }

    /// As [`Self::share`], where terms that may be rounding altogether are not counted; NaN where a number is none. In units of the roots
    /// of `weight` (`n_q`), M with substitutes for zeros, and of the diagonal of `G W⁻¹ Gᵀ` all equations are comparable.
    pub(crate) fn share_of_what_matters(&self, weight: &[f64], diagonal: &[f64]) -> f64 {
        let units = || weight.iter().chain(diagonal).map(|square| square.sqrt());
        let in_units = largest(self.size.iter().zip(units()).map(|(size, unit)| size / unit));
        // a substitute for a mass may be far from all masses: then the numbers as they stand are the limit
        let plain = largest(self.size.iter().copied());
        let left = self.left.iter().zip(&self.size).zip(units()).filter(|((left, _), _)| **left != 0.0);
        largest(left.map(|((left, size), unit)| left.abs() / (size + NEGLIGIBLE * plain.min(in_units * unit))))
    }
}

/// The largest number; NaN when there is one.
fn largest(x: impl Iterator<Item = f64>) -> f64 {
    x.fold(0.0, |m: f64, x| if x > m || x.is_nan() { x } else { m })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_rounding_of_a_coordinate_that_is_held_at_zero_does_not_matter() {
        let pattern = SparsityPattern::new(&[0, 1], &[0]);
        let mut equations = EquationResidual::new(2, 1, &pattern);
        // the first coordinate and its multiplier are zero but for rounding
        equations.write(&[1.0, 1.0], &[1.0], &[0.0, 1.0, 0.0], &[1e-17, 1.0, -1e-17]);
        assert_eq!(equations.share(), 1.0);
        let [of_rounding, of_an_error] = [f64::EPSILON, 1e-13].map(|x| {
            equations.write(&[1.0, 1.0], &[1.0], &[0.0, 1.0, 0.0], &[x, 1.0, -x]);
            equations.share_of_what_matters(&[1.0, 1.0], &[1.0])
        });
        assert!(of_rounding <= 1e-12 && of_an_error > 1e-12, "{of_rounding:e} {of_an_error:e}");
    }

    /// Of `[2 0 4; 0 3 5; 4 5 0] [x; λ] = r`: what is left of each equation, over the sum of the magnitudes of its terms.
    #[test]
    fn analytic_parts_that_a_solution_leaves() {
        let pattern = SparsityPattern::new(&[0, 2], &[0, 1]);
        let mut equations = EquationResidual::new(2, 1, &pattern);
        let (mass, jacobian) = ([2.0, 3.0], [4.0, 5.0]);
        let (right_side, solution) = ([7.0, -1.0, 2.0], [1.0, -2.0, 0.5]);
        equations.write(&mass, &jacobian, &right_side, &solution);
        assert_eq!(equations.left, [7.0 - 2.0 - 2.0, -1.0 + 6.0 - 2.5, 2.0 - 4.0 + 10.0]);
        assert_eq!(equations.share(), (3.0_f64 / 11.0).max(2.5 / 9.5).max(8.0 / 16.0));
        // the row, its largest entry made one: 8/5 of 5 m/s² of the second coordinate, or 7/2 of the first one's free fall
        let left = equations.rows_left(&mass, &jacobian, &[1.0, 1.0], &right_side, &solution, |_| true);
        assert_eq!((left.rows, left.scale), (8.0 / 5.0, 3.5));
        let left = equations.rows_left(&mass, &jacobian, &[1.0, 0.5], &right_side, &solution, |_| true);
        assert_eq!((left.rows, left.scale), (8.0 / 10.0, 3.5));
        let left = equations.rows_left(&mass, &jacobian, &[1.0, 4.0], &[0.0; 3], &solution, |_| false);
        assert_eq!((left.rows, left.scale), (0.0, 8.0));
    }
}
