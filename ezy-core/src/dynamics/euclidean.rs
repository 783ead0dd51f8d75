//! Corrections that are smallest in plain numbers.

use super::MotionError;
use super::solved::Solved;
use crate::linalg::{INDEPENDENT, Independent, LARGEST_DENSE, NullSpaceKkt};
use crate::model::SceneInfo;

/// `δ = −Gᵀ (G Gᵀ)⁻¹ r`, from K with M = 1: over the position constraints for positions, over all rows for velocities.
pub(super) struct Euclidean {
    ones: Vec<f64>,
    positions: NullSpaceKkt,
    velocities: NullSpaceKkt,
    right_side: Vec<f64>,
}

impl Euclidean {
    /// The one of a system, made when it is first asked for.
    pub(super) fn of<'e>(
        made: &'e mut Option<Box<Self>>,
        info: &SceneInfo,
        units: &[f64],
    ) -> Result<&'e mut Self, MotionError> {
        let (n, limit) = (info.n_unknowns(), LARGEST_DENSE);
        if n > limit {
            return Err(MotionError::EuclideanTooLarge { n, limit });
        }
        Ok(made.get_or_insert_with(|| {
            let solver = |n_rows| NullSpaceKkt::new(units, &info.jacobian, n_rows);
            Box::new(Self {
                ones: vec![1.0; units.len()],
                positions: solver(info.n_position_rows),
                velocities: solver(info.n_rows()),
                right_side: vec![0.0; n],
            })
        }))
    }

    /// For a residual of the position constraints, or of all, without the rows that are `off`; `None` when a number is not finite.
    pub(super) fn correction(
        &mut self,
        jacobian: &[f64],
        residual: &[f64],
        off: &[usize],
        delta: &mut [f64],
    ) -> Option<Solved> {
        let Self { ones, positions, velocities, right_side } = self;
        let n_q = ones.len();
        let of_positions = n_q + residual.len() < right_side.len();
        let x = &mut right_side[..n_q + residual.len()];
        let kkt = if of_positions { positions } else { velocities };
        x[..n_q].fill(0.0);
        x[n_q..].iter_mut().zip(residual).for_each(|(x, r)| *x = -r);
        kkt.factor(ones, jacobian, Independent::Above(INDEPENDENT), off).ok()?;
        let left = kkt.solve(x);
        delta.copy_from_slice(&x[..n_q]);
        let rank = kkt.rank();
        Some(Solved { smallest_pivot: rank.smallest_pivot().powi(2), is_rank_deficient: rank.n_redundant() > 0, left })
    }
}
