//! Steps of given lengths, for tests of the methods: nothing chooses their length, nothing is projected.

use crate::dynamics::{MotionError, State, System};
use crate::integrate::{Attempt, Collocated, Dop853, Gauss, Node, Radau, Rk4, Taylor, Tolerance, interpolate};
use crate::model::SceneRef;

/// A method by its steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum StepsBy {
    /// The classical Runge–Kutta method.
    Rk4,
    /// DOP853 without error control.
    Dop853,
    /// Gauss–Legendre collocation; its sweeps go on to rounding.
    Gauss,
    /// Radau IIA; its iteration goes on to rounding.
    Radau,
    /// Taylor's method of this order.
    Taylor(usize),
}

/// Any error will do: the step is given.
const ANY: Tolerance = Tolerance::new(1.0, 1.0);
/// The iteration goes on to rounding.
const CONVERGED: Tolerance = Tolerance::new(1e-10, 1e-10);

/// The same of sweeps, whose changes are compared with the tolerance itself.
const TO_ROUNDING: Tolerance = Tolerance::new(1e-14, 1e-14);

enum Method {
    Rk4(Box<Rk4>),
    Dop853(Box<Dop853>),
    Gauss(Box<Gauss>),
    Radau(Box<Radau>),
    Taylor(Box<Taylor>),
}

/// Steps from one state to the next.
pub struct GivenSteps<P: SceneRef> {
    system: System<P>,
    method: Method,
    /// Where the next step begins.
    state: State,
    /// Where the step that was tried last ends; once it is taken, where it began.
    other: State,
    /// Accelerations and powers at the beginning of that step.
    a: Vec<f64>,
    power: Vec<f64>,
    lambda: Vec<f64>,
    /// Length of the step that was taken last, s; none once the method goes on from it.
    taken_s: Option<f64>,
}

impl<P: SceneRef> GivenSteps<P> {
    /// From `state`, with the works that it holds; none where the scene lacks what the method needs.
    pub fn new(system: System<P>, state: State, by: StepsBy) -> Option<Self> {
        let (scene, info, n_works) = (system.scene(), system.info(), state.work.len());
        let (n_q, n_c) = (info.n_coordinates(), info.n_rows());
        let method = match by {
            StepsBy::Rk4 => Method::Rk4(Box::new(Rk4::new(n_q, n_c, n_works))),
            StepsBy::Dop853 => Method::Dop853(Box::new(Dop853::new(n_q, n_c, n_works))),
            StepsBy::Gauss => Method::Gauss(Box::new(Gauss::new(scene, n_works))),
            StepsBy::Radau => Method::Radau(Box::new(Radau::new(scene, n_works).ok()??)),
            StepsBy::Taylor(order) => Method::Taylor(Box::new(Taylor::new(scene, order, n_works)?)),
        };
        let (a, power, lambda) = (vec![0.0; n_q], vec![0.0; n_works], vec![0.0; n_c]);
        Some(Self { system, method, other: state.clone(), state, a, power, lambda, taken_s: None })
    }

    /// Begins anew at `state`: what rounding cut off and the steps before are forgotten.
    pub fn place(&mut self, state: &State) {
        self.state.copy_from(state);
        self.taken_s = None;
        match &mut self.method {
            Method::Rk4(rk4) => rk4.restart(),
            Method::Dop853(dop853) => dop853.restart(),
            Method::Gauss(gauss) => gauss.restart(),
            Method::Radau(radau) => radau.restart(),
            Method::Taylor(taylor) => taylor.restart(),
        }
    }

    /// Where a step of length `h`, s, leads, which is not taken; none where an iteration does not converge.
    ///
    /// # Errors
    /// [`MotionError`] of a stage.
    pub fn attempt(&mut self, h: f64) -> Result<Option<&State>, MotionError> {
        let Self { system, method, state, other, a, power, lambda, taken_s } = self;
        match (&mut *method, taken_s.take()) {
            (Method::Radau(radau), Some(taken_s)) => radau.accept(taken_s),
            (Method::Gauss(gauss), Some(_)) => gauss.accept(),
            _ => {}
        }
        if let Method::Taylor(taylor) = method {
            taylor.expand(system, state, a, lambda)?;
            taylor.accept();
            taylor.advance(system, state, h, other);
            return Ok(Some(other));
        }
        system.accelerations(state.t, &state.q, &state.v, a, lambda)?;
        if !power.is_empty() {
            system.power(state.t, &state.q, &state.v, lambda, power);
        }
        let from = Node { state, a, power };
        let is_solved = match method {
            Method::Rk4(rk4) => rk4.step(system, from, h, state.t + h, other).map(|()| true)?,
            Method::Dop853(dop853) => dop853.attempt(system, from, h, ANY, other).map(|_| true)?,
            Method::Gauss(gauss) => {
                matches!(gauss.attempt(system, from, h, TO_ROUNDING, other)?, Collocated::Solved { .. })
            }
            Method::Radau(radau) => {
                matches!(radau.attempt(system, from, h, CONVERGED, other)?, Attempt::Solved { .. })
            }
            Method::Taylor(_) => true,
        };
        Ok(is_solved.then_some(&*other))
    }

    /// Takes a step of length `h`, s; none where an iteration does not converge.
    ///
    /// # Errors
    /// As [`GivenSteps::attempt`].
    pub fn step(&mut self, h: f64) -> Result<Option<&State>, MotionError> {
        if self.attempt(h)?.is_none() {
            return Ok(None);
        }
        if let Method::Dop853(dop853) = &mut self.method {
            dop853.accept();
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
        let Self { system, method, state, other: from, a, power, lambda, .. } = self;
        let (mut middle, h) = (from.clone(), state.t - from.t);
        let (mut a_end, mut power_end) = (a.clone(), power.clone());
        system.accelerations(state.t, &state.q, &state.v, &mut a_end, lambda)?;
        if !power.is_empty() {
            system.power(state.t, &state.q, &state.v, lambda, &mut power_end);
        }
        let (begin, end) = (Node { state: from, a, power }, Node { state, a: &a_end, power: &power_end });
        match method {
            Method::Rk4(_) => interpolate(begin, end, from.t + 0.5 * h, &mut middle),
            Method::Dop853(dop853) => {
                dop853.prepare_dense(system, begin, end)?;
                dop853.dense_at(0.5, &mut middle);
            }
            Method::Gauss(gauss) => gauss.dense_at(from, 0.5, &mut middle),
            Method::Radau(radau) => radau.dense_at(from, state, 0.5, &mut middle),
            Method::Taylor(taylor) => taylor.dense_at(system, from, 0.5 * h, &mut middle),
        }
        middle.t = from.t + 0.5 * h;
        Ok(middle)
    }

    /// The longest step of Taylor's method whose last terms are at most the state, s; none of another method.
    ///
    /// # Errors
    /// [`MotionError`] when there are no accelerations.
    pub fn radius(&mut self) -> Result<Option<f64>, MotionError> {
        let Self { system, method: Method::Taylor(taylor), state, a, lambda, .. } = self else { return Ok(None) };
        taylor.expand(system, state, a, lambda)?;
        taylor.accept();
        Ok(Some(taylor.longest_step(ANY)))
    }
}
