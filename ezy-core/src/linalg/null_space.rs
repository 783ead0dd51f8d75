//! The null-space method: K solved for any rank of G, with singular M where rows hold what has no mass.

use super::equation_residual::EquationResidual;
use super::rank::{Independent, RankRevealing};
use super::tolerances::refinement::{MAX_REFINEMENTS, ROUNDING};
use super::{Left, SingularKkt};
use crate::model::SparsityPattern;
use nalgebra::linalg::Cholesky;
use nalgebra::{DMatrix, DVectorView, DVectorViewMut, Dyn};

/// Factors of `K = [M Gᵀ; G 0]` by coordinate partitioning.
///
/// Full pivoting of G, rows scaled to one and angles in units of their levers, gives `P G Q = L [U₁ U₂]` on the independent rows,
/// and the dependent coordinates x₁ as functions of the independent ones x₂: `Z = [−U₁⁻¹ U₂; I]` spans the null space of G.
/// `Zᵀ M Z` is positive definite wherever the motion is determined, and
///
/// ```text
/// p = U₁⁻¹ L⁻¹ s,   Zᵀ M Z x₂ = Zᵀ (r − M [p; 0]),   x = [p; 0] + Z x₂,   (L U₁)ᵀ y = (r − M x)₁
/// ```
///
/// Redundant rows take no part; y is the smallest of all that belong to x, each multiplier in units of its scaled row. Iterative
/// refinement against K makes each equation as exact as the rounding of its own terms, also where masses are 1e12 apart.
///
/// # Source
/// Wehage, Haug, J. Mech. Design 104 (1982), coordinate partitioning by full pivoting; Benzi, Golub, Liesen, Acta Numerica 14
/// (2005), section 6; Skeel, Math. Comp. 35 (1980), for the refinement.
pub(crate) struct NullSpaceKkt {
    /// Unit of each coordinate: its lever for an angle, one for a length.
    unit: Vec<f64>,
    rank: RankRevealing,
    /// Of the scaled `Zᵀ M Z`.
    reduced: Cholesky<f64, Dyn>,
    /// Scale of the independent coordinates in it.
    scale: Vec<f64>,
    /// Of `I + T Tᵀ`, T the redundant rows as combinations of the independent ones.
    redundant: Cholesky<f64, Dyn>,
    mass: Vec<f64>,
    jacobian: Vec<f64>,
    right_side: Vec<f64>,
    /// The best solution so far.
    best: Vec<f64>,
    equations: EquationResidual,
    /// Masses in these units, forces, then accelerations, in the order of the pivots.
    mass_by_place: Vec<f64>,
    forces: Vec<f64>,
    x: Vec<f64>,
    rows: Vec<f64>,
}

impl NullSpaceKkt {
    /// Storage for the first `n_rows` rows of `pattern`; `unit` (`n_q`) is the lever of each angle, m, and one for lengths.
    pub(crate) fn new(unit: &[f64], pattern: &SparsityPattern, n_rows: usize) -> Self {
        let n_q = unit.len();
        let zeros = |n: usize| vec![0.0; n];
        Self {
            unit: unit.to_vec(),
            rank: RankRevealing::new(n_rows, n_q, pattern),
            // of the size for rows that are all independent
            reduced: Cholesky::pack_dirty(DMatrix::zeros(n_q.saturating_sub(n_rows), n_q.saturating_sub(n_rows))),
            scale: zeros(n_q),
            redundant: empty(),
            mass: zeros(n_q),
            jacobian: zeros(pattern.n_nonzeros()),
            right_side: zeros(n_q + n_rows),
            best: zeros(n_q + n_rows),
            equations: EquationResidual::new(n_q, n_rows, pattern),
            mass_by_place: zeros(n_q),
            forces: zeros(n_q),
            x: zeros(n_q),
            rows: zeros(n_rows),
        }
    }

    /// What the last successful factorisation found about the rows of G.
    pub(crate) fn rank(&self) -> &RankRevealing {
        &self.rank
    }

    /// Factors K for the diagonal `mass` (`n_q`) and the entries `jacobian` of G in the order of the pattern, without the rows that are
    /// `off`: their multipliers are zero.
    ///
    /// # Errors
    /// [`SingularKkt`] when a number is not finite, nothing moves a coordinate, or rows that are taken for independent are not.
    /// # Cost
    /// `n_c² n_q` comparisons and as many multiplications; no allocation unless the rank changed.
    pub(crate) fn factor(
        &mut self,
        mass: &[f64],
        jacobian: &[f64],
        independent: Independent<'_>,
        off: &[usize],
    ) -> Result<(), SingularKkt> {
        self.mass.copy_from_slice(mass);
        self.jacobian.copy_from_slice(jacobian);
        if !self.rank.factor(jacobian, &self.unit, mass, independent, off) {
            return Err(SingularKkt);
        }
        for (place, felt) in self.mass_by_place.iter_mut().enumerate() {
            let column = self.rank.column(place);
            *felt = mass[column] / self.unit[column] / self.unit[column];
        }
        self.factor_redundant();
        self.factor_reduced()
    }

    /// `Zᵀ M Z`, scaled to ones on its diagonal.
    fn factor_reduced(&mut self) -> Result<(), SingularKkt> {
        let (r, n) = (self.rank.rank(), self.unit.len() - self.rank.rank());
        let (of_dependent, of_independent) = self.mass_by_place.split_at(r);
        let Z = self.rank.dependent_by_independent();
        let mut H = storage(&mut self.reduced, n);
        for (j, of_j) in Z.column_iter().enumerate() {
            for (i, of_i) in Z.column_iter().enumerate().skip(j) {
                let products = of_dependent.iter().zip(of_i.iter().zip(of_j.iter()));
                let own = if i == j { of_independent[j] } else { 0.0 };
                H[(i, j)] = products.map(|(m, (x, y))| m * x * y).sum::<f64>() + own;
            }
            self.scale[j] = H[(j, j)].sqrt().recip();
        }
        for j in 0..n {
            for i in j..n {
                H[(i, j)] *= self.scale[i] * self.scale[j];
            }
        }
        let rounding = n as f64 * f64::EPSILON;
        self.reduced = Cholesky::new(H)
            .filter(|factor| (0..n).all(|i| factor.l_dirty()[(i, i)].powi(2) > rounding))
            .ok_or(SingularKkt)?;
        Ok(())
    }

    /// `I + T Tᵀ`, which is regular.
    fn factor_redundant(&mut self) {
        let T = self.rank.redundant_by_independent();
        let n = T.nrows();
        let mut S = storage(&mut self.redundant, n);
        for j in 0..n {
            for i in j..n {
                let own = if i == j { 1.0 } else { 0.0 };
                S[(i, j)] = T.row(i).iter().zip(T.row(j).iter()).map(|(x, y)| x * y).sum::<f64>() + own;
            }
        }
        if let Some(factor) = Cholesky::new(S) {
            self.redundant = factor;
        }
    }

    /// Replaces `[r; s]` (`n_q + n_c`) by `[x; y]` with the factors of the last successful [`Self::factor`]; tells what redundant rows
    /// leave.
    pub(crate) fn solve(&mut self, solution: &mut [f64]) -> Left {
        self.right_side.copy_from_slice(solution);
        self.substitute(solution);
        let (mut left, mut share) = self.put_in(solution);
        for _ in 0..MAX_REFINEMENTS {
            if share <= ROUNDING {
                break;
            }
            let mut correction = std::mem::take(&mut self.equations.left);
            self.substitute(&mut correction);
            self.best.copy_from_slice(solution);
            solution.iter_mut().zip(&correction).for_each(|(x, dx)| *x += dx);
            self.equations.left = correction;
            let (left_now, share_now) = self.put_in(solution);
            if share_now.is_nan() || share_now >= share {
                solution.copy_from_slice(&self.best);
                break;
            }
            (left, share) = (left_now, share_now);
        }
        left
    }

    /// Puts a solution into the equations: what redundant rows leave, and the largest share that another equation leaves.
    fn put_in(&mut self, solution: &[f64]) -> (Left, f64) {
        let Self { mass, jacobian, right_side, equations, rank, unit, .. } = self;
        equations.write(mass, jacobian, right_side, solution);
        // a few redundant rows
        let redundant = || (rank.rank()..rank.rank() + rank.n_redundant()).map(|place| rank.row(place));
        let of_rows =
            equations.rows_left(mass, jacobian, unit, right_side, solution, |row| redundant().any(|of| of == row));
        redundant().for_each(|row| equations.left[unit.len() + row] = 0.0);
        (of_rows, equations.share())
    }

    /// Replaces `[r; s]` by `[x; y]` with the factors alone.
    pub(crate) fn substitute(&mut self, right_side: &mut [f64]) {
        let Self { unit, rank, reduced, scale, redundant, mass_by_place: mass, forces, x, rows, .. } = self;
        let (n_q, r) = (unit.len(), rank.rank());
        let (force, row) = right_side.split_at_mut(n_q);
        for (place, to) in forces.iter_mut().enumerate() {
            *to = force[rank.column(place)] / unit[rank.column(place)];
        }
        for (place, to) in rows.iter_mut().enumerate() {
            *to = row[rank.row(place)] * rank.row_scale(rank.row(place));
        }
        let Z = rank.dependent_by_independent();
        let (dependent, independent) = x.split_at_mut(r);
        dependent.copy_from_slice(&rows[..r]);
        rank.solve(dependent);
        let balance = |place: usize, x: f64| forces[place] - mass[place] * x;
        for (j, (x, column)) in independent.iter_mut().zip(Z.column_iter()).enumerate() {
            let through = column.iter().zip(&*dependent).enumerate().map(|(i, (z, x))| z * balance(i, *x));
            *x = (forces[r + j] + through.sum::<f64>()) * scale[j];
        }
        reduced.solve_mut(&mut DVectorViewMut::from_slice(independent, n_q - r));
        independent.iter_mut().zip(&*scale).for_each(|(x, scale)| *x *= scale);
        for (x, column) in independent.iter().zip(Z.column_iter()) {
            dependent.iter_mut().zip(column.iter()).for_each(|(of, z)| *of += z * x);
        }
        let (first, second) = rows.split_at_mut(r);
        first.iter_mut().zip(&*dependent).enumerate().for_each(|(i, (y, x))| *y = balance(i, *x));
        rank.solve_transposed(first);
        let (second, off) = second.split_at_mut(rank.n_redundant());
        off.fill(0.0);
        if !second.is_empty() {
            // of all multipliers [y₁ − Tᵀ z; z] the smallest
            let T = rank.redundant_by_independent();
            let mut z = DVectorViewMut::from_slice(second, T.nrows());
            z.gemv(1.0, &T, &DVectorView::from_slice(first, r), 0.0);
            redundant.solve_mut(&mut z);
            DVectorViewMut::from_slice(first, r).gemv_tr(-1.0, &T, &z, 1.0);
        }
        for (place, x) in x.iter().enumerate() {
            force[rank.column(place)] = x / unit[rank.column(place)];
        }
        for (place, y) in rows.iter().enumerate() {
            row[rank.row(place)] = y * rank.row_scale(rank.row(place));
        }
    }
}

fn empty() -> Cholesky<f64, Dyn> {
    Cholesky::pack_dirty(DMatrix::zeros(0, 0))
}

/// The storage of a factor, of this size.
fn storage(factor: &mut Cholesky<f64, Dyn>, n: usize) -> DMatrix<f64> {
    let matrix = std::mem::replace(factor, empty()).unpack_dirty();
    if matrix.nrows() == n { matrix } else { DMatrix::zeros(n, n) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: Independent<'static> = Independent::Above(crate::linalg::INDEPENDENT);

    /// Two bodies on a line, x₁ and x₂, and rows among 1 x₁ + 0 x₂, 1 x₁ + 1 x₂, 2 x₁ + 1 x₂.
    const ROWS: SparsityPattern = SparsityPattern::new(&[0, 2, 4, 6], &[0, 1, 0, 1, 0, 1]);

    #[test]
    fn analytic_a_repeated_row_shares_its_force() {
        // two rows x₁ = x₂ and one that is twice as large: each carries as much, in units of its scaled row
        let mut kkt = NullSpaceKkt::new(&[1.0, 1.0], &ROWS, 3);
        kkt.factor(&[1.0, 3.0], &[1.0, -1.0, 1.0, -1.0, 2.0, -2.0], ALL, &[]).unwrap();
        assert_eq!(kkt.rank().n_redundant(), 2);
        let mut x = [8.0, 0.0, 0.0, 0.0, 0.0];
        let left = kkt.solve(&mut x);
        // 4 kg accelerate by 2; a force of 6 on the second
        for (x, expected) in x.iter().zip([2.0, 2.0, 2.0, 2.0, 1.0]) {
            assert!((x - expected).abs() <= 1e-14, "{x} {expected}");
        }
        assert_eq!(left.rows, 0.0);
    }

    #[test]
    fn invariant_redundant_rows_that_contradict_others_are_told() {
        let mut kkt = NullSpaceKkt::new(&[1.0, 1.0], &ROWS, 2);
        kkt.factor(&[1.0, 1.0], &[1.0, -1.0, 1.0, -1.0, 0.0, 0.0], ALL, &[]).unwrap();
        let left = kkt.solve(&mut [0.0, 0.0, 1.0, 0.5]);
        // the first row has terms of 1, 1/2 and 1/2
        assert_eq!((left.rows, left.scale), (0.5, 2.0));
    }

    #[test]
    fn analytic_massless_coordinates_follow_rows_and_free_ones_are_singular() {
        let pattern = SparsityPattern::new(&[0, 2], &[0, 1]);
        let mut kkt = NullSpaceKkt::new(&[1.0, 1.0], &pattern, 1);
        kkt.factor(&[0.0, 2.0], &[1.0, -1.0], ALL, &[]).unwrap();
        let mut x = [4.0, 0.0, 0.0];
        kkt.solve(&mut x);
        assert!(x.iter().zip([2.0, 2.0, 4.0]).all(|(x, exact)| (x / exact - 1.0).abs() <= 4.0 * f64::EPSILON), "{x:?}");
        assert_eq!(kkt.factor(&[0.0, 0.0], &[1.0, -1.0], ALL, &[]), Err(SingularKkt));
    }

    /// Of two coordinates without mass only 3 x₂ + k x₃ is felt, by the heavy one: their `Zᵀ M Z` has rank one, up to rounding.
    #[test]
    fn invariant_motion_that_only_rounding_resists_is_singular() {
        let pattern = SparsityPattern::new(&[0, 3], &[0, 1, 2]);
        for i in 1..200 {
            let k = 0.37 * f64::from(i);
            let mut kkt = NullSpaceKkt::new(&[1.0; 3], &pattern, 1);
            // the heavy coordinate is the only pivot
            let jacobian = [1e4, -3.0, -k];
            assert_eq!(kkt.factor(&[0.7, 0.0, 0.0], &jacobian, ALL, &[]), Err(SingularKkt), "{k}");
        }
    }

    /// Factors of a third of the mass: x = r leaves −2 r of terms of 4 r, and the refined x = −r leaves 4 r. It is taken back.
    #[test]
    fn analytic_refinement_that_makes_a_solution_worse_is_taken_back() {
        let pattern = SparsityPattern::new(&[0, 1], &[0]);
        let mut kkt = NullSpaceKkt::new(&[1.0, 1.0], &pattern, 1);
        kkt.factor(&[1.0, 1.0], &[1.0], ALL, &[]).unwrap();
        kkt.mass[1] = 3.0;
        let mut x = [0.0, 1.0, 0.0];
        kkt.solve(&mut x);
        assert_eq!(x, [0.0, 1.0, 0.0]);
    }

    #[test]
    fn analytic_accelerations_are_exact_whatever_the_ratio_of_masses() {
        // a chain of three on a line, pulled at its end: all accelerate by F/Σm
        let pattern = SparsityPattern::new(&[0, 2, 4], &[0, 1, 1, 2]);
        for masses in [[1.0, 1.0, 1e12], [1e12, 1.0, 1.0], [1e6, 1e-6, 1e6], [1.0, 1e-300, 1.0]] {
            let mut kkt = NullSpaceKkt::new(&[1.0; 3], &pattern, 2);
            kkt.factor(&masses, &[1.0, -1.0, 1.0, -1.0], ALL, &[]).unwrap();
            let mut x = [0.0, 0.0, 1.0, 0.0, 0.0];
            kkt.solve(&mut x);
            let expected = 1.0 / masses.iter().sum::<f64>();
            assert!(x[..3].iter().all(|a| (a / expected - 1.0).abs() <= 1e-15), "{masses:?}: {x:?}");
        }
    }

    #[test]
    fn invariant_every_equation_keeps_its_digits_whatever_the_masses() {
        // the light coordinates are on short levers, so that the heavy one is by turns dependent and independent
        let pattern = SparsityPattern::new(&[0, 3, 6], &[0, 1, 2, 0, 1, 2]);
        let (jacobian, right_side) = ([0.0, -1.0, 0.0, 0.8, -0.8, 0.004], [-1.5, 1.3e-6, -2e-7, 0.0, 0.3]);
        for exponent in -8..=8 {
            let mass = [2.0 * 10_f64.powi(exponent), 2e-6, 2e-7];
            let mut kkt = NullSpaceKkt::new(&[1.0; 3], &pattern, 2);
            kkt.factor(&mass, &jacobian, ALL, &[]).unwrap();
            let mut x = right_side;
            kkt.solve(&mut x);
            let mut equations = EquationResidual::new(3, 2, &pattern);
            equations.write(&mass, &jacobian, &right_side, &x);
            assert!(equations.share() <= 4.0 * f64::EPSILON, "{mass:?}: {:e}", equations.share());
        }
    }
}
