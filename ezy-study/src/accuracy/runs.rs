//! The runs of a measurement: one scene, one start, one grid.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use super::variant::Variant;
use ezy_core::dynamics::SystemError;
use ezy_core::integrate::Method;
use ezy_core::model::{Scene, Start};
use ezy_core::record::{RecordError, Recorder, Sample};
use ezy_core::simulate::{Outcome, Run, SetupError, Simulation, StopReason, processor_time};

/// Intervals of the grid on which motions are compared.
const N_INTERVALS: usize = 100;

/// The settings that all runs share.
#[derive(Clone)]
pub(super) struct Runs<'s> {
    pub scene: &'s dyn Scene,
    pub given: Vec<(String, f64)>,
    pub inputs: Vec<(String, f64)>,
    /// s
    pub start_s: f64,
    /// s
    pub until_s: f64,
    /// Interval of the grid, s.
    pub every_s: f64,
    /// Ends the measurement when it is true.
    pub interrupt: Option<&'s AtomicBool>,
}

/// A run without a result.
pub(super) enum NoRun {
    /// The settings cannot be used.
    Setup(SetupError),
    /// It exceeded its time.
    Overtime,
    /// The measurement was interrupted.
    Interrupted,
    /// The motion ended early.
    Stopped(String),
}

impl<'s> Runs<'s> {
    pub(super) fn new(
        scene: &'s dyn Scene,
        given: Vec<(String, f64)>,
        inputs: Vec<(String, f64)>,
        until_s: f64,
        interrupt: Option<&'s AtomicBool>,
    ) -> Result<Self, SetupError> {
        SetupError::refuse_modes(&scene.info())?;
        let start_s = Start::declared(scene).map_err(SystemError::from)?.t;
        let every_s = (until_s - start_s) / N_INTERVALS as f64;
        Ok(Self { scene, given, inputs, start_s, until_s, every_s, interrupt })
    }

    /// Whether the measurement is to end.
    pub(super) fn is_interrupted(&self) -> bool {
        self.interrupt.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    fn simulation(&self, method: Method, variant: Variant) -> Simulation<'s, &'s (dyn Scene + 's)> {
        let order = Simulation::new(self.scene)
            .method(method)
            .until(self.until_s)
            .project(variant.projection)
            .metric(variant.metric)
            .without_events();
        let order = self.interrupt.into_iter().fold(order, Simulation::interrupted_by);
        let order = self.given.iter().fold(order, |order, (name, value)| order.start(name, *value));
        self.inputs.iter().fold(order, |order, (name, value)| order.input(name, *value))
    }

    /// A run that keeps its two ends.
    pub(super) fn bare(&self, method: Method, variant: Variant) -> Result<Run, NoRun> {
        finished(self.simulation(method, variant).run())
    }

    /// A run with a sample at every time of the grid, and works; it ends when the processor time is past
    /// `until`.
    pub(super) fn on_grid(&self, method: Method, variant: Variant, until: Duration) -> Result<Run, NoRun> {
        let mut deadline = Deadline(until);
        finished(self.simulation(method, variant).every(self.every_s).work().record_to(&mut deadline).run())
    }
}

fn finished(done: Result<Run, SetupError>) -> Result<Run, NoRun> {
    let run = match done {
        Ok(run) => run,
        Err(SetupError::Record(_)) => return Err(NoRun::Overtime),
        Err(error) => return Err(NoRun::Setup(error)),
    };
    match &run.outcome {
        // what a run with long steps is worth is measured
        Outcome::ReachedEnd | Outcome::Untrusted { .. } => Ok(run),
        Outcome::Stopped { reason: StopReason::Record(_), .. } => Err(NoRun::Overtime),
        Outcome::Interrupted { .. } => Err(NoRun::Interrupted),
        outcome => Err(NoRun::Stopped(outcome.to_string())),
    }
}

impl std::fmt::Display for NoRun {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Setup(error) => error.fmt(f),
            Self::Overtime => f.write_str("was not finished in the time given to it"),
            Self::Interrupted => f.write_str("was interrupted"),
            Self::Stopped(outcome) => f.write_str(outcome),
        }
    }
}

/// Refuses every sample after the deadline.
struct Deadline(Duration);

impl Recorder for Deadline {
    fn record(&mut self, sample: &Sample<'_>) -> Result<(), RecordError> {
        if processor_time() < self.0 {
            return Ok(());
        }
        let cause = io::Error::new(io::ErrorKind::TimedOut, "the time given to the measurement is over");
        Err(RecordError { t: sample.t, cause })
    }
}
