//! The equations of a scene at eight states at once.

use super::{Equations, Pivots, Powers};
use crate::scalar::{Lanes, Scalar, in_widest};

/// States that kernels take at once.
pub const N_LANES: usize = 8;

/// Eight numbers, one a state.
pub(crate) type Eight = Lanes<N_LANES>;

/// Kernels of a scene with a generated elimination, at eight states at once, in the widest vector registers of the machine. Arguments and shapes
/// are those of [`Equations`], with a time for each state.
pub trait EquationsInLanes: Send + Sync {
    /// [`Equations::accelerations`].
    fn accelerations_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        v: &[Eight],
        a: &mut [Eight],
        lambda: &mut [Eight],
    ) -> Pivots;

    /// [`Powers::powers`].
    fn powers_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], lambda: &[Eight], out: &mut [Eight]);

    /// [`Equations::position_constraint`].
    fn position_constraint_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], out: &mut [Eight]);

    /// [`Equations::velocity_constraint`].
    fn velocity_constraint_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], out: &mut [Eight]);

    /// [`Equations::correction`].
    fn correction_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        residual: &[Eight],
        delta: &mut [Eight],
    ) -> Pivots;
}

impl<S: Equations<Eight> + Powers<Eight>> EquationsInLanes for S {
    fn accelerations_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        v: &[Eight],
        a: &mut [Eight],
        lambda: &mut [Eight],
    ) -> Pivots {
        in_widest(
            #[inline(always)]
            || self.accelerations(c, *t, q, v, a, lambda),
        )
    }

    fn powers_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], lambda: &[Eight], out: &mut [Eight]) {
        in_widest(
            #[inline(always)]
            || self.powers(c, *t, q, v, lambda, out),
        );
    }

    fn position_constraint_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], out: &mut [Eight]) {
        in_widest(
            #[inline(always)]
            || self.position_constraint(c, *t, q, out),
        );
    }

    fn velocity_constraint_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], v: &[Eight], out: &mut [Eight]) {
        in_widest(
            #[inline(always)]
            || self.velocity_constraint(c, *t, q, v, out),
        );
    }

    fn correction_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        residual: &[Eight],
        delta: &mut [Eight],
    ) -> Pivots {
        in_widest(
            #[inline(always)]
            || self.correction(c, *t, q, residual, delta),
        )
    }
}

/// A matrix, by columns, times the eight values of a number.
#[inline(always)]
pub(crate) fn times(matrix: &[Eight; N_LANES], values: &Eight) -> Eight {
    let product = |j: usize| matrix[j] * Eight::from_f64(values.0[j]);
    let [mut even, mut odd] = [product(0), product(1)];
    for j in [2, 4, 6] {
        even = matrix[j].fused(Eight::from_f64(values.0[j]), even);
        odd = matrix[j + 1].fused(Eight::from_f64(values.0[j + 1]), odd);
    }
    even + odd
}

/// The largest difference of a number, each with its weight; what is no number counts.
#[inline(always)]
pub(crate) fn largest_change(one: &[Eight], other: &[Eight], weights: &[f64]) -> f64 {
    let mut largest = Lanes([0.0; N_LANES]);
    for ((one, other), weight) in one.iter().zip(other).zip(weights) {
        let change = (*one - *other).abs() * Eight::from_f64(*weight);
        for i in 0..N_LANES {
            largest.0[i] = if change.0[i] <= largest.0[i] { largest.0[i] } else { change.0[i] };
        }
    }
    largest.magnitude()
}
