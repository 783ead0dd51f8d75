//! The loop: step, project, record.

use super::instantaneous::Instantaneous;
use super::keeper::Keeper;
use super::{Cost, Outcome, Run, SetupError, StopReason};
use crate::dynamics::{Metric, MotionError, Projection, State, System};
use crate::integrate::{Clock, Rk4, interpolate};
use crate::model::Scene;
use crate::record::Recorder;
use std::time::Instant;

/// What a run is to do, checked.
pub(super) struct Plan {
    pub clock: Clock,
    pub every_s: Option<f64>,
    pub projection: Projection,
    pub metric: Metric,
}

/// A sample within this fraction of a step of a step's end is that end.
const ON_STEP: f64 = 1e-9;

/// How often progress is told.
const N_PROGRESS: u64 = 100;

pub(super) struct RunLoop<'s, S: Scene + ?Sized> {
    system: System<'s, S>,
    plan: Plan,
    method: Rk4,
    now: Instantaneous,
    next: Instantaneous,
    between: Instantaneous,
    keeper: Keeper<'s>,
    on_progress: Option<Box<dyn FnMut(f64) + 's>>,
}

impl<'s, S: Scene + ?Sized> RunLoop<'s, S> {
    /// Evaluates and records the start.
    pub fn new(
        mut system: System<'s, S>,
        plan: Plan,
        start: State,
        recorder: Option<&'s mut dyn Recorder>,
        on_progress: Option<Box<dyn FnMut(f64) + 's>>,
    ) -> Result<Self, SetupError> {
        let info = system.info();
        let (n_q, n_c, n_e) = (info.n_coordinates(), info.n_rows(), info.n_effects());
        let [mut now, next, between] = std::array::from_fn(|_| Instantaneous::zero(info));
        now.state = start;
        now.evaluate(&mut system)?;
        if let Some(i) = first_not_finite(&now.a) {
            let quantity = info.coordinates[i].name;
            return Err(MotionError::NotFinite { t: now.state.t, quantity }.into());
        }
        let mut keeper = Keeper::new(info, recorder);
        keeper.keep(&mut system, &now)?;
        Ok(Self { method: Rk4::new(n_q, n_c, n_e), system, plan, now, next, between, keeper, on_progress })
    }

    pub fn run(mut self) -> Result<Run, SetupError> {
        let began = Instant::now();
        let n_steps = self.plan.clock.n_steps();
        let mut steps = 0;
        let mut outcome = Outcome::ReachedEnd;
        while steps < n_steps {
            if let Err(reason) = self.step(steps) {
                outcome = Outcome::Stopped { t: self.now.state.t, reason };
                break;
            }
            steps += 1;
            self.tell_progress(steps, n_steps);
        }
        if self.keeper.last_time() < self.now.state.t {
            // the end, or the last good state
            if let Err(error) = self.keeper.keep(&mut self.system, &self.now)
                && outcome.reached_end()
            {
                outcome = Outcome::Stopped { t: self.now.state.t, reason: error.into() };
            }
        }
        let counters = self.system.counters();
        let cost = Cost {
            steps,
            rejected: 0,
            evaluations: counters.evaluations,
            factorizations: counters.factorizations,
            seconds: began.elapsed().as_secs_f64(),
        };
        Ok(Run { outcome, cost, info: self.system.info(), record: self.keeper.into_record() })
    }

    /// One step from `now`, which stays as it is when the step fails.
    fn step(&mut self, n: u64) -> Result<(), StopReason> {
        let clock = &self.plan.clock;
        let (h, t_next) = (clock.step(n), clock.time(n + 1));
        let (system, next) = (&mut self.system, &mut self.next);
        self.method.step(system, self.now.knot(), h, t_next, &mut next.state)?;
        check_finite(system, self.now.state.t, &next.state)?;
        let State { q, v, .. } = &mut next.state;
        if self.plan.projection.positions() {
            system.project_positions(t_next, q, self.plan.metric)?;
        }
        if self.plan.projection.velocities() {
            system.project_velocities(t_next, q, v, self.plan.metric)?;
        }
        next.evaluate(system)?;
        self.record_step(n, h)?;
        std::mem::swap(&mut self.now, &mut self.next);
        Ok(())
    }

    /// Records what falls after `now` and not after `next`; the end itself is recorded when the loop is done.
    fn record_step(&mut self, n: u64, h: f64) -> Result<(), StopReason> {
        let Some(every_s) = self.plan.every_s else { return Ok(()) };
        let (clock, system) = (&self.plan.clock, &mut self.system);
        let t_next = self.next.state.t;
        loop {
            let t = clock.time(0) + self.keeper.n_kept() as f64 * every_s;
            if (t - t_next).abs() <= ON_STEP * h {
                if n + 1 < clock.n_steps() {
                    self.keeper.keep(system, &self.next)?;
                }
                return Ok(());
            }
            if t > t_next {
                return Ok(());
            }
            interpolate(self.now.knot(), self.next.knot(), t, &mut self.between.state);
            self.between.evaluate(system)?;
            self.keeper.keep(system, &self.between)?;
        }
    }

    fn tell_progress(&mut self, steps: u64, n_steps: u64) {
        if let Some(progress) = &mut self.on_progress
            && (steps.is_multiple_of(n_steps.div_ceil(N_PROGRESS)) || steps == n_steps)
        {
            progress(steps as f64 / n_steps as f64);
        }
    }
}

fn first_not_finite(x: &[f64]) -> Option<usize> {
    x.iter().position(|x| !x.is_finite())
}

fn check_finite<S: Scene + ?Sized>(system: &System<'_, S>, t: f64, state: &State) -> Result<(), MotionError> {
    let coordinates = system.info().coordinates;
    let quantity = match (first_not_finite(&state.q), first_not_finite(&state.v)) {
        (Some(i), _) => coordinates[i].name,
        (None, Some(i)) => coordinates[i].velocity_name,
        (None, None) => match first_not_finite(&state.work) {
            Some(i) => system.info().effects[i].name,
            None => return Ok(()),
        },
    };
    Err(MotionError::NotFinite { t, quantity })
}
