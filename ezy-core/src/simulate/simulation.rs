//! The settings of a run.

use super::inputs::control::Law;
use super::inputs::given::GivenStart;
use super::monitor::{Caller, Limits};
use super::recording::sample_times::{SampleTimes, Sampling};
use super::stepping::solver::Solver;
use super::{InputTable, Inputs, Now};
use crate::dynamics::{Metric, Projection, State};
use crate::integrate::Method;
use crate::linalg::Backend;
use crate::model::{NamedInputs, NamedScene, Scene as _, SceneRef};
use crate::record::Recorder;
use std::sync::atomic::AtomicBool;

/// One run of a scene: its settings, then [`Simulation::run`].
///
/// The scene is borrowed, `&scene`, or shared, `Arc::new(scene)`; a stepper that shares it lives as long as it likes.
///
/// ```
/// # use ezy_core::prelude::*;
/// # fn of(scene: &dyn Scene) -> Result<(), Box<dyn std::error::Error>> {
/// let run = Simulation::new(scene).method(Method::rk4(1e-3)).until(60.0).every(0.01).run()?;
/// println!("{} m", run.last().get("seat.x")?);
/// # Ok(())
/// # }
/// ```
pub struct Simulation<'s, P: SceneRef> {
    pub(super) scene: P,
    pub(super) settings: Settings,
    pub(super) hooks: Hooks<'s>,
}

/// What a run is asked for.
#[derive(Debug, Clone)]
pub(super) struct Settings {
    pub solver: Solver,
    pub start: GivenStart,
    pub until_s: f64,
    pub inputs: Vec<(String, InputTable)>,
    pub sampling: Sampling,
    pub limits: Limits,
    /// Whether events are located.
    pub watched: bool,
    /// Whether other runs estimate the error of this one.
    pub estimated: bool,
}

/// What takes part in one run alone.
#[derive(Default)]
pub(super) struct Hooks<'s> {
    pub law: Option<Law<'s>>,
    pub recorder: Option<&'s mut dyn Recorder>,
    pub caller: Caller<'s>,
}

impl<'s, P: SceneRef> Simulation<'s, P> {
    /// The scene with its own end, DOP853 at 1e-9 ([`Method::default`]), both projections, keeping the start and the end: two samples, and
    /// more by [`Simulation::every`] or [`Simulation::at`].
    pub fn new(scene: P) -> Self {
        let settings = Settings {
            solver: Solver::default(),
            start: GivenStart::default(),
            until_s: scene.info().until_s,
            inputs: Vec::new(),
            sampling: Sampling::default(),
            limits: Limits::default(),
            watched: true,
            estimated: false,
        };
        Self { scene, settings, hooks: Hooks::default() }
    }

    /// Integration method, and its tolerance or step; a relative tolerance below [`Tolerance::SMALLEST_RELATIVE`](crate::integrate::Tolerance::SMALLEST_RELATIVE) is lifted to it
    /// ([`Method::lifted`]). Control laws, input tables and steppers need a fixed step: `Method::rk4(1e-3)`.
    #[must_use]
    pub fn method(mut self, method: Method) -> Self {
        self.settings.solver.method = method.lifted();
        self
    }

    /// End of the run, s.
    #[must_use]
    pub fn until(mut self, until_s: f64) -> Self {
        self.settings.until_s = until_s;
        self
    }

    /// Keeps a sample every `every_s` seconds, besides the start and the end. It replaces [`Simulation::at`].
    ///
    /// Recording never changes the motion. A sample that falls on a step is the state of that step; one in between
    /// is interpolated, and its accelerations and multipliers are solved for at
    /// the interpolated state.
    #[must_use]
    pub fn every(mut self, every_s: f64) -> Self {
        self.settings.sampling.times = SampleTimes::Every(every_s);
        self
    }

    /// Keeps samples at these times, s, in any order, besides the start and the end. It replaces [`Simulation::every`].
    ///
    /// ```
    /// use ezy_core::prelude::*;
    ///
    /// model! {
    ///     pub model Throw {
    ///         body ball { mass: 1, inertia: 1 }
    ///         gravity (0, -10);
    ///         start up { ball at (0, 0) velocity (3, 12); }
    ///         scene flight { start up; until 2 s; }
    ///     }
    /// }
    ///
    /// let run = Simulation::new(&throw::Flight::default()).at([1.5, 0.25]).run()?;
    /// let times: Vec<f64> = run.samples().map(|sample| sample.t).collect();
    /// assert_eq!(times, [0.0, 0.25, 1.5, 2.0]);
    /// # Ok::<(), ezy_core::simulate::SetupError>(())
    /// ```
    #[must_use]
    pub fn at(mut self, times_s: impl IntoIterator<Item = f64>) -> Self {
        self.settings.sampling.times = SampleTimes::At(times_s.into_iter().collect());
        self
    }

    /// Keeps samples `every_s` seconds apart, or `n` of the run, unless their times were given before.
    #[must_use]
    pub fn sampled(mut self, every_s: Option<f64>, n: f64) -> Self {
        let span = self.settings.until_s;
        if let (SampleTimes::Never, Some(every_s)) =
            (&self.settings.sampling.times, every_s.or((span > 0.0).then_some(span / n)))
        {
            self.settings.sampling.times = SampleTimes::Every(every_s);
        }
        self
    }

    /// The scene.
    pub fn scene(&self) -> &P {
        &self.scene
    }

    /// What is projected after each step.
    #[must_use]
    pub fn project(mut self, projection: Projection) -> Self {
        self.settings.solver.projection = projection;
        self
    }

    /// Metric of the projection.
    #[must_use]
    pub fn metric(mut self, metric: Metric) -> Self {
        self.settings.solver.metric = metric;
        self
    }

    /// Solver of the equations of motion.
    #[must_use]
    pub fn backend(mut self, backend: Backend) -> Self {
        self.settings.solver.backend = backend;
        self
    }

    /// Holds a start value, by the name of a coordinate (`seat.x`) or velocity (`seat.vx`), in place of the scene's
    /// own; what neither gives is assembled from the constraints.
    #[must_use]
    pub fn start(mut self, name: impl Into<String>, value: f64) -> Self {
        self.settings.start.values.push((name.into(), value));
        self
    }

    /// Projects a start that contradicts the constraints onto them, in place of refusing it.
    ///
    /// Given values are held as long as the rows can be met with them. Where they cannot, they move as little as possible in the
    /// metric of the masses: centres first, then angles with them, by `δᵀ M δ`; then velocities so that
    /// `(v − v₀)ᵀ M (v − v₀)` is smallest, as after an impulse that closes the joints. Angles count with moments of inertia, so metres and radians
    /// are never added; coordinates without mass follow at no cost.
    #[must_use]
    pub fn project_start(mut self) -> Self {
        self.settings.start.gives_way = true;
        self
    }

    /// Sets an input: a number, or an [`InputTable`] that is read in the middle of each fixed step and held over it. Of two
    /// settings of one input the later counts.
    #[must_use]
    pub fn input(mut self, name: impl Into<String>, value: impl Into<InputTable>) -> Self {
        self.settings.inputs.push((name.into(), value.into()));
        self
    }

    /// Calls `law` at the start of every step with what there is now and the inputs to set, both by the names of the model file. What
    /// it leaves in the inputs is held over the step. It may keep a state of its own, and has the last word after
    /// [`Simulation::input`]. A wrong name is a compile error. The method must have a fixed step.
    ///
    /// ```
    /// # use ezy_core::prelude::*;
    /// model! {
    ///     pub model Cart {
    ///         body cart { mass: 2, inertia: 1 }
    ///         input push: N = 0;
    ///         output ahead: cm = cart.x;
    ///         force at cart(0, 0): (push, 0);
    ///         start here { cart at (0, 0) angle 0; at rest; }
    ///         scene pushed { start here; until 8 s; }
    ///     }
    /// }
    /// // to x = 1 m by a controller with an integral of its own
    /// let scene = cart::Pushed::default();
    /// let mut integral = 0.0;
    /// let run = Simulation::new(&scene)
    ///     .method(Method::rk4(1e-3)) // the sampling time of the controller
    ///     .control(|now, set| {
    ///         let error = 1.0 - now.cart.x;
    ///         integral += error * 1e-3;
    ///         set.push = 60.0 * error + 40.0 * integral - 20.0 * now.cart.vx;
    ///     })
    ///     .run()?;
    /// assert!((run.last().get("cart.x")? - 1.0).abs() < 1e-3);
    ///
    /// // or a function, which reads an output
    /// fn brake(now: &Now<cart::Pushed>, set: &mut Inputs<cart::Pushed>) {
    ///     set.push = if now.outputs().ahead > 50.0 { -20.0 * now.cart.vx } else { 1.0 };
    /// }
    /// let run = Simulation::new(&scene).method(Method::rk4(1e-3)).control(brake).run()?;
    /// assert!(run.last().get("cart.vx")?.abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// A name that the model does not declare:
    ///
    /// ```compile_fail,E0609
    /// # use ezy_core::prelude::*;
    /// # model! {
    /// #     pub model Cart {
    /// #         body cart { mass: 2, inertia: 1 }
    /// #         input push: N = 0;
    /// #         force at cart(0, 0): (push, 0);
    /// #         start here { cart at (0, 0) angle 0; at rest; }
    /// #         scene pushed { start here; until 8 s; }
    /// #     }
    /// # }
    /// let scene = cart::Pushed::default();
    /// let order = Simulation::new(&scene).control(|now, set| set.pull = -now.cart.x);
    /// // error[E0609]: no field `pull` on type `&mut PushedInputs`; available field is: `push`
    /// ```
    #[must_use]
    pub fn control(mut self, mut law: impl FnMut(&Now<'_, P::Target>, &mut Inputs<P::Target>) + Send + 's) -> Self
    where
        P: Send + 's,
        P::Target: NamedScene,
    {
        let scene = self.scene.clone();
        let mut room = vec![0.0; scene.info().n_outputs()];
        self.hooks.law = Some(Box::new(move |state, controlled| {
            let mut set = Inputs::<P::Target>::read(controlled.inputs());
            law(&Now::new(&scene, state, controlled, &mut room), &mut set);
            set.write(controlled.inputs_mut());
        }));
        self
    }

    /// As [`Simulation::control`], for programs that take any scene (`dyn Scene`): `law` gets time, state and the inputs in the order of
    /// [`SceneInfo::inputs`](crate::model::SceneInfo::inputs), each in its unit. [`input_index`](crate::record::input_index) and
    /// [`coordinate_index`](crate::record::coordinate_index) find the places of names.
    #[must_use]
    pub fn control_by_index(mut self, mut law: impl FnMut(f64, &State, &mut [f64]) + Send + 's) -> Self {
        self.hooks.law = Some(Box::new(move |state, controlled| law(state.t, state, controlled.inputs_mut())));
        self
    }

    /// Integrates the work of every effect with the motion, so that samples hold works and energy balance. The motion
    /// is the same to the last bit without.
    #[must_use]
    pub fn work(mut self) -> Self {
        self.settings.sampling.wanted.work = true;
        self
    }

    /// Samples hold the power of each effect, and of the forces with a potential, too.
    #[must_use]
    pub fn power(mut self) -> Self {
        self.settings.sampling.wanted.power = true;
        self
    }

    /// Samples hold the outputs of the scene, too.
    #[must_use]
    pub fn outputs(mut self) -> Self {
        self.settings.sampling.wanted.outputs = true;
        self
    }

    /// Ends the run before a state in which a row is violated by more than this: at position level, m or rad, or at velocity
    /// level, m/s or rad/s. Where both are projected a run keeps to 1e-12 by itself; without projection rows drift.
    #[must_use]
    pub fn max_drift(mut self, residual: f64) -> Self {
        self.settings.limits.drift = residual;
        self
    }

    /// Ends the run before a state whose energy balance is more than this part of the energy turned over
    /// ([`EnergyError::relative`](super::EnergyError::relative)). Integrates works, as [`Simulation::work`].
    #[must_use]
    pub fn max_energy_error(mut self, relative: f64) -> Self {
        self.settings.limits.energy_error = relative;
        self.work()
    }

    /// Ends the run after this many steps, rejected ones included. Without it, methods that choose their steps try ten million at
    /// most, and end as soon as their pace shows that the end needs more ([`ExceededLimit::Pace`](super::ExceededLimit::Pace)).
    #[must_use]
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.settings.limits.steps = Some(steps);
        self
    }

    /// Estimates the error that the run reaches, by a second and a third run beside it on other cores ([`Run::error_estimate`]). Then
    /// samples are kept also where they are streamed.
    ///
    /// The second run keeps to a thousandth of the tolerance, or to 1e-13 by dop853 beside fixed steps: the difference, and what the second may be off by itself, is the error. The third one shows by
    /// a start that is moved a little how much the motion amplifies errors. The run itself is the same to the last bit.
    ///
    /// ```
    /// # use ezy_core::prelude::*;
    /// # fn of(scene: &dyn Scene) -> Result<(), Box<dyn std::error::Error>> {
    /// let run = Simulation::new(scene).method(Method::dop853(1e-6)).every(0.1).estimate_error().run()?;
    /// if let Some(Ok(estimate)) = &run.error_estimate {
    ///     for error in &estimate.errors {
    ///         println!("{} {:.1e} {}", error.quantity, error.largest, error.unit);
    ///     }
    /// }
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`SetupError::ControlledOnce`](super::SetupError::ControlledOnce) from [`Simulation::run`] when a control law is set.
    ///
    /// [`Run::error_estimate`]: super::Run::error_estimate
    #[must_use]
    pub fn estimate_error(mut self) -> Self {
        self.settings.estimated = true;
        self
    }

    /// Locates no events: the run continues through conditions that would end it.
    #[must_use]
    pub fn without_events(mut self) -> Self {
        self.settings.watched = false;
        self
    }

    /// Also hands every sample to `recorder`, as it is made. Samples are those of [`Simulation::every`] or [`Simulation::at`]: without
    /// them a recorder gets two, the start and the end.
    #[must_use]
    pub fn record_to(mut self, recorder: &'s mut dyn Recorder) -> Self {
        self.hooks.recorder = Some(recorder);
        self
    }

    /// Hands every sample to `recorder`, as it is made, and keeps only the first and the last: memory does not grow with the
    /// number of samples. Without [`Simulation::every`] or [`Simulation::at`] a recorder gets two, the start and the end.
    #[must_use]
    pub fn stream_to(mut self, recorder: &'s mut dyn Recorder) -> Self {
        self.settings.sampling.streamed = true;
        self.record_to(recorder)
    }

    /// Ends the run with [`Outcome::Interrupted`](super::Outcome::Interrupted) once `flag` is true, which is read before each step. Another
    /// thread or a signal handler sets it. Of several flags each one ends the run.
    #[must_use]
    pub fn interrupted_by(mut self, flag: &'s AtomicBool) -> Self {
        self.hooks.caller.interrupts.push(flag);
        self
    }

    /// Calls `progress` with the fraction done, about a hundred times.
    #[must_use]
    pub fn on_progress(mut self, progress: impl FnMut(f64) + Send + 's) -> Self {
        self.hooks.caller.on_progress = Some(Box::new(progress));
        self
    }
}

/// A run of any scene, so that unit tests do not compile the solver for each of fifty types.
#[cfg(test)]
pub(crate) fn simulation<'s>(scene: &'s (dyn crate::model::Scene + 's)) -> Simulation<'s, &'s dyn crate::model::Scene> {
    Simulation::new(scene)
}
