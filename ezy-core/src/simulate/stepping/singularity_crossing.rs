//! Crossing of singular positions, in which the rank of G drops for an instant.

use super::projected_stages::ProjectedStages;
use super::singular::{Approach, Vanishing, about};
use super::snapshot::Snapshot;
use crate::archive::Archive;
use crate::dynamics::{Metric, MotionError, Projection, State, System};
use crate::integrate::{DOP853_ERROR_ORDER, StepControl, Tolerance};
use crate::model::SceneRef;
use crate::simulate::tolerances::crossing::{
    ABOUT, LEAST_TOLERANCE, MAX_TRIES, MIDDLE, NOISE, OF_FIXED_STEPS, SHORTEST,
};
use crate::simulate::tolerances::monitors::BESIDE;
use std::ops::Range;

/// A stretch of a run across a singular position, where rank is lost for an instant, or towards one. Its steps are of DOP853 with
/// projected stages, whatever the method of the run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SingularityCrossed {
    /// Its beginning, s.
    pub from_s: f64,
    /// Its end, s; a run that ends at an event may end before.
    pub to_s: f64,
    /// How near it comes to the singular position, as a part of the distance at the beginning of its last step: predicted, and zero up to the
    /// accuracy of the search where it leads through.
    pub nearest: f64,
}

impl SingularityCrossed {
    /// Whether it leads past the singular position and not through it. Then a run with a smaller tolerance may not meet it.
    pub fn is_beside(&self) -> bool {
        self.nearest > BESIDE
    }
}

/// Steps that begin well before a singular position and end well beyond it.
///
/// At a distance D from it, rounding of positions appears in velocities multiplied by 1/D² and in forces by 1/D³. So no step
/// ends near it. One step of DOP853 crosses it, with the singular position in the widest gap between its nodes. The stages are
/// projected, since accelerations have a pole there off the constraints.
pub(in crate::simulate) struct SingularityCrossing {
    stages: ProjectedStages,
    control: StepControl,
    /// Whether the method of the run chooses its steps.
    chooses_steps: bool,
    /// Step length for the tolerance, s.
    length_s: f64,
    last: SingularityCrossed,
    /// End of the last step, projected and evaluated.
    pub end: Snapshot,
    /// Whether the run is within this step or at its end.
    pub is_under_way: bool,
    /// Predicted time of the singular position, s.
    ahead_s: Option<f64>,
    /// No attempt before this time, s.
    in_vain_until_s: f64,
    /// Rejected attempts.
    pub n_rejected: u64,
}

impl SingularityCrossing {
    pub(in crate::simulate) fn new<P: SceneRef>(system: &System<P>, tolerance: Option<Tolerance>, work: bool) -> Self {
        let end = Snapshot::zero(system.info(), work);
        let wanted = tolerance.unwrap_or(Tolerance::new(OF_FIXED_STEPS, OF_FIXED_STEPS));
        let [relative, absolute] = [wanted.relative, wanted.absolute].map(|wanted| wanted.max(LEAST_TOLERANCE));
        let wanted = Tolerance { relative, absolute, ..wanted };
        Self {
            stages: ProjectedStages::new(system, end.power.len(), wanted),
            control: StepControl::new(DOP853_ERROR_ORDER),
            chooses_steps: tolerance.is_some(),
            length_s: 0.0,
            last: SingularityCrossed { from_s: 0.0, to_s: 0.0, nearest: 0.0 },
            end,
            is_under_way: false,
            ahead_s: None,
            in_vain_until_s: f64::NEG_INFINITY,
            n_rejected: 0,
        }
    }

    /// Writes what is known of the step under way, or reads it.
    pub(in crate::simulate) fn remember(&mut self, archive: &mut Archive) {
        self.stages.remember(archive);
        self.control.remember(archive);
        self.end.remember(archive);
        let Self { length_s, last: SingularityCrossed { from_s, to_s, nearest }, in_vain_until_s, .. } = self;
        *to_s = self.end.state.t;
        [length_s, from_s, nearest, in_vain_until_s].into_iter().for_each(|number| archive.number(number));
        archive.option(&mut self.ahead_s);
        archive.flag(&mut self.is_under_way);
        archive.count(&mut self.n_rejected);
    }

    /// Whether the last step approached a singular position.
    pub(in crate::simulate) fn is_heading(&self) -> bool {
        self.ahead_s.is_some()
    }

    /// Forgets the step under way.
    pub(in crate::simulate) fn restart(&mut self) {
        self.is_under_way = false;
        self.ahead_s = None;
        self.in_vain_until_s = f64::NEG_INFINITY;
    }

    /// A step over a singular position or towards it, when one is `within` these times from now, s, or on the way already; false when there is
    /// none, or no way over it. `usual_s` is the length of the steps before.
    pub(in crate::simulate) fn step<P: SceneRef>(
        &mut self,
        system: &mut System<P>,
        approach: &Approach<'_>,
        within: Range<f64>,
        usual_s: f64,
    ) -> bool {
        let now = approach.now;
        let t = now.state.t;
        if t < self.in_vain_until_s {
            return false;
        }
        let within = match self.ahead_s.take() {
            Some(ahead) => about(ahead - t),
            None => {
                self.length_s = usual_s;
                within
            }
        };
        let found = approach.find(system, &mut self.stages.on_rows.q, within);
        let Some(Vanishing { within_s: distance, nearest }) = found else { return false };
        if !self.chooses_steps {
            self.length_s = distance / MIDDLE;
        }
        let shortest = SHORTEST * usual_s;
        let noise = NOISE / self.stages.tolerance.relative;
        for _ in 0..MAX_TRIES {
            let length = self.length_s;
            let crosses_now = distance <= ABOUT * MIDDLE * length;
            let h = if crosses_now { distance / MIDDLE } else { length.min(distance - MIDDLE * length) };
            let error = self.stages.attempt(system, now, h, &mut self.end.state).unwrap_or(f64::INFINITY);
            if error <= 1.0 || error <= noise && length <= shortest {
                self.length_s = length.max(h * self.control.accept(error.max(f64::MIN_POSITIVE)));
                self.last = SingularityCrossed { from_s: t, to_s: self.end.state.t, nearest };
                if self.finish(system, now).is_err() {
                    self.n_rejected += 1;
                    break;
                }
                self.is_under_way = true;
                self.ahead_s = (!crosses_now).then_some(t + distance);
                return true;
            }
            self.n_rejected += 1;
            if !self.chooses_steps || length <= shortest {
                break;
            }
            self.length_s = (h * self.control.reject(error)).max(shortest);
        }
        self.in_vain_until_s = t + distance;
        false
    }

    /// Projects and evaluates the end of a step, and prepares its interpolant.
    fn finish<P: SceneRef>(&mut self, system: &mut System<P>, now: &Snapshot) -> Result<(), MotionError> {
        let State { t, q, v, .. } = &mut self.end.state;
        system.project(*t, q, v, Projection::Both, Metric::Mass)?;
        self.end.evaluate(system)?;
        self.stages.prepare_dense(system, now, &self.end)
    }

    /// The last step.
    pub(in crate::simulate) fn crossed(&self) -> SingularityCrossed {
        self.last
    }

    /// The state at `t` within the step, not projected.
    pub(in crate::simulate) fn between(&mut self, t: f64, out: &mut State) {
        let SingularityCrossed { from_s, to_s, .. } = self.last;
        self.stages.dense_at((t - from_s) / (to_s - from_s), out);
        out.t = t;
    }
}
