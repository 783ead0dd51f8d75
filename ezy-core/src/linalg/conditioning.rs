//! How well K can be solved with at one state.

use super::{DenseKkt, KktFactorization};
use crate::model::SparsityPattern;

/// What an estimate found; of the scaled K, in which lengths and angles, heavy and light bodies compare.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Conditioning {
    /// Condition number in the 1-norm, estimated from below; infinite where a pivot vanishes.
    pub condition: f64,
    /// Smallest pivot.
    pub pivot: f64,
    /// Its unknown: a coordinate below `n_q`, then the multiplier of a row; none where the pivot vanishes.
    pub unknown: Option<usize>,
}

/// Estimates the condition number of K from a dense factorisation and a few solves.
pub(crate) struct ConditionEstimator {
    kkt: DenseKkt,
    x: Vec<f64>,
    /// Column sums.
    sums: Vec<f64>,
}

/// Solves of an estimate; two or three are the rule.
const MAX_SOLVES: usize = 5;

impl ConditionEstimator {
    /// Storage; everything is allocated here.
    pub(crate) fn new(n_q: usize, pattern: &SparsityPattern) -> Self {
        let n = n_q + pattern.n_rows();
        Self { kkt: DenseKkt::new(n_q, pattern, pattern.n_rows()), x: vec![0.0; n], sums: vec![0.0; n] }
    }

    /// Of K with the diagonal `mass` (`n_q`) and the entries `jacobian` of G in the order of `pattern`.
    ///
    /// # Source
    /// Hager, SIAM J. Sci. Stat. Comput. 5 (1984); Higham, Accuracy and Stability of Numerical Algorithms (2002), algorithm
    /// 15.1, for a symmetric matrix.
    pub(crate) fn estimate(&mut self, mass: &[f64], pattern: &SparsityPattern, jacobian: &[f64]) -> Conditioning {
        if let Err(vanished) = self.kkt.factor(mass, jacobian) {
            return Conditioning { condition: f64::INFINITY, pivot: vanished.relative, unknown: None };
        }
        let (pivot, unknown) = self.kkt.weakest_unknown();
        let norm = self.norm(mass, pattern, jacobian);
        let n = self.x.len();
        let mut of_inverse = 0.0;
        self.x.fill(1.0 / n as f64);
        for _ in 0..MAX_SOLVES {
            self.solve();
            of_inverse = self.x.iter().map(|x| x.abs()).sum::<f64>().max(of_inverse);
            self.x.iter_mut().for_each(|x| *x = if *x < 0.0 { -1.0 } else { 1.0 });
            self.solve();
            let (steepest, slope) = self
                .x
                .iter()
                .enumerate()
                .fold((0, 0.0), |(i, largest), (j, z)| if z.abs() > largest { (j, z.abs()) } else { (i, largest) });
            // where no unit vector promises more, what was found is a maximum
            if slope <= of_inverse {
                break;
            }
            self.x.fill(0.0);
            self.x[steepest] = 1.0;
        }
        Conditioning { condition: norm * of_inverse, pivot, unknown: Some(unknown) }
    }

    /// Largest column sum of D K D.
    fn norm(&mut self, mass: &[f64], pattern: &SparsityPattern, jacobian: &[f64]) -> f64 {
        let (n_q, d, sums) = (mass.len(), self.kkt.scale(), &mut self.sums);
        sums.fill(0.0);
        for (i, m) in mass.iter().enumerate() {
            sums[i] = d[i] * m * d[i];
        }
        for (k, row, column) in pattern.entries() {
            let g = (d[n_q + row] * jacobian[k] * d[column]).abs();
            sums[column] += g;
            sums[n_q + row] += g;
        }
        sums.iter().copied().fold(0.0, f64::max)
    }

    /// Replaces x by (D K D)⁻¹ x.
    fn solve(&mut self) {
        let Self { kkt, x, .. } = self;
        x.iter_mut().zip(kkt.scale()).for_each(|(x, d)| *x /= d);
        kkt.solve(x);
        x.iter_mut().zip(kkt.scale()).for_each(|(x, d)| *x /= d);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO_ROWS: SparsityPattern = SparsityPattern { starts: &[0, 2, 4], columns: &[0, 1, 0, 1] };
    const ONE_ROW: SparsityPattern = SparsityPattern { starts: &[0, 1], columns: &[0] };

    /// An estimate is at most the condition number, and rarely below a third of it (Higham 2002, 15.2).
    fn assert_estimates(found: Conditioning, exact: f64) {
        let rounding = 1.0 + 1e-9;
        assert!(found.condition <= exact * rounding && found.condition >= exact / 3.0, "{found:?}, {exact:e}");
    }

    #[test]
    fn analytic_condition_of_one_held_coordinate() {
        // K⁻¹ = [0 0 1; 0 1 0; 1 0 −1]: both norms are 2
        let found = ConditionEstimator::new(2, &ONE_ROW).estimate(&[1.0, 1.0], &ONE_ROW, &[1.0]);
        assert_estimates(found, 4.0);
        assert_eq!(found.pivot, 1.0);
    }

    #[test]
    fn analytic_condition_grows_with_the_square_of_the_angle_between_rows() {
        let mut estimator = ConditionEstimator::new(2, &TWO_ROWS);
        for angle in [1e-1, 1e-3] {
            let found = estimator.estimate(&[1.0, 1.0], &TWO_ROWS, &[1.0, 0.0, 1.0, angle]);
            // the largest column of K⁻¹ is that of the first row: G⁻¹ above −(G Gᵀ)⁻¹
            let exact = 3.0 * (1.0 + 1.0 / angle + (2.0 + angle * angle) / (angle * angle));
            assert_estimates(found, exact);
        }
    }

    #[test]
    fn invariant_condition_of_a_row_twice_is_infinite() {
        let found = ConditionEstimator::new(2, &TWO_ROWS).estimate(&[1.0, 1.0], &TWO_ROWS, &[1.0, 0.0, 1.0, 0.0]);
        assert_eq!((found.condition, found.unknown), (f64::INFINITY, None));
    }
}
