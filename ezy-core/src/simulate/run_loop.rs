//! The loop: control, step, project, record.

use super::events::{EventDetector, EventFunction, Passage};
use super::inputs::control::Control;
use super::modes::Modes;
use super::monitor::Watch;
use super::monitor::processor_time::processor_time;
use super::monitor::rank_watch::RankRecord;
use super::recording::sample_times::SampleTimes;
use super::recording::sampler::Sampler;
use super::stepping::schedule::Schedule;
use super::stepping::snapshot::Snapshot;
use super::stepping::stepper_state::StepperState;
use super::tolerances::samples::{N_PROGRESS, ON_STEP};
use super::{Cost, Outcome, Run, SetupError, StopReason};
use crate::dynamics::{MotionError, MovedValue, not_finite};
use crate::model::{EventInfo, SceneRef};
use crate::record::{Recorder, Wanted};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

/// The checked settings of a run.
pub(super) struct Plan<'s> {
    pub schedule: Schedule,
    pub sample_times: SampleTimes,
    pub wanted: Wanted,
    /// Whether samples go to the recorder alone.
    pub streamed: bool,
    /// One that is true ends the run.
    pub interrupts: Vec<&'s AtomicBool>,
    /// Start values that changed.
    pub moved: Vec<MovedValue>,
    /// Events to locate.
    pub events: &'static [EventInfo],
}

pub(super) struct RunLoop<'s, P: SceneRef> {
    stepper: StepperState<P>,
    control: Control<'s>,
    plan: Plan<'s>,
    watch: Watch,
    detector: EventDetector,
    /// Of a scene with modes.
    modes: Option<Box<Modes<P>>>,
    /// Steps that ended before the clock's time.
    n_cut: u64,
    /// Whether the last step was one of these.
    cut: bool,
    between: Snapshot,
    /// Inputs of the step under way, restored when the controller of the next one fails.
    inputs: Vec<f64>,
    sampler: Sampler<'s>,
    on_progress: Option<Box<dyn FnMut(f64) + Send + 's>>,
    /// Hundredths of the run that were reported.
    told: f64,
    rank: RankRecord,
}

impl<'s, P: SceneRef> RunLoop<'s, P> {
    /// Evaluates and records the start, where the stepper is.
    pub(super) fn new(
        mut stepper: StepperState<P>,
        mut modes: Option<Box<Modes<P>>>,
        mut control: Control<'s>,
        plan: Plan<'s>,
        watch: Watch,
        recorder: Option<&'s mut dyn Recorder>,
        on_progress: Option<Box<dyn FnMut(f64) + Send + 's>>,
    ) -> Result<Self, SetupError> {
        let info = Arc::clone(stepper.system.info());
        let t = stepper.now.state.t;
        control.act(&stepper.now.state, plan.schedule.step(0, t).0, &mut stepper.system)?;
        stepper.evaluate_now()?;
        if let Some(quantity) = not_finite(&info, &stepper.now.a, &[]) {
            return Err(MotionError::NotFinite { t: stepper.now.state.t, quantity }.into());
        }
        if let Some(i) = stepper.now.rate.iter().position(|rate| !rate.is_finite()) {
            let quantity = format!("the rate of {}", info.states[i].name).into();
            return Err(MotionError::NotFinite { t: stepper.now.state.t, quantity }.into());
        }
        stepper.check_beginning(plan.schedule.end() - t)?;
        let recorded = modes.as_ref().map_or_else(|| Arc::clone(&info), |modes| modes.record_info(&stepper));
        let mut sampler = Sampler::new(recorded, plan.wanted, recorder, plan.streamed);
        let mut between = Snapshot::zero(&info, plan.wanted.work);
        if let Some(modes) = &mut modes {
            modes.start(&mut stepper)?;
            between.lambda.clone_from(&stepper.now.lambda);
            sampler.lacking = modes.lacking();
        }
        sampler.keep(&mut stepper.system, &stepper.now)?;
        let mut rank = RankRecord::default();
        rank.see(&mut stepper);
        let inputs = stepper.system.inputs().to_vec();
        let detector = EventDetector::new(EventFunction::Events, plan.events, &stepper.now.state);
        Ok(Self {
            stepper,
            control,
            plan,
            watch,
            detector,
            modes,
            n_cut: 0,
            cut: false,
            between,
            inputs,
            sampler,
            on_progress,
            told: 0.0,
            rank,
        })
    }

    pub(super) fn run(mut self) -> Result<Run, SetupError> {
        let (began, began_working) = (Instant::now(), processor_time());
        let mut steps = 0;
        let mut outcome = Outcome::ReachedEnd;
        while self.stepper.now.state.t < self.plan.schedule.end() {
            if self.plan.interrupts.iter().any(|flag| flag.load(Ordering::Relaxed)) {
                outcome = Outcome::Interrupted { t: self.stepper.now.state.t };
                break;
            }
            match self.step(steps) {
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
            self.tell_progress();
        }
        if self.sampler.last_time() < self.stepper.now.state.t {
            // the end, or the last good state
            if let Err(error) = self.sampler.keep(&mut self.stepper.system, &self.stepper.now)
                && outcome.reached_end()
            {
                outcome = Outcome::Stopped { t: self.stepper.now.state.t, reason: error.into(), strain: None };
            }
        }
        let (rejected, seconds) = (self.n_rejected(), began.elapsed().as_secs_f64());
        let processor_seconds = (processor_time() - began_working).as_secs_f64();
        let mut cost = Cost { steps, rejected, seconds, processor_seconds, ..Cost::default() };
        let (mut events, mut stiff_since_s) = (self.detector.occurred, None);
        let parked = self.modes.iter().flat_map(|modes| modes.parked());
        for stepper in std::iter::once(&self.stepper).chain(parked) {
            let counters = stepper.system.counters();
            cost.evaluations += counters.evaluations;
            cost.factorizations += counters.factorizations;
            stiff_since_s = stiff_since_s.or(stepper.stiff_since());
        }
        if let Some(modes) = self.modes {
            events.extend(modes.occurred);
            events.sort_by(|a, b| a.state.t.total_cmp(&b.state.t));
        }
        let StepperState { system, now, .. } = &self.stepper;
        let (info, monitors) =
            (Arc::clone(self.sampler.info()), self.watch.monitors(system.work_of_rounding(&now.lambda)));
        if let Some(energy) = monitors.energy
            && outcome.reached_end()
            && !self.watch.trusts(energy, self.stepper.chooses_steps())
        {
            let [_, step_s] = monitors.steps_s.unwrap_or_default();
            outcome = Outcome::Untrusted { t: now.state.t, step_s, energy };
        }
        let record = self.sampler.into_record();
        if outcome.reached_end()
            && let Some((column, value)) = record.no_number_at_end()
        {
            outcome = Outcome::Stopped { t: now.state.t, reason: StopReason::NoNumber { column, value }, strain: None };
        }
        let (rank, moved) = (self.rank, self.plan.moved);
        Ok(Run { outcome, cost, monitors, rank, moved, stiff_since_s, error_estimate: None, info, events, record })
    }

    /// One step from `now`, which is unchanged when the step fails; returns the event that ends the run.
    fn step(&mut self, n: u64) -> Result<Option<Passage>, StopReason> {
        let (t, end) = (self.stepper.now.state.t, self.plan.schedule.end());
        self.watch.admits_step(self.stepper.chooses_steps(), self.n_rejected(), t, end)?;
        let (h, t_next) = self.plan.schedule.step(n - self.n_cut, self.stepper.now.state.t);
        let changes = self.advance(h, t_next)?;
        let last = self.stepper.next.state.t >= self.plan.schedule.end();
        if !self.detector.is_idle() {
            self.stepper.evaluate_next()?;
            let end = self.detector.look(&mut self.stepper)?;
            if let Some(end) = end {
                return self.end(end).map(Some);
            }
        }
        let StepperState { system, projected, now, next, .. } = &mut self.stepper;
        self.watch.look(system, now.state.t, &next.state, projected, last)?;
        let controlled = !self.control.is_idle() && !last && !self.cut;
        if !self.detector.is_idle() {
            self.detector.keep(&mut self.stepper)?;
        } else if !controlled || self.sample_is_due_before() {
            self.stepper.evaluate_next()?;
        }
        self.record_between(f64::INFINITY)?;
        if controlled {
            self.control_next(n)?;
        }
        self.accept(last)?;
        let changed = match &mut self.modes {
            Some(modes) if changes && !last => modes.change(&mut self.stepper),
            _ => Ok(()),
        };
        self.follow_mode();
        changed?;
        Ok(None)
    }

    /// Sets the inputs for the step after step `n`; from here on `next` is evaluated as the start of that step.
    fn control_next(&mut self, n: u64) -> Result<(), MotionError> {
        let stepper = &mut self.stepper;
        let (h, _) = self.plan.schedule.step(n + 1 - self.n_cut, stepper.next.state.t);
        self.control.act(&stepper.next.state, h, &mut stepper.system)?;
        stepper.evaluate_next()
    }

    /// `next` becomes `now`, and a sample where one is due there; the `last` one is recorded at the end of the run.
    fn accept(&mut self, last: bool) -> Result<(), StopReason> {
        let on_end = self.is_on_end(self.next_sample());
        self.stepper.accept();
        self.rank.see(&mut self.stepper);
        self.inputs.copy_from_slice(self.stepper.system.inputs());
        if on_end && !last {
            self.sampler.keep(&mut self.stepper.system, &self.stepper.now)?;
        }
        Ok(())
    }

    /// Ends the run within a step; monitors do not see the rest of the step.
    fn end(&mut self, end: Passage) -> Result<Passage, StopReason> {
        let state = &mut self.between.state;
        self.stepper.find(end.t, state)?;
        let StepperState { system, projected, now, .. } = &mut self.stepper;
        self.watch.look(system, now.state.t, state, projected, true)?;
        self.detector.keep(&mut self.stepper)?;
        self.record_between(end.t)?;
        self.stepper.end_at(end.t, &mut self.between.state)?;
        self.stepper.accept();
        self.rank.see(&mut self.stepper);
        Ok(end)
    }

    /// Rejected steps of all modes.
    fn n_rejected(&self) -> u64 {
        self.stepper.n_rejected() + self.modes.as_ref().map_or(0, |modes| modes.n_rejected())
    }

    /// A step from `now` to `next`; returns whether the mode changes at its end.
    fn advance(&mut self, h: f64, t_next: f64) -> Result<bool, MotionError> {
        let h = if self.cut { t_next - self.stepper.now.state.t } else { h };
        let changes = match &mut self.modes {
            None => self.stepper.advance(h, t_next).map(|()| false),
            Some(modes) => modes.advance(&mut self.stepper, h, t_next),
        };
        self.follow_mode();
        let changes = changes?;
        self.cut = self.stepper.next.state.t < t_next;
        self.n_cut += u64::from(self.cut);
        Ok(changes)
    }

    /// Adapts the buffers of samples to the mode.
    fn follow_mode(&mut self) {
        if let Some(modes) = &self.modes {
            self.between.lambda.clone_from(&self.stepper.now.lambda);
            self.sampler.lacking = modes.lacking();
        }
    }

    /// Time of the next sample; infinite when only start and end are kept.
    fn next_sample(&self) -> f64 {
        self.plan.sample_times.next(self.plan.schedule.start(), self.sampler.n_kept())
    }

    /// Whether a sample falls into the step from `now` to `next`, not on its end.
    fn sample_is_due_before(&self) -> bool {
        let t = self.next_sample();
        t <= self.stepper.next.state.t && !self.is_on_end(t)
    }

    /// Whether a sample at `t` is the end of the step.
    fn is_on_end(&self, t: f64) -> bool {
        let (now, next) = (self.stepper.now.state.t, self.stepper.next.state.t);
        (t - next).abs() <= ON_STEP * (next - now)
    }

    /// Records what falls between `now` and `next` and before `end`, both evaluated with the inputs of this step.
    fn record_between(&mut self, end: f64) -> Result<(), StopReason> {
        while self.sample_is_due_before() && self.next_sample() < end {
            let t = self.next_sample();
            self.stepper.between(t, &mut self.between)?;
            self.sampler.keep(&mut self.stepper.system, &self.between)?;
        }
        Ok(())
    }

    fn tell_progress(&mut self) {
        let (start, end) = (self.plan.schedule.start(), self.plan.schedule.end());
        let done = (self.stepper.now.state.t - start) / (end - start);
        if let Some(progress) = &mut self.on_progress
            && (done * N_PROGRESS >= self.told + 1.0 || done >= 1.0)
        {
            self.told = (done * N_PROGRESS).floor();
            progress(done);
        }
    }
}
