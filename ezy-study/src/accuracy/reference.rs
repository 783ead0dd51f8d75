//! The reference motion: in double-double where the scene has a Taylor series, otherwise the run of DOP853 with the smallest
//! tolerance.

use std::time::Duration;

use super::error::AccuracyError;
use super::errors::{Comparison, Errors, Scales, Size, compare, difference};
use super::ladder::command;
use super::runs::{NoRun, Runs};
use super::trajectory::Trajectory;
use super::variant::Variant;
use ezy_core::dynamics::State;
use ezy_core::integrate::{Method, PreciseMotion};
use ezy_core::record::Sample;
use ezy_core::scalar::legible_time;
use ezy_core::simulate::{Cost, Run, processor_time};

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
    pub(super) trajectory: Trajectory,
    /// Sizes of the motion.
    pub(super) scales: Scales,
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
        let deadline = processor_time() + budget;
        let mut best: Vec<(Method, Run)> = Vec::new();
        let mut refused = None;
        for method in TOLERANCES.map(Method::dop853) {
            match runs.on_grid(method, Variant::default(), processor_time() + budget / 4) {
                Ok(run) => best.push((method, run)),
                Err(NoRun::Setup(error)) => return Err(error.into()),
                Err(NoRun::Interrupted) => return Err(AccuracyError::Interrupted),
                Err(why) => refused = Some((method, why)),
            }
            if best.len() == 2 || processor_time() >= deadline {
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
        if runs.is_interrupted() {
            return Err(AccuracyError::Interrupted);
        }
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

/// How it is named in reports.
const NAME: &str = "Taylor's method of order 38 in double-double, with 31 digits";

/// The motion from `start` at each of `times`, rounded to f64, or why there is none.
fn precise(runs: &Runs<'_>, start: &Sample<'_>, times: &[f64], deadline: Duration) -> Result<Trajectory, String> {
    if !runs.inputs.is_empty() {
        return Err("inputs are set, and the motion in double-double takes them as declared".to_owned());
    }
    let state = State {
        t: start.t,
        q: start.coordinates.to_vec(),
        v: start.velocities.to_vec(),
        z: start.states.to_vec(),
        work: Vec::new(),
    };
    let mut motion = PreciseMotion::new(runs.scene, &state).map_err(|error| error.to_string())?;
    let mut trajectory = Trajectory::empty(runs.scene.info());
    for &t in times {
        motion.advance_to(t).map_err(|error| error.to_string())?;
        if processor_time() >= deadline || runs.is_interrupted() {
            return Err(format!(
                "the motion in double-double had come to t = {} s when its time was over",
                legible_time(t)
            ));
        }
        let [q, v, lambda] = [motion.q(), motion.v(), motion.lambda()]
            .map(|numbers| numbers.iter().map(|x| x.high()).collect::<Vec<f64>>());
        trajectory.push(t, &q, &v, &lambda);
    }
    Ok(trajectory)
}

/// A second route to the reference.
#[derive(Debug, Clone)]
pub struct Second {
    /// How it was made.
    pub by: String,
    /// Difference from the reference.
    pub difference: Comparison,
    /// Difference of its own last two approximations.
    pub own: Comparison,
}

/// A second method may differ from the reference by this factor of the difference of its own last two runs. At the level of
/// rounding both vary by chance.
const CONFIRMED: f64 = 100.0;

/// Relative differences up to this are rounding of a long run.
const ROUNDING: f64 = 1e-12;

/// RK4 steps for each step of the reference: extrapolated RK4 then comes near to rounding.
const STEPS_PER_STEP: u64 = 16;

impl Second {
    /// Whether it agrees with the reference within its own accuracy.
    pub fn confirms(&self) -> bool {
        let [difference, own] = [&self.difference, &self.own].map(|of| of.grid.position.scaled);
        difference <= (CONFIRMED * own).max(ROUNDING)
    }

    /// RK4 with two steps, extrapolated to the step zero.
    fn by_rk4(
        runs: &Runs<'_>,
        cost: Cost,
        reference: &Trajectory,
        scales: &Scales,
        until: Duration,
    ) -> Result<Self, String> {
        let step_s = (runs.until_s - runs.start_s) / (STEPS_PER_STEP * cost.steps.max(1)) as f64;
        let motion = |step_s: f64| {
            let run = runs.on_grid(Method::rk4(step_s), Variant::default(), until);
            run.map(|run| Trajectory::of(&run)).map_err(|why| refused(&why))
        };
        let (coarse, fine) = (motion(step_s)?, motion(0.5 * step_s)?);
        let compared = |one: &Trajectory, other: &Trajectory| {
            compare(one, other, scales).ok_or_else(|| "rk4 has samples at other times".to_owned())
        };
        let own = compared(&fine, &coarse)?;
        let difference = compared(&fine.extrapolated(&coarse, 1.0 / 15.0), reference)?;
        let by = format!("rk4 with steps of {step_s:.2e} s and half of it, extrapolated to the step zero");
        Ok(Self { by, difference, own })
    }
}

fn refused(why: &NoRun) -> String {
    format!("rk4 {why}")
}
