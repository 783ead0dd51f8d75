//! A scene from a start through the times of a reference, by EZY and by the naive program, with the same questions.

use super::case::{Check, Ended, Findings, Program};
use super::naive::Naive;
use super::subject::Subject;
use crate::garage::worse;
use ezy_core::dynamics::MotionError;
use ezy_core::model::Scene;
use ezy_core::prelude::*;
use ezy_core::simulate::{ExceededLimit, SetupError, StopReason};
use ezy_core_tests::simulation;

/// Recorded times this near to a reference's are the same, as a part of the whole run.
const SAME_TIME: f64 = 1e-12;

/// The motion at one time, from either program.
pub struct Seen<'a> {
    /// Time, s.
    pub t: f64,
    /// Coordinates.
    pub q: &'a [f64],
    /// Velocities.
    pub v: &'a [f64],
    /// Multipliers; of the naive program those of its last stage.
    pub lambda: &'a [f64],
    /// Change of the energy that no work accounts for, J; NaN where the naive program has no works.
    pub drift_j: f64,
    /// Largest |C|.
    pub gap: f64,
}

/// The error of one quantity.
type Error<'a, At> = Box<dyn Fn(At, &Seen<'_>) -> f64 + 'a>;

/// When a quantity is looked at.
enum When<'a> {
    /// At the times of the reference, by their index.
    Reference(Error<'a, usize>),
    /// At every sample.
    Always(Error<'a, ()>),
}

/// A quantity with its bound.
pub struct Question<'a> {
    what: &'static str,
    bound: f64,
    is_for_all: bool,
    when: When<'a>,
}

impl<'a> Question<'a> {
    /// Compared at the times of the reference, by their index.
    pub fn at_times(what: &'static str, bound: f64, error: impl Fn(usize, &Seen<'_>) -> f64 + 'a) -> Self {
        Self { what, bound, is_for_all: false, when: When::Reference(Box::new(error)) }
    }

    /// Looked at in every sample.
    pub fn always(what: &'static str, bound: f64, error: impl Fn(&Seen<'_>) -> f64 + 'a) -> Self {
        Self { what, bound, is_for_all: false, when: When::Always(Box::new(move |(), seen| error(seen))) }
    }

    /// The same, whatever the tolerance.
    pub fn for_all(self) -> Self {
        Self { is_for_all: true, ..self }
    }

    /// The rows of positions.
    pub fn gaps(bound: f64) -> Self {
        Self::always("gaps, m", bound, |seen| seen.gap).for_all()
    }

    /// The energy balance as a part of a scale, J.
    pub fn energy(bound: f64, scale_j: f64) -> Self {
        Self::always("energy, relative", bound, move |seen| seen.drift_j / scale_j)
    }
}

/// A scene with its start, the times of its reference, and what is asked.
pub struct Trial<'a> {
    /// The scene.
    pub scene: &'a dyn Scene,
    /// Start values by name.
    pub given: Vec<(String, f64)>,
    /// Times of the reference, s, ascending.
    pub times: Vec<f64>,
    /// What is asked.
    pub questions: Vec<Question<'a>>,
}

/// Fewest and most samples that a run keeps between its ends, for what must hold all the time.
const N_SAMPLES: std::ops::Range<u32> = 200..2000;

/// Steps that any scene may take.
const FEWEST: u64 = 1000;

impl<'a> Trial<'a> {
    /// From the start of the reference.
    pub fn new(subject: &'a Subject, times: Vec<f64>, questions: Vec<Question<'a>>) -> Self {
        Self { scene: &*subject.scene, given: subject.given(), times, questions }
    }

    /// Runs it.
    pub fn examine(&self, by: Program) -> Findings {
        let until_s = self.times.last().copied().unwrap_or_default();
        let mut errors = vec![f64::NAN; self.questions.len()];
        let mut findings = match self.run(by, until_s, Some(self.sampling(until_s))) {
            Ok(run) => {
                let ended = ended(&run.outcome);
                if ended == Ended::Reached {
                    errors = self.errors_of(by, &run);
                }
                let stopped = (!run.outcome.reached_end()).then(|| run.outcome.to_string());
                Findings { steps: run.cost.steps, stopped, ended: Some(ended), ..Findings::default() }
            }
            Err(error) => {
                let ended = Some(Ended::Refused(refusal(&error)));
                Findings { stopped: Some(error.to_string()), ended, ..Findings::default() }
            }
        };
        let check = |(question, &reached): (&Question<'_>, &f64)| Check {
            is_for_all: question.is_for_all,
            ..Check::new(question.what, question.bound, reached)
        };
        findings.checks = self.questions.iter().zip(&errors).map(check).collect();
        if let Some(step_s) = by.naive_step_s {
            self.add_naive(step_s, &mut findings);
        }
        findings
    }

    fn order(&self, method: Method) -> Simulation<'_, &dyn Scene> {
        let order = simulation(self.scene).method(method);
        self.given.iter().fold(order, |order, (name, value)| order.start(name.clone(), *value))
    }

    fn run(&self, by: Program, until_s: f64, every_s: Option<f64>) -> Result<Run, SetupError> {
        let order = self.order(by.method).until(until_s);
        let order = by.most.into_iter().fold(order, |order, most| order.max_steps(self.most_steps(most)));
        let order = if let Some(every_s) = every_s { order.every(every_s) } else { order };
        if self.scene.info().n_effects() > 0 { order.work().run() } else { order.run() }
    }

    /// Steps that may be taken, of so many steps times unknowns.
    fn most_steps(&self, most: u64) -> u64 {
        let n = (self.scene.info().n_coordinates() + self.scene.info().n_rows()) as u64;
        (most / n).max(FEWEST)
    }

    /// An interval of samples that meets all times of the reference, where there is one.
    fn sampling(&self, until_s: f64) -> f64 {
        let meets = |n: &u32| {
            let samples = self.times.iter().map(|t| t / until_s * f64::from(*n));
            samples.into_iter().all(|i| (i - i.round()).abs() <= SAME_TIME * i)
        };
        until_s / f64::from(N_SAMPLES.into_iter().find(meets).unwrap_or(N_SAMPLES.start))
    }

    /// Errors of a run and of shorter ones that end at times of the reference between two samples.
    fn errors_of(&self, by: Program, run: &Run) -> Vec<f64> {
        let mut errors = vec![0.0; self.questions.len()];
        let start_j = run.first().energy.kinetic + run.first().energy.potential;
        run.samples().for_each(|sample| self.look(None, &seen(&sample, start_j), &mut errors));
        let until_s = run.last().t;
        for (i, &t) in self.times.iter().enumerate() {
            let same = |sample: &Sample<'_>| (sample.t - t).abs() <= SAME_TIME * until_s;
            if let Some(sample) = run.samples().find(same) {
                self.look(Some(i), &seen(&sample, start_j), &mut errors);
                continue;
            }
            match self.run(by, t, None) {
                Ok(run) if run.outcome.reached_end() => self.look(Some(i), &seen(&run.last(), start_j), &mut errors),
                _ => self.missed(&mut errors),
            }
        }
        errors
    }

    /// A time of the reference was not reached.
    fn missed(&self, errors: &mut [f64]) {
        for (error, question) in errors.iter_mut().zip(&self.questions) {
            if matches!(question.when, When::Reference(_)) {
                *error = f64::NAN;
            }
        }
    }

    fn look(&self, time: Option<usize>, seen: &Seen<'_>, errors: &mut [f64]) {
        for (worst, question) in errors.iter_mut().zip(&self.questions) {
            let error = match (&question.when, time) {
                (When::Reference(error), Some(i)) => error(i, seen),
                (When::Always(error), _) => error((), seen),
                (When::Reference(_), None) => continue,
            };
            if !worst.is_nan() {
                *worst = worse(*worst, error);
            }
        }
    }

    /// The naive program from the same start, in equal steps from one time of the reference to the next.
    fn add_naive(&self, step_s: f64, findings: &mut Findings) {
        let alone = Program { method: Method::default(), naive_step_s: None, most: None };
        let Ok(start) = self.run(alone, 0.0, None) else { return };
        let (start, mut errors) = (start.first(), vec![0.0; self.questions.len()]);
        let mut naive = Naive::new(self.scene, start.coordinates, start.velocities);
        let (start_j, has_work) = (naive.energy(0.0), self.scene.info().n_effects() > 0);
        let (mut t, mut n_steps, mut fault) = (0.0, 0_u64, None);
        'run: for (i, &end) in self.times.iter().enumerate() {
            let n = ((end - t) / step_s - SAME_TIME).ceil().max(1.0);
            let (from, h) = (t, (end - t) / n);
            for k in 0..n as u64 {
                if let Err(why) = naive.step(from + k as f64 * h, h) {
                    fault = Some((from + k as f64 * h, why));
                    break 'run;
                }
                n_steps += 1;
                let is_last = k + 1 == n as u64;
                t = if is_last { end } else { from + (k + 1) as f64 * h };
                let drift_j = if has_work { f64::NAN } else { naive.energy(t) - start_j };
                let (q, v) = naive.state.split_at(naive.state.len() / 2);
                let seen = Seen { t, q, v, lambda: &naive.lambda, drift_j, gap: naive.gap(t) };
                self.look(is_last.then_some(i), &seen, &mut errors);
            }
        }
        let step = format!("h = {step_s:e} s: ");
        findings.naive_by = Some(match fault {
            None => format!("{step}{n_steps} steps"),
            Some((t, why)) => {
                errors.fill(f64::NAN);
                format!("{step}{why} from t = {t:.4} s")
            }
        });
        findings.checks.iter_mut().zip(&errors).for_each(|(check, &error)| check.naive = Some(error));
    }
}

fn seen<'r>(sample: &Sample<'r>, start_j: f64) -> Seen<'r> {
    let energy = sample.energy;
    let drift_j = if sample.wanted.work { energy.balance } else { energy.kinetic + energy.potential - start_j };
    let (t, gap) = (sample.t, sample.position_residual);
    Seen { t, q: sample.coordinates, v: sample.velocities, lambda: sample.multipliers, drift_j, gap }
}

fn ended(outcome: &Outcome) -> Ended {
    match outcome {
        Outcome::Stopped {
            reason: StopReason::Limit(ExceededLimit::Steps { .. } | ExceededLimit::Pace { .. }),
            ..
        } => Ended::Cut,
        Outcome::Stopped { reason: StopReason::Motion(error), .. } => Ended::Refused(word(error)),
        Outcome::Untrusted { .. } => Ended::Refused("not to be trusted"),
        Outcome::Stopped { .. } => Ended::Refused("stopped"),
        _ => Ended::Reached,
    }
}

fn refusal(error: &SetupError) -> &'static str {
    match error {
        SetupError::Motion(error) => word(error),
        SetupError::Start(_) => "start",
        _ => "not run by this method",
    }
}

fn word(error: &MotionError) -> &'static str {
    match error {
        MotionError::ContradictoryRows { .. } => "contradiction",
        MotionError::SingularPosition { .. } => "singular position",
        MotionError::LostInRounding { .. } => "lost in rounding",
        MotionError::LockedUp { .. } => "does not get past",
        MotionError::StepCollapsed { .. } => "step shrunk",
        MotionError::ProjectionStalled { .. } => "projection stalled",
        MotionError::NotFinite { .. } => "not finite",
        _ => "other",
    }
}
