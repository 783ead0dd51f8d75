//! Neighbouring cases that a thread computes one after the other, or in lanes.

use super::case::{Case, Left, OwnNumber, Refused};
use super::finished::{Ended, Finished};
use super::kept::Reader;
use super::plan::Plan;
use super::row::Row;
use super::trajectories::Trajectories;
use ezy_core::model::SceneInfo;
use ezy_core::simulate::{Alone, EndOfRun, WaitingRun};
use std::cell::RefCell;
use std::io;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

/// Runs one case.
pub(super) type Runner<'a> = dyn Fn(&Case<'_>) -> Result<Finished, Refused> + Sync + 'a;

/// Runs cases of one scene in lanes.
pub(super) type Together<'a> = dyn Fn(&[WaitingRun], &[&AtomicBool]) -> Vec<Result<EndOfRun, Alone>> + Sync + 'a;

/// What became of a case.
pub(super) struct Computed {
    pub row: Row,
    /// Why it failed.
    pub failure: Option<String>,
    /// Why it ran by itself, when cases run in lanes.
    pub alone: Option<Alone>,
    /// A file that could not be written, which ends the sweep.
    pub unwritten: Option<(PathBuf, io::Error)>,
}

/// How groups of cases are computed.
pub(super) struct Group<'a> {
    pub plan: &'a Plan,
    pub runner: &'a Runner<'a>,
    /// When cases run in lanes, and of which scene.
    pub together: Option<(&'a SceneInfo, &'a Together<'a>)>,
    pub reader: &'a Reader,
    pub own: &'a [OwnNumber<'a>],
    pub every_s: Option<f64>,
    pub trajectories: Option<Trajectories<'a>>,
    /// One that is set ends the work.
    pub interrupts: [&'a AtomicBool; 2],
}

impl Group<'_> {
    /// Computes the cases that are `asked` for of the `whole` group, on which alone the results depend; `None` once a flag is set.
    pub(super) fn compute(&self, whole: Range<u64>, asked: &Range<u64>) -> Option<Vec<Computed>> {
        let Some((info, together)) = self.together else {
            return asked.clone().map(|index| self.run(index, None)).collect();
        };
        let (mut waiting, mut indices) = (Vec::new(), Vec::new());
        let mut computed = Vec::new();
        for index in whole {
            let left = RefCell::new(Err("it is not run by `Case::run`"));
            let result = self.run_case(index, Some((info, &left)));
            match (result, left.into_inner()) {
                (Ok(_), Ok(run)) => {
                    waiting.push(run);
                    indices.push(index);
                }
                (result, left) => computed.push(self.computed(index, result, left.err())?),
            }
        }
        for (index, end) in indices.into_iter().zip(together(&waiting, &self.interrupts)) {
            if !asked.contains(&index) {
                continue;
            }
            computed.push(match end {
                Ok(end) => {
                    let finished = Finished::at_end(self.reader.numbers_of_end(&end), end.t, end.n_steps);
                    Computed { row: self.row(index, Ok(finished)), failure: None, alone: None, unwritten: None }
                }
                Err(why) => self.run(index, Some(why))?,
            });
        }
        computed.retain(|computed| asked.contains(&computed.row.index));
        computed.sort_by_key(|computed| computed.row.index);
        Some(computed)
    }

    /// A case by itself.
    fn run(&self, index: u64, alone: Option<Alone>) -> Option<Computed> {
        self.computed(index, self.run_case(index, None), alone)
    }

    fn run_case(&self, index: u64, left: Option<Left<'_>>) -> Result<Finished, Refused> {
        let Self { plan, reader, own, every_s, interrupts, trajectories, .. } = *self;
        if interrupts[0].load(Ordering::Relaxed) {
            return Ok(Finished::under_way());
        }
        (self.runner)(&Case {
            index,
            plan,
            values: plan.values(index),
            reader,
            own,
            every_s,
            interrupts,
            left,
            trajectories,
        })
    }

    fn computed(&self, index: u64, mut run: Result<Finished, Refused>, alone: Option<Alone>) -> Option<Computed> {
        let unwritten = run.as_mut().ok().and_then(|run| run.unwritten.take());
        let failure = match &run {
            Ok(Finished { outcome: Ended::Interrupted, .. }) => return None,
            Ok(run) if run.outcome.is_good() => None,
            Ok(run) => Some(run.message.clone()),
            Err(Refused(why)) => Some(why.clone()),
        };
        Some(Computed { row: self.row(index, run.map_err(|Refused(why)| why)), failure, alone, unwritten })
    }

    fn row(&self, index: u64, run: Result<Finished, String>) -> Row {
        Row::new(index, &self.plan.values(index), self.reader.columns.len() + self.own.len(), run)
    }
}
