//! Eigenvectors of a matrix whose eigenvalues are known.

use super::tolerances::mode::{ITERATIONS, SHIFTS};
use nalgebra::{Complex, DMatrix, DVector};

/// A = Q H Qᵀ, with Q orthogonal and no entries of H below those next to its diagonal: equations with H − s take n² operations.
pub(super) struct Eigenvectors {
    q: DMatrix<f64>,
    h: DMatrix<f64>,
    size: f64,
}

impl Eigenvectors {
    /// Of a square matrix.
    pub(super) fn of(a: &DMatrix<f64>) -> Self {
        let size = a.norm();
        let (q, h) = if a.is_empty() { (a.clone(), a.clone()) } else { a.clone().hessenberg().unpack() };
        Self { q, h, size }
    }

    /// A unit vector x with A x = s x, by inverse iteration: (A − σ) x⁺ = x with σ beside s by rounding. The first x depends on `i`, so that
    /// equal eigenvalues with several eigenvectors get different ones. None where no equations can be solved with s.
    ///
    /// # Source
    /// Golub, Van Loan, Matrix Computations, section 7.6.1.
    pub(super) fn of_eigenvalue(&self, s: Complex<f64>, i: usize) -> Option<DVector<Complex<f64>>> {
        let n = self.h.nrows();
        let first = DVector::from_fn(n, |row, _| Complex::new((1.0 + (row + n * i) as f64).sin(), 0.0));
        let vector = SHIFTS.into_iter().find_map(|shift| {
            let factors = HessenbergLu::of(&self.h, s + shift * self.size);
            let mut x = first.clone();
            for _ in 0..ITERATIONS {
                factors.solve(x.as_mut_slice());
                let norm = x.norm();
                x /= Complex::new(norm, 0.0);
            }
            x.iter().all(|x| x.re.is_finite() && x.im.is_finite()).then_some(x)
        });
        Some(real_times(&self.q, &vector?))
    }
}

/// A real matrix times a complex vector.
pub(super) fn real_times(matrix: &DMatrix<f64>, x: &DVector<Complex<f64>>) -> DVector<Complex<f64>> {
    let [re, im] = [matrix * x.map(|x| x.re), matrix * x.map(|x| x.im)];
    re.zip_map(&im, Complex::new)
}

/// Factors of H − s, rows exchanged where the entry below the diagonal is larger.
struct HessenbergLu {
    /// The upper triangle, row after row.
    upper: Vec<Vec<Complex<f64>>>,
    /// Whether a row was exchanged with the next one, and how much of it the next one then lost.
    eliminations: Vec<(bool, Complex<f64>)>,
}

impl HessenbergLu {
    fn of(h: &DMatrix<f64>, s: Complex<f64>) -> Self {
        let n = h.nrows();
        let entry = |i: usize, j: usize| if i == j { h[(i, j)] - s } else { Complex::new(h[(i, j)], 0.0) };
        let mut upper: Vec<Vec<_>> = (0..n).map(|i| (i.saturating_sub(1)..n).map(|j| entry(i, j)).collect()).collect();
        let mut eliminations = Vec::with_capacity(n);
        for k in 1..n {
            let (above, below) = upper.split_at_mut(k);
            let (row, next) = (&mut above[k - 1], &mut below[0]);
            let exchanged = next[0].norm_sqr() > row[0].norm_sqr();
            if exchanged {
                std::mem::swap(row, next);
            }
            let factor = next[0] / row[0];
            next.iter_mut().zip(&*row).skip(1).for_each(|(x, y)| *x -= factor * y);
            // what is left begins at its diagonal, as the rows before
            next.remove(0);
            eliminations.push((exchanged, factor));
        }
        Self { upper, eliminations }
    }

    fn solve(&self, x: &mut [Complex<f64>]) {
        for (k, (exchanged, factor)) in self.eliminations.iter().enumerate() {
            if *exchanged {
                x.swap(k, k + 1);
            }
            let above = x[k];
            x[k + 1] -= factor * above;
        }
        for (k, row) in self.upper.iter().enumerate().rev() {
            let rest: Complex<f64> = row.iter().zip(&x[k..]).skip(1).map(|(u, x)| u * x).sum();
            x[k] = (x[k] - rest) / row[0];
        }
    }
}
