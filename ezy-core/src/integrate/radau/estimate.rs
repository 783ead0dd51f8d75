//! The end of a step, and an estimate of its error.

use super::Radau;
use super::control::values_over_estimate;
use super::stages::{Stages, add_combination, combine};
use super::tableau::{
    GAMMA, N_STAGES, NODES, START_SLOPE, UNSEEN, UNSEEN_INTEGRALS, UNSEEN_REMAINDER, UNSEEN_SECOND_INTEGRALS,
    UNSEEN_SLOPES,
};
use crate::dynamics::{State, System};
use crate::integrate::tolerances::radau::STIFF;
use crate::integrate::{Node, Tolerance, compensated};
use crate::model::SceneRef;

impl Radau {
    /// Works up to the stages.
    pub(super) fn add_works<P: SceneRef>(&mut self, system: &mut System<P>, start: &State, h: f64) {
        for (i, c) in NODES.iter().enumerate() {
            self.stages.write_state(i, start, [&mut self.q, &mut self.v, &mut self.z]);
            system.place_states(&self.z);
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
        compensated::add_each(&mut to.z, &start.z, &stages.z[end], &mut rest.z);
        compensated::add_each(&mut to.work, &start.work, &stages.work[end], &mut rest.work);
        to.t = start.t + h;
    }

    /// Error of the step over the tolerance, and the same unfiltered.
    ///
    /// A quadrature with the derivative at the start and the stages has order 3. Its difference from the method is filtered by
    /// (1 − h J/γ)⁻¹, so that stiff components of the derivative at the start do not dominate.
    pub(super) fn estimate(&mut self, from: Node<'_>, h: f64) -> (f64, f64) {
        let Self { stages, matrices, error, solution, .. } = self;
        error.q.copy_from_slice(&from.state.v);
        error.v.copy_from_slice(from.a);
        error.z.copy_from_slice(from.rate);
        subtract_slopes(stages, h, error);
        let unfiltered = norm([&error.q, &error.v, &error.z], &self.weights) * h / GAMMA;
        matrices.filter(h, error, solution);
        error.work.iter_mut().zip(from.power).for_each(|(error, power)| *error = h * power);
        add_combination(&START_SLOPE, &stages.work, &mut error.work);
        error.work.iter_mut().for_each(|error| *error /= GAMMA);
        (norm([&error.q, &error.v, &error.z], &self.weights), unfiltered)
    }

    /// What the filter of the estimate takes away of it, twice, and leaves of that, twice, over the tolerance of values between steps; nothing where the
    /// estimate is below that.
    ///
    /// Of a motion that the step resolves it is of order 6 in the step, as the error is. Of an oscillation that is too fast for it and that the step damps, it
    /// is as large as that up to hω = 3, and the part (3/(hω))² of it beyond: y' = iωy. A spring as stiff as a rod, which turns, is none: its
    /// velocities have an estimate of lower order, which would make steps shorter for nothing.
    pub(super) fn error_of_oscillations(&mut self, h: f64, tolerance: Tolerance, estimate: f64) -> f64 {
        let over = values_over_estimate(tolerance);
        if estimate * over <= 1.0 {
            return 0.0;
        }
        let Self { matrices, error, second_error: second, filtered, solution, weights, .. } = self;
        let mut filter = |of: &mut State| {
            for numbers in [&mut of.q, &mut of.v, &mut of.z] {
                numbers.iter_mut().for_each(|x| *x *= GAMMA / h);
            }
            matrices.filter(h, of, solution);
        };
        second.copy_from(error);
        filter(second);
        filter(second);
        for _ in 0..2 {
            filtered.copy_from(second);
            filter(filtered);
            for (x, left) in [(&mut second.q, &filtered.q), (&mut second.v, &filtered.v), (&mut second.z, &filtered.z)]
            {
                x.iter_mut().zip(left).for_each(|(x, left)| *x -= left);
            }
        }
        norm([&second.q, &second.v, &second.z], weights) * over
    }

    /// The residual of the equations where no stage stands, less what of it the estimate is: of order 5 for a motion that the step resolves,
    /// and half of the estimate for another. Filtered as the estimate is, over the tolerance of values between steps; the estimate where
    /// that is larger, and for a stiff step.
    pub(super) fn second_look<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        start: &State,
        h: f64,
        tolerance: Tolerance,
        estimate: f64,
    ) -> f64 {
        let Self {
            stages, matrices, error, second_error: second, solution, q, v, z, a, lambda, rates, weights, ..
        } = self;
        combine(&UNSEEN_SLOPES, &stages.a, a);
        combine(&UNSEEN_SLOPES, &stages.lambda, lambda);
        combine(&UNSEEN_SLOPES, &stages.rates, rates);
        v.copy_from_slice(&start.v);
        add_combination(&UNSEEN_INTEGRALS.map(|weight| h * weight), &stages.a, v);
        q.iter_mut().zip(&start.q).zip(&start.v).for_each(|((q, start), v)| *q = start + UNSEEN * h * v);
        add_combination(&UNSEEN_SECOND_INTEGRALS.map(|weight| h * h * weight), &stages.a, q);
        z.copy_from_slice(&start.z);
        add_combination(&UNSEEN_INTEGRALS.map(|weight| h * weight), &stages.rates, z);
        system.place_states(z);
        system.at(start.t + UNSEEN * h, q).residual(v, a, lambda, rates, solution);
        let residual = size_of_forces(solution, system.mass_matrix(), weights);
        matrices.solve_real(solution);
        for ((q, v), alpha) in second.q.iter_mut().zip(&mut second.v).zip(&*solution) {
            *v = h / GAMMA * alpha;
            *q = h / GAMMA * *v;
        }
        let of_states = &solution[solution.len() - second.z.len()..];
        second.z.iter_mut().zip(of_states).for_each(|(z, omega)| *z = h / GAMMA * omega);
        let (second_numbers, numbers) = (second.v.iter().chain(&second.z), error.v.iter().chain(&error.z));
        let left = second_numbers.zip(numbers).zip(&weights[second.q.len()..]);
        let left = left.map(|((x, error), weight)| ((x + UNSEEN_REMAINDER * error) * weight).powi(2)).sum::<f64>();
        let larger = (left / weights.len().max(1) as f64).sqrt() * values_over_estimate(tolerance);
        if larger <= estimate {
            return estimate;
        }
        matrices.slope_along(second, solution);
        self.is_stiff = size_of_forces(solution, system.mass_matrix(), weights) > STIFF * residual;
        if self.is_stiff { estimate } else { larger }
    }

    /// The same with the Jacobians at the end of the step: those at its start hide what a force does that was stiff there and levels
    /// off within the step. Infinite when their matrix is singular.
    pub(super) fn estimate_at_end<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        to: &State,
    ) -> f64 {
        let Self { stages, matrices, jacobians, second_error: second, solution, .. } = self;
        let end = N_STAGES - 1;
        system.place_states(&to.z);
        system.at(to.t, &to.q).jacobians(&to.v, &stages.a[end], &stages.lambda[end], jacobians);
        matrices.write(system.mass_matrix(), jacobians);
        self.fresh = false;
        system.counters().factorizations += 1;
        if !matrices.factor_real(h) {
            return f64::INFINITY;
        }
        second.q.copy_from_slice(&from.state.v);
        second.v.copy_from_slice(from.a);
        second.z.copy_from_slice(from.rate);
        subtract_slopes(stages, h, second);
        matrices.filter(h, second, solution);
        norm([&second.q, &second.v, &second.z], &self.weights)
    }
}

/// The slopes (v, a, z') in `of`, less those of the polynomial through start and stages.
fn subtract_slopes(stages: &Stages, h: f64, of: &mut State) {
    let weights = START_SLOPE.map(|weight| weight / h);
    add_combination(&weights, &stages.q, &mut of.q);
    add_combination(&weights, &stages.v, &mut of.v);
    add_combination(&weights, &stages.z, &mut of.z);
}

/// Size of forces, as accelerations in tolerances of a velocity, and of rates in tolerances of their states, 1/s; a coordinate without mass
/// has no acceleration of its own.
fn size_of_forces(forces: &[f64], mass: &[f64], weights: &[f64]) -> f64 {
    let of_v = &weights[mass.len()..];
    let all = forces.iter().zip(mass).zip(of_v).filter(|((_, mass), _)| **mass > 0.0);
    let all = all.map(|((force, mass), weight)| (force / mass * weight).powi(2));
    let of_z = &of_v[mass.len()..];
    let rates = forces[forces.len() - of_z.len()..].iter().zip(of_z).map(|(rate, weight)| (rate * weight).powi(2));
    all.chain(rates).sum::<f64>().sqrt()
}

/// Root mean square of positions, velocities and first-order states, each times its weight.
pub(super) fn norm([q, v, z]: [&[f64]; 3], weights: &[f64]) -> f64 {
    let squares = q.iter().chain(v).chain(z).zip(weights).map(|(x, weight)| (x * weight).powi(2));
    (squares.sum::<f64>() / weights.len().max(1) as f64).sqrt()
}
