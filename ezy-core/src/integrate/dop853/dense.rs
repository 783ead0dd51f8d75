//! Values between the ends of a step.

use super::sums::WIDTH;
use super::tableau::{DENSE, N_STAGES, N_STAGES_OF_DENSE_OUTPUT};
use super::{Dop853, read, write};
use crate::dynamics::{MotionError, State, System};
use crate::integrate::Knot;
use crate::model::Scene;

/// Coefficients of the polynomial of degree 7, without the state at the start.
pub const N_COEFFICIENTS: usize = 7;

impl Dop853 {
    /// Prepares values between `from` and `to`, the ends of the step that was tried last; `to` may be projected.
    ///
    /// # Errors
    /// [`MotionError`] of a stage.
    /// # Cost
    /// Three evaluations of the accelerations.
    pub fn prepare_dense<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        from: Knot<'_>,
        to: Knot<'_>,
    ) -> Result<(), MotionError> {
        let (n, h) = (self.n, to.state.t - from.state.t);
        self.begin(from);
        read(self.slopes[N_STAGES * n..][..n].as_flattened_mut(), [&to.state.v, to.a, to.power]);
        for stage in N_STAGES + 1..N_STAGES_OF_DENSE_OUTPUT {
            self.evaluate(system, from.state.t, h, stage)?;
        }
        read(self.stage.as_flattened_mut(), [&to.state.q, &to.state.v, &to.state.work]);
        let (slopes, dense) = (self.slopes.as_flattened(), self.dense.as_flattened_mut());
        let n = WIDTH * n;
        for (i, (start, end)) in self.start.as_flattened().iter().zip(self.stage.as_flattened()).enumerate() {
            let slope = |stage: usize| slopes[stage * n + i];
            let rise = end - start;
            let mut set = |k: usize, value: f64| dense[k * n + i] = value;
            set(0, rise);
            set(1, h * slope(0) - rise);
            set(2, 2.0 * rise - h * (slope(0) + slope(N_STAGES)));
            for (k, weights) in DENSE.iter().enumerate() {
                set(3 + k, h * weights.iter().map(|&(stage, weight)| weight * slope(stage)).sum::<f64>());
            }
        }
        Ok(())
    }

    /// The state at the part `s` of the step, between 0 and 1, not projected. The time is left alone.
    pub fn dense_at(&mut self, s: f64, out: &mut State) {
        let (n, dense) = (WIDTH * self.n, self.dense.as_flattened());
        let ends = self.start.as_flattened().iter().zip(self.stage.as_flattened_mut());
        for (i, (start, stage)) in ends.enumerate() {
            let mut value = 0.0;
            for k in (0..N_COEFFICIENTS).rev() {
                value = (value + dense[k * n + i]) * if k % 2 == 0 { s } else { 1.0 - s };
            }
            *stage = start + value;
        }
        write(self.stage.as_flattened(), out);
    }
}
