//! Steps of given lengths, for tests of the methods: nothing chooses their length, nothing is projected.

use crate::dynamics::{MotionError, State, System};
use crate::integrate::{AlongSeries, Integrator, MethodKind, Node, Tolerance};
use crate::model::SceneRef;

/// A method by its steps. Nothing controls their error, and iterations go on to rounding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum StepsBy {
    /// A method; Taylor's with the lowest order.
    Method(MethodKind),
    /// Taylor's method of this order.
    Taylor(usize),
}

/// Steps from one state to the next.
pub struct GivenSteps<P: SceneRef> {
    system: System<P>,
    integrator: Box<dyn Integrator<System<P>>>,
    /// Where the next step begins.
    state: State,
    /// Where the step that was tried last ends; once it is taken, where it began.
    other: State,
    /// Accelerations and powers at the beginning of that step.
    q_rate: Vec<f64>,
    a: Vec<f64>,
    rate: Vec<f64>,
    power: Vec<f64>,
    lambda: Vec<f64>,
    /// Length of the step that was taken last, s; none once the method goes on from it.
    taken_s: Option<f64>,
}

/// What the longest step of a series is such that its last terms are at most the state.
const OF_THE_STATE: Tolerance = Tolerance::new(1.0, 1.0);

impl<P: SceneRef> GivenSteps<P> {
    /// From `state`, with the works that it holds; none where the scene lacks what the method needs, and where the
    /// state has the first-order states of another scene.
    pub fn new(system: System<P>, state: State, by: StepsBy) -> Option<Self> {
        let (n_v, n_c, n_works) = (system.info().n_velocities(), system.info().n_rows(), state.work.len());
        if state.z.len() != system.info().n_states() {
            return None;
        }
        let integrator = match by {
            StepsBy::Method(kind) => kind.of_system(&system, n_works, OF_THE_STATE, false).ok()??,
            StepsBy::Taylor(order) => Box::new(AlongSeries::of_order(&system, n_works, order, OF_THE_STATE)?),
        };
        let (a, rate, power, lambda) = (vec![0.0; n_v], vec![0.0; state.z.len()], vec![0.0; n_works], vec![0.0; n_c]);
        Some(Self {
            system,
            integrator,
            other: state.clone(),
            q_rate: state.q.clone(),
            state,
            a,
            rate,
            power,
            lambda,
            taken_s: None,
        })
    }

    /// Begins anew at `state`: what rounding cut off and the steps before are forgotten.
    pub fn place(&mut self, state: &State) {
        self.state.copy_from(state);
        self.taken_s = None;
        self.integrator.restart();
    }

    /// Where a step of length `h`, s, leads, which is not taken; none where an iteration does not converge.
    ///
    /// # Errors
    /// [`MotionError`] of a stage.
    pub fn attempt(&mut self, h: f64) -> Result<Option<&State>, MotionError> {
        if let Some(taken_s) = self.taken_s.take() {
            self.integrator.accept_given(taken_s);
        }
        self.evaluate()?;
        let Self { system, integrator, state, other, q_rate, a, rate, power, .. } = self;
        let is_solved = integrator.given_step(system, Node { state, q_rate, a, rate, power }, h, other)?;
        Ok(is_solved.then_some(&*other))
    }

    /// Accelerations and powers at the state, and what the method needs for a step from there.
    fn evaluate(&mut self) -> Result<(), MotionError> {
        let Self { system, integrator, state, q_rate, a, rate, power, lambda, .. } = self;
        system.place_states(&state.z);
        match integrator.expand(system, state, a, lambda) {
            Some(solved) => solved?,
            None => system.accelerations(state.t, &state.q, &state.v, a, lambda)?,
        };
        system.position_rates(&state.q, &state.v, q_rate);
        system.state_rates(state.t, &state.q, &state.v, rate);
        if !power.is_empty() {
            system.power(state.t, &state.q, &state.v, lambda, power);
        }
        Ok(())
    }

    /// Takes a step of length `h`, s; none where an iteration does not converge.
    ///
    /// # Errors
    /// As [`GivenSteps::attempt`].
    pub fn step(&mut self, h: f64) -> Result<Option<&State>, MotionError> {
        if self.attempt(h)?.is_none() {
            return Ok(None);
        }
        self.taken_s = Some(h);
        std::mem::swap(&mut self.state, &mut self.other);
        Ok(Some(&self.state))
    }

    /// The state in the middle of the step that was taken last, by the interpolation of the method.
    ///
    /// # Errors
    /// [`MotionError`] of a stage.
    pub fn middle(&mut self) -> Result<State, MotionError> {
        let Self { system, integrator, state, other: from, q_rate, a, rate, power, lambda, .. } = self;
        let mut middle = from.clone();
        let (mut a_end, mut rate_end, mut power_end) = (a.clone(), rate.clone(), power.clone());
        let mut q_rate_end = q_rate.clone();
        system.place_states(&state.z);
        system.accelerations(state.t, &state.q, &state.v, &mut a_end, lambda)?;
        system.position_rates(&state.q, &state.v, &mut q_rate_end);
        system.state_rates(state.t, &state.q, &state.v, &mut rate_end);
        if !power.is_empty() {
            system.power(state.t, &state.q, &state.v, lambda, &mut power_end);
        }
        let (begin, end) = (
            Node { state: from, q_rate, a, rate, power },
            Node { state, q_rate: &q_rate_end, a: &a_end, rate: &rate_end, power: &power_end },
        );
        let half = from.t + 0.5 * (state.t - from.t);
        integrator.between(system, begin, end, half, &mut middle)?;
        Ok(middle)
    }

    /// The longest step of Taylor's method whose last terms are at most the state, s; none of another method.
    ///
    /// # Errors
    /// [`MotionError`] when there are no accelerations.
    pub fn radius(&mut self) -> Result<Option<f64>, MotionError> {
        self.evaluate()?;
        self.integrator.accept();
        Ok(self.integrator.longest_step())
    }
}
