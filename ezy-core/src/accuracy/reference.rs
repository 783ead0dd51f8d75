//! The reference motion: in double-double where the scene has a Taylor series, otherwise the run of DOP853 with the smallest
//! tolerance.

use std::time::{Duration, Instant};

use super::command::command;
use super::error::AccuracyError;
use super::errors::{Comparison, Errors, Scales, Size, compare, difference};
use super::precise::{NAME, precise};
use super::runs::{NoRun, Runs};
use super::second::Second;
use super::trajectory::Trajectory;
use super::variant::Variant;
use crate::integrate::Method;
use crate::simulate::Run;

/// Tolerances from the tightest on, until two runs have reached the end.
const TOLERANCES: [f64; 6] = [1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10];

/// Two reference runs that differ by more than this relative difference give no reference.
const KNOWN: f64 = 1e-6;

/// A reference motion and its uncertainty.
#[derive(Debug, Clone)]
pub struct Reference {
    /// How it was made.
    pub by: String,
    /// The motion.
    pub trajectory: Trajectory,
    /// Sizes of the motion.
    pub scales: Scales,
    /// What [`Reference::uncertainty`] is, as the beginning of a sentence.
    pub doubt: &'static str,
    /// Its uncertainty: smaller errors cannot be measured.
    pub uncertainty: Comparison,
    /// Why it is not in double-double, when it is not.
    pub imprecise: Option<String>,
    /// Difference from another method, or why none was run.
    pub second: Result<Second, String>,
}

/// A reference, or the time up to which it is known.
pub(super) enum Found {
    /// Up to the end.
    Whole(Box<Reference>),
    /// Only up to a time, s; scaled difference of positions at the end.
    Until(f64, f64),
}

impl Reference {
    /// In double-double, compared with the two tightest runs that reach the end within `budget`, or the tightest of them.
    pub(super) fn find(runs: &Runs<'_>, budget: Duration) -> Result<Found, AccuracyError> {
        let deadline = Instant::now() + budget;
        let mut best: Vec<(Method, Run)> = Vec::new();
        let mut refused = None;
        for method in TOLERANCES.map(Method::dop853) {
            match runs.on_grid(method, Variant::default(), Instant::now() + budget / 4) {
                Ok(run) => best.push((method, run)),
                Err(NoRun::Setup(error)) => return Err(error.into()),
                Err(why) => refused = Some((method, why)),
            }
            if best.len() == 2 || Instant::now() >= deadline {
                break;
            }
        }
        let [(method, run), (_, second_best)] = &best[..] else {
            let (method, outcome) = refused.map_or_else(
                || ("dop853".to_owned(), NoRun::Overtime.to_string()),
                |(method, why)| (format!("dop853 {}", command(method)), why.to_string()),
            );
            return Err(AccuracyError::NoReference { method, outcome });
        };
        let (tightest, other) = (Trajectory::of(run), Trajectory::of(second_best));
        let precise = precise(runs, &run.first(), tightest.times(), deadline);
        let scales = Scales::of(precise.as_ref().unwrap_or(&tightest));
        if let Some(until) = unknown_from(precise.as_ref().unwrap_or(&other), &tightest, &scales)? {
            return Ok(until);
        }
        let own = compare(&tightest, &other, &scales).unwrap_or_default();
        let by = format!("dop853 {}", command(*method));
        Ok(Found::Whole(Box::new(match precise {
            Ok(trajectory) => {
                let difference = compare(&tightest, &trajectory, &scales).unwrap_or_default();
                let second = Ok(Second { by, difference, own });
                let (doubt, uncertainty) = ("Rounding to double changes it", rounding(&scales));
                Self { by: NAME.to_owned(), trajectory, scales, doubt, uncertainty, imprecise: None, second }
            }
            Err(why) => {
                let second = Second::by_rk4(runs, run.cost, &tightest, &scales, deadline);
                let doubt = "The next looser run differs from it";
                Self { by, trajectory: tightest, scales, doubt, uncertainty: own, imprecise: Some(why), second }
            }
        })))
    }
}

/// Rounding error of numbers of these sizes when they are stored as f64.
fn rounding(scales: &Scales) -> Comparison {
    let half = 0.5 * f64::EPSILON;
    let of = |scales: &[f64]| Size { absolute: half * scales.iter().fold(0.0, |m, x| f64::max(m, *x)), scaled: half };
    let Scales { position, velocity, reaction } = scales;
    let all = Errors { position: of(position), velocity: of(velocity), reaction: of(reaction) };
    Comparison { end: all, grid: all }
}

/// The time from which two motions differ noticeably, if they do.
fn unknown_from(one: &Trajectory, other: &Trajectory, scales: &Scales) -> Result<Option<Found>, AccuracyError> {
    let n = one.times().len().min(other.times().len());
    let apart = |i: usize| difference(one.row(i), other.row(i), scales).position.scaled;
    let known = |i: &usize| apart(*i) <= KNOWN;
    let n_known = (0..n).take_while(known).count();
    match n_known {
        _ if n_known == n => Ok(None),
        0 | 1 => Err(AccuracyError::NothingKnown { difference: apart(1.min(n - 1)) }),
        _ => Ok(Some(Found::Until(one.times()[n_known - 1], apart(n - 1)))),
    }
}
