//! Event location: roots of event functions within a step.
//!
//! After each step the event functions are sampled on its interpolant, at the ends of equal parts. A change of sign
//! between two samples is located. Where a parabola through three samples predicts a double root, it is searched for.

mod double_root;
mod event_function;
pub(super) mod laws;
mod step_samples;

use super::stepping::stepper_state::StepperState;
use crate::dynamics::{MotionError, State};
use crate::integrate::{resolution_at, root, side_of};
use crate::model::{EventInfo, EventKind, SceneRef};
use crate::simulate::tolerances::events::NOTHING;
pub(super) use event_function::EventFunction;
use step_samples::StepSamples;

/// An event that took place.
#[derive(Debug, Clone)]
pub struct Occurrence {
    /// Its description; `event.name` compares with the constants that the model has in its module `events`: `throw::events::landing`.
    pub event: &'static EventInfo,
    /// The state then: interpolated and projected.
    pub state: State,
}

/// A root of an event function.
#[derive(Debug, Clone, Copy)]
pub(super) struct Passage {
    pub t: f64,
    pub event: &'static EventInfo,
}

/// Finds roots of event functions and keeps the events of a run.
pub(super) struct EventDetector {
    samples: StepSamples,
    events: &'static [EventInfo],
    /// Number of events to report: discontinuities come last and are not reported.
    n_told: usize,
    /// Last sign of each event function: -1 or 1; 0 when it has not left zero yet.
    sides: Vec<f64>,
    /// Whether no step was sampled yet.
    fresh: bool,
    /// Of the present step.
    passages: Vec<Passage>,
    pub occurred: Vec<Occurrence>,
}

impl EventDetector {
    pub(super) fn new<P: SceneRef>(
        function: EventFunction,
        events: &'static [EventInfo],
        stepper: &StepperState<P>,
    ) -> Self {
        Self {
            samples: StepSamples::new(function, events.len(), stepper),
            events,
            n_told: events
                .iter()
                .filter(|event| !matches!(event.kind, EventKind::Discontinuity | EventKind::Layer))
                .count(),
            sides: vec![0.0; events.len()],
            fresh: true,
            passages: Vec::new(),
            occurred: Vec::new(),
        }
    }

    pub(super) fn is_idle(&self) -> bool {
        self.n_told == 0
    }

    /// Locates the events of a step, both ends evaluated; returns the event that ends the run.
    pub(super) fn look<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<Option<Passage>, MotionError> {
        self.find(stepper)?;
        let end = self.passages.iter().position(|passage| passage.event.kind == EventKind::End);
        if let Some(end) = end {
            self.passages.truncate(end + 1);
        }
        Ok(end.map(|end| self.passages[end]))
    }

    /// Keeps the events of the step that was sampled last.
    pub(super) fn keep<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        for Passage { t, event } in self.passages.drain(..) {
            let mut state = stepper.now.state.clone();
            stepper.find(t, &mut state)?;
            self.occurred.push(Occurrence { event, state });
        }
        Ok(())
    }

    /// Time of the first root of this step alone, s. The function starts above zero, or at zero when the mode `begins`.
    pub(super) fn first<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        begins: bool,
    ) -> Result<Option<f64>, MotionError> {
        self.fresh = begins;
        self.sides.fill(1.0);
        self.find(stepper)?;
        Ok(self.passages.first().map(|passage| passage.t))
    }

    /// Last time of the step at which the functions are defined, s; at `undefined` they are not.
    pub(super) fn last_defined<P: SceneRef>(&mut self, stepper: &mut StepperState<P>, undefined: f64) -> f64 {
        let (mut last, mut beyond) = (stepper.now.state.t, undefined);
        while beyond - last > resolution_at(beyond) {
            let t = 0.5 * (last + beyond);
            match self.samples.value(stepper, 0, t) {
                Ok(_) => last = t,
                Err(_) => beyond = t,
            }
        }
        last
    }

    /// Number of parts of a step at whose ends functions are sampled.
    pub(super) fn n_parts(&self) -> usize {
        self.samples.n_parts()
    }

    /// Whether a value is below zero at the end of the step.
    pub(super) fn ends_below(&self) -> bool {
        self.samples.values().next_back().is_some_and(|values| values.iter().any(|&value| value < 0.0))
    }

    /// Finds the roots of a step, in time order.
    fn find<P: SceneRef>(&mut self, stepper: &mut StepperState<P>) -> Result<(), MotionError> {
        self.passages.clear();
        self.samples.sample(stepper)?;
        if self.fresh {
            self.begin();
        }
        for i in 0..self.n_told {
            for part in 1..=self.samples.n_parts() {
                let ends = [part - 1, part].map(|k| self.samples.at(k, i));
                match self.samples.double_root(stepper, i, part)? {
                    Some(lowest) => {
                        self.compare(stepper, i, [ends[0], lowest])?;
                        self.compare(stepper, i, [lowest, ends[1]])?;
                    }
                    None => self.compare(stepper, i, ends)?,
                }
            }
        }
        self.passages.sort_by(|a, b| a.t.total_cmp(&b.t));
        Ok(())
    }

    /// Signs at the start of a run.
    fn begin(&mut self) {
        self.fresh = false;
        for (i, side) in self.sides.iter_mut().enumerate() {
            let largest = self.samples.values().fold(0.0, |largest: f64, values| largest.max(values[i].abs()));
            let (_, first) = self.samples.at(0, i);
            *side = if first.abs() > NOTHING * largest { side_of(first) } else { 0.0 };
        }
    }

    /// Keeps the root of function `i` when its sign changes between two samples.
    fn compare<P: SceneRef>(
        &mut self,
        stepper: &mut StepperState<P>,
        i: usize,
        [(t_before, before), (t, after)]: [(f64, f64); 2],
    ) -> Result<(), MotionError> {
        let (old, side) = (self.sides[i], side_of(after));
        if side == 0.0 || side == old {
            return Ok(());
        }
        self.sides[i] = side;
        let event = &self.events[i];
        if old == 0.0 || !event.direction.counts(side) {
            return Ok(());
        }
        // an input may have changed the sign between two steps
        let t = if side_of(before) == side {
            t_before
        } else {
            root((t_before, before), (t, after), resolution_at(t), |t| self.samples.value(stepper, i, t))?
        };
        self.passages.push(Passage { t, event });
        Ok(())
    }
}
