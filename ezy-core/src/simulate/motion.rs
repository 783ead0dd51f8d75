//! A scene in motion: where it is, and how it gets one step further. What runs and steppers share.

use super::SetupError;
use super::events::Kinks;
use super::instantaneous::Instantaneous;
use super::integrator::Integrator;
use crate::dynamics::{Metric, MotionError, Projection, State, Strain, System, not_finite};
use crate::integrate::Method;
use crate::model::Scene;

/// A step that ends at a singular position, where accelerations are hardly known, ends earlier instead by this factor.
const SHORTENED: f64 = 0.9;

/// More than one are needed only where rank is lost for good.
const MAX_SHORTENED: usize = 3;

/// The state `now`, and `next` where the step under way ends.
pub(super) struct Motion<'s, S: Scene + ?Sized> {
    pub system: System<'s, S>,
    integrator: Integrator<'s>,
    kinks: Kinks,
    projection: Projection,
    metric: Metric,
    /// Whether works are integrated.
    pub work: bool,
    pub now: Instantaneous,
    pub next: Instantaneous,
}

impl<'s, S: Scene + ?Sized> Motion<'s, S> {
    pub fn new(
        system: System<'s, S>,
        method: Method,
        projection: Projection,
        metric: Metric,
        work: bool,
    ) -> Result<Self, SetupError> {
        let info = system.info();
        let [now, next] = std::array::from_fn(|_| Instantaneous::zero(info, work));
        let projects = projection == Projection::Both && metric == Metric::Mass;
        let integrator = Integrator::new(method, system.scene(), now.power.len(), projects)?;
        let kinks = Kinks::new(info);
        Ok(Self { system, integrator, kinks, projection, metric, work, now, next })
    }

    /// Goes to a state without history; what belongs to it is not evaluated.
    pub fn place(&mut self, state: &State) {
        let now = &mut self.now.state;
        now.t = state.t;
        now.q.copy_from_slice(&state.q);
        now.v.copy_from_slice(&state.v);
        now.work.fill(0.0);
        self.integrator.restart();
        self.kinks.restart();
    }

    /// A step of length `h` from `now`, which is evaluated, to `next`, which is projected but not evaluated. A method
    /// that chooses its steps may stop before `t_next`, and any at a kink.
    pub fn advance(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        let outcome = self.advance_past_singular_positions(h, t_next);
        let State { t, q, .. } = &self.now.state;
        outcome.map_err(|error| self.system.locked_up(*t, q, error))
    }

    fn advance_past_singular_positions(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        self.step(h, t_next)?;
        if self.integrator.chooses_steps() && !self.now.lost_rank {
            for _ in 0..MAX_SHORTENED {
                if !self.system.lost_rank() {
                    break;
                }
                let t = self.now.state.t;
                let shorter = SHORTENED * (self.next.state.t - t);
                self.step(shorter, t + shorter)?;
            }
        }
        Ok(())
    }

    fn step(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        let (system, next) = (&mut self.system, &mut self.next);
        self.integrator.step(system, self.now.knot(), h, t_next, &mut self.kinks, &mut next.state)?;
        check_finite(system, self.now.state.t, &next.state)?;
        let State { t, q, v, .. } = &mut next.state;
        system.project(*t, q, v, self.projection, self.metric)
    }

    /// A state between `now` and `next`, both evaluated; projected and evaluated like them.
    pub fn between(&mut self, t: f64, out: &mut Instantaneous) -> Result<(), MotionError> {
        let system = &mut self.system;
        self.integrator.between(system, self.now.knot(), self.next.knot(), t, &mut out.state)?;
        if self.integrator.chooses_steps() {
            let State { q, v, .. } = &mut out.state;
            system.project(t, q, v, self.projection, self.metric)?;
        }
        out.evaluate(system)
    }

    /// Whether the method chooses the length of its steps.
    pub fn chooses_steps(&self) -> bool {
        self.integrator.chooses_steps()
    }

    /// What moves the scene hardest at `now`, which is evaluated.
    pub fn strain(&mut self) -> Option<Strain> {
        let Instantaneous { state, a, lambda, .. } = &self.now;
        self.system.strain(state.t, &state.q, &state.v, a, lambda)
    }

    /// The state at `t` between `now` and `next`, both evaluated; neither projected nor evaluated.
    pub fn inside(&mut self, t: f64, out: &mut State) -> Result<(), MotionError> {
        self.integrator.between(&mut self.system, self.now.knot(), self.next.knot(), t, out)
    }

    /// Projects a state as the ends of steps are.
    pub fn project(&mut self, state: &mut State) -> Result<(), MotionError> {
        let State { t, q, v, .. } = state;
        self.system.project(*t, q, v, self.projection, self.metric)
    }

    /// Ends the motion at `t` between `now` and `next`: `next` becomes the state there, projected and evaluated.
    pub fn end_at(&mut self, t: f64, state: &mut State) -> Result<(), MotionError> {
        self.inside(t, state)?;
        self.project(state)?;
        std::mem::swap(&mut self.next.state, state);
        self.next.evaluate(&mut self.system)
    }

    /// Goes to where another scene of the same coordinates is, without history, and evaluates there.
    pub fn take_over(&mut self, from: &Self) -> Result<(), MotionError> {
        self.follow(from);
        let State { t, q, v, .. } = &mut self.now.state;
        self.system.project(*t, q, v, self.projection, self.metric)?;
        self.evaluate_now()
    }

    /// Goes to where another scene comes to rest on the rows of this one, as by an impulse; to the last digit, since errors
    /// across the rows would stay while flights become short.
    pub fn land(&mut self, from: &Self) -> Result<(), MotionError> {
        self.follow(from);
        let State { t, q, v, .. } = &mut self.now.state;
        self.system.project_positions(*t, q, Metric::Mass)?;
        self.system.polish_positions(*t, q)?;
        self.system.project_velocities(*t, q, v, Metric::Mass)?;
        self.evaluate_now()
    }

    fn follow(&mut self, from: &Self) {
        self.system.inputs_mut().copy_from_slice(from.system.inputs());
        self.place(&from.now.state);
        self.now.state.work.copy_from_slice(&from.now.state.work);
    }

    /// Goes on from other positions and velocities, without history.
    pub fn rebound(&mut self, q: &[f64], v: Vec<f64>) -> Result<(), MotionError> {
        self.now.state.q.copy_from_slice(q);
        self.now.state.v = v;
        self.integrator.restart();
        self.kinks.restart();
        self.evaluate_now()
    }

    /// Kinetic and potential energy, J.
    pub fn energy(&self) -> f64 {
        let State { t, q, v, .. } = &self.now.state;
        self.system.kinetic_energy(v) + self.system.potential_energy(*t, q)
    }

    /// Makes the step under way again, as one of length `h` without history.
    pub fn advance_again(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        self.integrator.restart_with(h);
        self.evaluate_now()?;
        self.advance(h, t_next)
    }

    pub fn n_rejected(&self) -> u64 {
        self.integrator.n_rejected()
    }

    pub fn stiff_since(&self) -> Option<f64> {
        self.integrator.stiff_since()
    }

    pub fn evaluate_now(&mut self) -> Result<(), MotionError> {
        self.integrator.evaluate(&mut self.system, &mut self.now)?;
        self.integrator.accept();
        Ok(())
    }

    pub fn evaluate_next(&mut self) -> Result<(), MotionError> {
        self.integrator.evaluate(&mut self.system, &mut self.next)
    }

    /// `next` becomes `now`.
    pub fn accept(&mut self) {
        std::mem::swap(&mut self.now, &mut self.next);
        self.integrator.accept();
    }
}

fn check_finite<S: Scene + ?Sized>(system: &System<'_, S>, t: f64, state: &State) -> Result<(), MotionError> {
    let info = system.info();
    let quantity = match not_finite(info, &state.q, &state.v) {
        Some(quantity) => quantity,
        None => match state.work.iter().position(|work| !work.is_finite()) {
            Some(i) => info.effects[i].name,
            // squares overflow from 1e154 m/s on
            None if !system.kinetic_energy(&state.v).is_finite() => "kinetic energy",
            None => return Ok(()),
        },
    };
    Err(MotionError::NotFinite { t, quantity })
}
