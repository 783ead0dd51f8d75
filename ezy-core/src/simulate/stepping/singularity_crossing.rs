//! Crossing of singular positions, in which the rank of G drops for an instant.

use super::singular::{Approach, Vanishing, about};
use super::snapshot::Snapshot;
use crate::archive::Archive;
use crate::dynamics::{Metric, MotionError, OnRows, Projection, State, System};
use crate::integrate::{DOP853_ERROR_ORDER, Dop853, Sizes, StepControl, Tolerance};
use crate::model::SceneRef;
use crate::simulate::tolerances::crossing::{ABOUT, MAX_TRIES, MIDDLE, NOISE, OF_FIXED_STEPS, SHORTEST};
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
    method: Dop853,
    on_rows: State,
    control: StepControl,
    tolerance: Tolerance,
    /// Whether the method of the run chooses its steps.
    chooses_steps: bool,
    /// Step length for the tolerance, s.
    length_s: f64,
    /// Start of the last step, s.
    begin_s: f64,
    /// How near it comes to the singular position, as a part of the distance at its start.
    nearest: f64,
    /// Its end, projected and evaluated.
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
        let info = system.info();
        let end = Snapshot::zero(info, work);
        let n_works = end.power.len();
        let wanted = tolerance.unwrap_or(Tolerance::new(OF_FIXED_STEPS, OF_FIXED_STEPS));
        Self {
            method: Dop853::new(Sizes::new(info, n_works)),
            on_rows: State::zeros([info.n_coordinates(), info.n_velocities()], 0, 0),
            control: StepControl::new(DOP853_ERROR_ORDER),
            tolerance: wanted,
            chooses_steps: tolerance.is_some(),
            length_s: 0.0,
            begin_s: 0.0,
            nearest: 0.0,
            end,
            is_under_way: false,
            ahead_s: None,
            in_vain_until_s: f64::NEG_INFINITY,
            n_rejected: 0,
        }
    }

    /// Writes what is known of the step under way, or reads it.
    pub(in crate::simulate) fn remember(&mut self, archive: &mut Archive) {
        self.method.remember(archive);
        self.control.remember(archive);
        self.end.remember(archive);
        let Self { length_s, begin_s, nearest, in_vain_until_s, .. } = self;
        [length_s, begin_s, nearest, in_vain_until_s].into_iter().for_each(|number| archive.number(number));
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
        let found = approach.find(system, &mut self.on_rows.q, within);
        let Some(Vanishing { within_s: distance, nearest }) = found else { return false };
        if !self.chooses_steps {
            self.length_s = distance / MIDDLE;
        }
        let shortest = SHORTEST * usual_s;
        let noise = NOISE / self.tolerance.relative;
        for _ in 0..MAX_TRIES {
            let length = self.length_s;
            let crosses_now = distance <= ABOUT * MIDDLE * length;
            let h = if crosses_now { distance / MIDDLE } else { length.min(distance - MIDDLE * length) };
            self.method.restart();
            let error = self.attempt(system, now, h).unwrap_or(f64::INFINITY);
            if error <= 1.0 || error <= noise && length <= shortest {
                self.length_s = length.max(h * self.control.accept(error.max(f64::MIN_POSITIVE)));
                (self.begin_s, self.nearest) = (t, nearest);
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

    /// Error over tolerance of a step, without the part that its projection removes.
    fn attempt<P: SceneRef>(&mut self, system: &mut System<P>, now: &Snapshot, h: f64) -> Result<f64, MotionError> {
        let to = &mut self.end.state;
        let mut on_rows = OnRows::new(system, &mut self.on_rows);
        let error = self.method.attempt(&mut on_rows, now.node(), h, self.tolerance, to)?;
        let tangential =
            if error > 1.0 { self.method.tangential_error(&mut on_rows, h, self.tolerance, to) } else { None };
        Ok(tangential.unwrap_or(error))
    }

    /// Projects and evaluates the end of a step, and prepares its interpolant.
    fn finish<P: SceneRef>(&mut self, system: &mut System<P>, now: &Snapshot) -> Result<(), MotionError> {
        let State { t, q, v, .. } = &mut self.end.state;
        system.project(*t, q, v, Projection::Both, Metric::Mass)?;
        self.end.evaluate(system)?;
        let mut on_rows = OnRows::new(system, &mut self.on_rows);
        self.method.prepare_dense(&mut on_rows, now.node(), self.end.node())
    }

    /// The last step.
    pub(in crate::simulate) fn crossed(&self) -> SingularityCrossed {
        SingularityCrossed { from_s: self.begin_s, to_s: self.end.state.t, nearest: self.nearest }
    }

    /// The state at `t` within the step, not projected.
    pub(in crate::simulate) fn between(&mut self, t: f64, out: &mut State) {
        self.method.dense_at((t - self.begin_s) / (self.end.state.t - self.begin_s), out);
        out.t = t;
    }
}
