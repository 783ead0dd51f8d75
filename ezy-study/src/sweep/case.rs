//! One case of a sweep, and what became of it.

use super::finished::{Ended, Finished};
use super::kept::Reader;
use super::plan::{Plan, Value};
use super::trajectories::Trajectories;
use ezy_core::model::{Scene, SceneInfo, SceneRef};
use ezy_core::record::{Column, UnknownName};
use ezy_core::simulate::{Alone, Outcome, Run, SetupError, Simulation, WaitingRun};
use std::cell::RefCell;
use std::sync::atomic::AtomicBool;

/// A number that the caller reads from a run, with its column.
pub(super) type OwnNumber<'a> = (Column, Box<dyn Fn(&Run) -> f64 + Sync + 'a>);

/// A case: its number and its values.
pub struct Case<'a> {
    pub(super) index: u64,
    pub(super) plan: &'a Plan,
    pub(super) values: Vec<Value<'a>>,
    pub(super) reader: &'a Reader,
    pub(super) own: &'a [OwnNumber<'a>],
    pub(super) every_s: Option<f64>,
    pub(super) interrupts: [&'a AtomicBool; 2],
    /// When cases run in lanes.
    pub(super) left: Option<Left<'a>>,
    /// When whole trajectories are kept.
    pub(super) trajectories: Option<Trajectories<'a>>,
}

/// The scene that cases in lanes are of, and where a run is left to wait for others, or why it is not.
pub(super) type Left<'a> = (&'a SceneInfo, &'a RefCell<Result<WaitingRun, Alone>>);

/// Samples of a run from which extremes are taken, besides the first, when no interval is given.
const N_SAMPLES: f64 = 1000.0;

impl<'a> Case<'a> {
    /// Its number, from 0 on.
    pub fn index(&self) -> u64 {
        self.index
    }

    /// A value by its name in the plan.
    ///
    /// # Errors
    /// [`UnknownName`] when the plan does not vary it, or varies words.
    pub fn get(&self, name: &str) -> Result<f64, UnknownName> {
        match self.values[self.plan.index(name)?] {
            Value::Number(x) => Ok(x),
            Value::Word(_) => Err(self.of_other_kind("number", name)),
        }
    }

    /// A word by its name in the plan.
    ///
    /// # Errors
    /// [`UnknownName`] when the plan does not vary it, or varies numbers.
    pub fn word(&self, name: &str) -> Result<&'a str, UnknownName> {
        match self.values[self.plan.index(name)?] {
            Value::Word(word) => Ok(word),
            Value::Number(_) => Err(self.of_other_kind("word", name)),
        }
    }

    fn of_other_kind(&self, kind: &'static str, name: &str) -> UnknownName {
        let is_asked = |value: &Value<'_>| matches!(value, Value::Word(_)) == (kind == "word");
        let known = self.plan.names().into_iter().zip(&self.values).filter(|(_, value)| is_asked(value));
        let known = known.map(|(name, _)| name.to_owned()).collect();
        UnknownName { kind, name: name.to_owned(), nearest: None, known, remedy: None }
    }

    /// Values in the order of [`Plan::names`].
    pub fn values(&self) -> &[Value<'a>] {
        &self.values
    }

    /// Runs `simulation` with what the sweep keeps, and keeps that.
    ///
    /// # Errors
    /// [`SetupError`] when the run cannot start; the case is then a row without numbers that says why.
    pub fn run<'s, P: SceneRef>(&self, simulation: Simulation<'s, P>) -> Result<Finished, SetupError>
    where
        'a: 's,
    {
        let scene = simulation.scene().clone();
        if let Some((info, left)) = self.left {
            let of = scene.info();
            let is_same = of.identity() == info.identity();
            *left.borrow_mut() = if is_same { simulation.waiting() } else { Err("it is of another scene") };
            if left.borrow().is_ok() {
                return Ok(Finished::under_way());
            }
        }
        let mut simulation = simulation.outputs();
        for flag in self.interrupts {
            simulation = simulation.interrupted_by(flag);
        }
        if self.reader.needs_work {
            simulation = simulation.work();
        }
        if self.reader.needs_error {
            simulation = simulation.estimate_error();
        }
        if self.reader.needs_samples {
            simulation = simulation.sampled(self.every_s, N_SAMPLES);
        }
        let run = simulation.run()?;
        let (outcome, message) = match &run.outcome {
            Outcome::ReachedEnd => (Ended::ReachedEnd, String::new()),
            Outcome::ReachedEvent { name, .. } => (Ended::ReachedEvent(name), String::new()),
            other @ Outcome::Untrusted { .. } => (Ended::Untrusted, other.to_string()),
            Outcome::Interrupted { .. } => (Ended::Interrupted, String::new()),
            other => (Ended::Stopped, other.to_string()),
        };
        let mut numbers = self.reader.numbers(&*scene, &run)?;
        numbers.extend(self.own.iter().map(|(_, read)| read(&run)));
        let written = match self.trajectories {
            Some(trajectories) if outcome != Ended::Interrupted => trajectories.write(self.index, &run),
            _ => Ok(()),
        };
        let (t, n_steps) = (run.last().t, run.cost.steps);
        Ok(Finished { numbers, t, n_steps, outcome, message, unwritten: written.err() })
    }
}

/// Why a case has no run: any error that its closure met.
#[derive(Debug)]
pub struct Refused(pub(super) String);

impl Refused {
    /// Because of `why`.
    pub fn new(why: impl Into<String>) -> Self {
        Self(why.into())
    }
}

impl<E: std::error::Error> From<E> for Refused {
    fn from(error: E) -> Self {
        Self(error.to_string())
    }
}
