//! What a run does next to singular positions: steps across them, and shorter steps where there are none.

use super::singular::Approach;
use super::singularity_crossing::{SingularityCrossed, SingularityCrossing};
use super::snapshot::Snapshot;
use super::step_method::StepMethod;
use crate::archive::Archive;
use crate::dynamics::{Rows, State, System};
use crate::integrate::{DOP853_ERROR_ORDER, Method, MethodKind, Tolerance};
use crate::model::SceneRef;
use crate::simulate::tolerances::crossing::LEAST_TOLERANCE;
use crate::simulate::tolerances::singular::{CREEPING, FADING, TOO_NEAR};

/// Looks ahead for singular positions, and keeps the step that crosses one.
pub(in crate::simulate) struct SingularPositions {
    /// Whether they are crossed by special steps: only when steps are projected.
    crosses: bool,
    /// Length of a step that crosses to that of the steps of the run.
    of_crossing: f64,
    /// Made when it is first needed.
    crossing: Option<Box<SingularityCrossing>>,
    /// A buffer for positions ahead.
    foreseen: Vec<f64>,
    /// The last crossing step; none once it is recorded.
    pub crossed: Option<SingularityCrossed>,
    /// Steps taken again shorter: next to a singular position, or far off the constraints.
    pub n_shortened: u64,
    /// Usual step length, s, of which single steps are cut short; zero before the first step.
    pub usual_s: f64,
}

/// Length of a step that crosses to that of the steps of the run. Steps that cross are of DOP853 and keep [`LEAST_TOLERANCE`]; those of a run by the same method may keep less.
fn of_crossing(method: Method) -> f64 {
    let tolerance = method.tolerance().map(|tolerance| tolerance.relative.max(tolerance.absolute));
    match tolerance.filter(|tolerance| method.kind() == MethodKind::Dop853 && *tolerance < LEAST_TOLERANCE) {
        Some(tolerance) => (LEAST_TOLERANCE / tolerance).powf(1.0 / f64::from(DOP853_ERROR_ORDER)),
        None => 1.0,
    }
}

impl SingularPositions {
    /// `crosses`: whether they are crossed by special steps.
    pub(super) fn new(crosses: bool, method: Method) -> Self {
        let of_crossing = of_crossing(method);
        Self { crosses, of_crossing, crossing: None, foreseen: Vec::new(), crossed: None, n_shortened: 0, usual_s: 0.0 }
    }

    /// Writes what the next steps depend on, or reads it. `tolerance` and `work` are those of the run.
    pub(super) fn remember<P: SceneRef>(
        &mut self,
        system: &System<P>,
        tolerance: Option<Tolerance>,
        work: bool,
        archive: &mut Archive,
    ) {
        archive.number(&mut self.usual_s);
        archive.count(&mut self.n_shortened);
        let mut has_crossing = self.crossing.is_some();
        archive.flag(&mut has_crossing);
        self.crossed = None;
        if has_crossing {
            let new = || Box::new(SingularityCrossing::new(system, tolerance, work));
            self.crossing.get_or_insert_with(new).remember(archive);
        } else {
            self.crossing = None;
        }
    }

    /// Forgets the steps taken so far.
    pub(super) fn restart(&mut self) {
        self.usual_s = 0.0;
        self.crossed = None;
        if let Some(crossing) = &mut self.crossing {
            crossing.restart();
        }
    }

    /// The crossing step that is under way at `now`, or that begins there; none where no singular position is ahead, or no way over it.
    /// `tolerance` and `work` are those of the run.
    pub(super) fn crossing_step<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        approach: &Approach<'_>,
        tolerance: Option<Tolerance>,
        work: bool,
    ) -> Option<&mut SingularityCrossing> {
        if let Some(crossing) = &mut self.crossing
            && approach.now.state.t >= crossing.end.state.t
        {
            crossing.is_under_way = false;
        }
        if !self.is_crossing() {
            // a step over several ticks of the clock has the inputs of the first one only
            let holds_inputs = tolerance.is_some() || system.inputs().is_empty();
            if !self.crosses || !holds_inputs {
                return None;
            }
            let is_heading = self.crossing.as_ref().is_some_and(|crossing| crossing.is_heading());
            let usual_s = self.of_crossing * self.usual_s;
            // on the way, the crossing itself knows where
            let within = match is_heading {
                true => 0.0..0.0,
                false => approach.ahead(system, usual_s, &mut self.foreseen)?,
            };
            let new = || Box::new(SingularityCrossing::new(system, tolerance, work));
            let crossing = self.crossing.get_or_insert_with(new);
            if !crossing.step(system, approach, within, usual_s) {
                return None;
            }
            self.crossed = Some(crossing.crossed());
        }
        self.crossing.as_deref_mut()
    }

    /// Whether the run is within a crossing step or at its end.
    pub(super) fn is_crossing(&self) -> bool {
        self.crossing.as_ref().is_some_and(|crossing| crossing.is_under_way)
    }

    /// The state at `t` within the crossing step, not projected; false where the run is within none.
    #[inline]
    pub(super) fn between(&mut self, t: f64, out: &mut State) -> bool {
        let Some(crossing) = self.crossing.as_mut().filter(|crossing| crossing.is_under_way) else { return false };
        crossing.between(t, out);
        true
    }

    /// Notes the length of a step, s.
    #[inline]
    pub(super) fn see_step(&mut self, length_s: f64) {
        self.usual_s = length_s.max(self.usual_s - FADING * length_s);
    }

    /// Whether a step next to a singular position is so short that it leads nowhere but into rounding. The step may go on to `t_next`.
    pub(super) fn creeps<P: SceneRef>(&self, system: &mut System<P>, now: &State, next: &State, t_next: f64) -> bool {
        let is_short = next.t < t_next && next.t - now.t < CREEPING * self.usual_s;
        self.crosses && is_short && system.diagnosis().is_nearly_singular(now.t, &now.q)
    }

    /// Whether one may lie between the ends of the step from `now`, where steps of another kind pass it on the right branch.
    #[inline]
    pub(super) fn may_be_within<P: SceneRef>(&self, method: &StepMethod<P>, now: &Snapshot) -> bool {
        self.crosses && method.integrator.smallest_pivot_within() < TOO_NEAR * now.end.smallest_pivot
    }

    /// Whether rows that were independent at the start of the step nearly depend on each other at its end.
    #[inline]
    pub(super) fn is_near_end<P: SceneRef>(&self, system: &mut System<P>, now: &Snapshot, next: &Snapshot) -> bool {
        let (was, is) = (now.solved.is_rank_deficient, next.end.is_rank_deficient);
        let State { t, q, .. } = &next.state;
        let pivot = if was { system.at_with(*t, q, Rows::Held).smallest_pivot() } else { next.end.smallest_pivot };
        let has_fallen = self.crosses && pivot < TOO_NEAR * now.end.smallest_pivot;
        // where masses are far apart, pivots fall although constraints are independent
        is && !was || has_fallen && !system.diagnosis().is_far_from_singular(*t, q)
    }

    /// Rejected attempts of crossing steps, and steps taken again shorter.
    pub(super) fn n_rejected(&self) -> u64 {
        self.n_shortened + self.crossing.as_ref().map_or(0, |crossing| crossing.n_rejected)
    }
}
