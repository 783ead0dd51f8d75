//! From a [`Simulation`] to a run or a stepper: its settings are checked, then the start is assembled.

use super::control::Control;
use super::given::give;
use super::modes::Modes;
use super::monitor::Watch;
use super::run_loop::{Plan, RunLoop};
use super::schedule::Schedule;
use super::stepper_state::StepperState;
use super::tolerances::orders::{LARGEST_TOLERANCE, MAX_NUMBERS, MAX_STEPS};
use super::{Run, SetupError, Simulation, Stepper};
use crate::dynamics::{StartError, System};
use crate::integrate::{Clock, Method, Tolerance};
use crate::memory;
use crate::model::{Scene, Start};
use crate::record::{Recorder, input_index};

impl<'s, S: Scene + ?Sized> Simulation<'s, S> {
    /// Runs.
    ///
    /// # Errors
    /// [`SetupError`] when the run cannot start. A run that stops on the way is not an error: [`Run::outcome`] says
    /// so, and everything up to there is kept.
    pub fn run(self) -> Result<Run, SetupError> {
        match &self.scene.modes()[..] {
            [] => self.run_in_modes(&[]),
            [first, others @ ..] => {
                let others: Vec<&dyn Scene> = others.iter().map(|scene| &**scene).collect();
                self.of_scene(&**first).run_in_modes(&others)
            }
        }
    }

    /// The same settings for another scene with the same names.
    fn of_scene<'a>(self, scene: &'a dyn Scene) -> Simulation<'a, dyn Scene + 'a>
    where
        's: 'a,
    {
        Simulation {
            scene,
            method: self.method,
            until_s: self.until_s,
            every_s: self.every_s,
            projection: self.projection,
            metric: self.metric,
            backend: self.backend,
            given: self.given,
            start_gives_way: self.start_gives_way,
            inputs: self.inputs,
            law: self.law,
            wanted: self.wanted,
            limits: self.limits,
            watched: self.watched,
            recorder: self.recorder.map(|recorder| recorder as &mut dyn Recorder),
            streamed: self.streamed,
            interrupt: self.interrupt,
            on_progress: self.on_progress,
        }
    }

    /// Runs; `others` are the other modes of the scene.
    fn run_in_modes(mut self, others: &[&'s S]) -> Result<Run, SetupError> {
        let mut system = System::new(self.scene, self.backend)?;
        let start = self.start(&system)?;
        let control = self.take_control(&mut system)?;
        let schedule = self.schedule(start.t, control.is_idle())?;
        let limits = self.limits.checked()?;
        let events = if self.watched { self.scene.info().events } else { &[] };
        let Self { every_s, wanted, streamed, interrupt, .. } = self;
        let state = system.consistent_start(&start)?;
        let moved = system.moved_values(&start, &state);
        let plan = Plan { schedule, every_s, wanted, streamed, interrupt, moved, events };
        let mut stepper = self.stepper_in(system)?;
        stepper.place(&state);
        let watch = Watch::new(&mut stepper.system, &state, limits, self.projection, self.wanted.work);
        let others = others.iter().map(|scene| self.stepper_of(scene)).collect::<Result<_, _>>()?;
        let modes = Modes::new(&stepper, others).map(Box::new);
        RunLoop::new(stepper, modes, control, plan, watch, self.recorder, self.on_progress)?.run()
    }

    /// Hands the scene over to be stepped by the caller; end, limits, recording and progress are left to the caller, too.
    ///
    /// # Errors
    /// [`SetupError`] when the start or the step cannot be used.
    pub fn stepper(mut self) -> Result<Stepper<'s, S>, SetupError> {
        SetupError::refuse_modes(self.scene.info())?;
        let mut system = System::new(self.scene, self.backend)?;
        let start = self.start(&system)?;
        let step_s = self.fixed_step()?;
        let state = system.consistent_start(&start)?;
        let control = self.take_control(&mut system)?;
        let stepper = self.stepper_in(system)?;
        Ok(Stepper::new(stepper, control, step_s, start, state))
    }

    fn stepper_of(&self, scene: &'s S) -> Result<StepperState<'s, S>, SetupError> {
        self.stepper_in(System::new(scene, self.backend)?)
    }

    fn stepper_in(&self, system: System<'s, S>) -> Result<StepperState<'s, S>, SetupError> {
        StepperState::new(system, self.method, self.projection, self.metric, self.wanted.work)
    }

    /// The start of the scene with what is given in its place.
    fn start(&self, system: &System<'_, S>) -> Result<Start, SetupError> {
        let mut start = system.scene_start();
        for (name, value) in &self.given {
            give(system.info(), &mut start, name, *value)?;
        }
        if self.start_gives_way {
            start.give_way();
        }
        Ok(start)
    }

    /// Tables and control law of the run; constant inputs are set at once. Of two settings of one input the later one counts.
    fn take_control(&mut self, system: &mut System<'_, S>) -> Result<Control<'s>, SetupError> {
        let mut control = Control { tables: Vec::new(), law: self.law.take() };
        for (name, table) in self.inputs.drain(..) {
            let i = input_index(system.info(), &name)?;
            control.tables.retain(|(other, _)| *other != i);
            match table.constant() {
                Some(value) => system.inputs_mut()[i] = value,
                None => control.tables.push((i, table)),
            }
        }
        Ok(control)
    }

    /// The fixed step of a method that has one.
    fn fixed_step(&self) -> Result<f64, SetupError> {
        match self.method {
            Method::Rk4 { step_s } if step_s.is_finite() && step_s > 0.0 => Ok(step_s),
            Method::Rk4 { step_s } => Err(SetupError::Step { step_s }),
            _ => Err(SetupError::NeedsFixedStep { method: self.method.name() }),
        }
    }

    /// `idle`: whether inputs stay constant. Inputs that change are held over steps of fixed length.
    fn schedule(&self, start_s: f64, idle: bool) -> Result<Schedule, SetupError> {
        let until_s = self.until_s;
        if !start_s.is_finite() {
            return Err(StartError::NotFinite { name: "t", value: start_s }.into());
        }
        if !(until_s.is_finite() && until_s >= start_s) {
            return Err(SetupError::Until { until_s, start_s });
        }
        if let Some(every_s) = self.every_s {
            if every_s.is_nan() || every_s <= 0.0 {
                return Err(SetupError::Every { every_s });
            }
            let samples = (until_s - start_s) / every_s;
            let info = self.scene.info();
            let n_numbers = (3 * info.n_coordinates() + info.n_rows()).max(1) as f64;
            // what is streamed is limited as steps are
            let limit = if self.streamed { MAX_STEPS } else { MAX_NUMBERS / n_numbers };
            if samples > limit {
                return Err(SetupError::TooManySamples { samples, every_s, limit });
            }
            let needed = (samples * n_numbers) as u64 * size_of::<f64>() as u64;
            if let Some(available) = memory::too_little_for(needed)
                && !self.streamed
            {
                return Err(SetupError::Memory { samples, every_s, needed, available });
            }
        }
        match self.method.tolerance() {
            Some(tolerance) if idle => {
                check_tolerance(tolerance)?;
                Ok(Schedule::Free { start: start_s, end: until_s })
            }
            _ => {
                let step_s = self.fixed_step()?;
                let steps = (until_s - start_s) / step_s;
                if steps > MAX_STEPS {
                    return Err(SetupError::TooManySteps { steps, step_s, limit: MAX_STEPS });
                }
                Ok(Schedule::Clock(Clock::new(start_s, until_s, step_s)))
            }
        }
    }
}

pub(super) fn check_tolerance(tolerance: Tolerance) -> Result<(), SetupError> {
    let Tolerance { relative, absolute } = tolerance;
    let usable = |x: f64, least: f64| (least..=LARGEST_TOLERANCE).contains(&x);
    let smallest = Tolerance::SMALLEST_RELATIVE;
    if usable(relative, smallest) && usable(absolute, f64::MIN_POSITIVE) {
        return Ok(());
    }
    Err(SetupError::Tolerance { relative, absolute, smallest, largest: LARGEST_TOLERANCE })
}
