//! Equations of motion in quasi-velocities.

use super::{Formula, Operations};
use crate::scalar::Scalar;

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

    /// u̇, the rates of the coordinates of [`QuasiVelocitiesInfo::feedback`], and sine and cosine of each angle whose sine or cosine these rates read. Writes `n_u`,
    /// as many as these coordinates, and two for each of [`QuasiVelocitiesInfo::n_angles`]. Of q it reads those coordinates and
    /// [`QuasiVelocitiesInfo::integrals`].
    #[expect(clippy::too_many_arguments, reason = "a state, what is known of its time, and three results")]
    fn quasi_accelerations(
        &self,
        c: &[T],
        t: T,
        q: &[T],
        u: &[T],
        of_time: &[T],
        a: &mut [T],
        rate: &mut [T],
        sines: &mut [T],
    );

    /// These rates, from these sines and cosines.
    #[expect(clippy::too_many_arguments, reason = "a state, and what is known of it and of its time")]
    fn rates(&self, c: &[T], t: T, q: &[T], u: &[T], of_time: &[T], sines: &[T], rate: &mut [T]);

    /// These angles. Writes [`QuasiVelocitiesInfo::n_angles`].
    fn angles(&self, c: &[T], t: T, q: &[T], of_time: &[T], out: &mut [T]);

    /// u̇, and the rates of the coordinates of [`QuasiVelocitiesInfo::integrated`]. Writes `n_u` and as many as these. Of q it reads the first
    /// [`QuasiVelocitiesInfo::n_read`] of them.
    fn motion(&self, c: &[T], t: T, q: &[T], u: &[T], a: &mut [T], rate: &mut [T]);

    /// Coordinates, with those that position constraints give computed from the others, so that they obey them, and v there. Writes `n_q` of both.
    fn whole_state(&self, c: &[T], t: T, q: &[T], u: &[T], out: &mut [T], v: &mut [T]);
}

/// Which numbers sweeps and stages integrate, known where these are compiled.
pub trait QuasiShape {
    /// n_u, how many quasi-velocities there are.
    const N_QUASI: usize;
    /// [`QuasiVelocitiesInfo::feedback`]
    const FEEDBACK: &'static [usize];
    /// [`QuasiVelocitiesInfo::integrals`]
    const INTEGRALS: &'static [(usize, usize)];
    /// [`QuasiVelocitiesInfo::integrated`]
    const INTEGRATED: &'static [usize];
    /// [`QuasiVelocitiesInfo::n_read`]
    const N_READ: usize;
    /// [`QuasiVelocitiesInfo::n_angles`]
    const N_ANGLES: usize;
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
    /// The coordinates that [`QuasiVelocities::motion`] gives the rates of: first those that it reads, then others that no position constraint gives.
    pub integrated: &'static [usize],
    /// How many it reads.
    pub n_read: usize,
    /// Whether a body may go along both of its axes, however it turns: no row such as that of a wheel or a hinge to the ground holds it. Velocities along axes that turn
    /// change then, where those along x and y of a body that nothing pushes stay.
    pub has_free_body: bool,
    /// How many numbers depend on time, inputs and parameters alone.
    pub n_of_time: usize,
    /// How many angles there are whose sine or cosine the rates of `feedback` read.
    pub n_angles: usize,
    /// Operations of [`QuasiVelocities::quasi_accelerations`].
    pub operations: Operations,
}
