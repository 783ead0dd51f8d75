//! How well K can be solved with at one state.

use super::tolerances::conditioning::{MAX_SOLVES, PASSES};
use super::{INDEPENDENT, Independent, NullSpaceKkt};
use crate::model::SparsityPattern;

/// What an estimate found; of the scaled K, in which lengths and angles, heavy and light bodies compare.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Conditioning {
    /// Condition number in the 1-norm, estimated from below; infinite where a pivot vanishes.
    pub(crate) condition: f64,
    /// Smallest pivot of G, of rows scaled to one.
    pub(crate) pivot: f64,
    /// The row that it belongs to; none where constraints depend on each other.
    pub(crate) row: Option<usize>,
}

/// Estimates the condition number of K from a dense factorisation and a few solves.
pub(crate) struct ConditionEstimator {
    kkt: NullSpaceKkt,
    /// D.
    scale: Vec<f64>,
    x: Vec<f64>,
    /// Column sums.
    sums: Vec<f64>,
}

impl ConditionEstimator {
    /// Storage; `unit` (`n_q`) is the lever of each angle, m, and one for lengths.
    pub(crate) fn new(unit: &[f64], pattern: &SparsityPattern) -> Self {
        let n = unit.len() + pattern.n_rows();
        let kkt = NullSpaceKkt::new(unit, pattern, pattern.n_rows());
        Self { kkt, scale: vec![1.0; n], x: vec![0.0; n], sums: vec![0.0; n] }
    }

    /// Of K with the diagonal `mass` (`n_q`) and the entries `jacobian` of G in the order of the pattern, without the rows that are `off`,
    /// whose entries are zero.
    ///
    /// # Source
    /// Hager, SIAM J. Sci. Stat. Comput. 5 (1984); Higham, Accuracy and Stability of Numerical Algorithms (2002), algorithm
    /// 15.1, for a symmetric matrix.
    pub(crate) fn estimate(&mut self, mass: &[f64], jacobian: &[f64], off: &[usize]) -> Conditioning {
        let factored = self.kkt.factor(mass, jacobian, Independent::Above(INDEPENDENT), off);
        if factored.is_err() || self.kkt.rank().n_redundant() > 0 {
            return Conditioning { condition: f64::INFINITY, pivot: 0.0, row: None };
        }
        let (pivot, row) = (self.kkt.rank().smallest_pivot(), self.kkt.rank().weakest_row());
        equilibrate(mass, self.kkt.rank().entries(), jacobian, &mut self.scale, &mut self.sums);
        let norm = self.norm(mass, jacobian);
        let n = self.x.len();
        let (mut of_inverse, mut unit) = (0.0, None);
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
            // where no other unit vector promises more, what was found is a maximum; the same one promises as much but for rounding
            if slope <= of_inverse || unit == Some(steepest) {
                break;
            }
            unit = Some(steepest);
            self.x.fill(0.0);
            self.x[steepest] = 1.0;
        }
        let condition = norm * of_inverse;
        // no number where a solve overflowed
        let condition = if condition > 0.0 { condition } else { f64::INFINITY };
        Conditioning { condition, pivot, row: Some(row) }
    }

    /// K⁻¹ of `right_side` (`n_v + n_c`), refined to the last digits, with the factors of the last estimate, which was finite.
    pub(crate) fn solution(&mut self, right_side: &[f64]) -> &[f64] {
        self.x.copy_from_slice(right_side);
        self.kkt.solve(&mut self.x);
        &self.x
    }

    /// Largest column sum of D K D.
    fn norm(&mut self, mass: &[f64], jacobian: &[f64]) -> f64 {
        let (n_q, d, sums) = (mass.len(), &self.scale, &mut self.sums);
        sums.fill(0.0);
        for (i, m) in mass.iter().enumerate() {
            sums[i] = d[i] * m * d[i];
        }
        for &(k, row, column) in self.kkt.rank().entries() {
            let g = (d[n_q + row] * jacobian[k] * d[column]).abs();
            sums[column] += g;
            sums[n_q + row] += g;
        }
        sums.iter().copied().fold(0.0, f64::max)
    }

    /// Replaces x by (D K D)⁻¹ x. An estimate needs no last digits, and no refinement.
    fn solve(&mut self) {
        let Self { kkt, x, scale, .. } = self;
        x.iter_mut().zip(&*scale).for_each(|(x, d)| *x /= d);
        kkt.substitute(x);
        x.iter_mut().zip(&*scale).for_each(|(x, d)| *x /= d);
    }
}

/// Writes the diagonal `d` of D such that the largest entry of each row and column of D K D is near one.
///
/// # Source
/// Ruiz, A scaling algorithm to equilibrate both rows and columns norms in matrices (2001), in the maximum norm.
fn equilibrate(mass: &[f64], entries: &[(usize, usize, usize)], jacobian: &[f64], d: &mut [f64], largest: &mut [f64]) {
    let n_q = mass.len();
    d.fill(1.0);
    for _ in 0..PASSES {
        largest.fill(0.0);
        for (i, m) in mass.iter().enumerate() {
            largest[i] = d[i] * m * d[i];
        }
        for &(k, row, column) in entries {
            let g = (d[n_q + row] * jacobian[k] * d[column]).abs();
            largest[column] = largest[column].max(g);
            largest[n_q + row] = largest[n_q + row].max(g);
        }
        for (d, largest) in d.iter_mut().zip(&*largest).filter(|(_, largest)| **largest > 0.0) {
            *d /= largest.sqrt();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TWO_ROWS: SparsityPattern = SparsityPattern::new(&[0, 2, 4], &[0, 1, 0, 1]);
    const ONE_ROW: SparsityPattern = SparsityPattern::new(&[0, 1], &[0]);

    /// An estimate is at most the condition number, and rarely below a third of it (Higham 2002, 15.2).
    fn assert_estimates(found: Conditioning, exact: f64) {
        let rounding = 1.0 + 1e-9;
        assert!(found.condition <= exact * rounding && found.condition >= exact / 3.0, "{found:?}, {exact:e}");
    }

    #[test]
    fn analytic_condition_of_one_held_coordinate() {
        // K⁻¹ = [0 0 1; 0 1 0; 1 0 −1]: both norms are 2
        let found = ConditionEstimator::new(&[1.0; 2], &ONE_ROW).estimate(&[1.0, 1.0], &[1.0], &[]);
        assert_estimates(found, 4.0);
        assert_eq!(found.pivot, 1.0);
    }

    #[test]
    fn analytic_condition_does_not_depend_on_units() {
        // one held coordinate, in units far apart: the scaled matrix is that of ones
        let found = ConditionEstimator::new(&[1.0; 2], &ONE_ROW).estimate(&[1e-40, 1e30], &[1e-60], &[]);
        assert!(found.condition <= 2.0 * 4.0 && found.condition >= 4.0 / 2.0, "{found:?}");
    }

    #[test]
    fn analytic_condition_grows_with_the_square_of_the_angle_between_rows() {
        let mut estimator = ConditionEstimator::new(&[1.0; 2], &TWO_ROWS);
        for angle in [1e-1, 1e-3] {
            let found = estimator.estimate(&[1.0, 1.0], &[1.0, 0.0, 1.0, angle], &[]);
            // the largest column of K⁻¹ is that of the first row: G⁻¹ above −(G Gᵀ)⁻¹
            let exact = 3.0 * (1.0 + 1.0 / angle + (2.0 + angle * angle) / (angle * angle));
            assert_estimates(found, exact);
        }
    }

    #[test]
    fn invariant_condition_of_a_row_twice_is_infinite() {
        let found = ConditionEstimator::new(&[1.0; 2], &TWO_ROWS).estimate(&[1.0, 1.0], &[1.0, 0.0, 1.0, 0.0], &[]);
        assert_eq!((found.condition, found.row), (f64::INFINITY, None));
    }

    /// Largest column sums of [2 0 4; 0 3 5; 4 5 0] and of [2 0 1 7; 0 3 1 0; 1 1 0 0; 7 0 0 0].
    #[test]
    fn analytic_norm_is_the_largest_column_sum() {
        const BOTH: SparsityPattern = SparsityPattern::new(&[0, 2], &[0, 1]);
        assert_eq!(ConditionEstimator::new(&[1.0; 2], &BOTH).norm(&[2.0, 3.0], &[4.0, -5.0]), 9.0);
        const SECOND: SparsityPattern = SparsityPattern::new(&[0, 2, 3], &[0, 1, 0]);
        let mut estimator = ConditionEstimator::new(&[1.0; 2], &SECOND);
        assert_eq!(estimator.norm(&[2.0, 3.0], &[1.0, -1.0, 7.0]), 10.0);
        assert_eq!(estimator.norm(&[2.0, 3.0], &[9.0, -9.0, 1.0]), 18.0);
        estimator.scale = vec![0.5, 1.0, 1.0, 2.0];
        // with D: [0.5 0 0.5 7; 0 3 1 0; 0.5 1 0 0; 7 0 0 0]
        assert_eq!(estimator.norm(&[2.0, 3.0], &[1.0, -1.0, 7.0]), 8.0);
    }

    /// Whatever the units, the largest entry of each row and column of D K D is one but for a few percent.
    #[test]
    fn invariant_equilibrated_rows_have_entries_of_one() {
        const PATTERN: SparsityPattern = SparsityPattern::new(&[0, 2, 4], &[0, 1, 1, 2]);
        let entries: Vec<_> = PATTERN.entries().collect();
        let (mass, jacobian) = ([1e6, 3e-4, 20.0], [1e3, 2e-5, -40.0, 7e8]);
        let (mut d, mut largest) = (vec![0.0; 5], vec![0.0; 5]);
        equilibrate(&mass, &entries, &jacobian, &mut d, &mut largest);
        let mut found = [0.0_f64; 5];
        for (i, m) in mass.iter().enumerate() {
            found[i] = d[i] * m * d[i];
        }
        for (k, (row, column)) in [(0, 0), (0, 1), (1, 1), (1, 2)].into_iter().enumerate() {
            let entry = (d[3 + row] * jacobian[k] * d[column]).abs();
            found[column] = found[column].max(entry);
            found[3 + row] = found[3 + row].max(entry);
        }
        assert!(found.iter().all(|entry| (entry - 1.0).abs() <= 0.05), "{found:?}");
    }

    /// Five coordinates that nothing holds do not count beside the one that is: K⁻¹ has column sums of two and ones.
    #[test]
    fn analytic_free_coordinates_do_not_matter() {
        let found = ConditionEstimator::new(&[1.0; 6], &ONE_ROW).estimate(&[1.0; 6], &[1.0], &[]);
        assert_estimates(found, 4.0);
    }
}
