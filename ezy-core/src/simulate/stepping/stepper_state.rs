//! A scene with the state of its integration: one step, projected. Shared by runs and steppers.

use super::singular::Approach;
use super::singularity_crossing::{SingularityCrossed, SingularityCrossing};
use super::snapshot::Snapshot;
use crate::archive::Archive;
use crate::dynamics::{Metric, MotionError, Projected, Projection, Rows, State, Strain, System, state_not_finite};
use crate::integrate::{EventDiscontinuities, Integrator, Method, Needs, QUARTERED, Tolerance};
use crate::model::{SceneInfo, SceneRef};
use crate::scalar::Scalar;
use crate::simulate::SetupError;
use crate::simulate::tolerances::singular::{CREEPING, FADING, MAX_SHORTENED, SHORTENED, TOO_NEAR};
use std::sync::Arc;

/// The state `now`, and the end `next` of the step under way.
pub(in crate::simulate) struct StepperState<P: SceneRef> {
    pub system: System<P>,
    integrator: Box<dyn Integrator<System<P>>>,
    /// Whether the method finds accelerations itself: asked once, not at each step.
    expands: bool,
    discontinuities: EventDiscontinuities,
    projection: Projection,
    metric: Metric,
    /// Whether singular positions are crossed by special steps: only when steps are projected.
    crosses: bool,
    /// Tolerance of a method that chooses its steps.
    tolerance: Option<Tolerance>,
    /// Made when it is first needed.
    crossing: Option<Box<SingularityCrossing>>,
    /// A buffer for positions ahead.
    foreseen: Vec<f64>,
    /// The last crossing step; none once it is recorded.
    pub crossed: Option<SingularityCrossed>,
    /// Steps taken again shorter: next to a singular position, or far off the constraints.
    n_shortened: u64,
    /// Usual step length, s, of which single steps are cut short; zero before the first step.
    usual_s: f64,
    /// Whether works are integrated.
    pub work: bool,
    /// What the last projection of a state found and left.
    pub projected: Projected,
    pub now: Snapshot,
    pub next: Snapshot,
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
        let projects = projection == Projection::Both && metric == Metric::Mass;
        let integrator = integrator(&system, method, now.power.len())?;
        let discontinuities = EventDiscontinuities::new(&info);
        Ok(Self {
            system,
            expands: integrator.expands(),
            integrator,
            discontinuities,
            projection,
            metric,
            crosses: projects && info.n_position_rows > 0,
            tolerance: method.tolerance(),
            crossing: None,
            foreseen: vec![0.0; info.n_coordinates()],
            crossed: None,
            n_shortened: 0,
            usual_s: 0.0,
            work,
            projected: Projected::default(),
            now,
            next,
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
        self.discontinuities.remember(archive);
        archive.number(&mut self.usual_s);
        archive.count(&mut self.n_shortened);
        let mut has_crossing = self.crossing.is_some();
        archive.flag(&mut has_crossing);
        self.crossed = None;
        if has_crossing {
            let Self { system, crossing, tolerance, work, .. } = self;
            let new = || Box::new(SingularityCrossing::new(system, *tolerance, *work));
            crossing.get_or_insert_with(new).remember(archive);
        } else {
            self.crossing = None;
        }
        self.integrator.remember(&mut self.system, archive);
        if archive.is_read() && self.expands {
            self.evaluate_now()?;
        }
        Ok(())
    }

    /// What is asked of the system next is asked at `now`: samples between steps have other first-order states.
    pub(in crate::simulate) fn place_now(&mut self) {
        self.system.place_states(&self.now.state.z);
    }

    /// Forgets the steps taken so far.
    fn restart(&mut self) {
        self.integrator.restart();
        self.discontinuities.restart();
        self.forget_crossing();
    }

    fn forget_crossing(&mut self) {
        self.usual_s = 0.0;
        self.crossed = None;
        if let Some(crossing) = &mut self.crossing {
            crossing.restart();
        }
    }

    /// A step of length `h` from `now`, which is evaluated, to `next`, which is projected but not evaluated. A method
    /// that chooses its steps may stop before `t_next`, and every method stops at a discontinuity.
    pub(in crate::simulate) fn advance(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        self.is_next_evaluated = false;
        let Snapshot { state: State { t, q, .. }, solved, .. } = &self.now;
        self.system.at(*t, q).hold_rows(solved.is_rank_deficient);
        let outcome = match self.advance_across_singularity(t_next) {
            Ok(true) => Ok(()),
            Ok(false) => self.advance_past_singular_positions(h, t_next),
            Err(error) => Err(error),
        };
        if outcome.is_ok() {
            let length = self.next.state.t - self.now.state.t;
            self.usual_s = length.max(self.usual_s - FADING * length);
        }
        let Snapshot { state: State { t, q, v, .. }, a, lambda, .. } = &self.now;
        outcome.map_err(|error| {
            let error = self.system.diagnosis().locked_up(*t, q, error);
            self.system.diagnosis().without_derivative((*t, q, v), (a, lambda), error)
        })?;
        check_angles(self.system.info(), self.tolerance, &self.next.state)
    }

    /// A step across a singular position, or a part of such a step; false where there is none.
    fn advance_across_singularity(&mut self, t_next: f64) -> Result<bool, MotionError> {
        let chooses_steps = self.chooses_steps();
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
            if !self.crosses || !holds_inputs {
                return Ok(false);
            }
            // on the way, the crossing itself knows where
            let ahead =
                if is_heading { Some(0.0..0.0) } else { approach.ahead(system, self.usual_s, &mut self.foreseen) };
            let Some(within) = ahead else { return Ok(false) };
            let crossing =
                crossing.get_or_insert_with(|| Box::new(SingularityCrossing::new(system, self.tolerance, self.work)));
            if !crossing.step(system, &approach, within, self.usual_s) {
                return Ok(false);
            }
            self.crossed = Some(crossing.crossed());
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
            self.integrator.step(system, end.node(), h, t_next, &mut self.discontinuities, &mut next.state)?;
            self.project_next()?;
        }
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
                Ok(()) if self.passes_singular_position() => QUARTERED * made,
                Ok(()) if self.ends_near_singular_position() => SHORTENED * made,
                Ok(()) => match self.integrator.shorter_for_constraints(&self.next.state.v) {
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
            self.n_shortened += 1;
        }
        outcome?;
        if self.creeps(t_next) {
            let State { t, .. } = self.now.state;
            return Err(MotionError::StepCollapsed { t, step_s: self.next.state.t - t });
        }
        Ok(())
    }

    /// Whether a step next to a singular position is so short that it leads nowhere but into rounding.
    fn creeps(&mut self, t_next: f64) -> bool {
        let (now, next) = (&self.now.state, &self.next.state);
        let is_short = next.t < t_next && next.t - now.t < CREEPING * self.usual_s;
        self.crosses && is_short && self.system.diagnosis().is_nearly_singular(now.t, &now.q)
    }

    /// Whether a singular position may lie between the ends of the step, where steps of another kind pass it on the right branch.
    fn passes_singular_position(&self) -> bool {
        self.crosses && self.integrator.smallest_pivot_within() < TOO_NEAR * self.now.end.smallest_pivot
    }

    /// Whether rows that were independent at the start of the step nearly depend on each other at its end.
    fn ends_near_singular_position(&mut self) -> bool {
        let (was, is) = (self.now.solved.is_rank_deficient, self.next.end.is_rank_deficient);
        let State { t, q, .. } = &self.next.state;
        let pivot =
            if was { self.system.at_with(*t, q, Rows::Held).smallest_pivot() } else { self.next.end.smallest_pivot };
        let has_fallen = self.crosses && pivot < TOO_NEAR * self.now.end.smallest_pivot;
        // where masses are far apart, pivots fall although constraints are independent
        is && !was || has_fallen && !self.system.diagnosis().is_far_from_singular(*t, q)
    }

    #[inline]
    fn step(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        let (system, now, next) = (&mut self.system, &self.now, &mut self.next);
        self.integrator.step(system, now.node(), h, t_next, &mut self.discontinuities, &mut next.state)?;
        check_finite(system, self.now.state.t, &next.state)?;
        self.project_next()?;
        if self.expands { self.judge_by_end(h, t_next) } else { Ok(()) }
    }

    /// Takes the step again shorter, as long as the method refuses it for the accelerations at its end.
    fn judge_by_end(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        loop {
            // an error here comes again when the end is evaluated
            self.is_next_evaluated =
                evaluate(self.expands.then_some(&mut *self.integrator), &mut self.system, &mut self.next).is_ok();
            let (system, now, next) = (&mut self.system, &self.now, &mut self.next);
            if !self.is_next_evaluated || !self.integrator.refuses(now.node(), next.node()) {
                return Ok(());
            }
            self.integrator.step(system, now.node(), h, t_next, &mut self.discontinuities, &mut next.state)?;
            check_finite(system, now.state.t, &next.state)?;
            self.project_next()?;
        }
    }

    #[inline]
    fn project_next(&mut self) -> Result<(), MotionError> {
        let State { t, q, v, z, .. } = &mut self.next.state;
        self.system.place_states(z);
        // some methods find their own accelerations, and inputs may change before the next step
        let is_final = !self.expands && self.system.inputs().is_empty();
        self.projected = match is_final {
            true => self.system.projector().project_end(*t, q, v, self.projection, self.metric)?,
            false => self.system.project(*t, q, v, self.projection, self.metric)?,
        };
        self.next.end = self.projected.solved.unwrap_or_default();
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
        self.tolerance.is_some()
    }

    /// The largest acceleration at `now`, which is evaluated, and its cause.
    pub(in crate::simulate) fn strain(&mut self) -> Option<Strain> {
        self.place_now();
        let Snapshot { state, a, lambda, .. } = &self.now;
        self.system.diagnosis().strain(state.t, &state.q, &state.v, a, lambda)
    }

    /// The state at `t` between `now` and `next`, both evaluated; neither projected nor evaluated.
    pub(in crate::simulate) fn inside(&mut self, t: f64, out: &mut State) -> Result<(), MotionError> {
        if let Some(crossing) = self.crossing.as_mut().filter(|crossing| crossing.is_under_way) {
            crossing.between(t, out);
            return Ok(());
        }
        self.integrator.between(&mut self.system, self.now.node(), self.next.node(), t, out)
    }

    /// The state at `t` between `now` and `next`, both evaluated; projected as the ends of steps are. Where the projection changes more than
    /// the tolerance explains, it is the end of a step of its own.
    pub(in crate::simulate) fn find(&mut self, t: f64, out: &mut State) -> Result<(), MotionError> {
        self.inside(t, out)?;
        self.project(out)?;
        let is_across = self.crossing.as_ref().is_some_and(|crossing| crossing.is_under_way);
        let is_off = !is_across && self.integrator.is_off_constraints(&out.v);
        if is_off && self.integrator.step_to(&mut self.system, self.now.node(), t, out)? {
            self.project(out)?;
        }
        Ok(())
    }

    /// Projects a state as the ends of steps are.
    fn project(&mut self, state: &mut State) -> Result<(), MotionError> {
        let State { t, q, v, .. } = state;
        self.projected = self.system.project(*t, q, v, self.projection, self.metric)?;
        Ok(())
    }

    /// Ends the motion at `t` between `now` and `next`: `next` becomes the state there, projected and evaluated.
    pub(in crate::simulate) fn end_at(&mut self, t: f64, state: &mut State) -> Result<(), MotionError> {
        self.find(t, state)?;
        std::mem::swap(&mut self.next.state, state);
        self.next.evaluate(&mut self.system)
    }

    /// Switches the row that can be switched ([`System::switch`]), and projects the state, which is not evaluated; without history.
    pub(in crate::simulate) fn switch(&mut self, holds: bool, side: f64) -> Result<(), MotionError> {
        self.system.switch(holds, side);
        self.restart();
        let State { t, q, v, .. } = &mut self.now.state;
        self.system.project(*t, q, v, self.projection, self.metric)?;
        Ok(())
    }

    /// Switches the row on, and makes a plastic impact on it. Positions are projected to the last digit: errors normal to the constraints
    /// would remain while flights become short.
    pub(in crate::simulate) fn apply_impact(&mut self, side: f64) -> Result<(), MotionError> {
        self.system.switch(true, side);
        self.restart();
        let State { t, q, v, .. } = &mut self.now.state;
        self.system.project_positions(*t, q, Metric::Mass)?;
        self.system.projector().polish_positions(*t, q)?;
        self.system.project_velocities(*t, q, v, Metric::Mass)?;
        self.evaluate_now()
    }

    /// Switches the row off, and goes on from here with these velocities, without history.
    pub(in crate::simulate) fn let_go(&mut self, v: &[f64]) -> Result<(), MotionError> {
        self.system.switch(false, 0.0);
        self.go_on_with(v)
    }

    /// Goes on from here with these velocities, without history.
    fn go_on_with(&mut self, v: &[f64]) -> Result<(), MotionError> {
        self.now.state.v.copy_from_slice(v);
        self.restart();
        self.evaluate_now()
    }

    /// Switches the row on where these velocities keep it, and goes on from here with them, without history.
    pub(in crate::simulate) fn hold(&mut self, side: f64, v: &[f64]) -> Result<(), MotionError> {
        self.system.switch(true, side);
        self.go_on_with(v)
    }

    /// Kinetic and potential energy, J.
    pub(in crate::simulate) fn energy(&self) -> f64 {
        let State { t, q, v, .. } = &self.now.state;
        self.system.kinetic_energy(v) + self.system.potential_energy(*t, q)
    }

    /// Repeats the step under way with the length `h`, without history.
    pub(in crate::simulate) fn advance_again(&mut self, h: f64, t_next: f64) -> Result<(), MotionError> {
        self.integrator.restart_with(h);
        self.forget_crossing();
        self.evaluate_now()?;
        self.advance(h, t_next)
    }

    pub(in crate::simulate) fn n_rejected(&self) -> u64 {
        let of_crossings = self.crossing.as_ref().map_or(0, |crossing| crossing.n_rejected);
        self.integrator.n_rejected() + self.n_shortened + of_crossings
    }

    pub(in crate::simulate) fn stiff_since(&self) -> Option<f64> {
        self.integrator.stiff_since()
    }

    pub(in crate::simulate) fn evaluate_now(&mut self) -> Result<(), MotionError> {
        evaluate(self.expands.then_some(&mut *self.integrator), &mut self.system, &mut self.now)?;
        self.integrator.accept();
        Ok(())
    }

    /// Whether the motion can begin at `now`, which is evaluated, and last for `within_s`.
    pub(in crate::simulate) fn check_beginning(&mut self, within_s: f64) -> Result<(), MotionError> {
        let Snapshot { state, a, solved, .. } = &self.now;
        self.system.diagnosis().check_beginning(state, a, *solved, within_s)
    }

    pub(in crate::simulate) fn evaluate_next(&mut self) -> Result<(), MotionError> {
        if self.is_next_evaluated {
            return Ok(());
        }
        evaluate(self.expands.then_some(&mut *self.integrator), &mut self.system, &mut self.next)
    }

    /// `next` becomes `now`.
    pub(in crate::simulate) fn accept(&mut self) {
        std::mem::swap(&mut self.now, &mut self.next);
        self.integrator.accept();
    }
}

/// The method with its storage.
fn integrator<P: SceneRef>(
    system: &System<P>,
    method: Method,
    n_works: usize,
) -> Result<Box<dyn Integrator<System<P>>>, SetupError> {
    SetupError::refuse_angles(system.info(), method.tolerance())?;
    let made = method.kind().of_system(system, n_works, method.tolerance().unwrap_or(Tolerance::ANY))?;
    let info = system.info();
    made.ok_or(match method.info().needs {
        _ if info.n_states() > 0 && !method.info().takes_states => {
            SetupError::FirstOrderStates { scene: info.name, method: method.name() }
        }
        _ if !(info.is_planar() || method.info().takes_any_body) => {
            SetupError::SpatialBodies { scene: info.name, method: method.name() }
        }
        Needs::Jacobians => SetupError::NoJacobians { scene: info.name },
        Needs::Series | Needs::Nothing => SetupError::NoSeries { scene: info.name, series: info.series },
    })
}

/// Accelerations, multipliers and powers at a state; by the method where it `expands`.
fn evaluate<P: SceneRef>(
    expands: Option<&mut (dyn Integrator<System<P>> + 'static)>,
    system: &mut System<P>,
    at: &mut Snapshot,
) -> Result<(), MotionError> {
    let Some(integrator) = expands else { return at.evaluate(system) };
    let Snapshot { state, a, lambda, .. } = at;
    match integrator.expand(system, state, a, lambda) {
        Some(solved) => at.complete(system, solved?),
        None => at.evaluate(system),
    }
}

/// That no angle is too large for the tolerance of angles.
pub(in crate::simulate) fn check_angles<T: Scalar>(
    info: &SceneInfo,
    tolerance: Option<Tolerance>,
    state: &State<T>,
) -> Result<(), MotionError> {
    let Some(tolerance) = tolerance else { return Ok(()) };
    match tolerance.unresolved(&state.q).zip(tolerance.angle) {
        None => Ok(()),
        Some(((i, spacing), tolerance)) => {
            let (name, angle) = (info.coordinates[i].name.clone(), state.q[i].magnitude());
            Err(MotionError::AngleUnresolved { t: state.t, name, angle, spacing, tolerance })
        }
    }
}

fn check_finite<P: SceneRef>(system: &System<P>, t: f64, state: &State) -> Result<(), MotionError> {
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
