//! Whether a run of parallel cranks is right, and if not, what it says.

use super::members::Member;
use super::pendulum::{Course, Swing};
use crate::garage::worse;
use ezy_core::dynamics::MotionError;
use ezy_core::model::Scene;
use ezy_core::prelude::*;
use ezy_core::simulate::{SetupError, StopReason};
use ezy_core_tests::simulation;

/// What came of a run.
#[derive(Debug, Clone, PartialEq)]
pub enum Verdict {
    /// It ended within its bound.
    Right,
    /// It ended beyond its bound, and said that it reached the end.
    Off,
    /// It stopped next to a level position and named the rows.
    Refused(String),
    /// It stopped for a reason that is not true, or far from any level position.
    Untrue(String),
    /// Its steps became so short that it was given up.
    Stuck,
}

/// A run that was judged.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// The outcome.
    pub verdict: Verdict,
    /// Error at the end, rad; NaN when it was not reached.
    pub error: f64,
    /// What it may be, rad.
    pub allowed: f64,
    /// Error of the energy, of what was turned over.
    pub energy: f64,
    /// Accepted steps.
    pub steps: u64,
    /// Largest multiplier at the end, N.
    pub largest_multiplier: f64,
}

/// Steps beyond which a run is given up: ten times what the slowest good one takes.
const MOST_STEPS: u64 = 20_000;

/// Runs a member by a method.
pub fn judge(member: &Member, course: &Course, method: Method) -> Judged {
    let scene = member.cranks.scene();
    let run = match order(member, &*scene).method(method).until(member.until_s).max_steps(MOST_STEPS).run() {
        Ok(run) => run,
        Err(error) => return not_started(&error),
    };
    let last = run.last();
    let steps = run.cost.steps;
    let allowed = allowed(member, course, method, steps);
    let largest_multiplier = last.multipliers.iter().copied().fold(0.0, worse);
    let energy = run.monitors.energy.map_or(f64::NAN, |energy| energy.relative);
    let mut judged = Judged { verdict: Verdict::Off, error: f64::NAN, allowed, energy, steps, largest_multiplier };
    match &run.outcome {
        Outcome::Stopped { reason: StopReason::Limit(_), .. } => judged.verdict = Verdict::Stuck,
        Outcome::Stopped { t, reason, .. } => {
            let message = reason.to_string();
            let true_here = is_true(reason) && is_near_level(member, *t);
            judged.verdict = if true_here { Verdict::Refused(message) } else { Verdict::Untrue(message) };
        }
        _ => {
            judged.error = error(member, course, &last);
            if judged.error <= allowed {
                judged.verdict = Verdict::Right;
            }
        }
    }
    judged
}

/// The order of a run, with every crank at its start.
pub fn order<'s>(member: &Member, scene: &'s (dyn Scene + 's)) -> Simulation<'s, &'s dyn Scene> {
    let Swing { angle, rate } = member.start;
    (0..member.cranks.n()).fold(simulation(scene), |order, k| {
        let name = member.cranks.name(k);
        order.start(format!("{name}.phi"), angle).start(format!("{name}.omega"), rate)
    })
}

fn not_started(error: &SetupError) -> Judged {
    let nan = f64::NAN;
    let verdict = Verdict::Untrue(error.to_string());
    Judged { verdict, error: nan, allowed: nan, energy: nan, steps: 0, largest_multiplier: nan }
}

/// Largest error of an angle, or of a rate over the pace of the motion, of all cranks and the coupler.
fn error(member: &Member, course: &Course, last: &Sample<'_>) -> f64 {
    let Swing { angle, rate } = course.end;
    let n = member.cranks.n();
    let coupler = worse(last.coordinates[2].abs(), last.velocities[2] / course.pace);
    (1..=n).fold(coupler, |worst, k| {
        let (phi, omega) = (last.coordinates[3 * k + 2], last.velocities[3 * k + 2]);
        worse(worse(worst, phi - angle), (omega - rate) / course.pace)
    })
}

/// Errors of angles that a step of one tolerance makes, in tolerances: the estimate is the root of the mean square over 6 (n + 1)
/// numbers, and n of these are the angles of the cranks, which err alike.
const OF_A_STEP: f64 = 3.0;

/// What a step of RK4 leaves, in (h Ω)⁵: a linear oscillator leaves 1/120, and coordinates of points on circles with their
/// projection ten times as much.
const OF_RK4: f64 = 1.0 / 12.0;

/// What rounding leaves of the angle at each passage of the level position, rad: at a distance D of it rounding of coordinates
/// comes back in velocities with 1/D², and the slowest cranks, which pass it at 0.1 √κ, turn back at D = 0.1²/2 beyond it.
const OF_A_PASSAGE: f64 = f64::EPSILON / (0.005 * 0.005);

/// What a run may be off, rad: every step makes its error, and the motion makes it larger.
fn allowed(member: &Member, course: &Course, method: Method, steps: u64) -> f64 {
    let steps = steps as f64;
    let turned = 1.0 + member.start.angle.abs().max(course.end.angle.abs());
    let of_method = match method.step_s() {
        Some(step_s) => steps * OF_RK4 * (step_s * course.pace).powi(5),
        None => steps * OF_A_STEP * method.setting() * turned,
    };
    let of_rounding = steps * f64::EPSILON * turned + f64::from(course.n_level) * OF_A_PASSAGE;
    course.growth * (of_method + of_rounding)
}

/// Whether a reason can be true of rows that agree in a motion that goes on.
fn is_true(reason: &StopReason) -> bool {
    matches!(
        reason,
        StopReason::Motion(
            MotionError::LockedUp { .. }
                | MotionError::LostInRounding { .. }
                | MotionError::StepCollapsed { .. }
                | MotionError::SingularPosition { .. }
        )
    )
}

/// Part of a radian within which a motion may be refused.
const NEAR: f64 = 0.2;

fn is_near_level(member: &Member, t: f64) -> bool {
    let so_far = Member { until_s: t, ..member.clone() }.course();
    (so_far.end.angle - member.cranks.level()).sin().abs() <= NEAR
}
