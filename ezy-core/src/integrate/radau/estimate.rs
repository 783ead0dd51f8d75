//! The end of a step, and an estimate of its error.

use super::Radau;
use super::matrix::Matrices;
use super::stages::{Stages, add_combination};
use super::tableau::{GAMMA, N_STAGES, NODES, START_SLOPE};
use crate::dynamics::{MotionError, Rows, State, System};
use crate::integrate::{Node, compensated};
use crate::model::Scene;

impl Radau {
    /// Works up to the stages.
    pub(super) fn add_works<S: Scene + ?Sized>(&mut self, system: &System<'_, S>, start: &State, h: f64) {
        for (i, c) in NODES.iter().enumerate() {
            self.stages.write_state(i, start, &mut self.q, &mut self.v);
            system.power(start.t + c * h, &self.q, &self.v, &self.stages.lambda[i], &mut self.powers[i]);
        }
        self.stages.add_works(&self.powers, h);
    }

    /// Writes the end of the step: its last stage.
    pub(super) fn finish(&mut self, start: &State, h: f64, to: &mut State) {
        self.next_rest.copy_from(&self.rest);
        let (stages, rest, end) = (&self.stages, &mut self.next_rest, N_STAGES - 1);
        compensated::add_each(&mut to.q, &start.q, &stages.q[end], &mut rest.q);
        compensated::add_each(&mut to.v, &start.v, &stages.v[end], &mut rest.v);
        compensated::add_each(&mut to.work, &start.work, &stages.work[end], &mut rest.work);
        to.t = start.t + h;
    }

    /// Error of the step over the tolerance.
    ///
    /// A quadrature with the derivative at the start and the stages has order 3. Its difference from the method is filtered by
    /// (1 − h J/γ)⁻¹, so that stiff components of the derivative at the start do not dominate.
    pub(super) fn estimate(&mut self, from: Node<'_>, h: f64) -> f64 {
        let Self { stages, matrices, error, solution, .. } = self;
        error.q.copy_from_slice(&from.state.v);
        error.v.copy_from_slice(from.a);
        filter(stages, matrices, h, error, solution);
        error.work.iter_mut().zip(from.power).for_each(|(error, power)| *error = h * power);
        add_combination(&START_SLOPE, &stages.work, &mut error.work);
        error.work.iter_mut().for_each(|error| *error /= GAMMA);
        norm(&error.q, &error.v, &self.weights)
    }

    /// The same with the derivative evaluated at the start plus the first estimate, which removes what the method damps.
    pub(super) fn look_again<S: Scene + ?Sized>(
        &mut self,
        system: &mut System<'_, S>,
        start: &State,
        h: f64,
    ) -> Result<f64, MotionError> {
        let Self { stages, matrices, error, second_error: second, solution, .. } = self;
        self.q.iter_mut().zip(&start.q).zip(&error.q).for_each(|((q, start), error)| *q = start + error);
        second.q.iter_mut().zip(&start.v).zip(&error.v).for_each(|((v, start), error)| *v = start + error);
        system.accelerations_unchecked(start.t, &self.q, &second.q, &mut second.v, &mut self.lambda, Rows::Held)?;
        filter(stages, matrices, h, second, solution);
        Ok(norm(&second.q, &second.v, &self.weights))
    }
}

/// `(γ/h − J)⁻¹` times the slopes (v, a) in `of`, less those of the polynomial through start and stages.
fn filter(stages: &Stages, matrices: &mut Matrices, h: f64, of: &mut State, solution: &mut [f64]) {
    let weights = START_SLOPE.map(|weight| weight / h);
    add_combination(&weights, &stages.q, &mut of.q);
    add_combination(&weights, &stages.v, &mut of.v);
    matrices.filter(h, &mut of.q, &mut of.v, solution);
}

/// Root mean square of positions and velocities, each times its weight.
pub(super) fn norm(q: &[f64], v: &[f64], weights: &[f64]) -> f64 {
    let squares = q.iter().chain(v).zip(weights).map(|(x, weight)| (x * weight).powi(2));
    (squares.sum::<f64>() / weights.len().max(1) as f64).sqrt()
}
