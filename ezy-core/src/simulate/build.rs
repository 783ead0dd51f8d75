//! From a [`Simulation`] to a run or a stepper: its settings are checked, then the start is assembled.

use super::checked::{check_step, check_tolerance};
use super::inputs::control::Control;
use super::inputs::given::give;
use super::modes::Modes;
use super::monitor::Watch;
use super::recording::sample_times::SampleTimes;
use super::run_loop::{Plan, RunLoop};
use super::several::estimated_run;
use super::simulation::{Hooks, Settings};
use super::stepping::schedule::Schedule;
use super::stepping::stepper_state::StepperState;
use super::tolerances::orders::{MAX_NUMBERS, MAX_STEPS};
use super::{Run, SetupError, Simulation, Stepper};
use crate::dynamics::{StartError, State, System};
use crate::integrate::Clock;
use crate::memory;
use crate::model::{Derived as _, Name, Scene, SceneInfo, SceneRef, Start};
use crate::record::{Recorder, input_index};

impl<'s, P: SceneRef> Simulation<'s, P> {
    /// Runs.
    ///
    /// # Errors
    /// [`SetupError`] when the run cannot start. A run that stops on the way is not an error: [`Run::outcome`] says
    /// so, and everything up to there is kept.
    pub fn run(self) -> Result<Run, SetupError> {
        if self.settings.estimated { estimated_run::run(self) } else { self.run_once() }
    }

    /// Runs without an estimate of the error.
    pub(super) fn run_once(self) -> Result<Run, SetupError> {
        let modes = self.scene.modes();
        match &modes[..] {
            [] => self.run_in_modes(&[]),
            [first, others @ ..] => {
                let others: Vec<&dyn Scene> = others.iter().map(|scene| &**scene).collect();
                self.of_scene(&**first).run_in_modes(&others)
            }
        }
    }

    /// The same settings for another scene with the same names.
    fn of_scene<'a>(self, scene: &'a dyn Scene) -> Simulation<'a, &'a (dyn Scene + 'a)>
    where
        's: 'a,
    {
        let Hooks { law, recorder, interrupts, on_progress } = self.hooks;
        let recorder = recorder.map(|recorder| recorder as &mut dyn Recorder);
        let hooks = Hooks { law, recorder, interrupts, on_progress };
        Simulation { scene, settings: self.settings, hooks }
    }

    /// Runs; `others` are the other modes of the scene.
    fn run_in_modes(mut self, others: &[P]) -> Result<Run, SetupError> {
        let mut system = System::new(self.scene.clone(), self.settings.backend)?;
        let start = self.settings.start_values(&system)?;
        let control = self.take_control(start.t, &mut system)?;
        let schedule = self.schedule(start.t, control.is_idle())?;
        let limits = self.settings.limits.checked()?;
        let events = if self.settings.watched { self.scene.info().events } else { &[] };
        let sample_times = self.settings.sample_times.of_run(start.t, self.settings.until_s)?;
        let Settings { wanted, streamed, start_moved_by, .. } = self.settings;
        let interrupts = self.hooks.interrupts.clone();
        let mut state = system.consistent_start(&start)?;
        let moved = system.moved_values(&start, &state);
        if start_moved_by > 0.0 {
            state = system.consistent_start(&estimated_run::beside(&state, start_moved_by))?;
        }
        let plan = Plan { schedule, sample_times, wanted, streamed, interrupts, moved, events };
        let mut stepper = self.stepper_in(system)?;
        stepper.place(&state);
        let watch =
            Watch::new(&mut stepper.system, &state, limits, self.settings.projection, self.settings.wanted.work);
        let others = others.iter().map(|scene| self.stepper_of(scene.clone())).collect::<Result<_, _>>()?;
        let modes = Modes::new(&stepper, others).map(Box::new);
        RunLoop::new(stepper, modes, control, plan, watch, self.hooks.recorder, self.hooks.on_progress)?.run()
    }

    /// Names of the start values that nobody gave and that the constraints leave free: the assembly begins with 0, and changes them as
    /// little as it can. Velocities are named where one is given that is not 0; otherwise the scene starts at rest.
    ///
    /// # Errors
    /// [`SetupError`] when the start cannot be assembled.
    pub fn free_start_values(&self) -> Result<Vec<Name>, SetupError> {
        match &self.scene.modes()[..] {
            [] => self.settings.free_start_values(self.scene.clone()),
            [first, ..] => self.settings.free_start_values(&**first),
        }
    }

    /// Hands the scene over to be stepped by the caller; end, limits, recording and progress are left to the caller, too.
    ///
    /// # Errors
    /// [`SetupError`] when the start or the step cannot be used.
    pub fn stepper(mut self) -> Result<Stepper<'s, P>, SetupError> {
        SetupError::refuse_modes(&self.scene.info())?;
        let mut system = System::new(self.scene.clone(), self.settings.backend)?;
        let start = self.settings.start_values(&system)?;
        let step_s = self.fixed_step()?;
        let control = self.take_control(start.t, &mut system)?;
        let state = system.consistent_start(&start)?;
        let stepper = self.stepper_in(system)?;
        let Settings { method, projection, metric, backend, wanted, .. } = &self.settings;
        let settings = vec![
            ("method", method.name().to_owned()),
            ("step", format!("{step_s:?} s")),
            ("projection", format!("{projection:?}")),
            ("metric", format!("{metric:?}")),
            ("backend", format!("{backend:?}")),
            ("works", wanted.work.to_string()),
        ];
        Ok(Stepper::new(stepper, control, step_s, settings, start, state))
    }

    fn stepper_of(&self, scene: P) -> Result<StepperState<P>, SetupError> {
        self.stepper_in(System::new(scene, self.settings.backend)?)
    }

    fn stepper_in(&self, system: System<P>) -> Result<StepperState<P>, SetupError> {
        StepperState::new(
            system,
            self.settings.method,
            self.settings.projection,
            self.settings.metric,
            self.settings.wanted.work,
        )
    }

    /// Tables and control law of the run; constant inputs are set at once. Of two settings of one input the later one counts.
    fn take_control(&mut self, start_s: f64, system: &mut System<P>) -> Result<Control<'s>, SetupError> {
        let mut control = Control { tables: Vec::new(), law: self.hooks.law.take() };
        for (name, table) in self.settings.inputs.drain(..) {
            let i = input_index(system.info(), &name)?;
            control.tables.retain(|(other, _)| *other != i);
            match table.constant() {
                Some(value) => system.inputs_mut()[i] = value,
                None => {
                    refuse_integrated(system.info(), i)?;
                    control.tables.push((i, table));
                }
            }
        }
        system.begin_inputs(start_s);
        Ok(control)
    }

    /// The fixed step of a method that has one.
    fn fixed_step(&self) -> Result<f64, SetupError> {
        let method = self.settings.method;
        method.step_s().map_or(Err(SetupError::NeedsFixedStep { method: method.name() }), check_step)
    }

    /// `idle`: whether inputs stay constant. Inputs that change are held over steps of fixed length.
    fn schedule(&self, start_s: f64, idle: bool) -> Result<Schedule, SetupError> {
        let until_s = self.settings.until_s;
        if !start_s.is_finite() {
            return Err(StartError::NotFinite { name: "t".into(), value: start_s }.into());
        }
        if !(until_s.is_finite() && until_s >= start_s) {
            return Err(SetupError::Until { until_s, start_s });
        }
        if let SampleTimes::Every(every_s) = self.settings.sample_times.of_run(start_s, until_s)? {
            let samples = (until_s - start_s) / every_s;
            let info = self.scene.info();
            let n_numbers = (info.n_coordinates() + 2 * info.n_velocities() + info.n_rows()).max(1) as f64;
            // what is streamed is limited as steps are
            let streamed = self.settings.streamed && !self.settings.estimated;
            let limit = if streamed { MAX_STEPS } else { MAX_NUMBERS / n_numbers };
            if samples > limit {
                return Err(SetupError::TooManySamples { samples, every_s, limit });
            }
            // the two runs beside it keep samples, too
            let n_runs = if self.settings.estimated { 3.0 } else { 1.0 };
            let needed = (n_runs * samples * n_numbers) as u64 * size_of::<f64>() as u64;
            if let Some(available) = memory::too_little_for(needed)
                && !streamed
            {
                return Err(SetupError::Memory { samples, every_s, needed, available });
            }
        }
        match self.settings.method.tolerance() {
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

impl Settings {
    /// The start of the scene with what is given in its place.
    fn start_values<P: SceneRef>(&self, system: &System<P>) -> Result<Start, SetupError> {
        let mut start = system.scene_start();
        for (name, value) in &self.given {
            give(system.info(), &mut start, name, *value)?;
        }
        if self.start_gives_way {
            start.give_way();
        }
        Ok(start)
    }

    fn free_start_values<P: SceneRef>(&self, scene: P) -> Result<Vec<Name>, SetupError> {
        let (mut system, start, state) = self.assembled(scene)?;
        Ok(system.free_values(&start, &state))
    }

    /// The scene with its constant inputs, its start, and the consistent state that belongs to it.
    pub(super) fn assembled<P: SceneRef>(&self, scene: P) -> Result<(System<P>, Start, State), SetupError> {
        let mut system = System::new(scene, self.backend)?;
        let start = self.start_values(&system)?;
        for (name, table) in &self.inputs {
            let i = input_index(system.info(), name)?;
            if let Some(value) = table.constant() {
                system.inputs_mut()[i] = value;
            }
        }
        system.begin_inputs(start.t);
        let state = system.consistent_start(&start)?;
        Ok((system, start, state))
    }
}

/// Value and rate of an input by acceleration follow from where they start.
fn refuse_integrated(info: &SceneInfo, i: usize) -> Result<(), SetupError> {
    let first = info.integrated_inputs.iter().find(|first| SceneInfo::integrated_places(**first).contains(&i));
    match first {
        Some(&first) => Err(SetupError::IntegratedInput { name: info.inputs[i].name, input: info.inputs[first].name }),
        None => Ok(()),
    }
}
