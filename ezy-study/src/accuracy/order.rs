//! The settings of a measurement.

use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use super::error::AccuracyError;
use super::ladder::Ladder;
use super::measured::{WorkPrecision, machine};
use super::point::{Point, PointResult, measure, repeats};
use super::reference::{Found, Reference};
use super::runs::{NoRun, Runs};
use super::variant::Variant;
use ezy_core::integrate::{Method, MethodKind};
use ezy_core::model::Scene;
use ezy_core::simulate::{PROCESSOR_TIME_IS_KNOWN, processor_time};

/// One measurement of a scene: its settings, then [`Accuracy::measure`].
pub struct Accuracy<'s> {
    scene: &'s dyn Scene,
    until_s: f64,
    given: Vec<(String, f64)>,
    inputs: Vec<(String, f64)>,
    budget_s: f64,
    ladder: Ladder,
    interrupt: Option<&'s AtomicBool>,
}

/// Default budget, s.
const BUDGET_S: f64 = 60.0;

/// Largest budget, s: thirty years. Beyond, the system's clock cannot represent the end.
const LONGEST_BUDGET_S: f64 = 1e9;

/// Part of the budget for the reference.
const REFERENCE_SHARE: f64 = 0.4;

/// Part of the budget after which other projections than the default one begin.
const MAIN_SHARE: f64 = 0.7;

/// Part of the remaining budget that one setting may take.
const POINT_SHARE: f64 = 0.5;

/// Tolerance of the run that estimates the step length, and the factor from its steps to those at the loosest tolerance: the
/// eighth root of a hundred.
const SCOUT_TOLERANCE: f64 = 1e-6;
const LONG_STEPS: f64 = 1.8;

/// Other projections than the default one take every second rung of the ladder.
const STRIDE: usize = 2;

/// A run on the grid, with works, takes about as long as this many runs that keep only their ends.
const ON_GRID: usize = 2;

/// With a hundredth of the tolerance a method of order 8 takes less than this factor of the time.
const ADAPTIVE_GROWTH: f64 = 2.0;

/// A setting to be measured.
struct Job {
    family: usize,
    method: Method,
    variant: Variant,
}

impl<'s> Accuracy<'s> {
    /// The scene from its own start to its own end, in at most a minute of processor time.
    pub fn new(scene: &'s dyn Scene) -> Self {
        let until_s = scene.info().until_s;
        let (given, inputs) = (Vec::new(), Vec::new());
        Self { scene, until_s, given, inputs, budget_s: BUDGET_S, ladder: Ladder::default(), interrupt: None }
    }

    /// End of the runs, s.
    #[must_use]
    pub fn until(mut self, until_s: f64) -> Self {
        self.until_s = until_s;
        self
    }

    /// Holds a start value by its name.
    #[must_use]
    pub fn start(mut self, name: impl Into<String>, value: f64) -> Self {
        self.given.push((name.into(), value));
        self
    }

    /// Sets an input for the whole run.
    #[must_use]
    pub fn input(mut self, name: impl Into<String>, value: f64) -> Self {
        self.inputs.push((name.into(), value));
        self
    }

    /// Budget of the measurement, s of processor time of this thread; settings that are not measured by then are listed.
    #[must_use]
    pub fn budget(mut self, budget_s: f64) -> Self {
        self.budget_s = budget_s;
        self
    }

    /// Tolerances and steps.
    #[must_use]
    pub fn ladder(mut self, ladder: Ladder) -> Self {
        self.ladder = ladder;
        self
    }

    /// Ends the measurement once `flag` is true: what was not measured by then is listed as interrupted.
    #[must_use]
    pub fn interrupted_by(mut self, flag: &'s AtomicBool) -> Self {
        self.interrupt = Some(flag);
        self
    }

    /// Measures; calls `progress` with the fraction done and the next task.
    ///
    /// # Errors
    /// [`AccuracyError`]: the settings cannot be used, there is no reference, or it was interrupted before there was one.
    pub fn measure(self, mut progress: impl FnMut(f64, &str)) -> Result<WorkPrecision, AccuracyError> {
        self.measured(&mut progress)
    }

    fn measured(self, progress: &mut dyn FnMut(f64, &str)) -> Result<WorkPrecision, AccuracyError> {
        let Self { scene, until_s, given, inputs, budget_s, ladder, interrupt } = self;
        if !(budget_s > 0.0 && budget_s <= LONGEST_BUDGET_S) {
            return Err(AccuracyError::Budget { budget_s, longest_s: LONGEST_BUDGET_S });
        }
        let (began, began_wall) = (processor_time(), Instant::now());
        let mut runs = Runs::new(scene, given, inputs, until_s, interrupt)?;
        if until_s == runs.start_s {
            return Err(AccuracyError::NoTime { until_s });
        }
        progress(0.0, "reference");
        let (reference, unknown) = find_reference(&mut runs, until_s, budget_s)?;
        let long_s = longest_step(&runs)?;
        let jobs = jobs(&Variant::all(&scene.info()), &ladder, long_s);
        let mut points: Vec<Point> = Vec::with_capacity(jobs.len());
        for (i, Job { family, method, variant }) in jobs.iter().enumerate() {
            let spent = (processor_time() - began).as_secs_f64();
            progress((i as f64 / jobs.len() as f64).max(spent / budget_s).min(1.0), MethodKind::ALL[*family].name());
            let share = if *variant == Variant::default() { MAIN_SHARE } else { 1.0 };
            let left = share * budget_s - spent;
            let affordable = match expected_seconds(&points, *method, *variant) {
                Some(seconds) => seconds * (ON_GRID + repeats(seconds)) as f64 <= POINT_SHARE * left,
                None => left > 0.0,
            };
            let result = match affordable {
                true => {
                    measure(&runs, *method, *variant, &reference, began + Duration::from_secs_f64(share * budget_s))
                }
                false => PointResult::NotRun,
            };
            let result = match (result, runs.is_interrupted()) {
                (PointResult::NotRun, true) => PointResult::Interrupted,
                (result, _) => result,
            };
            points.push(Point { method: *method, variant: *variant, result });
        }
        let seconds = (processor_time() - began).as_secs_f64();
        Ok(WorkPrecision {
            info: scene.info(),
            start_s: runs.start_s,
            until_s: runs.until_s,
            asked_until_s: until_s,
            unknown,
            reference,
            points,
            machine: machine(),
            budget_s,
            seconds,
            processor_share: PROCESSOR_TIME_IS_KNOWN.then(|| seconds / began_wall.elapsed().as_secs_f64().max(seconds)),
            interrupted: runs.is_interrupted(),
        })
    }
}

/// The reference. When it is not known up to the end, the runs are shortened, and the second number is the relative
/// difference of positions at the requested end.
fn find_reference(runs: &mut Runs<'_>, until_s: f64, budget_s: f64) -> Result<(Reference, Option<f64>), AccuracyError> {
    let budget = Duration::from_secs_f64(REFERENCE_SHARE * budget_s);
    let mut unknown = None;
    loop {
        match Reference::find(runs, budget)? {
            Found::Whole(reference) => return Ok((*reference, unknown)),
            Found::Until(t, difference) => {
                unknown = unknown.or(Some(difference));
                let shorter = Runs::new(runs.scene, runs.given.clone(), runs.inputs.clone(), t, runs.interrupt)?;
                debug_assert!(t < until_s, "a shorter run is shorter");
                *runs = shorter;
            }
        }
    }
}

/// A step that a method of order 8 takes at the loosest tolerance, s.
fn longest_step(runs: &Runs<'_>) -> Result<f64, AccuracyError> {
    let scout = Method::dop853(SCOUT_TOLERANCE);
    match runs.bare(scout, Variant::default()) {
        Ok(run) => Ok(LONG_STEPS * (runs.until_s - runs.start_s) / run.cost.steps.max(1) as f64),
        Err(NoRun::Setup(error)) => Err(error.into()),
        Err(NoRun::Interrupted) => Err(AccuracyError::Interrupted),
        Err(why) => Err(AccuracyError::NoReference { method: "dop853".to_owned(), outcome: why.to_string() }),
    }
}

/// The default projection first, from coarse to fine, methods in turn; then every second rung with the others.
fn jobs(variants: &[Variant], ladder: &Ladder, long_s: f64) -> Vec<Job> {
    let rungs: Vec<Vec<Method>> = MethodKind::ALL.iter().map(|kind| ladder.rungs(*kind, long_s)).collect();
    let n_rungs = rungs.iter().map(Vec::len).max().unwrap_or(0);
    let rung = |i: usize, variant: Variant| {
        let all = rungs.iter().enumerate();
        all.filter_map(move |(family, rungs)| rungs.get(i).map(|&method| Job { family, method, variant }))
    };
    let (first, others) = variants.split_at(1.min(variants.len()));
    let main = first.iter().flat_map(|&variant| (0..n_rungs).flat_map(move |i| rung(i, variant)));
    let others = (0..n_rungs).step_by(STRIDE).flat_map(|i| others.iter().flat_map(move |&variant| rung(i, variant)));
    main.chain(others).collect()
}

/// Seconds of a run by those of the rung before, when there is one; steps in proportion, tolerances with a reserve.
fn expected_seconds(points: &[Point], method: Method, variant: Variant) -> Option<f64> {
    let of_kind = |point: &&Point| point.variant == variant && point.method.name() == method.name();
    let before = points.iter().rev().find(of_kind)?;
    match &before.result {
        PointResult::Measured(measured) => {
            let growth = method.step_s().map_or(ADAPTIVE_GROWTH, |step_s| before.method.setting() / step_s);
            Some(growth * measured.seconds_min)
        }
        PointResult::Stopped(_) => None,
        PointResult::NotRun | PointResult::Interrupted => Some(f64::INFINITY),
    }
}
