//! A scene with the state of its integration: one step, projected. Shared by runs and steppers.

use super::SetupError;
use super::crossing::Crossing;
use super::events::Kinks;
use super::instantaneous::Instantaneous;
use super::integrator::Integrator;
use super::singular::Approach;
use super::usual;
use crate::dynamics::{Metric, MotionError, Projection, State, Strain, System, not_finite};
use crate::integrate::{Method, Tolerance};
use crate::model::Scene;

/// A step that ends at a singular position is shortened by this factor, since accelerations are inaccurate there.
const SHORTENED: f64 = 0.9;

/// A step ends next to a singular position when the smallest pivot falls below this part of its value at the start.
const TOO_NEAR: f64 = 0.03;

/// More than one is needed only where constraints are redundant for good.
const MAX_SHORTENED: usize = 3;

/// The state `now`, and the end `next` of the step under way.
pub(super) struct Motion<'s, S: Scene + ?Sized> {
    pub system: System<'s, S>,
    integrator: Integrator<'s>,
    kinks: Kinks,
    projection: Projection,
    metric: Metric,
    /// Whether singular positions are crossed by special steps: only when steps are projected.
    crosses: bool,
    /// Tolerance of a method that chooses its steps.
    tolerance: Option<Tolerance>,
    /// Made when it is first needed.
    crossing: Option<Box<Crossing>>,
    /// Usual step length, s; zero before the first step.
    usual_s: f64,
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
        Ok(Self {
            system,
            integrator,
            kinks,
            projection,
            metric,
            crosses: projects && info.n_position_rows > 0,
            tolerance: method.tolerance(),
            crossing: None,
            usual_s: 0.0,
            work,
            now,
            next,
        })
    }

    /// Moves to a state without history, which is not evaluated.
    pub fn place(&mut self, state: &State) {
        let now = &mut self.now.state;
        now.t = state.t;
        now.q.copy_from_slice(&state.q);
        now.v.copy_from_slice(&state.v);
        now.work.fill(0.0);
        self.restart();
    }

    /// Forgets the steps taken so far.
    fn restart(&mut self) {
        self.integrator.restart();
        self.kinks.restart();
        self.forget_crossing();
    }

    fn forget_crossing(&mut self) {
        self.usual_s = 0.0;
        if let Some(crossing) = &mut self.crossing {
            crossing.restart();
        }
    }

    /// A step of length `h` from `now`, which is evaluated, to `next`, which is projected but not evaluated. A method
    /// that chooses its steps may stop before `t_next`, and every method stops at a kink.
    pub fn advance(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        let outcome = match self.advance_on_leap(t_next) {
            Ok(true) => Ok(()),
            Ok(false) => self.advance_past_singular_positions(h, t_next),
            Err(error) => Err(error),
        };
        if outcome.is_ok() {
            let length = self.next.state.t - self.now.state.t;
            self.usual_s = usual::follow(self.usual_s, length, length);
        }
        let State { t, q, .. } = &self.now.state;
        outcome.map_err(|error| self.system.locked_up(*t, q, error))
    }

    /// A step across a singular position, or a part of such a step; false where there is none.
    fn advance_on_leap(&mut self, t_next: f64) -> Result<bool, MotionError> {
        let chooses_steps = self.integrator.chooses_steps();
        let Self { system, crossing, now, next, .. } = self;
        if let Some(crossing) = crossing
            && now.state.t >= crossing.end.state.t
        {
            crossing.is_under_way = false;
        }
        if !crossing.as_ref().is_some_and(|crossing| crossing.is_under_way) {
            // a step over several ticks of the clock has the inputs of the first one only
            let holds_inputs = chooses_steps || system.inputs().is_empty();
            let approach = Approach { now, before: next };
            let is_heading = crossing.as_ref().is_some_and(|crossing| crossing.is_heading());
            if !self.crosses || !holds_inputs || !is_heading && approach.distance(self.usual_s).is_none() {
                return Ok(false);
            }
            let crossing = crossing.get_or_insert_with(|| Box::new(Crossing::new(system, self.tolerance, self.work)));
            if !crossing.step(system, &approach, self.usual_s) {
                return Ok(false);
            }
        }
        let Some(crossing) = crossing else { return Ok(false) };
        let end = &crossing.end;
        if t_next < end.state.t {
            crossing.between(t_next, &mut next.state);
            self.project_next()?;
        } else if chooses_steps || t_next == end.state.t {
            next.state.copy_from(&end.state);
            self.integrator.restart();
            self.project_next()?;
        } else {
            crossing.is_under_way = false;
            self.integrator.restart();
            let h = t_next - end.state.t;
            self.integrator.step(system, end.knot(), h, t_next, &mut self.kinks, &mut next.state)?;
            self.project_next()?;
        }
        check_finite(&self.system, self.now.state.t, &self.next.state)?;
        Ok(true)
    }

    fn advance_past_singular_positions(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        self.step(h, t_next)?;
        if self.integrator.chooses_steps() && !self.now.lost_rank {
            for _ in 0..MAX_SHORTENED {
                let too_near = self.crosses && self.next.pivot < TOO_NEAR * self.now.pivot;
                if !self.system.lost_rank() && !too_near {
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
        self.project_next()
    }

    fn project_next(&mut self) -> Result<(), MotionError> {
        let State { t, q, v, .. } = &mut self.next.state;
        self.system.project(*t, q, v, self.projection, self.metric)?;
        self.next.pivot = self.system.smallest_pivot();
        Ok(())
    }

    /// A state between `now` and `next`, both evaluated; projected and evaluated like them.
    pub fn between(&mut self, t: f64, out: &mut Instantaneous) -> Result<(), MotionError> {
        self.inside(t, &mut out.state)?;
        let system = &mut self.system;
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

    /// The largest acceleration at `now`, which is evaluated, and its cause.
    pub fn strain(&mut self) -> Option<Strain> {
        let Instantaneous { state, a, lambda, .. } = &self.now;
        self.system.strain(state.t, &state.q, &state.v, a, lambda)
    }

    /// The state at `t` between `now` and `next`, both evaluated; neither projected nor evaluated.
    pub fn inside(&mut self, t: f64, out: &mut State) -> Result<(), MotionError> {
        if let Some(crossing) = &mut self.crossing
            && crossing.is_under_way
        {
            crossing.between(t, out);
            return Ok(());
        }
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

    /// Takes over the state of another scene with the same coordinates, without history, and evaluates it.
    pub fn take_over(&mut self, from: &Self) -> Result<(), MotionError> {
        self.follow(from);
        let State { t, q, v, .. } = &mut self.now.state;
        self.system.project(*t, q, v, self.projection, self.metric)?;
        self.evaluate_now()
    }

    /// Takes over the state of another scene after a plastic impact on the constraints of this one. Positions are projected to the
    /// last digit: errors normal to the constraints would remain while flights become short.
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

    /// Continues from other positions and velocities, without history.
    pub fn rebound(&mut self, q: &[f64], v: Vec<f64>) -> Result<(), MotionError> {
        self.now.state.q.copy_from_slice(q);
        self.now.state.v = v;
        self.restart();
        self.evaluate_now()
    }

    /// Kinetic and potential energy, J.
    pub fn energy(&self) -> f64 {
        let State { t, q, v, .. } = &self.now.state;
        self.system.kinetic_energy(v) + self.system.potential_energy(*t, q)
    }

    /// Repeats the step under way with the length `h`, without history.
    pub fn advance_again(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        self.integrator.restart_with(h);
        self.forget_crossing();
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
