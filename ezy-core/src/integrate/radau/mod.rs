//! Radau IIA with three stages: implicit, of order 5, for stiff scenes.

mod control;
mod convergence;
mod coupled;
mod dense;
mod entries;
mod estimate;
mod factors;
mod implicit;
mod matrix;
mod newton;
mod stages;
mod tableau;
#[cfg(test)]
mod tests;

use super::family::Sizes;
use super::{Node, Tolerance};
use crate::archive::Archive;
use crate::dynamics::{Jacobians, MotionError, ResidualPlaces, Rows, State, System};
use crate::integrate::tolerances::radau::{FAST, FIRST, LEAST_FIRST_S, N_COUPLED, SAME_STEP, SHORTEN};
use crate::linalg::SparseKktError;
use crate::model::{Scene, SceneRef};
use convergence::{Convergence, Verdict};
use coupled::Coupled;
use matrix::Matrices;
use newton::Newton;
use stages::Stages;
use tableau::{N_STAGES, NODES, Triple};

use control::{RadauControl, tolerance_of_estimate};
pub(crate) use implicit::Implicit;

/// Stages of the method for q' = v, v' = a, z' = rates of first-order states, w' = power of each effect, where a and the multipliers λ
/// solve the equations of motion.
///
/// The unknowns are a, λ and z' at the stages. Positions, velocities and states follow by quadrature, so that no stage needs a
/// factorisation of its own, and bodies may be massless. The method is L-stable: modes that decay fast, or oscillate faster
/// than the steps resolve, are damped out in one step. Works are integrated by the quadrature of the method and do not choose
/// its steps. What rounding cuts off a sum is added to the next one, as in [`Rk4`](super::Rk4).
///
/// # Source
/// Hairer, Wanner, Solving Ordinary Differential Equations II (1996), IV.5 and IV.8.
pub(crate) struct Radau {
    n_works: usize,
    stages: Stages,
    /// Of the last accepted step.
    before: Stages,
    /// Length of that step, s; none at the beginning.
    before_s: Option<f64>,
    matrices: Matrices,
    jacobians: Jacobians,
    /// Whether the Jacobians are those at the start of the step under way.
    fresh: bool,
    newton: Newton,
    /// None in scenes with too many equations for it.
    coupled: Option<Coupled>,
    /// Steps that it is still used for.
    n_coupled: u32,
    /// What one pass of the iteration leaves of the error, in the last step.
    rate: f64,
    /// Error after the last pass of that iteration, over its change.
    share: f64,
    /// Reciprocals of what is tolerated, q then v then z.
    weights: Vec<f64>,
    /// Whether the step is stiff, so that nothing tells how good its polynomial is.
    is_stiff: bool,
    /// Estimate of the error of q, v, z and works, a second look at it, and what a filter leaves of that.
    error: State,
    second_error: State,
    filtered: State,
    solution: Vec<f64>,
    /// Rounding of the equations of motion, `n_q`, then of the rates of first-order states, `n_z`.
    rounding: Vec<f64>,
    /// A state with its accelerations, multipliers and rates, for the time of a call.
    q: Vec<f64>,
    v: Vec<f64>,
    z: Vec<f64>,
    a: Vec<f64>,
    lambda: Vec<f64>,
    rates: Vec<f64>,
    powers: Triple<Vec<f64>>,
    /// What rounding cut off the last accepted step, and what it would cut off the present one.
    rest: State,
    next_rest: State,
}

/// Outcome of an attempted step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Attempt {
    /// The iteration converged.
    Solved {
        /// Error over the tolerance: the step is good when that is at most 1.
        error: f64,
        /// Passes of the iteration.
        n_passes: u32,
    },
    /// It did not converge; a step with this factor may.
    Diverged {
        /// Below 1.
        factor: f64,
    },
}

impl Radau {
    /// Storage for steps of a scene with `n_works` works; none for one that does not know its Jacobians.
    ///
    /// # Errors
    /// [`SparseKktError`] when there is no memory for the analysis of a large scene.
    pub(crate) fn new<S: Scene + ?Sized>(scene: &S, n_works: usize) -> Result<Option<Self>, SparseKktError> {
        let info = scene.info();
        let Some(places) = ResidualPlaces::of(scene) else { return Ok(None) };
        let sizes = Sizes::new(&info, n_works);
        let Sizes { n_q, n_c, n_z, n_works, .. } = sizes;
        let (stages, state) = (Stages::zero(sizes), State::zeros([n_q; 2], n_z, n_works));
        Ok(Some(Self {
            n_works,
            before: stages.clone(),
            stages,
            before_s: None,
            matrices: Matrices::new(&info, &places)?,
            jacobians: Jacobians::zero(&info, &places),
            fresh: false,
            newton: Newton::new(n_q + n_c + n_z),
            coupled: Coupled::new(&info, &places),
            n_coupled: 0,
            rate: 1.0,
            share: 1.0,
            weights: vec![0.0; 2 * n_q + n_z],
            is_stiff: false,
            error: state.clone(),
            second_error: state.clone(),
            filtered: state.clone(),
            solution: vec![0.0; n_q + n_c + n_z],
            rounding: vec![0.0; n_q + n_z],
            q: vec![0.0; n_q],
            v: vec![0.0; n_q],
            z: vec![0.0; n_z],
            a: vec![0.0; n_q],
            lambda: vec![0.0; n_c],
            rates: vec![0.0; n_z],
            powers: std::array::from_fn(|_| vec![0.0; n_works]),
            rest: state.clone(),
            next_rest: state,
        }))
    }

    /// Storage for other steps of the same scene; none without memory for the analysis of a large one.
    pub(crate) fn another<S: Scene + ?Sized>(&self, scene: &S) -> Option<Self> {
        Self::new(scene, self.n_works).ok().flatten()
    }

    /// Writes what the next step takes from those before, or reads it.
    fn remember<P: SceneRef>(&mut self, system: &System<P>, archive: &mut Archive) {
        self.before.remember(archive);
        archive.option(&mut self.before_s);
        let Jacobians { by_q, by_v, by_z, jacobian } = &mut self.jacobians;
        [by_q, by_v, by_z, jacobian].into_iter().for_each(|entries| archive.numbers(entries));
        if archive.is_read() {
            self.matrices.write(system.mass_matrix(), &self.jacobians);
        }
        self.matrices.remember(archive);
        archive.flag(&mut self.fresh);
        archive.count_of_few(&mut self.n_coupled);
        archive.number(&mut self.rate);
        archive.number(&mut self.share);
        self.rest.remember(archive);
    }

    /// Forgets the stages and Jacobians of the steps before, which belong to another law.
    pub(crate) fn turn(&mut self) {
        self.before_s = None;
        self.fresh = false;
        self.rate = 1.0;
        self.share = 1.0;
        self.n_coupled = 0;
    }

    /// Forgets the steps before, at the beginning of another run or after a jump.
    pub(crate) fn restart(&mut self) {
        self.turn();
        for rest in [&mut self.rest.q, &mut self.rest.v, &mut self.rest.z, &mut self.rest.work] {
            rest.fill(0.0);
        }
    }

    /// Attempts a step of length `h` from `from`; writes `to`, not yet projected, when the iteration converges.
    ///
    /// # Errors
    /// [`MotionError`] when accelerations at the start cannot be found.
    /// # Cost
    /// Three residuals and two solves a pass; up to six solves and a residual for the estimate; two factorisations when the length of the step changes;
    /// Jacobians and one factorisation more where stiffness hides the estimate, and new ones for the next step; no allocation. Where the
    /// iteration does not converge, in scenes with at most 80 equations, a factorisation of all stages together
    /// a pass.
    pub(crate) fn attempt<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        tolerance: Tolerance,
        to: &mut State,
    ) -> Result<Attempt, MotionError> {
        self.weigh(from.state, tolerance);
        self.predict(system, from, h)?;
        if !self.prepare_matrices(system, from.state, h) {
            return Ok(Attempt::Diverged { factor: SHORTEN });
        }
        let (stages, end) = (&self.stages, N_STAGES - 1);
        let unknowns = [&stages.a[end][..], &stages.lambda[end], &stages.rates[end]];
        self.matrices.rounding_along(from.state, unknowns, &mut self.rounding);
        let n_passes = match self.solve(system, from, h, tolerance)? {
            Ok(n_passes) => n_passes,
            Err(factor) => return Ok(Attempt::Diverged { factor }),
        };
        if self.n_works > 0 {
            self.add_works(system, from.state, h);
        }
        self.finish(from.state, h, to);
        self.is_stiff = false;
        let (mut error, unfiltered) = self.estimate(from, h);
        if error <= 1.0 {
            let of_oscillations = self.error_of_oscillations(h, tolerance, error);
            error = self.second_look(system, from.state, h, tolerance, error).max(of_oscillations);
        }
        if error < 1.0 && unfiltered > 1.0 {
            error = error.max(self.estimate_at_end(system, from, h, to));
        }
        Ok(Attempt::Solved { error, n_passes })
    }

    /// Solves for the stages by the simplified iteration or, if that did not converge lately, by the coupled one. Returns the
    /// number of passes, or the factor for a step that may converge.
    fn solve<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        from: Node<'_>,
        h: f64,
        tolerance: Tolerance,
    ) -> Result<Result<u32, f64>, MotionError> {
        // what rounding leaves, over the tolerance, is largest where that is smallest
        let tolerance = Tolerance { relative: tolerance.smallest_relative(&from.state.q), ..tolerance };
        if self.n_coupled == 0 {
            let outcome = self.iterate(system, from.state, h, Convergence::new(tolerance, self.share), None);
            if outcome.is_ok() || self.coupled.is_none() {
                return Ok(outcome);
            }
            self.n_coupled = N_COUPLED;
            self.predict(system, from, h)?;
        }
        self.n_coupled -= 1;
        let mut coupled = self.coupled.take();
        let outcome = self.iterate(system, from.state, h, Convergence::new(tolerance, 1.0), coupled.as_mut());
        self.coupled = coupled;
        (self.rate, self.share) = (1.0, 1.0);
        Ok(outcome)
    }

    /// Iterates until the stages have converged; when `coupled`, each stage has its own slopes.
    fn iterate<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        start: &State,
        h: f64,
        mut convergence: Convergence,
        mut coupled: Option<&mut Coupled>,
    ) -> Result<u32, f64> {
        loop {
            for (i, c) in NODES.iter().enumerate() {
                let Self { stages, q, v, z, newton, .. } = self;
                stages.write_state(i, start, [q, v, z]);
                system.place_states(z);
                let (t, a, lambda) = (start.t + c * h, &stages.a[i], &stages.lambda[i]);
                let mut at = system.at(t, q);
                at.residual(v, a, lambda, &stages.rates[i], &mut newton.residual[i]);
                if let Some(coupled) = &mut coupled {
                    at.jacobians(v, a, lambda, &mut coupled.jacobians);
                    coupled.write(i, h, system.mass_matrix());
                }
            }
            let change = match &mut coupled {
                None => self.newton.improve(&mut self.matrices, &mut self.stages, h, &self.weights),
                Some(coupled) => {
                    system.counters().factorizations += 1;
                    coupled.improve(&self.newton.residual, &mut self.stages, h, &self.weights)
                }
            };
            let unsolved = self.unsolved(system.mass_matrix(), h);
            match convergence.judge(change, unsolved) {
                Verdict::GoOn => {}
                Verdict::Converged => break,
                Verdict::Diverged { factor } => {
                    (self.rate, self.share) = (1.0, 1.0);
                    return Err(factor);
                }
            }
        }
        (self.rate, self.share) = (convergence.rate(), convergence.share());
        Ok(convergence.n_passes())
    }

    /// Largest change of a velocity or a first-order state, over its tolerance, that the residuals make in a step of length `h`, less
    /// their rounding. A coordinate without mass has no velocity of its own.
    fn unsolved(&self, mass: &[f64], h: f64) -> f64 {
        let Self { newton, rounding, weights, .. } = self;
        let of_v = &weights[mass.len()..];
        let mut largest: f64 = 0.0;
        for residual in &newton.residual {
            for (((residual, rounding), mass), weight) in residual.iter().zip(rounding).zip(mass).zip(of_v) {
                if *mass > 0.0 {
                    largest = largest.max((residual.abs() - rounding) * h / mass * weight);
                }
            }
            let (n_q, n_z) = (mass.len(), rounding.len() - mass.len());
            let of_states = residual[residual.len() - n_z..].iter().zip(&rounding[n_q..]).zip(&of_v[n_q..]);
            for ((residual, rounding), weight) in of_states {
                largest = largest.max((residual.abs() - rounding) * h * weight);
            }
        }
        largest
    }

    /// Accepts the last attempt: the next step starts at its end.
    pub(crate) fn accept(&mut self, h: f64) {
        std::mem::swap(&mut self.stages, &mut self.before);
        std::mem::swap(&mut self.rest, &mut self.next_rest);
        self.before_s = Some(h);
        self.fresh = false;
    }

    /// Whether the last step is stiff.
    pub(crate) fn is_stiff(&self) -> bool {
        self.is_stiff
    }

    /// Whether another step of the same length would keep the factors.
    pub(crate) fn keeps_factors(&self) -> bool {
        self.rate <= FAST
    }

    /// A first step: a hundredth of the time in which the state would change by its own size.
    pub(crate) fn first_step(&mut self, from: Node<'_>, longest: f64, tolerance: Tolerance) -> f64 {
        self.weigh(from.state, tolerance);
        let State { q, v, z, .. } = from.state;
        let ratio = estimate::norm([q, v, z], &self.weights) / estimate::norm([v, from.a, from.rate], &self.weights);
        let step_s = if ratio.is_finite() { (FIRST * ratio).max(LEAST_FIRST_S) } else { LEAST_FIRST_S };
        step_s.min(longest)
    }

    fn weigh(&mut self, start: &State, tolerance: Tolerance) {
        let numbers = start.q.iter().chain(&start.v).chain(&start.z).enumerate();
        for (weight, (i, x)) in self.weights.iter_mut().zip(numbers) {
            *weight = 1.0 / tolerance.of(i, start.q.len(), x.abs());
        }
    }

    /// First guess of the stages.
    fn predict<P: SceneRef>(&mut self, system: &mut System<P>, from: Node<'_>, h: f64) -> Result<(), MotionError> {
        let State { t, q, v, z, .. } = from.state;
        system.place_states(z);
        match self.before_s {
            Some(before_s) => {
                self.stages.extrapolate(&self.before, h / before_s);
                if system.active().leaves_out_redundant() {
                    // nothing fixes their part in the null space of Gᵀ, which extrapolation would make grow from step to step
                    system.at_with(*t, q, Rows::Projected).accelerations(v, &mut self.a, &mut self.lambda)?;
                    self.stages.hold_multipliers(&self.lambda);
                }
            }
            None => {
                system.at_with(*t, q, Rows::Projected).accelerations(v, &mut self.a, &mut self.lambda)?;
                self.stages.hold(&self.a, &self.lambda, from.rate);
            }
        }
        self.stages.follow(&from.state.v, h);
        Ok(())
    }

    /// Factors for this step, unless those of the last one serve; false when a matrix is singular.
    fn prepare_matrices<P: SceneRef>(&mut self, system: &mut System<P>, start: &State, h: f64) -> bool {
        let serves = |factored_s: f64| (factored_s - h).abs() <= SAME_STEP * h;
        if self.rate <= FAST && self.matrices.step_s().is_some_and(serves) {
            return true;
        }
        if !self.fresh {
            // at the end of the last step, before its projection
            let (a, lambda) = match self.before_s {
                Some(_) => (&self.before.a[N_STAGES - 1], &self.before.lambda[N_STAGES - 1]),
                None => (&self.stages.a[N_STAGES - 1], &self.stages.lambda[N_STAGES - 1]),
            };
            system.place_states(&start.z);
            system.at(start.t, &start.q).jacobians(&start.v, a, lambda, &mut self.jacobians);
            self.matrices.write(system.mass_matrix(), &self.jacobians);
            self.fresh = true;
        }
        system.counters().factorizations += 1;
        self.matrices.factor(h)
    }
}
