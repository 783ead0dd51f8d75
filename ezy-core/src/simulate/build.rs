//! From a [`Simulation`] to a run or a stepper: its settings are checked, then the start is assembled.

use super::checked::check_tolerance;
use super::inputs::control::Control;
use super::modes::{Modes, fault_of_laws};
use super::monitor::Watch;
use super::recording::sample_times::{SampleTimes, Sampling};
use super::run_loop::{Plan, RunLoop};
use super::several::estimated_run;
use super::simulation::{Hooks, Settings};
use super::stepping::schedule::Schedule;
use super::stepping::starts::Starts;
use super::tolerances::orders::{MAX_NUMBERS, MAX_STEPS};
use super::{Run, SetupError, Simulation, Stepper};
use crate::dynamics::{StartError, State, System};
use crate::integrate::Clock;
use crate::memory;
use crate::model::{AsDynScene as _, Name, Scene, SceneInfo, SceneRef, Start};
use crate::record::input_index;

impl Simulation<'_, &dyn Scene> {
    /// Runs without an estimate of the error.
    pub(super) fn run_once(mut self) -> Result<Run, SetupError> {
        let mut system = self.settings.solver.system(self.scene)?;
        let start = self.settings.start.of_scene(&system)?;
        let control = self.take_control(start.t, &mut system)?;
        let schedule = self.schedule(start.t, control.is_idle())?;
        let limits = self.settings.limits.checked()?;
        let events = if self.settings.watched { self.scene.info().events } else { &[] };
        let Settings { solver, ref sampling, until_s, .. } = self.settings;
        let (moved_by, wanted) = (self.settings.start.moved_by, sampling.wanted);
        let sampling = Sampling { times: sampling.times.of_run(start.t, until_s)?, ..*sampling };
        let assembled = system.consistent_start(&start);
        let of_law = |system| fault_of_laws(system, start.t, &start.q, &start.v);
        let mut state = assembled.map_err(|error| of_law(&system).map_or(SetupError::from(error), SetupError::from))?;
        let moved = system.moved_values(&start, &state);
        if moved_by > 0.0 {
            state = system.consistent_start(&estimated_run::beside(&state, moved_by))?;
        }
        let mut stepper = solver.stepper(system, wanted.work)?;
        stepper.place(&state);
        let watch = Watch::new(&mut stepper.system, &state, limits, solver.projection, wanted.work);
        // a long chain has better use for their memory
        drop((start, state));
        let modes = Modes::new(&stepper).map(Box::new);
        let Hooks { recorder, caller, .. } = self.hooks;
        let plan = Plan { schedule, sampling, recorder, caller, events };
        RunLoop::new(stepper, modes, control, plan, watch)?.run(moved)
    }
}

impl<'s, P: SceneRef> Simulation<'s, P> {
    /// Runs.
    ///
    /// # Errors
    /// [`SetupError`] when the run cannot start. A run that stops on the way is not an error: [`Run::outcome`] says
    /// so, and everything up to there is kept.
    pub fn run(self) -> Result<Run, SetupError> {
        let Self { scene, settings, hooks } = self;
        // behind its trait, so that the loop is compiled with this crate, once
        let simulation = Simulation { scene: scene.as_dyn(), settings, hooks };
        if simulation.settings.estimated { estimated_run::run(simulation) } else { simulation.run_once() }
    }

    /// Names of the start values that nobody gave and that the constraints leave free: the assembly begins with 0, and changes them as
    /// little as it can. Velocities are named where one is given that is not 0; otherwise the scene starts at rest.
    ///
    /// # Errors
    /// [`SetupError`] when the start cannot be assembled.
    pub fn free_start_values(&self) -> Result<Vec<Name>, SetupError> {
        let (mut system, start, state) = self.settings.assembled(self.scene.as_dyn())?;
        Ok(system.assembly().free_values(&start, &state))
    }

    /// The scene with its constant inputs and its start, for what is no run.
    ///
    /// # Errors
    /// [`SetupError`] when the scene, an input or the start cannot be used.
    #[cfg(feature = "analysis")]
    pub fn system_at_start(self) -> Result<(System<P>, Start), SetupError> {
        let (system, start, _) = self.settings.assembled(self.scene.clone())?;
        Ok((system, start))
    }

    /// Hands the scene over to be stepped by the caller; end, limits, recording and progress are left to the caller, too.
    ///
    /// # Errors
    /// [`SetupError`] when the start or the step cannot be used.
    pub fn stepper(mut self) -> Result<Stepper<'s, P>, SetupError> {
        SetupError::refuse_modes(&self.scene.info())?;
        let solver = self.settings.solver;
        let mut system = solver.system(self.scene.clone())?;
        let start = self.settings.start.of_scene(&system)?;
        let step_s = solver.fixed_step()?;
        let control = self.take_control(start.t, &mut system)?;
        let state = system.consistent_start(&start)?;
        let starts = Starts::new(system.inputs(), start, state);
        let stepper = solver.stepper(system, self.settings.sampling.wanted.work)?;
        Ok(Stepper::new(stepper, control, solver, step_s, starts))
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
        system.integrated_inputs().begin(start_s);
        Ok(control)
    }

    /// `idle`: whether inputs stay constant. Inputs that change are held over steps of fixed length.
    fn schedule(&self, start_s: f64, idle: bool) -> Result<Schedule, SetupError> {
        let Settings { solver, sampling, until_s, estimated, .. } = &self.settings;
        let until_s = *until_s;
        if !start_s.is_finite() {
            return Err(StartError::NotFinite { name: "t".into(), value: start_s }.into());
        }
        if !(until_s.is_finite() && until_s >= start_s) {
            return Err(SetupError::Until { until_s, start_s });
        }
        if let SampleTimes::Every(every_s) = sampling.times.of_run(start_s, until_s)? {
            let samples = (until_s - start_s) / every_s;
            let info = self.scene.info();
            let n_numbers = (info.n_coordinates() + 2 * info.n_velocities() + info.n_rows()).max(1) as f64;
            // what is streamed is limited as steps are
            let streamed = sampling.streamed && !estimated;
            let limit = if streamed { MAX_STEPS } else { MAX_NUMBERS / n_numbers };
            if samples > limit {
                return Err(SetupError::TooManySamples { samples, every_s, limit });
            }
            // the two runs beside it keep samples, too
            let n_runs = if *estimated { 3.0 } else { 1.0 };
            let needed = (n_runs * samples * n_numbers) as u64 * size_of::<f64>() as u64;
            if let Some(available) = memory::too_little_for(needed)
                && !streamed
            {
                return Err(SetupError::Memory { samples, every_s, needed, available });
            }
        }
        match solver.method.tolerance() {
            Some(tolerance) if idle => {
                check_tolerance(tolerance)?;
                Ok(Schedule::new(None, until_s))
            }
            _ => {
                let step_s = solver.fixed_step()?;
                let steps = (until_s - start_s) / step_s;
                if steps > MAX_STEPS {
                    return Err(SetupError::TooManySteps { steps, step_s, limit: MAX_STEPS });
                }
                Ok(Schedule::new(Some(Clock::new(start_s, until_s, step_s)), until_s))
            }
        }
    }
}

impl Settings {
    /// The scene with its constant inputs, its start, and the consistent state that belongs to it.
    pub(super) fn assembled<P: SceneRef>(&self, scene: P) -> Result<(System<P>, Start, State), SetupError> {
        let mut system = self.solver.system(scene)?;
        let start = self.start.of_scene(&system)?;
        for (name, table) in &self.inputs {
            let i = input_index(system.info(), name)?;
            if let Some(value) = table.constant() {
                system.inputs_mut()[i] = value;
            }
        }
        system.integrated_inputs().begin(start.t);
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
