//! A run, as a user orders it.

use super::control::{Control, Law};
use super::motion::Motion;
use super::run_loop::{Plan, RunLoop};
use super::{InputTable, Run, SetupError, Stepper};
use crate::dynamics::{Metric, Projection, StartError, State, System};
use crate::integrate::{Clock, Method};
use crate::linalg::Backend;
use crate::model::{Scene, SceneInfo, Start};
use crate::record::{Recorder, UnknownName, Wanted, find_name, input_index};

/// An order for one run of a scene.
///
/// ```text
/// let run = Simulation::new(&scene).method(Method::rk4(1e-3)).until(60.0).every(0.01).run()?;
/// println!("{} m", run.last().get("seat.x")?);
/// ```
pub struct Simulation<'s, S: Scene + ?Sized> {
    scene: &'s S,
    method: Method,
    until_s: f64,
    every_s: Option<f64>,
    projection: Projection,
    metric: Metric,
    backend: Backend,
    given: Vec<(String, f64)>,
    inputs: Vec<(String, InputTable)>,
    law: Option<Law<'s>>,
    wanted: Wanted,
    recorder: Option<&'s mut dyn Recorder>,
    on_progress: Option<Box<dyn FnMut(f64) + 's>>,
}

/// At 100 ns a step half an hour; more is a slip of the pen.
const MAX_STEPS: f64 = 1e10;

/// A few hundred bytes each: some gigabytes.
const MAX_SAMPLES: f64 = 1e7;

impl<'s, S: Scene + ?Sized> Simulation<'s, S> {
    /// The scene with its own end, RK4 at 1 ms, both projections, keeping the start and the end.
    pub fn new(scene: &'s S) -> Self {
        Self {
            scene,
            method: Method::default(),
            until_s: scene.info().until_s,
            every_s: None,
            projection: Projection::default(),
            metric: Metric::default(),
            backend: Backend::default(),
            given: Vec::new(),
            inputs: Vec::new(),
            law: None,
            wanted: Wanted::default(),
            recorder: None,
            on_progress: None,
        }
    }

    /// Integration method and its step.
    #[must_use]
    pub fn method(mut self, method: Method) -> Self {
        self.method = method;
        self
    }

    /// End of the run, s.
    #[must_use]
    pub fn until(mut self, until_s: f64) -> Self {
        self.until_s = until_s;
        self
    }

    /// Keeps a sample every `every_s`, besides the start and the end.
    ///
    /// Recording never changes the motion. A sample that falls on a step is the state of that step; one in between
    /// is interpolated ([`crate::integrate::interpolate`]), and its accelerations and multipliers are solved for at
    /// the interpolated state.
    #[must_use]
    pub fn every(mut self, every_s: f64) -> Self {
        self.every_s = Some(every_s);
        self
    }

    /// What is projected after each step.
    #[must_use]
    pub fn project(mut self, projection: Projection) -> Self {
        self.projection = projection;
        self
    }

    /// Metric of the projection.
    #[must_use]
    pub fn metric(mut self, metric: Metric) -> Self {
        self.metric = metric;
        self
    }

    /// Solver of the equations of motion.
    #[must_use]
    pub fn backend(mut self, backend: Backend) -> Self {
        self.backend = backend;
        self
    }

    /// Holds a start value, by the name of a coordinate (`seat.x`) or velocity (`seat.vx`), in place of the scene's
    /// own; what neither gives is assembled from the constraints.
    #[must_use]
    pub fn give(mut self, name: impl Into<String>, value: f64) -> Self {
        self.given.push((name.into(), value));
        self
    }

    /// Sets an input: a number, or an [`InputTable`] that is read in the middle of each step and held over it.
    #[must_use]
    pub fn input(mut self, name: impl Into<String>, value: impl Into<InputTable>) -> Self {
        self.inputs.push((name.into(), value.into()));
        self
    }

    /// Calls `law` at the start of every step with time, state and the inputs in their order ([`SceneInfo::inputs`]),
    /// each in its unit. What it leaves there is held over the step. It may keep a state of its own, and has the last
    /// word after [`Simulation::input`].
    ///
    /// ```
    /// # use ezy_core::prelude::*;
    /// model! {
    ///     pub model Cart {
    ///         body cart { mass: 2, inertia: 1 }
    ///         input push: N = 0;
    ///         force at cart(0, 0): (push, 0);
    ///         start here { cart at (0, 0) angle 0; at rest; }
    ///         scene pushed { start here; until 8 s; }
    ///     }
    /// }
    /// // to x = 1 m by a controller with an integral of its own
    /// let scene = cart::Pushed::default();
    /// let mut integral = 0.0;
    /// let run = Simulation::new(&scene)
    ///     .control(|_t, state, inputs| {
    ///         let error = 1.0 - state.q[0];
    ///         integral += error * 1e-3;
    ///         inputs[0] = 60.0 * error + 40.0 * integral - 20.0 * state.v[0];
    ///     })
    ///     .run()?;
    /// assert!((run.last().get("cart.x")? - 1.0).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn control(mut self, law: impl FnMut(f64, &State, &mut [f64]) + Send + 's) -> Self {
        self.law = Some(Box::new(law));
        self
    }

    /// Integrates the work of every effect with the motion, so that samples hold works and energy balance. The motion
    /// is the same to the last bit without.
    #[must_use]
    pub fn work(mut self) -> Self {
        self.wanted.work = true;
        self
    }

    /// Samples hold the outputs of the scene, too.
    #[must_use]
    pub fn outputs(mut self) -> Self {
        self.wanted.outputs = true;
        self
    }

    /// Also hands every sample to `recorder`, as it is made.
    #[must_use]
    pub fn record_to(mut self, recorder: &'s mut dyn Recorder) -> Self {
        self.recorder = Some(recorder);
        self
    }

    /// Calls `progress` with the fraction done, about a hundred times.
    #[must_use]
    pub fn on_progress(mut self, progress: impl FnMut(f64) + 's) -> Self {
        self.on_progress = Some(Box::new(progress));
        self
    }

    /// Runs.
    ///
    /// # Errors
    /// [`SetupError`] when the run cannot start. A run that stops on the way is not an error: [`Run::outcome`] says
    /// so, and everything up to there is kept.
    pub fn run(mut self) -> Result<Run, SetupError> {
        let mut system = System::new(self.scene, self.backend)?;
        let start = self.start(&system)?;
        let plan = Plan { clock: self.clock(start.t)?, every_s: self.every_s, wanted: self.wanted };
        let state = system.consistent_start(&start)?;
        let control = self.take_control(system.info())?;
        let mut motion = Motion::new(system, self.projection, self.metric, self.wanted.work);
        motion.place(&state);
        RunLoop::new(motion, control, plan, self.recorder, self.on_progress)?.run()
    }

    /// Hands the scene over to be stepped by the caller; end, recording and progress are left to the caller, too.
    ///
    /// # Errors
    /// [`SetupError`] when the start or the step cannot be used.
    pub fn stepper(mut self) -> Result<Stepper<'s, S>, SetupError> {
        let mut system = System::new(self.scene, self.backend)?;
        let start = self.start(&system)?;
        let step_s = self.check_step()?;
        let state = system.consistent_start(&start)?;
        let control = self.take_control(system.info())?;
        let motion = Motion::new(system, self.projection, self.metric, self.wanted.work);
        Ok(Stepper::new(motion, control, step_s, start, state))
    }

    /// The start of the scene with what is given in its place.
    fn start(&self, system: &System<'_, S>) -> Result<Start, SetupError> {
        let mut start = system.scene_start();
        for (name, value) in &self.given {
            give(system.info(), &mut start, name, *value)?;
        }
        Ok(start)
    }

    fn take_control(&mut self, info: &SceneInfo) -> Result<Control<'s>, SetupError> {
        let mut control = Control { tables: Vec::new(), law: self.law.take() };
        for (name, table) in self.inputs.drain(..) {
            control.tables.push((input_index(info, &name)?, table));
        }
        Ok(control)
    }

    fn check_step(&self) -> Result<f64, SetupError> {
        let Method::Rk4 { step_s } = self.method;
        if step_s.is_finite() && step_s > 0.0 { Ok(step_s) } else { Err(SetupError::Step { step_s }) }
    }

    fn clock(&self, start_s: f64) -> Result<Clock, SetupError> {
        let until_s = self.until_s;
        if !start_s.is_finite() {
            return Err(StartError::NotFinite { name: "t", value: start_s }.into());
        }
        if !(until_s.is_finite() && until_s >= start_s) {
            return Err(SetupError::Until { until_s, start_s });
        }
        let step_s = self.check_step()?;
        let steps = (until_s - start_s) / step_s;
        if steps > MAX_STEPS {
            return Err(SetupError::TooManySteps { steps, step_s, limit: MAX_STEPS });
        }
        if let Some(every_s) = self.every_s {
            if every_s.is_nan() || every_s <= 0.0 {
                return Err(SetupError::Every { every_s });
            }
            let samples = (until_s - start_s) / every_s;
            if samples > MAX_SAMPLES {
                return Err(SetupError::TooManySamples { samples, every_s, limit: MAX_SAMPLES });
            }
        }
        Ok(Clock::new(start_s, until_s, step_s))
    }
}

/// Holds a start value by its name.
pub(super) fn give(info: &SceneInfo, start: &mut Start, name: &str, value: f64) -> Result<(), UnknownName> {
    let positions = info.coordinates.iter().map(|c| c.name);
    let velocities = info.coordinates.iter().map(|c| c.velocity_name);
    let i = find_name("start value", name, positions.chain(velocities))?;
    match i.checked_sub(info.n_coordinates()) {
        None => start.give_position(i, value),
        Some(i) => start.give_velocity(i, value),
    }
    Ok(())
}
