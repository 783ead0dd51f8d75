//! Equations of motion in quasi-velocities.

use super::{Eight, Formula, Operations};
use crate::scalar::{Scalar, in_widest};

/// The equations of motion in quasi-velocities u, of which there are as many as degrees of freedom at velocity level: v = R(q) u + v_t obeys all rows, and
/// `Rᵀ M R u̇ = Rᵀ (F − M (Ṙ u + v̇_t))` has no multipliers. Velocities that no row gives, along and across the axes of bodies.
///
/// `model!` derives them where each row gives a velocity by a pivot that depends on parameters alone, and where they take fewer operations than the
/// elimination of the rows. With parameters for which such a pivot vanishes they are no numbers.
///
/// # Source
/// Kane, Levinson, Dynamics (1985), ch. 2 and 6.
pub trait QuasiVelocities<T: Scalar>: Send + Sync {
    /// u at velocities that obey the rows. Writes `n_u`.
    fn quasi_velocities(&self, c: &[T], q: &[T], v: &[T], u: &mut [T]);

    /// v = R(q) u + v_t. Writes `n_q`.
    fn velocities(&self, c: &[T], t: T, q: &[T], u: &[T], v: &mut [T]);

    /// What [`QuasiVelocities::quasi_accelerations`] reads that depends on time, inputs and parameters alone. Writes
    /// [`QuasiVelocitiesInfo::n_of_time`] numbers.
    fn values_of_time(&self, c: &[T], t: T, of_time: &mut [T]);

    /// u̇, and the rates of the coordinates of [`QuasiVelocitiesInfo::feedback`]. Writes `n_u` and as many as these. Of q it reads those and
    /// [`QuasiVelocitiesInfo::integrals`].
    #[expect(clippy::too_many_arguments, reason = "a state, what is known of its time, and two results")]
    fn quasi_accelerations(&self, c: &[T], t: T, q: &[T], u: &[T], of_time: &[T], a: &mut [T], rate: &mut [T]);
}

/// What is known of the equations in quasi-velocities when they are compiled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct QuasiVelocitiesInfo {
    /// Each quasi-velocity.
    pub formulas: &'static [Formula],
    /// The coordinates that u̇, velocities or accelerations depend on and whose rates are no quasi-velocities, ascending.
    pub feedback: &'static [usize],
    /// Those whose rates are, each with the number of its quasi-velocity.
    pub integrals: &'static [(usize, usize)],
    /// How many numbers depend on time, inputs and parameters alone.
    pub n_of_time: usize,
    /// Operations of [`QuasiVelocities::quasi_accelerations`].
    pub operations: Operations,
}

/// [`QuasiVelocities`] as a run takes them: accelerations at eight states at once, in the widest vector registers of the machine.
pub trait EquationsInQuasiVelocities: Send + Sync {
    /// [`QuasiVelocities::quasi_velocities`].
    fn quasi_velocities_of(&self, c: &[f64], q: &[f64], v: &[f64], u: &mut [f64]);

    /// [`QuasiVelocities::velocities`].
    fn velocities_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], u: &[Eight], v: &mut [Eight]);

    /// [`QuasiVelocities::values_of_time`].
    fn values_of_time_in_lanes(&self, c: &[Eight], t: &Eight, of_time: &mut [Eight]);

    /// [`QuasiVelocities::quasi_accelerations`].
    #[expect(clippy::too_many_arguments, reason = "as those")]
    fn quasi_accelerations_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        u: &[Eight],
        of_time: &[Eight],
        a: &mut [Eight],
        rate: &mut [Eight],
    );
}

impl<S: QuasiVelocities<f64> + QuasiVelocities<Eight>> EquationsInQuasiVelocities for S {
    fn quasi_velocities_of(&self, c: &[f64], q: &[f64], v: &[f64], u: &mut [f64]) {
        self.quasi_velocities(c, q, v, u);
    }

    fn velocities_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], u: &[Eight], v: &mut [Eight]) {
        in_widest(
            #[inline(always)]
            || self.velocities(c, *t, q, u, v),
        );
    }

    fn values_of_time_in_lanes(&self, c: &[Eight], t: &Eight, of_time: &mut [Eight]) {
        in_widest(
            #[inline(always)]
            || self.values_of_time(c, *t, of_time),
        );
    }

    fn quasi_accelerations_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        u: &[Eight],
        of_time: &[Eight],
        a: &mut [Eight],
        rate: &mut [Eight],
    ) {
        in_widest(
            #[inline(always)]
            || self.quasi_accelerations(c, *t, q, u, of_time, a, rate),
        );
    }
}
