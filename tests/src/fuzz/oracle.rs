//! K x = r in numbers of 31 digits, by Gauss elimination with complete pivoting: slow, and right.

use ezy_core::scalar::{DoubleDouble, Scalar};

/// A pivot below this part of the largest is what rounding of the entries of K leaves of a dependent row.
const RANK: f64 = 1e-14;

/// Factors of a square matrix.
pub struct Oracle {
    /// Row by row: multipliers below the diagonal, pivots on and above it.
    factors: Vec<Vec<DoubleDouble>>,
    rows: Vec<usize>,
    columns: Vec<usize>,
    /// Powers of two that the rows and columns were multiplied by.
    scale: Vec<f64>,
    /// Whether every pivot stands out from rounding.
    pub is_regular: bool,
}

impl Oracle {
    /// Factors a symmetric matrix; `None` where a number overflows or is none.
    pub fn new<T: Copy + Into<DoubleDouble>>(matrix: &[Vec<T>]) -> Option<Self> {
        let matrix: Vec<Vec<DoubleDouble>> =
            matrix.iter().map(|row| row.iter().map(|x| (*x).into()).collect()).collect();
        let scale = scales(&matrix)?;
        let n = matrix.len();
        let scaled = |i: usize, j: usize| matrix[i][j] * DoubleDouble::from(scale[i]) * DoubleDouble::from(scale[j]);
        let mut factors: Vec<Vec<DoubleDouble>> = (0..n).map(|i| (0..n).map(|j| scaled(i, j)).collect()).collect();
        let (mut rows, mut columns): (Vec<usize>, Vec<usize>) = ((0..n).collect(), (0..n).collect());
        let mut is_regular = true;
        let mut largest = 0.0_f64;
        for k in 0..n {
            let below = (k..n).flat_map(|i| (k..n).map(move |j| (i, j)));
            let size = |&(i, j): &(usize, usize)| factors[i][j].magnitude();
            let (i, j) = below.max_by(|a, b| size(a).total_cmp(&size(b)))?;
            let pivot = factors[i][j];
            largest = largest.max(pivot.magnitude());
            if !pivot.is_finite() {
                return None;
            }
            if pivot.magnitude() <= RANK * largest {
                is_regular = false;
                break;
            }
            factors.swap(k, i);
            rows.swap(k, i);
            factors.iter_mut().for_each(|row| row.swap(k, j));
            columns.swap(k, j);
            let (above, rest) = factors.split_at_mut(k + 1);
            for row in rest {
                let factor = row[k] / pivot;
                row[k] = factor;
                if factor.magnitude() != 0.0 {
                    for (x, y) in row[k + 1..].iter_mut().zip(&above[k][k + 1..]) {
                        *x = *x - factor * *y;
                    }
                }
            }
        }
        Some(Self { factors, rows, columns, scale, is_regular })
    }

    /// x with K x = r; of a regular matrix.
    pub fn solve<T: Copy + Into<DoubleDouble>>(&self, r: &[T]) -> Vec<f64> {
        let n = r.len();
        let scaled = |i: usize| r[i].into() * DoubleDouble::from(self.scale[i]);
        let mut x: Vec<DoubleDouble> = self.rows.iter().map(|&i| scaled(i)).collect();
        for i in 0..n {
            for j in 0..i {
                x[i] = x[i] - self.factors[i][j] * x[j];
            }
        }
        for i in (0..n).rev() {
            for j in i + 1..n {
                x[i] = x[i] - self.factors[i][j] * x[j];
            }
            x[i] = x[i] / self.factors[i][i];
        }
        let mut solution = vec![0.0; n];
        for (x, &j) in x.iter().zip(&self.columns) {
            solution[j] = x.high() * self.scale[j];
        }
        solution
    }

    /// Rounding of the largest number of a solution where K is scaled, in each number.
    pub fn rounding(&self, x: &[f64]) -> Vec<f64> {
        let largest = x.iter().zip(&self.scale).fold(0.0, |m: f64, (x, scale)| m.max((x / scale).abs()));
        self.scale.iter().map(|scale| f64::EPSILON * largest * scale).collect()
    }

    /// How far x can be from K⁻¹ r when r is off by these numbers, whatever their signs: `|K⁻¹| error`.
    pub fn at_most(&self, error: &[f64]) -> Vec<f64> {
        let mut sum = vec![0.0; error.len()];
        for (j, error) in error.iter().enumerate().filter(|(_, error)| **error != 0.0) {
            let mut alone = vec![0.0; sum.len()];
            alone[j] = *error;
            sum.iter_mut().zip(self.solve(&alone)).for_each(|(sum, x)| *sum += x.abs());
        }
        sum
    }
}

/// Powers of two that bring the largest entry of every row and column near one (Ruiz 2001).
fn scales(matrix: &[Vec<DoubleDouble>]) -> Option<Vec<f64>> {
    const PASSES: usize = 8;
    let mut scale = vec![1.0_f64; matrix.len()];
    for _ in 0..PASSES {
        let largest: Vec<f64> = matrix
            .iter()
            .enumerate()
            .map(|(i, row)| row.iter().zip(&scale).fold(0.0, |m: f64, (x, s)| m.max((x.high() * s * scale[i]).abs())))
            .collect();
        if matrix.iter().flatten().map(|x| x.high()).chain(largest.iter().copied()).any(|x| !x.is_finite()) {
            return None;
        }
        for (scale, largest) in scale.iter_mut().zip(&largest) {
            if *largest > 0.0 {
                *scale *= (-0.5 * largest.log2()).round().exp2();
            }
        }
    }
    scale.iter().all(|s| s.is_finite() && *s > 0.0).then_some(scale)
}
