//! Accelerations that leave nothing of any equation, or a word about why there are none.

use super::deficient::{Rank, second_opinion};
use super::system::Buffers;
use super::{MotionError, System};
use crate::linalg::{DampedKkt, KktFactorization, LARGEST_DIAGNOSED, weights};
use crate::model::Scene;

/// Share of the terms of an equation that dependent rows that agree leave of it at most. Of what damping has passed over, levers far
/// apart can make much more than its share.
const ROUNDING: f64 = 1e-14;

/// Share of the terms of an equation that accelerations may leave of it.
/// Of rows at the distance σ from dependent ones damping leaves what it passes over, up to 4e-6 of the accelerations; where
/// rounding does not hide what these rows say (pivots of σ² above 1e-13) complete pivoting leaves rounding again. Below it
/// rows count as dependent when they agree to this share, and are refused when they do not.
const SETTLED: f64 = 1e-12;

impl<S: Scene + ?Sized> System<'_, S> {
    /// Makes sure of accelerations that were not eliminated: where they leave a part of an equation, damping has passed over
    /// what rows say, or pivots were too small; complete pivoting shows whether K tells more than rounding. Large systems of
    /// full rank are taken as they are, like what the elimination gives.
    ///
    /// # Errors
    /// [`MotionError::NotFinite`], [`MotionError::ContradictoryRows`], [`MotionError::LostInRounding`].
    pub(super) fn settle_accelerations(
        &mut self,
        t: f64,
        q: &[f64],
        v: &[f64],
        a: &mut [f64],
        lambda: &mut [f64],
    ) -> Result<(), MotionError> {
        let is_small = self.info.n_unknowns() <= LARGEST_DIAGNOSED;
        if !is_small && !self.rank.deficient {
            return Ok(());
        }
        let mut left = self.share_left(t, q, v);
        if left <= ROUNDING {
            return Ok(());
        }
        if is_small {
            let dense = second_opinion(&mut self.second_opinion, self.info);
            if dense.factor_completely(&self.mass, &self.buffers.jacobian).is_ok() {
                self.write_right_side(t, q, v);
                second_opinion(&mut self.second_opinion, self.info).solve(&mut self.buffers.right_side);
                let decided = self.share_left(t, q, v);
                if decided < left || left.is_nan() {
                    self.read_solution(a, lambda);
                    self.rank = Rank::default();
                    left = decided;
                }
            }
        }
        if left <= SETTLED {
            return Ok(());
        }
        if left.is_nan() {
            return Err(MotionError::NotFinite { t, quantity: "an acceleration or a multiplier" });
        }
        self.check_accelerations(t, q)?;
        let found = self.dependencies_in(t, q, &weights(&self.mass)).filter(|found| found.n > 0);
        Err(MotionError::LostInRounding {
            t,
            rows: found.iter().flat_map(|found| &found.rows).map(|&i| self.info.rows[i].name).collect(),
            smallest_pivot: found.map(|found| found.smallest_pivot),
            residual: left,
        })
    }

    /// The largest share that the solution in the buffer leaves of the terms of an equation of motion or of a row.
    fn share_left(&mut self, t: f64, q: &[f64], v: &[f64]) -> f64 {
        let Buffers { right_side, second_side, .. } = &mut self.buffers;
        std::mem::swap(right_side, second_side);
        self.write_right_side(t, q, v);
        std::mem::swap(&mut self.buffers.right_side, &mut self.buffers.second_side);
        let damped = self.damped.get_or_insert_with(|| Box::new(DampedKkt::new(&self.mass, self.info.n_rows())));
        let Buffers { jacobian, right_side: solution, second_side: right_side, .. } = &self.buffers;
        damped.share_left(&self.info.jacobian, &self.mass, jacobian, right_side, solution)
    }
}
