//! Fast modes beside slow motion.

use super::*;
use crate::garage::rows;
use crate::reference;
use ezy_core::model::Scene;
use ezy_core::prelude::{Method, MethodKind};
use ezy_models::ezy_roller;

/// Of the reference: from the rigid pendulum.
const RIGID: f64 = 1e-6;
/// Of the reference, m.
const EXTENSION: f64 = 1e-10;
/// Of the reference, for a method that steps over the mode that has died out.
const MAX_STEPS: f64 = 5000.0;
/// Of the reference.
const CASTER: f64 = 1e-7;
/// Of the reference.
const CASTER_TOLERANCE: f64 = 1e-9;
/// A tolerance at which an aligned caster is followed by its slow motion alone.
const ALIGNED_TOLERANCE: f64 = 1e-6;
/// Steps of the naive program, s.
const NAIVE_STEP_S: f64 = 1e-4;
/// Ours: the reference has 36 digits and states none.
const NEAR_SINGULAR: f64 = 1e-9;

pub fn cases() -> Vec<Case> {
    vec![
        case(
            "stiff_spring_undamped",
            "a spring of 1e9 N/m swings at 31,623 rad/s for ever, and a step that follows it is 1e-5 s long",
            UNSTATED,
            Pace::Quick,
            |how| spring("stiff_spring_undamped", 1.0, how),
        ),
        case(
            "stiff_spring_damped",
            "the same mode dies within 50 ms; a method that need not follow it takes steps of 10 ms from then on",
            UNSTATED,
            Pace::Slow,
            |how| {
                let mut findings = spring("stiff_spring_damped", 3.0, how);
                let is_implicit = how.by(NAIVE_STEP_S).method.kind() == MethodKind::Radau;
                if is_implicit && !how.is_of_matrix() {
                    let steps = if findings.stopped.is_none() { findings.steps as f64 } else { f64::NAN };
                    findings.checks.push(Check::new("steps to 3 s", MAX_STEPS, steps));
                }
                findings
            },
        ),
        case(
            "caster_trail_1e-2",
            "a caster that trails its hinge by 1 cm turns into line within 10 ms; then its mode is stiff",
            CASTER_TOLERANCE,
            Pace::Quick,
            |how| caster("caster_trail_1e-2", how),
        ),
        case("caster_trail_1e-3", "a trail of 1 mm: within 1 ms, at 800 rad/s", CASTER_TOLERANCE, Pace::Quick, |how| {
            caster("caster_trail_1e-3", how)
        }),
        case(
            "ezyroller_near_singular",
            "both wheels 1 cm from the hinge and the bar nearly straight: G is close to losing a rank",
            UNSTATED,
            Pace::Quick,
            near_singular,
        ),
    ]
}

/// Followed exactly; and once it has aligned, by steps of an implicit method that need not follow its mode.
fn caster(name: &str, how: How) -> Findings {
    let by = how.by(NAIVE_STEP_S);
    let mut findings = through_states("torture", name, CASTER, by, |_| vec![]);
    if how.is_of_matrix() || by.method.kind() != MethodKind::Radau {
        return findings;
    }
    let subject = subject("torture", name);
    let trail = -number(&subject.block["skates"][1]["point"][0]);
    let times = times_of(&subject.data["states"]);
    let [from, to] = [times[1], times[2]];
    let steps = |until_s: f64| {
        let by = Program { method: Method::radau(ALIGNED_TOLERANCE), ..by };
        Trial::new(&subject, vec![until_s], vec![]).examine(by).steps as f64
    };
    let step_s = (to - from) / (steps(to) - steps(from));
    findings.checks.push(Check::new(
        "100 trail/speed over a step at 1e-6 after alignment",
        1.0,
        100.0 * trail / step_s,
    ));
    findings
}

fn spring(name: &str, until_s: f64, how: How) -> Findings {
    let subject = subject("torture", name);
    let table = rows(&subject.data["rows"]);
    let place = Question::at_times("x and y from the rigid pendulum's, m", RIGID, |i, seen| {
        let state = &subject.data["states"][i]["bodies"]["M"];
        let rigid = |k: usize| number(&state[k]) - table[i][2 + k];
        worse((seen.q[0] - rigid(0)).abs(), seen.q[1] - rigid(1))
    });
    let extension = Question::at_times("extension of the spring, m", EXTENSION, |i, seen| {
        seen.q[0].hypot(seen.q[1]) - 1.0 - table[i][1]
    });
    let times = times_of_rows(&table).into_iter().filter(|t| *t <= until_s).collect();
    Trial::new(&subject, times, vec![place, extension]).examine(how.by(NAIVE_STEP_S))
}

fn near_singular(how: How) -> Findings {
    let samples = reference::load("ezyroller_near_singular");
    let scene = ezy_roller::Coast { b: -0.19, d: -0.09, ..Default::default() };
    let scene: &dyn Scene = &scene;
    // the rear wheel rolls back at 1 m/s while the seat turns at 0.02 rad/s
    let given = [
        ("seat.x", 0.0),
        ("seat.y", 0.0),
        ("seat.phi", 0.0),
        ("bar.phi", 0.05),
        ("seat.vx", -1.0),
        ("seat.vy", 0.2 * 0.02),
        ("seat.omega", 0.02),
    ];
    let state = Question::at_times("coordinates, m, rad", NEAR_SINGULAR, |i, seen| {
        seen.q.iter().zip(&samples[i].q).map(|(q, x)| q - x).fold(0.0, worse)
    });
    let trial = Trial {
        scene,
        given: given.map(|(name, value)| (name.to_owned(), value)).to_vec(),
        times: samples.iter().map(|sample| sample.t).collect(),
        questions: vec![state, Question::gaps(GAP)],
    };
    trial.examine(how.by(1e-3))
}
