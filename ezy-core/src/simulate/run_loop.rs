//! The loop: control, step, project, record.

use super::control::Control;
use super::instantaneous::Instantaneous;
use super::keeper::Keeper;
use super::motion::{Motion, first_not_finite};
use super::{Cost, Outcome, Run, SetupError, StopReason};
use crate::dynamics::MotionError;
use crate::integrate::{Clock, interpolate};
use crate::model::Scene;
use crate::record::{Recorder, Wanted};
use std::time::Instant;

/// What a run is to do, checked.
pub(super) struct Plan {
    pub clock: Clock,
    pub every_s: Option<f64>,
    pub wanted: Wanted,
}

/// A sample within this fraction of a step of a step's end is that end.
const ON_STEP: f64 = 1e-9;

/// How often progress is told.
const N_PROGRESS: u64 = 100;

pub(super) struct RunLoop<'s, S: Scene + ?Sized> {
    motion: Motion<'s, S>,
    control: Control<'s>,
    plan: Plan,
    between: Instantaneous,
    /// Inputs of the step under way, to come back to when control of the next one fails.
    inputs: Vec<f64>,
    keeper: Keeper<'s>,
    on_progress: Option<Box<dyn FnMut(f64) + 's>>,
}

impl<'s, S: Scene + ?Sized> RunLoop<'s, S> {
    /// Evaluates and records the start, where `motion` is.
    pub fn new(
        mut motion: Motion<'s, S>,
        mut control: Control<'s>,
        plan: Plan,
        recorder: Option<&'s mut dyn Recorder>,
        on_progress: Option<Box<dyn FnMut(f64) + 's>>,
    ) -> Result<Self, SetupError> {
        let info = motion.system.info();
        control.act(&motion.now.state, plan.clock.step(0), &mut motion.system)?;
        motion.evaluate_now()?;
        if let Some(i) = first_not_finite(&motion.now.a) {
            let quantity = info.coordinates[i].name;
            return Err(MotionError::NotFinite { t: motion.now.state.t, quantity }.into());
        }
        let mut keeper = Keeper::new(info, plan.wanted, recorder);
        keeper.keep(&mut motion.system, &motion.now)?;
        let between = Instantaneous::zero(info, plan.wanted.work);
        let inputs = motion.system.inputs().to_vec();
        Ok(Self { motion, control, plan, between, inputs, keeper, on_progress })
    }

    pub fn run(mut self) -> Result<Run, SetupError> {
        let began = Instant::now();
        let n_steps = self.plan.clock.n_steps();
        let mut steps = 0;
        let mut outcome = Outcome::ReachedEnd;
        while steps < n_steps {
            if let Err(reason) = self.step(steps) {
                outcome = Outcome::Stopped { t: self.motion.now.state.t, reason };
                self.motion.system.inputs_mut().copy_from_slice(&self.inputs);
                break;
            }
            steps += 1;
            self.tell_progress(steps, n_steps);
        }
        if self.keeper.last_time() < self.motion.now.state.t {
            // the end, or the last good state
            if let Err(error) = self.keeper.keep(&mut self.motion.system, &self.motion.now)
                && outcome.reached_end()
            {
                outcome = Outcome::Stopped { t: self.motion.now.state.t, reason: error.into() };
            }
        }
        let counters = self.motion.system.counters();
        let cost = Cost {
            steps,
            rejected: 0,
            evaluations: counters.evaluations,
            factorizations: counters.factorizations,
            seconds: began.elapsed().as_secs_f64(),
        };
        Ok(Run { outcome, cost, info: self.motion.system.info(), record: self.keeper.into_record() })
    }

    /// One step from `now`, which stays as it is when the step fails.
    fn step(&mut self, n: u64) -> Result<(), StopReason> {
        let clock = self.plan.clock;
        self.motion.advance(clock.step(n), clock.time(n + 1))?;
        let controlled = !self.control.is_idle() && n + 1 < clock.n_steps();
        if !controlled || self.sample_is_due_before(n) {
            self.motion.evaluate_next()?;
        }
        self.record_between(n)?;
        if controlled {
            // what is evaluated from here on is the start of the next step
            let (motion, h) = (&mut self.motion, clock.step(n + 1));
            self.control.act(&motion.next.state, h, &mut motion.system)?;
            motion.evaluate_next()?;
        }
        self.motion.accept();
        self.inputs.copy_from_slice(self.motion.system.inputs());
        self.record_now(n + 1)
    }

    /// Time of the next sample; infinite when only start and end are kept.
    fn next_sample(&self) -> f64 {
        let start = self.plan.clock.time(0);
        self.plan.every_s.map_or(f64::INFINITY, |every_s| start + self.keeper.n_kept() as f64 * every_s)
    }

    /// Whether a sample falls into step `n`, not on its end.
    fn sample_is_due_before(&self, n: u64) -> bool {
        let (t, t_next) = (self.next_sample(), self.plan.clock.time(n + 1));
        t <= t_next && !self.is_on_end_of(n, t)
    }

    fn is_on_end_of(&self, n: u64, t: f64) -> bool {
        (t - self.plan.clock.time(n + 1)).abs() <= ON_STEP * self.plan.clock.step(n)
    }

    /// Records what falls between `now` and `next`, both evaluated with the inputs of this step.
    fn record_between(&mut self, n: u64) -> Result<(), StopReason> {
        while self.sample_is_due_before(n) {
            let (t, Motion { system, now, next, .. }) = (self.next_sample(), &mut self.motion);
            interpolate(now.knot(), next.knot(), t, &mut self.between.state);
            self.between.evaluate(system)?;
            self.keeper.keep(system, &self.between)?;
        }
        Ok(())
    }

    /// Records `now` when a sample falls on it; the end itself is recorded when the loop is done.
    fn record_now(&mut self, n: u64) -> Result<(), StopReason> {
        if n < self.plan.clock.n_steps() && self.is_on_end_of(n - 1, self.next_sample()) {
            self.keeper.keep(&mut self.motion.system, &self.motion.now)?;
        }
        Ok(())
    }

    fn tell_progress(&mut self, steps: u64, n_steps: u64) {
        if let Some(progress) = &mut self.on_progress
            && (steps.is_multiple_of(n_steps.div_ceil(N_PROGRESS)) || steps == n_steps)
        {
            progress(steps as f64 / n_steps as f64);
        }
    }
}
