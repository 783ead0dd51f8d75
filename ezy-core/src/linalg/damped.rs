//! K where rows depend on each other: a solution that leaves what they cannot tell apart alone.

use super::{KktFactorization, VanishedPivot};
use crate::model::SparsityPattern;

/// Solves `K [x; y] = [r; s]` by `[M Gᵀ; G −ε D]` in passes, each for what the passes before have left; `D` is the
/// diagonal of `G M⁻¹ Gᵀ`, with substitutes for massless coordinates.
///
/// Let σ be the singular values of `D^(−1/2) G M^(−1/2)`. After `p` passes the part of a direction is the share
/// `1 − (ε/(σ² + ε))^p` of what it ought to be: all of it where `σ² ≫ ε`, none where the rows depend on each other.
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
    rest: Vec<f64>,
    /// Magnitudes of the terms of each equation.
    size: Vec<f64>,
}

/// What a solution leaves of the rows: not small only where they contradict each other.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Left {
    /// Length of what is left of s, each row over the root of its entry of D.
    pub rows: f64,
    /// To compare with: the length of x in the mass matrix, or of M⁻¹ r where that is larger.
    pub scale: f64,
}

/// ε for accelerations and velocities: with a relative rounding of 1e-16 in positions, what σ = 3e-5 tells about
/// accelerations (rounding/σ³) is noise.
pub(crate) const COARSE: f64 = 1e-9;

/// ε for positions, whose rounding reaches the result with 1/σ only.
pub(crate) const FINE: f64 = 1e-13;

/// A pass squares what it leaves of well determined directions; the others stop here.
const MAX_PASSES: usize = 10;

/// A pass that changes x by less than this share of it was the last one.
const CONVERGED: f64 = 1e-15;

/// Terms smaller than this part of the largest may be rounding altogether: what an equation leaves is measured by no less.
const NEGLIGIBLE: f64 = 1e-2;

impl DampedKkt {
    /// Storage for the diagonal of M and `n_rows` rows. A zero is replaced by the least positive entry of its kind, mass
    /// or inertia.
    pub(crate) fn new(mass: &[f64], n_rows: usize) -> Self {
        let n = mass.len() + n_rows;
        Self {
            weight: weights(mass),
            diagonal: vec![0.0; n_rows],
            damping: vec![0.0; n_rows],
            right_side: vec![0.0; n],
            rest: vec![0.0; n],
            size: vec![0.0; n],
        }
    }

    /// Number of rows.
    pub(crate) fn n_rows(&self) -> usize {
        self.diagonal.len()
    }

    /// Factors K with the rows damped by `share`, ε.
    ///
    /// # Errors
    /// [`VanishedPivot`] when a coordinate has neither mass nor a row that holds it, or a number is not finite.
    pub(crate) fn factor(
        &mut self,
        kkt: &mut dyn KktFactorization,
        pattern: &SparsityPattern,
        mass: &[f64],
        jacobian: &[f64],
        share: f64,
    ) -> Result<(), VanishedPivot> {
        write_diagonal(rows_of(pattern, self.diagonal.len()), &self.weight, jacobian, &mut self.diagonal);
        self.damping.iter_mut().zip(&self.diagonal).for_each(|(damping, diagonal)| *damping = share * diagonal);
        kkt.factor_damped(mass, jacobian, &self.damping)
    }

    /// Replaces `[r; s]` by `[x; y]` with the factors of the last [`Self::factor`].
    pub(crate) fn solve(
        &mut self,
        kkt: &mut dyn KktFactorization,
        pattern: &SparsityPattern,
        mass: &[f64],
        jacobian: &[f64],
        solution: &mut [f64],
    ) -> Left {
        let n_q = mass.len();
        self.right_side.copy_from_slice(solution);
        solution.fill(0.0);
        for _ in 0..MAX_PASSES {
            self.write_rest(pattern, mass, jacobian, solution);
            kkt.solve(&mut self.rest);
            solution.iter_mut().zip(&self.rest).for_each(|(x, change)| *x += change);
            if self.length(&self.rest) <= CONVERGED * self.length(solution) {
                break;
            }
        }
        self.write_rest(pattern, mass, jacobian, solution);
        let rows = self.rest[n_q..].iter().zip(&self.diagonal);
        let applied = self.right_side[..n_q].iter().zip(&self.weight);
        Left {
            rows: rows.map(|(left, diagonal)| left * left / diagonal).sum::<f64>().sqrt(),
            scale: self.length(solution).max(applied.map(|(r, weight)| r * r / weight).sum::<f64>().sqrt()),
        }
    }

    /// The largest share that a solution of K [x; y] = [r; s], however it was found, leaves of the terms of an equation; NaN
    /// where a number is none.
    pub(crate) fn share_left(
        &mut self,
        pattern: &SparsityPattern,
        mass: &[f64],
        jacobian: &[f64],
        right_side: &[f64],
        solution: &[f64],
    ) -> f64 {
        write_diagonal(rows_of(pattern, self.diagonal.len()), &self.weight, jacobian, &mut self.diagonal);
        self.right_side.copy_from_slice(right_side);
        self.write_rest(pattern, mass, jacobian, solution);
        self.write_size(pattern, mass, jacobian, solution);
        // forces over the root of a mass, accelerations times it: in these units all equations compare
        let units = self.weight.iter().chain(&self.diagonal).map(|square| square.sqrt());
        let largest = self.size.iter().zip(units.clone()).fold(0.0, |m: f64, (size, unit)| m.max(size / unit));
        let plain = self.size.iter().copied().fold(0.0, f64::max);
        let left = self.rest.iter().zip(&self.size).zip(units).filter(|((rest, _), _)| **rest != 0.0);
        // a substitute for a mass may be far from all masses: then the numbers as they stand are the limit
        let shares = left.map(|((rest, size), unit)| rest.abs() / (size + NEGLIGIBLE * plain.min(largest * unit)));
        shares.fold(0.0, |m: f64, x| if x > m || x.is_nan() { x } else { m })
    }

    /// Length of `x` in the mass matrix.
    fn length(&self, x: &[f64]) -> f64 {
        x.iter().zip(&self.weight).map(|(x, weight)| weight * x * x).sum::<f64>().sqrt()
    }

    /// `rest = [r; s] − K [x; y]`
    fn write_rest(&mut self, pattern: &SparsityPattern, mass: &[f64], jacobian: &[f64], solution: &[f64]) {
        let n_q = mass.len();
        self.rest.copy_from_slice(&self.right_side);
        self.rest.iter_mut().zip(solution).zip(mass).for_each(|((rest, x), m)| *rest -= m * x);
        for (k, row, column) in rows_of(pattern, self.diagonal.len()) {
            self.rest[column] -= jacobian[k] * solution[n_q + row];
            self.rest[n_q + row] -= jacobian[k] * solution[column];
        }
    }

    /// `size = |[r; s]| + |K| |[x; y]|`
    fn write_size(&mut self, pattern: &SparsityPattern, mass: &[f64], jacobian: &[f64], solution: &[f64]) {
        let n_q = mass.len();
        self.size.iter_mut().zip(&self.right_side).for_each(|(size, r)| *size = r.abs());
        self.size.iter_mut().zip(solution).zip(mass).for_each(|((size, x), m)| *size += (m * x).abs());
        for (k, row, column) in rows_of(pattern, self.diagonal.len()) {
            self.size[column] += (jacobian[k] * solution[n_q + row]).abs();
            self.size[n_q + row] += (jacobian[k] * solution[column]).abs();
        }
    }
}

/// Entries of the first rows.
fn rows_of(pattern: &SparsityPattern, n_rows: usize) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
    pattern.entries().take_while(move |(_, row, _)| *row < n_rows)
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
        let of_kind = mass.iter().enumerate().filter(|(i, m)| (i % 3 == 2) == angle && **m > 0.0).map(|(_, m)| *m);
        of_kind.min_by(f64::total_cmp).unwrap_or(1.0)
    };
    let (length, angle) = (substitute(false), substitute(true));
    let weight = |(i, m): (usize, &f64)| match (*m > 0.0, i % 3 == 2) {
        (true, _) => *m,
        (false, false) => length,
        (false, true) => angle,
    };
    mass.iter().enumerate().map(weight).collect()
}
