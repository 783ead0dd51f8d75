//! The equations of a scene at eight states at once.

use super::{Equations, Pivots};
use crate::scalar::{Lanes, in_widest};

/// States that kernels take at once.
pub(crate) const N_LANES: usize = 8;

/// Eight numbers, one a state.
pub(crate) type Eight = Lanes<N_LANES>;

/// Kernels of a scene with a generated elimination, at eight states at once, in the widest vector registers of the machine.
pub trait EquationsInLanes: Send + Sync {
    /// [`Equations::accelerations`] at eight states and times.
    fn accelerations_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        v: &[Eight],
        a: &mut [Eight],
        lambda: &mut [Eight],
    ) -> Pivots;
}

impl<S: Equations<Eight>> EquationsInLanes for S {
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
}
