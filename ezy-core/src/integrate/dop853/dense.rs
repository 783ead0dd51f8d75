//! Values between the ends of a step.

use super::sums::WIDTH;
use super::tableau::{DENSE, N_STAGES, N_STAGES_OF_DENSE_OUTPUT};
use super::{Dop853, read, scale, write};
use crate::dynamics::{Dynamics, MotionError, State};
use crate::integrate::{Node, Tolerance};
use crate::scalar::Scalar;

/// Coefficients of the polynomial of degree 7, without the state at the start.
pub(super) const N_COEFFICIENTS: usize = 7;

/// Of s⁴ (1 − s)⁴, the first polynomial that is missing, between 0 and 1.
const LARGEST_BASIS: f64 = 1.0 / 256.0;

impl<T: Scalar> Dop853<T> {
    /// Prepares values between `from` and `to`, the ends of the step that was tried last; `to` may be projected.
    ///
    /// # Errors
    /// [`MotionError`] of a stage.
    /// # Cost
    /// Three evaluations of the accelerations.
    pub(crate) fn prepare_dense(
        &mut self,
        system: &mut impl Dynamics<T>,
        from: Node<'_, T>,
        to: Node<'_, T>,
    ) -> Result<(), MotionError> {
        let (n, length) = (self.n, to.state.t - from.state.t);
        let h = T::from_f64(length);
        self.begin(from);
        read(self.slopes[N_STAGES * n..][..n].as_flattened_mut(), [to.q_rate, to.a, to.rate, to.power]);
        for stage in N_STAGES + 1..N_STAGES_OF_DENSE_OUTPUT {
            self.evaluate(system, from.state.t, length, stage)?;
        }
        read(self.stage.as_flattened_mut(), [&to.state.q, &to.state.v, &to.state.z, &to.state.work]);
        let (slopes, dense) = (self.slopes.as_flattened(), self.dense.as_flattened_mut());
        let n = WIDTH * n;
        for (i, (start, end)) in self.start.as_flattened().iter().zip(self.stage.as_flattened()).enumerate() {
            let slope = |stage: usize| slopes[stage * n + i];
            let rise = *end - *start;
            let mut set = |k: usize, value: T| dense[k * n + i] = value;
            set(0, rise);
            set(1, h * slope(0) - rise);
            set(2, T::from_f64(2.0) * rise - h * (slope(0) + slope(N_STAGES)));
            for (k, weights) in DENSE.iter().enumerate() {
                let terms = weights.iter().map(|&(stage, weight)| T::from_f64(weight) * slope(stage));
                set(3 + k, h * terms.fold(T::from_f64(0.0), |sum, term| sum + term));
            }
        }
        Ok(())
    }

    /// Largest error of values between the ends of the step, over the tolerance, by the last two terms of the polynomial: the first
    /// that is missing is as much smaller than the last as that is than the one before.
    pub(crate) fn dense_error(&self, tolerance: Tolerance) -> f64 {
        let (n, n_numbers) = (WIDTH * self.n, self.n_controlled());
        let dense = self.dense.as_flattened();
        let ends = self.start.as_flattened().iter().zip(self.stage.as_flattened());
        let (mut last, mut before) = (0.0_f64, 0.0_f64);
        for (i, (start, end)) in ends.take(n_numbers).enumerate() {
            let scale = scale(tolerance, start.abs().max(end.abs()));
            last = last.max((dense[(N_COEFFICIENTS - 1) * n + i] / scale).magnitude());
            before = before.max((dense[(N_COEFFICIENTS - 2) * n + i] / scale).magnitude());
        }
        LARGEST_BASIS * last * (last / before.max(f64::MIN_POSITIVE)).min(1.0)
    }

    /// The state at the part `s` of the step, between 0 and 1, not projected. The time is left alone.
    pub(crate) fn dense_at(&mut self, s: f64, out: &mut State<T>) {
        let (n, dense) = (WIDTH * self.n, self.dense.as_flattened());
        let ends = self.start.as_flattened().iter().zip(self.stage.as_flattened_mut());
        for (i, (start, stage)) in ends.enumerate() {
            let mut value = T::from_f64(0.0);
            for k in (0..N_COEFFICIENTS).rev() {
                value = (value + dense[k * n + i]) * T::from_f64(if k % 2 == 0 { s } else { 1.0 - s });
            }
            *stage = *start + value;
        }
        write(self.stage.as_flattened(), out);
    }
}
