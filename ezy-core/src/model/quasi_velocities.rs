//! Equations of motion in quasi-velocities.

use super::in_lanes::{largest_change, one_by_one, times};
use super::{Eight, Formula, N_LANES, Operations};
use crate::scalar::{Scalar, in_widest_or};
use std::cell::RefCell;
use std::slice::from_ref;

/// The equations of motion in quasi-velocities u, of which there are as many as degrees of freedom at velocity level: v = R(q) u + v_t obeys all rows, and
/// `Rᵀ M R u̇ = Rᵀ (F − M (Ṙ u + v̇_t))` has no multipliers. Velocities that no row gives, along and across the axes of bodies.
///
/// `model!` derives them where each row gives a velocity by a pivot that depends on parameters alone, and where they take fewer operations than the
/// elimination of the rows. With parameters for which such a pivot vanishes they are no numbers.
///
/// # Source
/// Kane, Levinson, Dynamics (1985), ch. 2 and 6.
pub trait QuasiVelocities<T: Scalar>: Send + Sync {
    /// n_u, how many quasi-velocities there are.
    const N_QUASI: usize;
    /// [`QuasiVelocitiesInfo::feedback`]
    const FEEDBACK: &'static [usize];
    /// [`QuasiVelocitiesInfo::integrals`]
    const INTEGRALS: &'static [(usize, usize)];

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

/// The times of a step at which a sweep looks.
#[derive(Clone, Copy)]
pub struct Times<'a> {
    /// What kernels read of inputs and parameters, and [`QuasiVelocities::values_of_time`].
    pub c: &'a [Eight],
    pub of_time: &'a [Eight],
    /// Times, s, and the length of the step.
    pub t: &'a Eight,
    pub h: f64,
    /// From values at these times to their integrals up to each of them, over the length of the step, by columns.
    pub integrals: &'a [Eight; N_LANES],
}

impl Times<'_> {
    /// A number at these times, from its value at the start and its slopes there.
    #[inline(always)]
    fn integral(&self, slopes: &Eight, start: f64) -> Eight {
        times(self.integrals, slopes).fused(Eight::from_f64(self.h), Eight::from_f64(start))
    }
}

/// The start of a step.
#[derive(Clone, Copy)]
pub struct Start<'a> {
    /// u, then the coordinates of [`QuasiVelocitiesInfo::feedback`].
    pub values: &'a [f64],
    /// All coordinates.
    pub q: &'a [f64],
}

/// Numbers at the times of a step.
pub struct Nodes<'a> {
    /// u and the coordinates of [`QuasiVelocitiesInfo::feedback`], which are written.
    pub values: &'a mut [Eight],
    /// Their slopes: what sweeps begin with, and what they end with.
    pub slopes: &'a mut Vec<Eight>,
    /// As many numbers, which are overwritten.
    pub before: &'a mut Vec<Eight>,
    /// All coordinates; those that slopes depend on are written.
    pub q: &'a mut [Eight],
    /// All velocities, which are written.
    pub v: &'a mut [Eight],
}

/// [`QuasiVelocities`] as a run takes them: accelerations at eight states at once, in the widest vector registers of the machine.
pub trait EquationsInQuasiVelocities: Send + Sync {
    /// [`QuasiVelocities::quasi_velocities`].
    fn quasi_velocities_of(&self, c: &[f64], q: &[f64], v: &[f64], u: &mut [f64]);

    /// [`QuasiVelocities::velocities`].
    fn velocities_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], u: &[Eight], v: &mut [Eight]);

    /// [`QuasiVelocities::values_of_time`].
    fn values_of_time_in_lanes(&self, c: &[Eight], t: &Eight, of_time: &mut [Eight]);

    /// Sweeps of Picard's iteration at eight times, as long as `goes_on` says so of the largest change of a slope, each with its weight, and of the slopes.
    ///
    /// Quasi-velocities and coordinates there are what they are at the start and `h` times the integrals of their slopes, then slopes are computed at
    /// these: [`QuasiVelocities::quasi_accelerations`]. After the last sweep quasi-velocities, coordinates and velocities are those of its slopes.
    fn sweeps_in_lanes(
        &self,
        of: Times<'_>,
        start: Start<'_>,
        weights: &[f64],
        at: Nodes<'_>,
        goes_on: &mut dyn FnMut(f64, &[Eight]) -> bool,
    );
}

impl<S: QuasiVelocities<f64> + QuasiVelocities<Eight>> EquationsInQuasiVelocities for S {
    fn quasi_velocities_of(&self, c: &[f64], q: &[f64], v: &[f64], u: &mut [f64]) {
        self.quasi_velocities(c, q, v, u);
    }

    fn velocities_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], u: &[Eight], v: &mut [Eight]) {
        let v = RefCell::new(v);
        in_widest_or(
            #[inline(always)]
            || self.velocities(c, *t, q, u, *v.borrow_mut()),
            || velocities_one_by_one(&|c, t, q, u, v| self.velocities(c, t, q, u, v), c, t, q, u, *v.borrow_mut()),
        );
    }

    fn values_of_time_in_lanes(&self, c: &[Eight], t: &Eight, of_time: &mut [Eight]) {
        let of_time = RefCell::new(of_time);
        in_widest_or(
            #[inline(always)]
            || self.values_of_time(c, *t, *of_time.borrow_mut()),
            || {
                values_of_time_one_by_one(
                    &|c, t, of_time| self.values_of_time(c, t, of_time),
                    c,
                    t,
                    *of_time.borrow_mut(),
                )
            },
        );
    }

    fn sweeps_in_lanes(
        &self,
        of: Times<'_>,
        start: Start<'_>,
        weights: &[f64],
        at: Nodes<'_>,
        goes_on: &mut dyn FnMut(f64, &[Eight]) -> bool,
    ) {
        let made = RefCell::new((at, goes_on));
        in_widest_or(
            #[inline(always)]
            || {
                let (at, goes_on) = &mut *made.borrow_mut();
                let kernels = (
                    #[inline(always)]
                    |q: &[Eight], u: &[Eight], a: &mut [Eight], rate: &mut [Eight]| {
                        self.quasi_accelerations(of.c, *of.t, q, u, of.of_time, a, rate);
                    },
                    #[inline(always)]
                    |q: &[Eight], u: &[Eight], v: &mut [Eight]| self.velocities(of.c, *of.t, q, u, v),
                );
                sweeps(of, start, weights, at, *goes_on, Shape::of::<S>(), kernels);
            },
            || {
                let (at, goes_on) = &mut *made.borrow_mut();
                sweeps_one_by_one(
                    of,
                    start,
                    weights,
                    at,
                    *goes_on,
                    Shape::of::<S>(),
                    &|c, t, q, u, of_time, a, rate| self.quasi_accelerations(c, t, q, u, of_time, a, rate),
                    &|c, t, q, u, v| self.velocities(c, t, q, u, v),
                );
            },
        );
    }
}

/// Which numbers a sweep integrates: n_u, [`QuasiVelocities::FEEDBACK`] and [`QuasiVelocities::INTEGRALS`].
#[derive(Clone, Copy)]
struct Shape {
    n_u: usize,
    feedback: &'static [usize],
    integrals: &'static [(usize, usize)],
}

impl Shape {
    /// As constants where sweeps are inlined, so that their loops are unrolled.
    #[inline(always)]
    const fn of<S: QuasiVelocities<Eight>>() -> Self {
        Self { n_u: S::N_QUASI, feedback: S::FEEDBACK, integrals: S::INTEGRALS }
    }
}

/// [`EquationsInQuasiVelocities::sweeps_in_lanes`], with the kernels for u̇ and rates, and for velocities, at the times of the step.
#[inline(always)]
fn sweeps(
    of: Times<'_>,
    start: Start<'_>,
    weights: &[f64],
    at: &mut Nodes<'_>,
    goes_on: &mut dyn FnMut(f64, &[Eight]) -> bool,
    Shape { n_u, feedback, integrals }: Shape,
    (accelerate, velocities): (
        impl Fn(&[Eight], &[Eight], &mut [Eight], &mut [Eight]),
        impl Fn(&[Eight], &[Eight], &mut [Eight]),
    ),
) {
    let n = n_u + feedback.len();
    let Nodes { values, slopes, before, q, v } = at;
    let (first, weights, values) = (&start.values[..n], &weights[..n], &mut values[..n]);
    let mut goes_on_from_here = true;
    loop {
        for i in 0..n {
            values[i] = of.integral(&slopes[i], first[i]);
        }
        let (u, of_feedback) = values.split_at(n_u);
        for (&i, value) in feedback.iter().zip(of_feedback) {
            q[i] = *value;
        }
        for &(i, k) in integrals {
            q[i] = of.integral(&u[k], start.q[i]);
        }
        if !goes_on_from_here {
            break;
        }
        std::mem::swap(*before, *slopes);
        let (before, slopes) = (&before[..n], &mut slopes[..n]);
        let (a, rate) = slopes.split_at_mut(n_u);
        accelerate(q, u, a, rate);
        goes_on_from_here = goes_on(largest_change(slopes, before, weights), slopes);
    }
    velocities(q, &values[..n_u], v);
}

// Processors without the widest registers call the kernels of a scene for one state after the other. What calls them is compiled once, not for each scene.

/// [`QuasiVelocities::velocities`].
type Velocities<'s> = &'s dyn Fn(&[f64], f64, &[f64], &[f64], &mut [f64]);
/// [`QuasiVelocities::quasi_accelerations`].
type Accelerations<'s> = &'s dyn Fn(&[f64], f64, &[f64], &[f64], &[f64], &mut [f64], &mut [f64]);
/// [`QuasiVelocities::values_of_time`].
type ValuesOfTime<'s> = &'s dyn Fn(&[f64], f64, &mut [f64]);

#[cold]
fn velocities_one_by_one(of: Velocities<'_>, c: &[Eight], t: &Eight, q: &[Eight], u: &[Eight], v: &mut [Eight]) {
    one_by_one([c, from_ref(t), q, u], &mut [v], |[c, t, q, u], [v]| of(c, t[0], q, u, v));
}

#[cold]
fn values_of_time_one_by_one(of: ValuesOfTime<'_>, c: &[Eight], t: &Eight, of_time: &mut [Eight]) {
    one_by_one([c, from_ref(t)], &mut [of_time], |[c, t], [of_time]| of(c, t[0], of_time));
}

#[cold]
#[expect(clippy::too_many_arguments, reason = "those of `sweeps`")]
fn sweeps_one_by_one(
    of: Times<'_>,
    start: Start<'_>,
    weights: &[f64],
    at: &mut Nodes<'_>,
    goes_on: &mut dyn FnMut(f64, &[Eight]) -> bool,
    shape: Shape,
    accelerations: Accelerations<'_>,
    velocities_of: Velocities<'_>,
) {
    let kernels = (
        |q: &[Eight], u: &[Eight], a: &mut [Eight], rate: &mut [Eight]| {
            let read = [of.c, from_ref(of.t), q, u, of.of_time];
            one_by_one(read, &mut [a, rate], |[c, t, q, u, of_time], [a, rate]| {
                accelerations(c, t[0], q, u, of_time, a, rate);
            });
        },
        |q: &[Eight], u: &[Eight], v: &mut [Eight]| velocities_one_by_one(velocities_of, of.c, of.t, q, u, v),
    );
    sweeps(of, start, weights, at, goes_on, shape, kernels);
}
