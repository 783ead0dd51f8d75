//! K of large systems where constraints depend on each other: a solution that leaves alone what they cannot tell apart.

use super::equation_residual::EquationResidual;
use super::tolerances::damped::{MAX_PASSES, SHARE};
use super::{KktFactorization, Left, VanishedPivot};
use crate::model::SparsityPattern;
use crate::model::coordinate::is_angle;

/// Solves `K [x; y] = [r; s]` by `[M Gᵀ; G −ε D]` in passes, each for what the passes before have left; `D` is the
/// diagonal of `G M⁻¹ Gᵀ`, with substitutes for massless coordinates.
///
/// Let σ be the singular values of `D^(−1/2) G M^(−1/2)`. After `p` passes the part of a direction is the share
/// `1 − (ε/(σ² + ε))^p` of what it ought to be: all of it where `σ² ≫ ε`, none where the constraints depend on each other.
/// So x is unique, y is the smallest `Σ D_kk y_k²` among those that belong to it, and nearly dependent rows below
/// `σ = √(ε/p)`, whose part rounding decides, are passed over.
///
/// # Source
/// The method of multipliers; for rigid bodies Bayo, Avello, Nonlinear Dynamics 5 (1994); Carpentier, Budhiraja, Mansard,
/// Robotics: Science and Systems (2021).
pub(crate) struct DampedKkt {
    /// M, with a substitute in place of each zero.
    weight: Vec<f64>,
    /// D.
    diagonal: Vec<f64>,
    damping: Vec<f64>,
    right_side: Vec<f64>,
    change: Vec<f64>,
    equations: EquationResidual,
}

impl DampedKkt {
    /// Storage for the diagonal of M and the rows of `pattern`. A zero is replaced by the least positive entry of its kind, mass or
    /// inertia.
    pub(crate) fn new(mass: &[f64], pattern: &SparsityPattern) -> Self {
        let (n_q, n_rows) = (mass.len(), pattern.n_rows());
        Self {
            weight: weights(mass),
            diagonal: vec![0.0; n_rows],
            damping: vec![0.0; n_rows],
            right_side: vec![0.0; n_q + n_rows],
            change: vec![0.0; n_q + n_rows],
            equations: EquationResidual::new(n_q, n_rows, pattern),
        }
    }

    /// Factors K with the rows damped.
    ///
    /// # Errors
    /// [`VanishedPivot`] when a coordinate has neither mass nor a row that holds it, or a number is not finite.
    pub(crate) fn factor(
        &mut self,
        kkt: &mut dyn KktFactorization,
        pattern: &SparsityPattern,
        jacobian: &[f64],
    ) -> Result<(), VanishedPivot> {
        write_diagonal(pattern.entries(), &self.weight, jacobian, &mut self.diagonal);
        self.damping.iter_mut().zip(&self.diagonal).for_each(|(damping, diagonal)| *damping = SHARE * diagonal);
        kkt.factor_damped(jacobian, &self.damping)
    }

    /// Replaces `[r; s]` by `[x; y]` with the factors of the last [`Self::factor`].
    pub(crate) fn solve(
        &mut self,
        kkt: &mut dyn KktFactorization,
        mass: &[f64],
        jacobian: &[f64],
        unit: &[f64],
        solution: &mut [f64],
    ) -> Left {
        self.right_side.copy_from_slice(solution);
        solution.fill(0.0);
        for _ in 0..MAX_PASSES {
            self.equations.write(mass, jacobian, &self.right_side, solution);
            self.change.copy_from_slice(&self.equations.left);
            let (r, s) = self.change.split_at_mut(mass.len());
            kkt.solve(r, s);
            solution.iter_mut().zip(&self.change).for_each(|(x, change)| *x += change);
            if self.length(&self.change) <= f64::EPSILON * self.length(solution) {
                break;
            }
        }
        self.equations.write(mass, jacobian, &self.right_side, solution);
        self.equations.rows_left(mass, jacobian, unit, &self.right_side, solution, |_| true)
    }

    /// Length of `x` in the mass matrix.
    fn length(&self, x: &[f64]) -> f64 {
        x.iter().zip(&self.weight).map(|(x, weight)| weight * x * x).sum::<f64>().sqrt()
    }
}

/// Diagonal of `G W⁻¹ Gᵀ` for the entries of G; one for a row without any.
pub(crate) fn write_diagonal(
    entries: impl Iterator<Item = (usize, usize, usize)>,
    weight: &[f64],
    jacobian: &[f64],
    diagonal: &mut [f64],
) {
    diagonal.fill(0.0);
    for (k, row, column) in entries {
        diagonal[row] += jacobian[k] * jacobian[k] / weight[column];
    }
    diagonal.iter_mut().filter(|d| **d == 0.0).for_each(|d| *d = 1.0);
}

/// The diagonal of M; a coordinate without mass takes the smallest positive entry of its kind, or one.
pub(crate) fn weights(mass: &[f64]) -> Vec<f64> {
    let substitute = |angle: bool| {
        let of_kind = mass.iter().enumerate().filter(|(i, m)| is_angle(*i) == angle && **m > 0.0).map(|(_, m)| *m);
        of_kind.min_by(f64::total_cmp).unwrap_or(1.0)
    };
    let (length, angle) = (substitute(false), substitute(true));
    let weight = |(i, m): (usize, &f64)| match (*m > 0.0, is_angle(i)) {
        (true, _) => *m,
        (false, false) => length,
        (false, true) => angle,
    };
    mass.iter().enumerate().map(weight).collect()
}

#[cfg(feature = "sparse")]
#[cfg(test)]
mod tests {
    use super::super::SparseKkt;
    use super::*;

    /// Of an acceleration of one; the passes leave (ε/(σ² + ε))¹⁰ = 2e-8 of it at σ² = 5e-9.
    const HELD: f64 = 1e-6;

    #[test]
    fn analytic_a_row_at_an_angle_of_1e_4_holds_and_a_repeated_one_does_not_matter() {
        const ROWS: SparsityPattern = SparsityPattern::new(&[0, 2, 4, 6], &[0, 1, 0, 1, 0, 1]);
        let (mass, jacobian) = ([1.0, 1.0], [1.0, 0.0, 1.0, 1e-4, 1.0, 0.0]);
        let mut kkt = SparseKkt::new(&mass, &ROWS, 3).unwrap();
        let mut damped = DampedKkt::new(&mass, &ROWS);
        damped.factor(&mut kkt, &ROWS, &jacobian).unwrap();
        let mut x = [1.0, 1.0, 0.0, 0.0, 0.0];
        damped.solve(&mut kkt, &mass, &jacobian, &[1.0, 1.0], &mut x);
        assert!(x[0].abs() <= HELD && x[1].abs() <= HELD, "{x:?}");
    }
}
