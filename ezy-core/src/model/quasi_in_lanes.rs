//! Equations of motion in quasi-velocities at eight states at once: sweeps of collocation over a step, and stages of eight runs.

use super::in_lanes::{kernels, largest_change, one_by_one, times};
use super::quasi_velocities::{QuasiShape, QuasiVelocities};
use super::{Eight, N_LANES};
use crate::scalar::{Scalar, in_wide_or, in_widest_or};
use std::cell::RefCell;
use std::slice::from_ref;

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
    /// u, then the coordinates of [`feedback`](super::QuasiVelocitiesInfo::feedback).
    pub values: &'a [f64],
    /// All coordinates.
    pub q: &'a [f64],
}

/// Numbers at the times of a step.
pub struct Nodes<'a> {
    /// u and the coordinates of [`feedback`](super::QuasiVelocitiesInfo::feedback), which are written.
    pub values: &'a mut [Eight],
    /// Their slopes: what sweeps begin with, and what they end with.
    pub slopes: &'a mut Vec<Eight>,
    /// As many numbers, which are overwritten.
    pub before: &'a mut Vec<Eight>,
    /// Four numbers for each of [`n_angles`](super::QuasiVelocitiesInfo::n_angles), which are overwritten.
    pub turned: &'a mut [Eight],
    /// All coordinates; those that slopes depend on are written.
    pub q: &'a mut [Eight],
    /// All velocities, which are written.
    pub v: &'a mut [Eight],
}

/// Stages of an explicit Runge–Kutta step.
#[derive(Clone, Copy)]
pub struct Stages<'a> {
    /// What kernels read of inputs and parameters.
    pub c: &'a [Eight],
    /// The start, and the length of the step, s.
    pub t: f64,
    pub h: f64,
    /// Of all stages: their times as parts of the step, and their sums over stages before, as (stage, weight).
    pub nodes: &'a [f64],
    pub weights: &'a [&'a [(usize, f64)]],
    /// The first of those that are computed, and the first that is not.
    pub first: usize,
    pub end: usize,
}

/// Numbers at a stage, which are overwritten.
pub struct AtStage<'a> {
    /// u and the coordinates of [`integrated`](super::QuasiVelocitiesInfo::integrated).
    pub values: &'a mut [Eight],
    /// All coordinates.
    pub q: &'a mut [Eight],
}

/// [`QuasiVelocities`] as a run takes them: accelerations at eight states at once, in vector registers of the machine.
pub trait EquationsInQuasiVelocities: Send + Sync {
    /// The kernels of one state.
    fn of_one(&self) -> &dyn QuasiVelocities<f64>;

    /// [`QuasiVelocities::velocities`].
    fn velocities_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], u: &[Eight], v: &mut [Eight]);

    /// [`QuasiVelocities::values_of_time`].
    fn values_of_time_in_lanes(&self, c: &[Eight], t: &Eight, of_time: &mut [Eight]);

    /// Stages from `of.first` up to `of.end` of an explicit Runge–Kutta step of eight runs from u and [`integrated`](super::QuasiVelocitiesInfo::integrated) in `start`: writes u̇ and the rates of
    /// these at each stage into `slopes`, one stage behind the other, with those of the stages before.
    fn stages_in_lanes(&self, of: Stages<'_>, start: &[Eight], at: AtStage<'_>, slopes: &mut [Eight]);

    /// [`QuasiVelocities::whole_state`].
    fn whole_state_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        u: &[Eight],
        out: &mut [Eight],
        v: &mut [Eight],
    );

    /// Sweeps of Picard's iteration at eight times, as long as `goes_on` says so of the largest change of a slope, each with its weight, and of the slopes.
    ///
    /// Quasi-velocities and coordinates there are what they are at the start and `h` times the integrals of their slopes; coordinates of
    /// [`feedback`](super::QuasiVelocitiesInfo::feedback) once more by their rates there, [`QuasiVelocities::rates`]. Then slopes are computed at these:
    /// [`QuasiVelocities::quasi_accelerations`]. After the last sweep quasi-velocities, coordinates and velocities are those of its slopes.
    fn sweeps_in_lanes(
        &self,
        of: Times<'_>,
        start: Start<'_>,
        weights: &[f64],
        at: Nodes<'_>,
        goes_on: &mut dyn FnMut(f64, &[Eight]) -> bool,
    );
}

impl<S: QuasiVelocities<f64> + QuasiVelocities<Eight> + QuasiShape> EquationsInQuasiVelocities for S {
    fn of_one(&self) -> &dyn QuasiVelocities<f64> {
        self
    }

    fn velocities_in_lanes(&self, c: &[Eight], t: &Eight, q: &[Eight], u: &[Eight], v: &mut [Eight]) {
        kernels::velocities(self, c, t, q, u, v);
    }

    fn values_of_time_in_lanes(&self, c: &[Eight], t: &Eight, of_time: &mut [Eight]) {
        kernels::values_of_time(self, c, t, of_time);
    }

    fn stages_in_lanes(&self, of: Stages<'_>, start: &[Eight], at: AtStage<'_>, slopes: &mut [Eight]) {
        let made = RefCell::new((at, slopes));
        in_widest_or(
            #[inline(always)]
            || {
                let (at, slopes) = &mut *made.borrow_mut();
                stages(
                    of,
                    start,
                    at,
                    slopes,
                    Shape::of::<S>(),
                    #[inline(always)]
                    |t, q, u, a, rate| self.motion(of.c, t, q, u, a, rate),
                );
            },
            || {
                let (at, slopes) = &mut *made.borrow_mut();
                stages_one_by_one(of, start, at, slopes, Shape::of::<S>(), self);
            },
        );
    }

    fn whole_state_in_lanes(
        &self,
        c: &[Eight],
        t: &Eight,
        q: &[Eight],
        u: &[Eight],
        out: &mut [Eight],
        v: &mut [Eight],
    ) {
        kernels::whole_state(self, c, t, q, u, out, v);
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
        in_wide_or(
            #[inline(always)]
            || {
                let (at, goes_on) = &mut *made.borrow_mut();
                let kernels = (
                    #[inline(always)]
                    |q: &[Eight], u: &[Eight], a: &mut [Eight], rate: &mut [Eight], sines: &mut [Eight]| {
                        self.quasi_accelerations(of.c, *of.t, q, u, of.of_time, a, rate, sines);
                    },
                    #[inline(always)]
                    |q: &[Eight], u: &[Eight], sines: &[Eight], rate: &mut [Eight]| {
                        self.rates(of.c, *of.t, q, u, of.of_time, sines, rate);
                    },
                    #[inline(always)]
                    |q: &[Eight], out: &mut [Eight]| self.angles(of.c, *of.t, q, of.of_time, out),
                    #[inline(always)]
                    |q: &[Eight], u: &[Eight], v: &mut [Eight]| self.velocities(of.c, *of.t, q, u, v),
                );
                sweeps(of, start, weights, at, *goes_on, Shape::of::<S>(), kernels);
            },
            || {
                let (at, goes_on) = &mut *made.borrow_mut();
                sweeps_one_by_one(of, start, weights, at, *goes_on, Shape::of::<S>(), self);
            },
        );
    }
}

/// [`QuasiShape`] as values.
#[derive(Clone, Copy)]
struct Shape {
    n_u: usize,
    feedback: &'static [usize],
    integrals: &'static [(usize, usize)],
    integrated: &'static [usize],
    n_read: usize,
    n_angles: usize,
}

impl Shape {
    /// As constants where sweeps are inlined, so that their loops are unrolled.
    #[inline(always)]
    const fn of<S: QuasiShape>() -> Self {
        Self {
            n_u: S::N_QUASI,
            feedback: S::FEEDBACK,
            integrals: S::INTEGRALS,
            integrated: S::INTEGRATED,
            n_read: S::N_READ,
            n_angles: S::N_ANGLES,
        }
    }
}

/// [`EquationsInQuasiVelocities::sweeps_in_lanes`], with the kernels at the times of the step: accelerations, rates, their angles, velocities.
#[inline(always)]
fn sweeps(
    of: Times<'_>,
    start: Start<'_>,
    weights: &[f64],
    at: &mut Nodes<'_>,
    goes_on: &mut dyn FnMut(f64, &[Eight]) -> bool,
    Shape { n_u, feedback, integrals, n_angles, .. }: Shape,
    (accelerate, rates, angles, velocities): (
        impl Fn(&[Eight], &[Eight], &mut [Eight], &mut [Eight], &mut [Eight]),
        impl Fn(&[Eight], &[Eight], &[Eight], &mut [Eight]),
        impl Fn(&[Eight], &mut [Eight]),
        impl Fn(&[Eight], &[Eight], &mut [Eight]),
    ),
) {
    let n = n_u + feedback.len();
    let Nodes { values, slopes, before, turned, q, v } = at;
    let (first, weights, values) = (&start.values[..n], &weights[..n], &mut values[..n]);
    let (sines, of_angles) = turned.split_at_mut(2 * n_angles);
    let (known, present) = of_angles.split_at_mut(n_angles);
    let (mut is_known, mut goes_on_from_here) = (false, true);
    loop {
        for i in 0..n {
            values[i] = of.integral(&slopes[i], first[i]);
        }
        let (u, moved) = values.split_at_mut(n_u);
        for (&i, value) in feedback.iter().zip(&*moved) {
            q[i] = *value;
        }
        for &(i, k) in integrals {
            q[i] = of.integral(&u[k], start.q[i]);
        }
        if !feedback.is_empty() {
            // once more, by rates of the present quasi-velocities
            angles(q, present);
            for k in 0..n_angles {
                let of_known = [sines[2 * k], sines[2 * k + 1]];
                [sines[2 * k], sines[2 * k + 1]] =
                    if is_known { turned_to(present[k], known[k], of_known) } else { present[k].sin_cos().into() };
            }
            let rate = &mut slopes[n_u..n];
            rates(q, u, sines, rate);
            for (k, &i) in feedback.iter().enumerate() {
                moved[k] = of.integral(&rate[k], first[n_u + k]);
                q[i] = moved[k];
            }
        }
        if !goes_on_from_here {
            break;
        }
        std::mem::swap(*before, *slopes);
        let (before, slopes) = (&before[..n], &mut slopes[..n]);
        let (a, rate) = slopes.split_at_mut(n_u);
        angles(q, known);
        accelerate(q, u, a, rate, sines);
        is_known = true;
        goes_on_from_here = goes_on(largest_change(slopes, before, weights), slopes);
    }
    velocities(q, &values[..n_u], v);
}

/// Sine and cosine of an angle by those of a known one, but for a sixth of the cube of their difference. Whoever asks moves closer to the known one.
#[inline(always)]
fn turned_to<T: Scalar>(angle: T, known: T, [sin, cos]: [T; 2]) -> [T; 2] {
    let turn = angle - known;
    let less = turn * turn * T::from_f64(-0.5);
    [sin + (sin * less + cos * turn), cos + (cos * less - sin * turn)]
}

/// The same on a processor without wide registers, by kernels of one state after the other. It is compiled once, not for each scene.
#[cold]
fn sweeps_one_by_one(
    of: Times<'_>,
    start: Start<'_>,
    weights: &[f64],
    at: &mut Nodes<'_>,
    goes_on: &mut dyn FnMut(f64, &[Eight]) -> bool,
    shape: Shape,
    equations: &dyn QuasiVelocities<f64>,
) {
    let kernels = (
        |q: &[Eight], u: &[Eight], a: &mut [Eight], rate: &mut [Eight], sines: &mut [Eight]| {
            let read = [of.c, from_ref(of.t), q, u, of.of_time];
            one_by_one(read, &mut [a, rate, sines], |[c, t, q, u, of_time], [a, rate, sines]| {
                equations.quasi_accelerations(c, t[0], q, u, of_time, a, rate, sines);
            });
        },
        |q: &[Eight], u: &[Eight], sines: &[Eight], rate: &mut [Eight]| {
            let read = [of.c, from_ref(of.t), q, u, of.of_time, sines];
            one_by_one(read, &mut [rate], |[c, t, q, u, of_time, sines], [rate]| {
                equations.rates(c, t[0], q, u, of_time, sines, rate);
            });
        },
        |q: &[Eight], out: &mut [Eight]| {
            one_by_one([of.c, from_ref(of.t), q, of.of_time], &mut [out], |[c, t, q, of_time], [out]| {
                equations.angles(c, t[0], q, of_time, out);
            });
        },
        |q: &[Eight], u: &[Eight], v: &mut [Eight]| {
            one_by_one([of.c, from_ref(of.t), q, u], &mut [v], |[c, t, q, u], [v]| {
                equations.velocities(c, t[0], q, u, v);
            });
        },
    );
    sweeps(of, start, weights, at, goes_on, shape, kernels);
}

/// [`EquationsInQuasiVelocities::stages_in_lanes`], with the kernel for u̇ and rates at a time. Coordinates that these do not depend on are not computed.
#[inline(always)]
fn stages(
    of: Stages<'_>,
    start: &[Eight],
    AtStage { values, q }: &mut AtStage<'_>,
    slopes: &mut [Eight],
    Shape { n_u, integrated, n_read, .. }: Shape,
    motion: impl Fn(Eight, &[Eight], &[Eight], &mut [Eight], &mut [Eight]),
) {
    let (n, n_read) = (n_u + integrated.len(), n_u + n_read);
    let (start, values) = (&start[..n_read], &mut values[..n_read]);
    let h = Eight::from_f64(of.h);
    for stage in of.first..of.end {
        let (before, rest) = slopes.split_at_mut(stage * n);
        let whole = n_read / AT_ONCE * AT_ONCE;
        for i in (0..whole).step_by(AT_ONCE) {
            combine::<AT_ONCE>(i, of.weights[stage], h, before, n, start, values);
        }
        for i in whole..n_read {
            combine::<1>(i, of.weights[stage], h, before, n, start, values);
        }
        let (u, moved) = values.split_at(n_u);
        for (&i, value) in integrated.iter().zip(moved) {
            q[i] = *value;
        }
        let (a, rate) = rest[..n].split_at_mut(n_u);
        motion(Eight::from_f64(of.t + of.nodes[stage] * of.h), q, u, a, rate);
    }
}

/// Numbers that are summed at once: as many as there are registers for.
const AT_ONCE: usize = 4;

/// `values = start + h Σ weight · slope`, of `N` numbers from `first` on; slopes of stages are `n` long.
#[inline(always)]
fn combine<const N: usize>(
    first: usize,
    weights: &[(usize, f64)],
    h: Eight,
    slopes: &[Eight],
    n: usize,
    start: &[Eight],
    values: &mut [Eight],
) {
    let mut sum = [Eight::from_f64(0.0); N];
    for &(stage, weight) in weights {
        let (weight, slopes) = (Eight::from_f64(weight), &slopes[stage * n + first..][..N]);
        for i in 0..N {
            sum[i] = sum[i] + weight * slopes[i];
        }
    }
    for i in 0..N {
        values[first + i] = start[first + i] + h * sum[i];
    }
}

/// The same on a processor without wide registers, as [`sweeps_one_by_one`].
#[cold]
fn stages_one_by_one(
    of: Stages<'_>,
    start: &[Eight],
    at: &mut AtStage<'_>,
    slopes: &mut [Eight],
    shape: Shape,
    equations: &dyn QuasiVelocities<f64>,
) {
    stages(of, start, at, slopes, shape, |t, q, u, a, rate| {
        one_by_one([of.c, from_ref(&t), q, u], &mut [a, rate], |[c, t, q, u], [a, rate]| {
            equations.motion(c, t[0], q, u, a, rate);
        });
    });
}

#[cfg(test)]
mod tests {
    use super::turned_to;

    /// The next terms of the series: −turn³/6 of the cosine and of the sine.
    #[test]
    fn analytic_a_known_angle_gives_sines_but_for_a_cube() {
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        for known in [0.0, 0.3, -2.0, 40.0_f64] {
            for turn in [0.0, 1e-5, 1e-3, -1e-2_f64] {
                let angle = known + turn;
                let [sin, cos] = turned_to(angle, known, known.sin_cos().into());
                let cube = turn.powi(3) / 6.0;
                let tolerance = turn.powi(4) / 24.0 + ROUNDING;
                assert!((angle.sin() - sin + cube * known.cos()).abs() <= tolerance, "{known} {turn}");
                assert!((angle.cos() - cos - cube * known.sin()).abs() <= tolerance, "{known} {turn}");
            }
        }
    }
}
