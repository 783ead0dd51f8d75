//! One configuration: G, the factors of K and what they say of its rows.

use super::active_set::ActiveSet;
use super::factors::{Factors, Made, Solver};
use super::solved::{Rows, Solved};
use super::{MotionError, System};
use crate::linalg::{
    DampedKkt, INDEPENDENT, INDEPENDENT_EXACTLY, Independent, LARGEST_DIAGNOSED, Left, NullSpaceKkt, RankRevealing,
    undetermined_coordinates,
};
use crate::model::{Equations as _, SceneRef, body_kind};

/// A system at one configuration: the factors of K, made once for all that is asked there.
pub(crate) struct Configuration<'c, P: SceneRef> {
    pub(super) system: &'c mut System<P>,
    pub(super) t: f64,
    pub(super) q: &'c [f64],
    pub(super) rows: Rows,
}

impl<P: SceneRef> System<P> {
    /// The system at the configuration `q` (`n_q`) at time `t`.
    #[inline]
    pub(crate) fn at<'c>(&'c mut self, t: f64, q: &'c [f64]) -> Configuration<'c, P> {
        Configuration { system: self, t, q, rows: Rows::Exact }
    }

    /// As [`System::at`], with these rows; held ones where [`Configuration::hold_rows`] found some.
    #[inline]
    pub(crate) fn at_with<'c>(&'c mut self, t: f64, q: &'c [f64], rows: Rows) -> Configuration<'c, P> {
        let rows = if rows == Rows::Held && !self.active.leaves_out_redundant() { Rows::Projected } else { rows };
        Configuration { system: self, t, q, rows }
    }

    /// Switches a row of the scene on or off, and sets its side ([`SceneInfo::switches`](crate::model::SceneInfo::switches)). What a step held
    /// is forgotten.
    pub(crate) fn switch(&mut self, row: usize, holds: bool, side: f64) {
        let Self { scene, info, fixed, active, factors, .. } = self;
        scene.constants(active.switch(info, row, holds, side), fixed);
        factors.forget();
    }

    /// Which rows hold.
    #[inline]
    pub(crate) fn active(&self) -> &ActiveSet {
        &self.active
    }
}

impl<'c, P: SceneRef> Configuration<'c, P> {
    /// Inputs, first-order states and constants, as [`System::fixed`].
    pub(crate) fn fixed(&self) -> &[f64] {
        &self.system.fixed
    }

    /// The scene, as the system holds it.
    pub(super) fn scene(&self) -> &P {
        &self.system.scene
    }

    /// Where rows are redundant at the start of a step, its stages keep to those that are independent there.
    #[inline]
    pub(crate) fn hold_rows(self, are_redundant: bool) {
        if !are_redundant && !self.system.active.leaves_out_redundant() {
            return;
        }
        let Self { system, t, q, .. } = self;
        let mut held = std::mem::take(&mut system.active.held);
        held.clear();
        if are_redundant
            && let Some(rank) = system.at(t, q).rank(Independent::Above(INDEPENDENT))
            && rank.n_redundant() > 0
        {
            held.extend(rank.independent_rows());
        }
        system.active.held = held;
        if system.factors.factored == Some(Rows::Held) {
            system.factors.forget();
        }
    }

    /// What G says about its rows; none in a system too large to tell, or where G is not finite.
    pub(super) fn rank(self, independent: Independent<'_>) -> Option<&'c RankRevealing> {
        let System { scene, info, fixed, mass, geometry, active, factors, sines, .. } = self.system;
        if info.n_unknowns() > LARGEST_DIAGNOSED {
            return None;
        }
        factors.jacobian_at(scene, fixed, sines, self.t, self.q);
        let rank = factors
            .rank
            .get_or_insert_with(|| Box::new(RankRevealing::new(info.n_rows(), info.n_velocities(), &info.jacobian)));
        rank.factor(&factors.jacobian, &geometry.units, mass, independent, active.off()).then_some(rank)
    }

    /// Square of the smallest pivot of the rows that a step goes on with; zero where they depend on each other, none where that cannot
    /// be told.
    pub(super) fn pivot_of_rows(&mut self) -> Option<f64> {
        let held = std::mem::take(&mut self.system.active.held);
        let rows = if held.is_empty() { Independent::Above(f64::EPSILON) } else { Independent::Rows(&held) };
        let is_small = self.system.info.n_unknowns() <= LARGEST_DIAGNOSED;
        let pivot = match self.system.at(self.t, self.q).rank(rows) {
            Some(rank) if held.is_empty() && rank.n_redundant() > 0 => Some(0.0),
            Some(rank) => Some(rank.smallest_pivot().powi(2)),
            None => is_small.then_some(0.0),
        };
        self.system.active.held = held;
        pivot
    }

    /// Smallest pivot, as in [`Solved`], at positions that no row has to hold; zero where rows depend on each other.
    pub(crate) fn smallest_pivot(&mut self) -> f64 {
        let least = self.system.counters.least_pivot;
        let pivot = if self.may_eliminate() {
            let System { scene, fixed, residual, factors, counters, .. } = &mut *self.system;
            residual.fill(0.0);
            let pivots = scene.correction(fixed, self.t, self.q, residual, &mut factors.delta);
            counters.eliminated(pivots).unwrap_or(0.0)
        } else {
            let of_rows = self.pivot_of_rows();
            of_rows.unwrap_or_else(|| self.system.at_with(self.t, self.q, Rows::Projected).factored_pivot())
        };
        self.system.counters.least_pivot = least;
        pivot
    }

    /// The same as cheaply as can be: sparse factors say that no row depends on others, and are at hand for the first step.
    pub(crate) fn pivot_at_hand(&mut self) -> f64 {
        let System { solver, active, counters, .. } = &*self.system;
        let least = counters.least_pivot;
        if matches!(solver, Solver::Sparse(_)) && active.held.is_empty() && active.off().is_empty() {
            let mut all = self.system.at_with(self.t, self.q, Rows::Projected);
            let pivot = all.factored_pivot();
            let is_sparse = matches!(all.system.factors.made, Made::Sparse);
            self.system.counters.least_pivot = least;
            if is_sparse && pivot > 0.0 {
                return pivot;
            }
        }
        self.smallest_pivot()
    }

    /// Whether the scene's own elimination may solve here: not where rows are redundant.
    #[inline]
    pub(super) fn may_eliminate(&self) -> bool {
        self.system.uses_elimination()
            && self.rows != Rows::Held
            && !self.system.factors.are_of(self.t, self.q, self.rows)
    }

    /// Factors K unless it was factored here.
    ///
    /// # Errors
    /// [`MotionError`] when a number is not finite or a coordinate is undetermined.
    pub(crate) fn factor(&mut self) -> Result<(), MotionError> {
        self.factor_with(None).map(|_| ())
    }

    /// As [`Self::factor`], then replaces r by x and s by y.
    ///
    /// # Errors
    /// As [`Self::factor`].
    pub(super) fn factor_and_solve(&mut self, r: &mut [f64], s: &mut [f64]) -> Result<Solved, MotionError> {
        Ok(match self.factor_with(Some((&mut *r, &mut *s)))? {
            true => Solved::regular(self.pivot()),
            false => self.solve_by_factors(r, s),
        })
    }

    /// [`Self::factor`]; returns whether the right side was solved for in the same sweep, as sparse factors do.
    fn factor_with(&mut self, right_side: Option<(&mut [f64], &mut [f64])>) -> Result<bool, MotionError> {
        let (t, q, rows) = (self.t, self.q, self.rows);
        if self.system.factors.are_of(t, q, rows) {
            return Ok(false);
        }
        let solves = right_side.is_some();
        let System { scene, info, fixed, mass, geometry, solver, active, factors, counters, sines, .. } =
            &mut *self.system;
        counters.factorizations += 1;
        factors.jacobian_at(scene, fixed, sines, t, q);
        factors.factored = None;
        let mut vanished = None;
        let mut made = Made::Dense;
        if let Solver::Sparse(kkt) = solver
            && rows != Rows::Held
            && active.off().is_empty()
        {
            let factored = match right_side {
                Some((r, s)) => kkt.factor_and_solve(&factors.jacobian, r, s),
                None => kkt.factor(&factors.jacobian),
            };
            match factored {
                Ok(()) => made = Made::Sparse,
                Err(at) => vanished = Some(at.row),
            }
        }
        let is_singular = match (made, vanished, &mut *solver) {
            (Made::Sparse, ..) => false,
            (_, Some(row), Solver::Sparse(kkt)) if info.n_unknowns() > LARGEST_DIAGNOSED => {
                made = Made::Damped(row);
                let damped = factors.damped.get_or_insert_with(|| Box::new(DampedKkt::new(mass, &info.jacobian)));
                damped.factor(kkt.as_mut(), &info.jacobian, &factors.jacobian).is_err()
            }
            _ => {
                let dense = factors
                    .dense
                    .get_or_insert_with(|| Box::new(NullSpaceKkt::new(&geometry.units, &info.jacobian, info.n_rows())));
                let independent = match rows {
                    Rows::Held => Independent::Rows(&active.held),
                    Rows::Projected => Independent::Above(INDEPENDENT),
                    Rows::Exact => Independent::Above(INDEPENDENT_EXACTLY),
                };
                dense.factor(mass, &factors.jacobian, independent, active.off()).is_err()
            }
        };
        if is_singular && rows == Rows::Held {
            // held rows have come to depend on each other
            self.rows = Rows::Projected;
            return self.factor_with(None);
        }
        if is_singular {
            return Err(self.why_singular());
        }
        (factors.made, factors.factored) = (made, Some(rows));
        let smallest = self.pivot();
        let counters = &mut self.system.counters;
        counters.least_pivot = counters.least_pivot.min(smallest);
        Ok(solves && made == Made::Sparse)
    }

    /// Of the factors.
    fn pivot(&self) -> f64 {
        let Factors { made, dense, .. } = &self.system.factors;
        match (made, &self.system.solver, dense) {
            (Made::Sparse, Solver::Sparse(kkt), _) => kkt.smallest_pivot(),
            (Made::Dense, _, Some(dense)) => dense.rank().smallest_pivot().powi(2),
            _ => 0.0,
        }
    }

    /// Replaces r by x and s by y, with the factors at hand.
    pub(super) fn solve_by_factors(&mut self, r: &mut [f64], s: &mut [f64]) -> Solved {
        let smallest_pivot = self.pivot();
        let System { mass, geometry, solver, factors, .. } = &mut *self.system;
        let Factors { made, dense, damped, jacobian, both, .. } = factors;
        if let (Made::Sparse, Solver::Sparse(kkt)) = (&made, &mut *solver) {
            kkt.solve(r, s);
            return Solved::regular(smallest_pivot);
        }
        both.clear();
        both.extend(r.iter().chain(&*s));
        let (is_rank_deficient, left) = match (made, solver, dense, damped) {
            (Made::Damped(_), Solver::Sparse(kkt), _, Some(damped)) => {
                (true, damped.solve(kkt.as_mut(), mass, jacobian, &geometry.units, both))
            }
            (_, _, Some(dense), _) => {
                let left = dense.solve(both);
                (dense.rank().n_redundant() > 0, left)
            }
            _ => (false, Left::default()),
        };
        r.copy_from_slice(&both[..r.len()]);
        s.copy_from_slice(&both[r.len()..]);
        Solved { smallest_pivot, is_rank_deficient, left }
    }

    /// Smallest pivot of the factors; zero where there are none.
    pub(super) fn factored_pivot(&mut self) -> f64 {
        if self.factor().is_ok() { self.pivot() } else { 0.0 }
    }

    /// The row whose pivot vanished in a system too large to tell more; none where rows are independent.
    pub(super) fn vanished_row(&mut self) -> Option<usize> {
        self.factor().ok()?;
        match self.system.factors.made {
            Made::Damped(row) => row,
            _ => None,
        }
    }

    /// Names what makes K singular whatever rows are redundant. Slow; only for reports.
    #[cold]
    fn why_singular(&mut self) -> MotionError {
        let (t, info, jacobian) = (self.t, &self.system.info, &self.system.factors.jacobian);
        let moved = body_kind::coordinates_moved(&info.kinds, info.n_velocities());
        match undetermined_coordinates(&self.system.mass, &info.jacobian, jacobian) {
            Some(found) if !found.is_empty() => MotionError::UndeterminedMotion {
                t,
                coordinates: found.iter().map(|&i| info.coordinates[moved[i]].name.clone()).collect(),
            },
            _ => MotionError::NotFinite { t, quantity: "the constraint Jacobian or an entry of its factors".into() },
        }
    }
}

#[cfg(all(test, feature = "sparse"))]
mod tests {
    use super::Rows;
    use crate::dynamics::system_of;
    use crate::dynamics::tests::row;
    use crate::linalg::Backend;

    /// The pivot of a start comes from the sparse factors that the first step takes, and no matrix is taken apart as a full one.
    #[test]
    fn invariant_pivot_of_a_start_is_that_of_the_factors() {
        let scene = row::Swings::default();
        let mut system = system_of(&scene, Backend::Sparse).unwrap();
        let q = system.scene_start().q;
        let pivot = system.at_with(0.0, &q, Rows::Held).pivot_at_hand();
        assert_eq!(pivot, system.at_with(0.0, &q, Rows::Projected).factored_pivot());
        assert!(pivot > 0.0 && system.factors.rank.is_none() && system.factors.dense.is_none());
        // that of the rows alone is another number, and takes the matrix apart
        assert!(system.at_with(0.0, &q, Rows::Held).smallest_pivot() > 0.0 && system.factors.rank.is_some());
    }
}
