//! A scene with the state of its integration: one step, projected. Shared by runs and steppers.

use super::singular::Approach;
use super::singular_positions::SingularPositions;
use super::snapshot::Snapshot;
use super::state_projection::StateProjection;
use super::step_method::StepMethod;
use crate::archive::Archive;
use crate::dynamics::{
    Metric, MotionError, Projection, Solved, State, Strain, System, moves_finitely, state_not_finite,
};
use crate::integrate::{Method, QUARTERED};
use crate::model::SceneRef;
use crate::simulate::SetupError;
use crate::simulate::tolerances::singular::{MAX_SHORTENED, SHORTENED};
use std::sync::Arc;

/// The state `now`, and the end `next` of the step under way.
pub(in crate::simulate) struct StepperState<P: SceneRef> {
    pub system: System<P>,
    method: StepMethod<P>,
    pub projection: StateProjection,
    pub singular_positions: SingularPositions,
    /// Whether works are integrated.
    pub work: bool,
    // boxed, since they change places after each step
    pub now: Box<Snapshot>,
    pub next: Box<Snapshot>,
    /// Whether `next` was evaluated when the step was taken.
    is_next_evaluated: bool,
}

impl<P: SceneRef> StepperState<P> {
    pub(in crate::simulate) fn new(
        system: System<P>,
        method: Method,
        projection: Projection,
        metric: Metric,
        work: bool,
    ) -> Result<Self, SetupError> {
        let info = Arc::clone(system.info());
        let [now, next] = std::array::from_fn(|_| Snapshot::zero(&info, work));
        let projection = StateProjection::new(projection, metric);
        let crosses = projection.is_complete() && info.n_position_rows > 0;
        let singular_positions = SingularPositions::new(crosses, method);
        let method = StepMethod::new(&system, method, now.power.len(), projection.is_complete())?;
        Ok(Self {
            system,
            method,
            projection,
            singular_positions,
            work,
            now: Box::new(now),
            next: Box::new(next),
            is_next_evaluated: false,
        })
    }

    /// Moves to a state without history, which is not evaluated.
    pub(in crate::simulate) fn place(&mut self, state: &State) {
        let now = &mut self.now.state;
        now.t = state.t;
        now.q.copy_from_slice(&state.q);
        now.v.copy_from_slice(&state.v);
        now.z.copy_from_slice(&state.z);
        now.work.fill(0.0);
        self.restart();
    }

    /// Writes where the motion is, once a step is accepted, and all that its continuation depends on, or reads it.
    pub(in crate::simulate) fn remember(&mut self, archive: &mut Archive) -> Result<(), MotionError> {
        self.now.remember(archive);
        self.next.remember(archive);
        self.system.remember(archive);
        self.method.remember_discontinuities(archive);
        self.singular_positions.remember(&self.system, self.method.tolerance(), self.work, archive);
        self.method.integrator.remember(&mut self.system, archive);
        if archive.is_read() && self.method.expands() {
            self.evaluate_now()?;
        }
        Ok(())
    }

    /// What is asked of the system next is asked at `now`: samples between steps have other first-order states.
    pub(in crate::simulate) fn place_now(&mut self) {
        self.system.place_states(&self.now.state.z);
    }

    /// Forgets the steps taken so far.
    pub(in crate::simulate) fn restart(&mut self) {
        self.method.restart();
        self.singular_positions.restart();
    }

    /// A step of length `h` from `now`, which is evaluated, to `next`, which is projected but not evaluated. A method
    /// that chooses its steps may stop before `t_next`, and every method stops at a discontinuity.
    pub(in crate::simulate) fn advance(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        self.is_next_evaluated = false;
        let Snapshot { state: State { t, q, .. }, solved, .. } = &*self.now;
        self.system.at(*t, q).hold_rows(solved.is_rank_deficient);
        let outcome = match self.advance_across_singularity(t_next) {
            Ok(true) => Ok(()),
            Ok(false) => self.advance_past_singular_positions(h, t_next),
            Err(error) => Err(error),
        };
        if outcome.is_ok() {
            self.singular_positions.see_step(self.next.state.t - self.now.state.t);
        }
        let Snapshot { state: State { t, q, v, .. }, a, lambda, .. } = &*self.now;
        outcome.map_err(|error| {
            let error = self.system.diagnosis().locked_up(*t, q, error);
            self.system.diagnosis().without_derivative((*t, q, v), (a, lambda), error)
        })?;
        let Some(tolerance) = self.method.tolerance() else { return Ok(()) };
        tolerance.check_angles(self.system.info(), self.next.state.t, &self.next.state.q)
    }

    /// A step across a singular position, or a part of such a step; false where there is none.
    fn advance_across_singularity(&mut self, t_next: f64) -> Result<bool, MotionError> {
        let Self { system, method, singular_positions, now, next, work, .. } = self;
        let approach = Approach { now, before: next };
        let tolerance = method.tolerance();
        let Some(crossing) = singular_positions.crossing_step(system, &approach, tolerance, *work) else {
            return Ok(false);
        };
        let end = &crossing.end;
        if t_next < end.state.t {
            crossing.between(t_next, &mut next.state);
        } else if method.chooses_steps() || t_next == end.state.t {
            next.state.copy_from(&end.state);
            method.integrator.restart();
        } else {
            crossing.is_under_way = false;
            method.integrator.restart();
            let h = t_next - end.state.t;
            method.step(system, end.node(), h, t_next, &mut next.state)?;
        }
        self.project_next()?;
        check_finite(&self.system, self.now.state.t, &self.next.state)?;
        Ok(true)
    }

    /// A step that ends next to a singular position, or cannot be projected, or only by large changes, is taken again shorter where the
    /// method chooses steps.
    #[inline]
    fn advance_past_singular_positions(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        if !self.chooses_steps() {
            return self.step(h, t_next);
        }
        let mut outcome = self.step(h, t_next);
        for _ in 0..MAX_SHORTENED {
            let State { t, .. } = self.now.state;
            let made = self.next.state.t - t;
            let shorter = match &outcome {
                Ok(()) if self.singular_positions.may_be_within(&self.method, &self.now) => QUARTERED * made,
                Ok(()) if self.singular_positions.is_near_end(&mut self.system, &self.now, &self.next) => {
                    SHORTENED * made
                }
                Ok(()) => match self.method.integrator.shorter_for_constraints(&self.next.state.v) {
                    Some(shorter) => shorter,
                    None => break,
                },
                Err(
                    MotionError::ProjectionStalled { .. }
                    | MotionError::ContradictoryRows { .. }
                    | MotionError::SingularPosition { .. },
                ) => QUARTERED * made,
                Err(_) => break,
            };
            outcome = self.step(shorter, t + shorter);
            self.singular_positions.n_shortened += 1;
        }
        outcome?;
        let (now, next) = (&self.now.state, &self.next.state);
        if self.singular_positions.creeps(&mut self.system, now, next, t_next) {
            return Err(MotionError::StepCollapsed { t: now.t, step_s: next.t - now.t });
        }
        Ok(())
    }

    #[inline]
    fn step(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        let (system, now, next) = (&mut self.system, &self.now, &mut self.next);
        self.method.step(system, now.node(), h, t_next, &mut next.state)?;
        check_finite(system, self.now.state.t, &next.state)?;
        self.project_next()?;
        if self.method.judges_by_end() { self.judge_by_end(h, t_next) } else { Ok(()) }
    }

    /// Takes the step again shorter, as long as the method refuses it for the accelerations at its end.
    fn judge_by_end(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        loop {
            // an error here comes again when the end is evaluated
            self.is_next_evaluated = self.method.evaluate(&mut self.system, &mut self.next).is_ok();
            let (system, now, next) = (&mut self.system, &self.now, &mut self.next);
            if !self.is_next_evaluated || !self.method.integrator.refuses(now.node(), next.node()) {
                return Ok(());
            }
            self.method.step(system, now.node(), h, t_next, &mut next.state)?;
            check_finite(system, now.state.t, &next.state)?;
            self.project_next()?;
        }
    }

    #[inline]
    fn project_next(&mut self) -> Result<(), MotionError> {
        let Self { system, projection, next, .. } = self;
        let state = &mut next.state;
        if self.method.integrator.keeps_rows() {
            projection.see_kept(system, state);
            next.end = Solved::regular(f64::INFINITY);
            return Ok(());
        }
        system.place_states(&state.z);
        // some methods find their own accelerations, and inputs may change before the next step
        let is_final = !self.method.expands() && system.inputs().is_empty();
        match is_final {
            true => projection.project_end(system, state)?,
            false => projection.project(system, state)?,
        }
        self.next.end = self.projection.projected.solved.unwrap_or_default();
        Ok(())
    }

    /// A state between `now` and `next`, both evaluated; projected and evaluated like them.
    pub(in crate::simulate) fn between(&mut self, t: f64, out: &mut Snapshot) -> Result<(), MotionError> {
        if self.chooses_steps() {
            self.find(t, &mut out.state)?;
        } else {
            self.inside(t, &mut out.state)?;
        }
        out.evaluate(&mut self.system)
    }

    /// Whether the method chooses the length of its steps.
    pub(in crate::simulate) fn chooses_steps(&self) -> bool {
        self.method.chooses_steps()
    }

    /// The largest acceleration at `now`, which is evaluated, and its cause.
    pub(in crate::simulate) fn strain(&mut self) -> Option<Strain> {
        self.place_now();
        let Snapshot { state, a, lambda, .. } = &*self.now;
        self.system.diagnosis().strain(state.t, &state.q, &state.v, a, lambda)
    }

    /// Parts of a step at whose ends event functions are sampled.
    pub(in crate::simulate) fn n_event_parts(&self) -> usize {
        self.method.integrator.n_event_parts()
    }

    /// The state at `t` between `now` and `next`, both evaluated; neither projected nor evaluated.
    pub(in crate::simulate) fn inside(&mut self, t: f64, out: &mut State) -> Result<(), MotionError> {
        if self.singular_positions.between(t, out) {
            return Ok(());
        }
        self.method.integrator.between(&mut self.system, self.now.node(), self.next.node(), t, out)
    }

    /// The state at `t` between `now` and `next`, both evaluated; projected as the ends of steps are. Where the method asks for it, it is the end of a
    /// step of its own.
    pub(in crate::simulate) fn find(&mut self, t: f64, out: &mut State) -> Result<(), MotionError> {
        let is_crossing = self.singular_positions.is_crossing();
        if !is_crossing && self.method.integrator.is_unsure_between() && self.step_to(t, out)? {
            return Ok(());
        }
        self.inside(t, out)?;
        self.projection.project(&mut self.system, out)?;
        if !is_crossing && self.method.integrator.is_off_constraints(&out.v) {
            self.step_to(t, out)?;
        }
        Ok(())
    }

    /// The end of a step of its own, projected; false where there is none.
    fn step_to(&mut self, t: f64, out: &mut State) -> Result<bool, MotionError> {
        let is_found = self.method.integrator.step_to(&mut self.system, self.now.node(), t, out)?;
        if is_found {
            self.projection.project(&mut self.system, out)?;
        }
        Ok(is_found)
    }

    /// Ends the motion at `t` between `now` and `next`: `next` becomes the state there, projected and evaluated.
    pub(in crate::simulate) fn end_at(&mut self, t: f64, state: &mut State) -> Result<(), MotionError> {
        self.find(t, state)?;
        std::mem::swap(&mut self.next.state, state);
        self.next.evaluate(&mut self.system)
    }

    /// Switches a row ([`System::switch`]), and projects the state, which is not evaluated; without history.
    pub(in crate::simulate) fn switch(&mut self, row: usize, holds: bool, side: f64) -> Result<(), MotionError> {
        self.system.switch(row, holds, side);
        self.restart();
        self.projection.project_unseen(&mut self.system, &mut self.now.state)?;
        Ok(())
    }

    /// Switches a row on, and makes a plastic impact on it. Positions are projected to the last digit: errors normal to the constraints
    /// would remain while flights become short.
    pub(in crate::simulate) fn apply_impact(&mut self, row: usize, side: f64) -> Result<(), MotionError> {
        self.system.switch(row, true, side);
        self.restart();
        let State { t, q, v, .. } = &mut self.now.state;
        self.system.project_positions(*t, q, Metric::Mass)?;
        self.system.projector().polish_positions(*t, q)?;
        self.system.project_velocities(*t, q, v, Metric::Mass)?;
        self.evaluate_now()
    }

    /// Goes on from here with these velocities, without history; they keep the rows that are switched on.
    pub(in crate::simulate) fn go_on_with(&mut self, v: &[f64]) -> Result<(), MotionError> {
        self.now.state.v.copy_from_slice(v);
        self.restart();
        self.evaluate_now()
    }

    /// Kinetic and potential energy, J.
    pub(in crate::simulate) fn energy(&self) -> f64 {
        let State { t, q, v, .. } = &self.now.state;
        self.system.kinetic_energy(v) + self.system.potential_energy(*t, q)
    }

    /// Repeats the step under way with the length `h`, without history.
    pub(in crate::simulate) fn advance_again(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        self.method.integrator.restart_with(h);
        self.singular_positions.restart();
        self.evaluate_now()?;
        self.advance(h, t_next)
    }

    pub(in crate::simulate) fn n_rejected(&self) -> u64 {
        self.method.integrator.n_rejected() + self.singular_positions.n_rejected()
    }

    pub(in crate::simulate) fn stiff_since(&self) -> Option<f64> {
        self.method.integrator.stiff_since()
    }

    pub(in crate::simulate) fn evaluate_now(&mut self) -> Result<(), MotionError> {
        self.method.evaluate(&mut self.system, &mut self.now)?;
        self.method.integrator.accept();
        Ok(())
    }

    /// Whether the motion can begin at `now`, which is evaluated, and last for `within_s`.
    pub(in crate::simulate) fn check_beginning(&mut self, within_s: f64) -> Result<(), MotionError> {
        let Snapshot { state, a, solved, .. } = &*self.now;
        self.system.diagnosis().check_beginning(state, a, *solved, within_s)
    }

    pub(in crate::simulate) fn evaluate_next(&mut self) -> Result<(), MotionError> {
        if self.is_next_evaluated {
            return Ok(());
        }
        self.method.evaluate(&mut self.system, &mut self.next)
    }

    /// `next` becomes `now`.
    pub(in crate::simulate) fn accept(&mut self) {
        std::mem::swap(&mut self.now, &mut self.next);
        self.method.integrator.accept();
    }
}

fn check_finite<P: SceneRef>(system: &System<P>, t: f64, state: &State) -> Result<(), MotionError> {
    let are_finite = |numbers: &[f64]| numbers.iter().all(|x| x.is_finite());
    if moves_finitely(system.mass_matrix(), &state.q, &state.v) && are_finite(&state.z) && are_finite(&state.work) {
        return Ok(());
    }
    let info = system.info();
    let quantity = match state_not_finite(info, state) {
        Some(quantity) => quantity,
        None => match state.work.iter().position(|work| !work.is_finite()) {
            Some(i) => info.effects[i].name.into(),
            // squares overflow from 1e154 m/s on
            None if !system.kinetic_energy(&state.v).is_finite() => "kinetic energy".into(),
            None => return Ok(()),
        },
    };
    Err(MotionError::NotFinite { t, quantity })
}

#[cfg(test)]
mod tests;
