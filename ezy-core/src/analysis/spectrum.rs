//! Eigenvalues of a matrix, with those that are zero told apart.

use super::tolerances::spectrum::{MAX_ITERATIONS, ROUNDING, ZERO};
use nalgebra::{Complex, DMatrix, Schur};

/// The eigenvalues of a linear system.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Those that are not zero, 1/s, by falling real part; of a pair the one with the positive imaginary part first.
    pub eigenvalues: Vec<Complex<f64>>,
    /// How many are zero.
    pub n_zero: usize,
    /// Sizes of the Jordan blocks of zero, the largest first: in a block of two a deviation grows evenly with time.
    pub zero_blocks: Vec<usize>,
}

impl Spectrum {
    /// Of a square matrix; none where an entry is not finite.
    ///
    /// Zeros are split off by their null spaces, one after the other, with orthogonal matrices: what is left has none, and its eigenvalues
    /// do not suffer from the (ε)^(1/n) into which rounding splits n of them.
    ///
    /// # Source
    /// Kublanovskaya (1966); Golub, Van Loan, Matrix Computations, section 7.6, for the staircase of null spaces.
    pub(super) fn of(matrix: &DMatrix<f64>) -> Option<Self> {
        let (mut rest, mut nullities) = (matrix.clone(), Vec::new());
        if rest.iter().any(|x| !x.is_finite()) {
            return None;
        }
        let size = rest.amax();
        while rest.nrows() > 0 {
            let svd = rest.clone().svd(false, true);
            let v_t = svd.v_t?;
            let kept: Vec<usize> = (0..rest.nrows()).filter(|&i| svd.singular_values[i] > ZERO * size).collect();
            let nullity = rest.nrows() - kept.len();
            if nullity == 0 {
                break;
            }
            nullities.push(nullity);
            // the null space is invariant, and what is orthogonal to it follows by itself
            let orthogonal = v_t.select_rows(&kept).transpose();
            rest = orthogonal.tr_mul(&rest) * &orthogonal;
        }
        let mut eigenvalues: Vec<Complex<f64>> = if rest.nrows() == 0 {
            Vec::new()
        } else {
            Schur::try_new(rest, f64::EPSILON, MAX_ITERATIONS)?.complex_eigenvalues().iter().copied().collect()
        };
        eigenvalues.sort_by(|a, b| b.re.total_cmp(&a.re).then(b.im.total_cmp(&a.im)));
        let blocks = nullities.first().copied().unwrap_or(0);
        // the k-th null space has one dimension for each block of k at least
        let zero_blocks = (0..blocks).map(|i| nullities.iter().filter(|&&n| n > i).count()).collect();
        Some(Self { eigenvalues, n_zero: nullities.iter().sum(), zero_blocks })
    }

    /// How many eigenvalues have a real part above zero, beyond rounding.
    pub fn n_unstable(&self) -> usize {
        let rounding = self.rounding();
        self.eigenvalues.iter().filter(|s| s.re > rounding).count()
    }

    /// How many eigenvalues that are not zero are on the imaginary axis, to rounding.
    pub fn n_neutral(&self) -> usize {
        let rounding = self.rounding();
        self.eigenvalues.iter().filter(|s| s.re.abs() <= rounding).count()
    }

    /// Real parts up to here, 1/s, are those of zero.
    pub(super) fn rounding(&self) -> f64 {
        ROUNDING * self.largest()
    }

    /// The largest modulus.
    fn largest(&self) -> f64 {
        self.eigenvalues.iter().fold(0.0, |largest: f64, s| largest.max(s.norm()))
    }
}
