//! A run, as a user orders it.

use super::run_loop::{Plan, RunLoop};
use super::{Run, SetupError};
use crate::dynamics::{Metric, Projection, StartError, System};
use crate::integrate::{Clock, Method};
use crate::linalg::Backend;
use crate::model::{Scene, SceneInfo, Start};
use crate::record::{Recorder, find_name};

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
    pub fn run(self) -> Result<Run, SetupError> {
        let mut system = System::new(self.scene, self.backend)?;
        let mut start = system.scene_start();
        for (name, value) in &self.given {
            give(system.info(), &mut start, name, *value)?;
        }
        let clock = self.clock(start.t)?;
        let state = system.consistent_start(&start)?;
        let plan = Plan { clock, every_s: self.every_s, projection: self.projection, metric: self.metric };
        RunLoop::new(system, plan, state, self.recorder, self.on_progress)?.run()
    }

    fn clock(&self, start_s: f64) -> Result<Clock, SetupError> {
        let until_s = self.until_s;
        if !start_s.is_finite() {
            return Err(StartError::NotFinite { name: "t", value: start_s }.into());
        }
        if !(until_s.is_finite() && until_s >= start_s) {
            return Err(SetupError::Until { until_s, start_s });
        }
        let Method::Rk4 { step_s } = self.method;
        if !(step_s.is_finite() && step_s > 0.0) {
            return Err(SetupError::Step { step_s });
        }
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

fn give(info: &SceneInfo, start: &mut Start, name: &str, value: f64) -> Result<(), SetupError> {
    let positions = info.coordinates.iter().map(|c| c.name);
    let velocities = info.coordinates.iter().map(|c| c.velocity_name);
    let i = find_name("start value", name, positions.chain(velocities))?;
    match i.checked_sub(info.n_coordinates()) {
        None => start.give_position(i, value),
        Some(i) => start.give_velocity(i, value),
    }
    Ok(())
}
