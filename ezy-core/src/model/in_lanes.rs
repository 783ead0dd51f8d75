//! The equations of a scene at eight states at once.

use super::{Equations, Pivots, Powers};
use crate::scalar::{Lanes, in_widest};

/// States that kernels take at once.
pub(crate) const N_LANES: usize = 8;

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
