//! The method of Dormand and Prince of order 8, with error estimates of orders 5 and 3 and dense output of order 7.

mod adaptive;
mod dense;
mod family;
mod in_quasi_velocities;
mod single_run;
mod stiffness;
mod sums;
mod tableau;
#[cfg(test)]
mod tests;
mod whole_error;

use super::family::Sizes;
use super::step_control::Tolerance;
use super::{Node, compensated};
use crate::archive::Archive;
use crate::dynamics::{Dynamics, MotionError, State};
use crate::integrate::tolerances::dop853::ROUNDING;
use crate::model::coordinate::is_angle;
use crate::scalar::{Scalar, in_wide};
use sums::{Block, Sum, WIDTH, stages};
use tableau::{COUNTS, N_STAGES, N_STAGES_OF_DENSE_OUTPUT, NODES};

pub(crate) use adaptive::Adaptive;
pub(crate) use in_quasi_velocities::InQuasiVelocities;
pub(crate) use stiffness::StiffnessWatch;

/// Order of the error estimate's power of the step.
pub(crate) const ERROR_ORDER: i32 = 8;

/// Stages of the method for q' = N(q) v, v' = a(t, q, v, z), z' = rates of first-order states, w' = power of each effect, as one vector
/// y = (q, v, z, w).
///
/// Works are integrated beside the motion and do not choose its steps. What rounding cuts off a sum is added to the next
/// one, as in [`Rk4`](super::Rk4).
///
/// # Source
/// Prince, Dormand, J. Comp. Appl. Math. 7 (1981); Hairer, Nørsett, Wanner, Solving Ordinary Differential Equations I (1993),
/// II.5, II.6 and II.10.
#[derive(Debug)]
pub(crate) struct Dop853<T = f64> {
    n_q: usize,
    n_v: usize,
    n_z: usize,
    n_works: usize,
    /// Length of y in blocks.
    n: usize,
    /// Slopes of all stages, each `n` long.
    slopes: Vec<Block<T>>,
    start: Vec<Block<T>>,
    stage: Vec<Block<T>>,
    /// What rounding cut off the last accepted step, and what it would cut off the present one.
    rest: Vec<Block<T>>,
    next_rest: Vec<Block<T>>,
    /// Errors of orders 5 and 3.
    errors: [Vec<Block<T>>; 3],
    lambda: Vec<T>,
    /// Coefficients of the dense output, each `n` long.
    dense: Vec<Block<T>>,
}

impl<T: Scalar> Dop853<T> {
    const STAGES: [Sum<T>; N_STAGES_OF_DENSE_OUTPUT - 1] = stages();

    /// Storage for a scene with these sizes.
    pub(crate) fn new(Sizes { n_q, n_v, n_c, n_z, n_works }: Sizes) -> Self {
        let n = (n_q + n_v + n_z + n_works).div_ceil(WIDTH);
        let zero = |n: usize| vec![[T::from_f64(0.0); WIDTH]; n];
        Self {
            n_q,
            n_v,
            n_z,
            n_works,
            n,
            slopes: zero(N_STAGES_OF_DENSE_OUTPUT * n),
            start: zero(n),
            stage: zero(n),
            rest: zero(n),
            next_rest: zero(n),
            errors: [zero(n), zero(n), zero(n)],
            lambda: vec![T::from_f64(0.0); n_c],
            dense: zero(dense::N_COEFFICIENTS * n),
        }
    }

    /// Storage for other steps of the same scene.
    pub(crate) fn another(&self) -> Self {
        Self::new(Sizes { n_q: self.n_q, n_v: self.n_v, n_c: self.lambda.len(), n_z: self.n_z, n_works: self.n_works })
    }

    /// Forgets the rounding errors of the sums, before another run.
    pub(crate) fn restart(&mut self) {
        self.rest.fill([T::from_f64(0.0); WIDTH]);
    }

    /// Writes what is known of the last step, or reads it.
    pub(crate) fn remember(&mut self, archive: &mut Archive<T>) {
        for blocks in [&mut self.rest, &mut self.start, &mut self.slopes, &mut self.dense] {
            archive.scalars(blocks.as_flattened_mut());
        }
    }

    /// Attempts one step of length `h` from `from`; writes `to`, not yet projected, and returns the error over the tolerance.
    /// The step is accepted when that is at most 1.
    ///
    /// # Errors
    /// [`MotionError`] of a stage; `to` is then unspecified.
    /// # Cost
    /// Eleven evaluations of the accelerations; no allocation.
    pub(crate) fn attempt(
        &mut self,
        system: &mut impl Dynamics<T>,
        from: Node<'_, T>,
        h: f64,
        tolerance: Tolerance,
        to: &mut State<T>,
    ) -> Result<f64, MotionError> {
        self.take(system, from, h, to)?;
        Ok(self.weighted_error(h, tolerance))
    }

    /// The same without the error.
    fn take(
        &mut self,
        system: &mut impl Dynamics<T>,
        from: Node<'_, T>,
        h: f64,
        to: &mut State<T>,
    ) -> Result<(), MotionError> {
        self.begin(from);
        for stage in 1..N_STAGES {
            self.evaluate(system, from.state.t, h, stage)?;
        }
        sums::at_end(&self.slopes, &mut self.stage, &mut self.errors);
        let length = T::from_f64(h);
        self.next_rest.copy_from_slice(&self.rest);
        let starts = self.start.as_flattened().iter().zip(self.next_rest.as_flattened_mut());
        let ends = starts.zip(self.stage.as_flattened_mut());
        in_wide(
            #[inline(always)]
            || ends.for_each(|((start, rest), stage)| *stage = compensated::add(*start, length * *stage, rest)),
        );
        write(self.stage.as_flattened(), to);
        to.t = from.state.t + h;
        Ok(())
    }

    /// What was integrated at the start and at the end of the step that was tried last, its errors of orders 5 and 3 over its length, and its sixth difference.
    fn tried(&self) -> (&[T], &[T], [&[T]; 3]) {
        let errors = self.errors.each_ref().map(|errors| errors.as_flattened());
        (self.start.as_flattened(), self.stage.as_flattened(), errors)
    }

    /// Keeps what rounding cut off the step that was tried last.
    pub(crate) fn accept(&mut self) {
        std::mem::swap(&mut self.rest, &mut self.next_rest);
    }

    /// Length of the first step, from the derivative and its change, for order 8 and this tolerance.
    ///
    /// # Errors
    /// As [`Dop853::attempt`].
    pub(crate) fn first_step(
        &mut self,
        system: &mut impl Dynamics<T>,
        from: Node<'_, T>,
        longest: f64,
        tolerance: Tolerance,
    ) -> Result<f64, MotionError> {
        self.begin(from);
        let n = self.n_controlled();
        let n_q = self.n_q;
        let norm = |x: &[T], start: &[T]| {
            let scaled = x.iter().zip(start).enumerate();
            let scaled = scaled.map(|(i, (&x, &y))| x / scale_of(tolerance, i, n_q, y.abs()));
            let squares = scaled.fold(T::from_f64(0.0), |sum, x| sum + x * x);
            (squares / T::from_f64(n.max(1) as f64)).sqrt().magnitude()
        };
        let (start, rates) = (self.start.as_flattened(), self.slopes[..self.n].as_flattened());
        let (size, rate) = (norm(&start[..n], start), norm(&rates[..n], start));
        first_length(longest, size, rate, |guess| {
            self.evaluate_euler(system, from.state.t, guess)?;
            let (first, second) = self.slopes.split_at(self.n);
            let slopes = second.as_flattened()[..n].iter().zip(first.as_flattened());
            let change: Vec<T> = slopes.map(|(&b, &a)| b - a).collect();
            Ok(norm(&change, self.start.as_flattened()))
        })
    }

    /// Numbers of y whose errors choose the steps: all but works.
    fn n_controlled(&self) -> usize {
        self.n_q + self.n_v + self.n_z
    }

    fn begin(&mut self, from: Node<'_, T>) {
        let Node { state, q_rate, a, rate, power } = from;
        read(self.start.as_flattened_mut(), [&state.q, &state.v, &state.z, &state.work]);
        read(self.slopes[..self.n].as_flattened_mut(), [q_rate, a, rate, power]);
    }

    /// The slope of a stage.
    fn evaluate(&mut self, system: &mut impl Dynamics<T>, t: f64, h: f64, stage: usize) -> Result<(), MotionError> {
        Self::STAGES[stage - 1](&self.slopes, &self.start, h, &mut self.stage);
        self.slope_at_stage(system, t + NODES[stage] * h, stage)
    }

    fn evaluate_euler(&mut self, system: &mut impl Dynamics<T>, t: f64, h: f64) -> Result<(), MotionError> {
        sums::advance([(0, 1.0)], &self.slopes, &self.start, h, &mut self.stage);
        self.slope_at_stage(system, t + h, 1)
    }

    fn slope_at_stage(&mut self, system: &mut impl Dynamics<T>, t: f64, stage: usize) -> Result<(), MotionError> {
        let (q, rest) = self.stage.as_flattened().split_at(self.n_q);
        let (v, rest) = rest.split_at(self.n_v);
        let slope = self.slopes[stage * self.n..][..self.n].as_flattened_mut();
        let (of_q, of_rest) = slope.split_at_mut(self.n_q);
        let (of_v, of_rest) = of_rest.split_at_mut(self.n_v);
        let (of_z, of_rest) = of_rest.split_at_mut(self.n_z);
        // no sum of works has others
        let n_works = if COUNTS[stage] { self.n_works } else { 0 };
        let of_work = &mut of_rest[..n_works];
        system.slopes(t, [q, v, &rest[..self.n_z]], &mut self.lambda, [of_q, of_v, of_z, of_work])
    }

    /// Error over tolerance of the last attempt, without the part that the projection at its end `to` removes.
    ///
    /// Next to rank loss, stages off the constraints see noise in the forces, proportional to their distance over σ². It drives
    /// the motion in directions that the constraints forbid.
    ///
    /// # Source
    /// Eich, SIAM J. Numer. Anal. 30 (1993).
    pub(crate) fn tangential_error(
        &mut self,
        system: &mut impl Dynamics<T>,
        h: f64,
        tolerance: Tolerance,
        to: &State<T>,
    ) -> Option<f64> {
        // errors of positions are displacements where these have the axes of the velocities
        if self.n_q != self.n_v {
            return None;
        }
        // first-order states are in no row
        for errors in &mut self.errors {
            let (positions, rest) = errors.as_flattened_mut().split_at_mut(self.n_q);
            for part in [positions, &mut rest[..self.n_q]] {
                if !system.project_onto_null_space(to.t, &to.q, part) {
                    return None;
                }
            }
        }
        Some(self.weighted_error(h, tolerance))
    }

    /// Error over tolerance of the last attempt by the embedded solution of order 5 alone, where the motion is not smooth enough for what both
    /// of them tell.
    pub(crate) fn error_of_order_5(&self, h: f64, tolerance: Tolerance) -> f64 {
        let n = self.n_controlled();
        let ends = self.start.as_flattened()[..n].iter().zip(self.stage.as_flattened());
        let errors = ends.zip(self.errors[0].as_flattened()).enumerate();
        let squares = errors.map(|(i, ((start, end), error))| {
            let error = *error / scale_of(tolerance, i, self.n_q, start.abs().max(end.abs()));
            error * error
        });
        let sum = squares.fold(T::from_f64(0.0), |sum, square| sum + square);
        h.abs() * (sum / T::from_f64(n as f64)).sqrt().magnitude()
    }

    /// Error over tolerance, from both embedded solutions and a divided difference; the largest one for several lanes.
    fn weighted_error(&self, h: f64, tolerance: Tolerance) -> f64 {
        // apart, since a test of each number would keep the loop from running in lanes
        match tolerance.angle {
            None => in_wide(
                #[inline(always)]
                || self.error_by(h, tolerance, |_, size| scale(tolerance, size)),
            ),
            Some(_) => self.error_by(h, tolerance, |i, size| scale_of(tolerance, i, self.n_q, size)),
        }
    }

    #[inline(always)]
    fn error_by(&self, h: f64, tolerance: Tolerance, scale: impl Fn(usize, T) -> T) -> f64 {
        let [fives, threes, sixes] = &self.errors;
        let n = self.n_controlled();
        let zero = T::from_f64(0.0);
        let (mut five, mut three, mut six) = (zero, zero, zero);
        let ends = self.start.as_flattened()[..n].iter().zip(self.stage.as_flattened());
        let errors = fives.as_flattened().iter().zip(threes.as_flattened()).zip(sixes.as_flattened());
        for (i, ((start, end), ((of_5, of_3), of_6))) in ends.zip(errors).enumerate() {
            let scale = scale(i, start.abs().max(end.abs()));
            let (of_5, of_3, of_6) = (*of_5 / scale, *of_3 / scale, *of_6 / scale);
            five = five + of_5 * of_5;
            three = three + of_3 * of_3;
            six = six + of_6 * of_6;
        }
        // one may vanish by chance
        let five = if tolerance.relative >= ROUNDING { five.max(six) } else { five };
        // where both estimates are zero, so is the error
        let norm = ((five + T::from_f64(0.01) * three) * T::from_f64(n as f64)).max(T::from_f64(f64::MIN_POSITIVE));
        (T::from_f64(h.abs()) * five / norm.sqrt()).magnitude()
    }
}

/// Length of the first step from the size of the numbers and of their slopes over the tolerance, and from what slopes change by along a first guess of it.
///
/// # Errors
/// Those of `change`.
fn first_length<E>(longest: f64, size: f64, rate: f64, change: impl FnOnce(f64) -> Result<f64, E>) -> Result<f64, E> {
    let guess = if size < 1e-10 || rate < 1e-10 { 1e-6 } else { 0.01 * size / rate };
    let guess = guess.min(longest);
    let steepest = rate.max(change(guess)? / guess);
    let step =
        if steepest <= 1e-15 { (1e-3 * guess).max(1e-6) } else { (0.01 / steepest).powf(1.0 / f64::from(ERROR_ORDER)) };
    Ok(step.min(100.0 * guess).min(longest))
}

/// Tolerance for a number of this size.
#[inline(always)]
fn scale<T: Scalar>(tolerance: Tolerance, size: T) -> T {
    T::from_f64(tolerance.absolute) + T::from_f64(tolerance.relative) * size
}

/// Tolerance for number `i` of (q, v), of this size.
#[inline]
fn scale_of<T: Scalar>(tolerance: Tolerance, i: usize, n_q: usize, size: T) -> T {
    match tolerance.angle {
        Some(angle) if i < n_q && is_angle(i) => T::from_f64(angle),
        _ => scale(tolerance, size),
    }
}

/// y = (q, v, z, w, zeros) from its parts.
fn read<T: Copy>(y: &mut [T], parts: [&[T]; 4]) {
    let mut rest = y;
    for part in parts {
        let (this, others) = rest.split_at_mut(part.len());
        this.copy_from_slice(part);
        rest = others;
    }
}

fn write<T: Copy>(y: &[T], to: &mut State<T>) {
    let (q, rest) = y.split_at(to.q.len());
    let (v, rest) = rest.split_at(to.v.len());
    to.q.copy_from_slice(q);
    to.v.copy_from_slice(v);
    let (z, rest) = rest.split_at(to.z.len());
    to.z.copy_from_slice(z);
    let n_works = to.work.len();
    to.work.copy_from_slice(&rest[..n_works]);
}
