//! The loop: control, step, project, record.

use super::events::{EventDetector, EventFunction, Passage};
use super::inputs::control::Control;
use super::modes::Modes;
use super::monitor::processor_time::processor_time;
use super::monitor::rank_watch::RankRecord;
use super::monitor::{Caller, Watch};
use super::recording::run_samples::RunSamples;
use super::recording::sample_times::Sampling;
use super::recording::sampler::Sampler;
use super::stepping::schedule::Schedule;
use super::stepping::stepper_state::StepperState;
use super::{Cost, Outcome, Run, SetupError, StopReason};
use crate::dynamics::{MotionError, MovedValue, not_finite};
use crate::model::{EventInfo, SceneRef};
use crate::record::Recorder;
use std::sync::Arc;
use std::time::Instant;

/// The checked settings of a run.
pub(super) struct Plan<'s> {
    pub schedule: Schedule,
    pub sampling: Sampling,
    pub recorder: Option<&'s mut dyn Recorder>,
    pub caller: Caller<'s>,
    /// Events to locate.
    pub events: &'static [EventInfo],
}

pub(super) struct RunLoop<'s, P: SceneRef> {
    stepper: StepperState<P>,
    /// Of a scene with modes.
    modes: Option<Box<Modes>>,
    schedule: Schedule,
    control: Control<'s>,
    /// Inputs of the step under way, restored when the controller of the next one fails.
    inputs: Vec<f64>,
    detector: EventDetector,
    samples: RunSamples<'s>,
    watch: Watch,
    rank: RankRecord,
    caller: Caller<'s>,
}

impl<'s, P: SceneRef> RunLoop<'s, P> {
    /// Evaluates and records the start, where the stepper is.
    pub(super) fn new(
        mut stepper: StepperState<P>,
        mut modes: Option<Box<Modes>>,
        mut control: Control<'s>,
        plan: Plan<'s>,
        watch: Watch,
    ) -> Result<Self, SetupError> {
        let info = Arc::clone(stepper.system.info());
        let Plan { schedule, sampling, recorder, caller, events } = plan;
        let t = stepper.now.state.t;
        control.act(&stepper.now.state, schedule.next(t).0, &mut stepper.system)?;
        stepper.evaluate_now()?;
        if let Some(quantity) = not_finite(&info, &stepper.now.a, &[]) {
            return Err(MotionError::NotFinite { t: stepper.now.state.t, quantity }.into());
        }
        if let Some(i) = stepper.now.rate.iter().position(|rate| !rate.is_finite()) {
            let quantity = format!("the rate of {}", info.states[i].name).into();
            return Err(MotionError::NotFinite { t: stepper.now.state.t, quantity }.into());
        }
        stepper.check_beginning(schedule.end - t)?;
        let mut samples = RunSamples::new(&stepper, sampling, recorder);
        if let Some(modes) = &mut modes {
            modes.start(&mut stepper)?;
            samples.sampler.sliding.skates.extend(modes.sliding());
        }
        samples.keep_now(&mut stepper)?;
        let mut rank = RankRecord::default();
        rank.see(&mut stepper);
        let inputs = stepper.system.inputs().to_vec();
        let detector = EventDetector::new(EventFunction::Events, events, &stepper);
        Ok(Self { stepper, modes, schedule, control, inputs, detector, samples, watch, rank, caller })
    }

    /// `moved`: start values that changed.
    pub(super) fn run(mut self, moved: Vec<MovedValue>) -> Result<Run, SetupError> {
        let (began, began_working) = (Instant::now(), processor_time());
        let (mut steps, start, end) = (0, self.stepper.now.state.t, self.schedule.end);
        let mut outcome = Outcome::ReachedEnd;
        while self.stepper.now.state.t < end {
            if self.caller.interrupts() {
                outcome = Outcome::Interrupted { t: self.stepper.now.state.t };
                break;
            }
            match self.step() {
                Ok(None) => {}
                Ok(Some(Passage { t, event })) => {
                    outcome = Outcome::ReachedEvent { t, name: event.name };
                    steps += 1;
                    break;
                }
                Err(reason) => {
                    self.stepper.system.inputs_mut().copy_from_slice(&self.inputs);
                    let strain = if reason.asks_for_strain() { self.stepper.strain() } else { None };
                    outcome = Outcome::Stopped { t: self.stepper.now.state.t, reason, strain };
                    break;
                }
            }
            steps += 1;
            self.caller.tell((self.stepper.now.state.t - start) / (end - start));
        }
        // the end, or the last good state
        if self.samples.last_time() < self.stepper.now.state.t
            && let Err(error) = self.samples.keep_now(&mut self.stepper)
            && outcome.reached_end()
        {
            outcome = Outcome::Stopped { t: self.stepper.now.state.t, reason: error.into(), strain: None };
        }
        let (rejected, seconds) = (self.n_rejected(), began.elapsed().as_secs_f64());
        let processor_seconds = (processor_time() - began_working).as_secs_f64();
        let done = self.stepper.system.counters();
        let (evaluations, factorizations) = (done.evaluations, done.factorizations);
        let cost = Cost { steps, rejected, evaluations, factorizations, seconds, processor_seconds };
        let (mut events, stiff_since_s) = (self.detector.occurred, self.stepper.stiff_since());
        let rounding_j = self.stepper.system.diagnosis().work_of_rounding(&self.stepper.now.lambda);
        let mut monitors = self.watch.monitors(self.stepper.system.info(), rounding_j);
        if let Some(modes) = self.modes {
            monitors.softest_impact = modes.softest;
            events.extend(modes.occurred);
            events.sort_by(|a, b| a.state.t.total_cmp(&b.state.t));
        }
        if let Some(energy) = monitors.energy
            && outcome.reached_end()
            && !self.watch.trusts(energy, self.stepper.chooses_steps())
        {
            let [_, step_s] = monitors.steps_s.unwrap_or_default();
            outcome = Outcome::Untrusted { t: self.stepper.now.state.t, step_s, energy };
        }
        let Sampler { info, record, .. } = self.samples.sampler;
        if outcome.reached_end()
            && let Some((column, value)) = record.no_number_at_end()
        {
            let t = self.stepper.now.state.t;
            outcome = Outcome::Stopped { t, reason: StopReason::NoNumber { column, value }, strain: None };
        }
        let rank = self.rank;
        Ok(Run { outcome, cost, monitors, rank, moved, stiff_since_s, error_estimate: None, info, events, record })
    }

    /// One step from `now`, which is unchanged when the step fails; returns the event that ends the run.
    fn step(&mut self) -> Result<Option<Passage>, StopReason> {
        let (t, end) = (self.stepper.now.state.t, self.schedule.end);
        self.watch.admits_step(self.stepper.chooses_steps(), self.n_rejected(), t, end)?;
        let changes = self.advance()?;
        let last = self.stepper.next.state.t >= end;
        if !self.detector.is_idle() {
            self.stepper.evaluate_next()?;
            let end = self.detector.look(&mut self.stepper)?;
            if let Some(end) = end {
                return self.end(end).map(Some);
            }
        }
        let StepperState { system, projection, now, next, .. } = &mut self.stepper;
        self.watch.look(system, now.state.t, &next.state, &projection.projected, last)?;
        let controlled = !self.control.is_idle() && !last && !self.schedule.is_cut;
        if !self.detector.is_idle() {
            self.detector.keep(&mut self.stepper)?;
        } else if !controlled || self.samples.is_due_within(&self.stepper) {
            self.stepper.evaluate_next()?;
        }
        self.samples.keep_within(&mut self.stepper, f64::INFINITY)?;
        if controlled {
            self.control_next()?;
        }
        self.accept(last)?;
        let changed = match &mut self.modes {
            Some(modes) if changes && !last => modes.change_due(&mut self.stepper),
            _ => Ok(()),
        };
        self.follow_mode();
        changed?;
        Ok(None)
    }

    /// Sets the inputs for the next step; from here on `next` is evaluated as the start of that step.
    fn control_next(&mut self) -> Result<(), MotionError> {
        let stepper = &mut self.stepper;
        let (h, _) = self.schedule.next(stepper.next.state.t);
        self.control.act(&stepper.next.state, h, &mut stepper.system)?;
        stepper.evaluate_next()
    }

    /// `next` becomes `now`, and a sample where one is due there; the `last` one is recorded at the end of the run.
    fn accept(&mut self, last: bool) -> Result<(), StopReason> {
        let on_end = self.samples.is_due_at_end(&self.stepper);
        self.stepper.accept();
        self.rank.see(&mut self.stepper);
        self.inputs.copy_from_slice(self.stepper.system.inputs());
        if on_end && !last {
            self.samples.keep_now(&mut self.stepper)?;
        }
        Ok(())
    }

    /// Ends the run within a step; monitors do not see the rest of the step.
    fn end(&mut self, end: Passage) -> Result<Passage, StopReason> {
        let state = &mut self.samples.within().state;
        self.stepper.find(end.t, state)?;
        let StepperState { system, projection, now, .. } = &mut self.stepper;
        self.watch.look(system, now.state.t, state, &projection.projected, true)?;
        self.detector.keep(&mut self.stepper)?;
        self.samples.keep_within(&mut self.stepper, end.t)?;
        self.stepper.end_at(end.t, &mut self.samples.within().state)?;
        self.stepper.accept();
        self.rank.see(&mut self.stepper);
        Ok(end)
    }

    /// Rejected and discarded steps.
    fn n_rejected(&self) -> u64 {
        self.stepper.n_rejected() + self.modes.as_ref().map_or(0, |modes| modes.n_taken_back)
    }

    /// A step from `now` to `next`; returns whether the mode changes at its end.
    fn advance(&mut self) -> Result<bool, MotionError> {
        let (h, t_next) = self.schedule.next(self.stepper.now.state.t);
        let changes = match &mut self.modes {
            None => self.stepper.advance(h, t_next).map(|()| false),
            Some(modes) => modes.advance(&mut self.stepper, h, t_next),
        };
        self.follow_mode();
        let changes = changes?;
        self.schedule.count(self.stepper.next.state.t, t_next);
        Ok(changes)
    }

    /// Samples tell the forces of skates that slide.
    fn follow_mode(&mut self) {
        if let Some(modes) = &self.modes {
            let sliding = &mut self.samples.sampler.sliding.skates;
            sliding.clear();
            sliding.extend(modes.sliding());
        }
    }
}
