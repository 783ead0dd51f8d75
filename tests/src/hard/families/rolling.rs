//! Vehicles on wheels that do not slip.

use super::*;
use crate::garage::{load, rows};

/// Of the references.
const STATE: f64 = 1e-8;
const CLOSED_FORM: f64 = 1e-9;
const REVERSAL: f64 = 1e-6;
const RACER_ENERGY: f64 = 1e-10;
/// Of the references: of closed forms, and of others.
const CLOSED_FORM_TOLERANCE: f64 = 1e-11;
const STATE_TOLERANCE: f64 = 1e-10;
/// Of the references, over a million steps.
const MILLION_ENERGY: f64 = 1e-9;
const MILLION_RANGE: f64 = 1e-8;
/// Of the reference: what is left of the turn, rad/s.
const TURN_LEFT: f64 = 1e-12;
/// Steps of the naive program, s, and the time of a million of them.
const NAIVE_STEP_S: f64 = 1e-3;
const MILLION_S: f64 = 1e6 * NAIVE_STEP_S;

pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for case in list(&load("chaplygin_sleigh")["cases"]) {
        cases.push(named(
            "chaplygin_sleigh",
            case["name"].as_str().unwrap_or_default(),
            sleigh_why(case["name"].as_str()),
        ));
    }
    for name in ["scipy_dae", "dae4py", "fast_turn"] {
        cases.push(named("knife_edge_incline", name, "a blade on a slope runs sideways, on a cycloid"));
    }
    for (name, why) in [
        ("drive_gait", "trucks without mass, three prescribed angles"),
        ("rotate_gait", "the same with the twist at twice the frequency"),
        ("locked_steering", "one circle, with a momentum that is conserved exactly"),
        ("torque_driven", "trucks on springs with dampers, a torque between board and rider"),
    ] {
        cases.push(named("snakeboard", name, why));
    }
    for (name, why) in [
        ("free_racer", "no force at all: only the energy is conserved"),
        ("rowed_racer", "propelled by a torque in the hinge alone"),
        ("twistcar", "two heavy bodies, a spring and a torque between them"),
    ] {
        cases.push(named("roller_racer", name, why));
    }
    cases.push(case(
        "chaplygin_sleigh, a million steps",
        "the turn dies out below the smallest number, and no energy may come of it",
        CLOSED_FORM_TOLERANCE,
        Pace::Slow,
        long_sleigh,
    ));
    cases.push(case(
        "knife_edge_incline, a million steps",
        "167 turns of the cycloid, 3 km sideways: the blade must not creep downhill",
        CLOSED_FORM_TOLERANCE,
        Pace::Slow,
        long_blade,
    ));
    cases.push(named("car_trailers", "locked_circle", "two trailers settle on circles of known radii"));
    cases.push(named("car_trailers", "driven_slalom", "torque on the steering, thrust and drag"));
    cases
}

fn sleigh_why(name: Option<&str>) -> &'static str {
    match name {
        Some("reversal") => {
            "backwards the sleigh is unstable: what is left of an error grows a thousand times before it turns over"
        }
        Some("com_behind") => "the centre of mass behind the blade",
        Some("spin") => "a fast turn that dies out",
        _ => "the turn dies out, the sleigh runs straight",
    }
}

fn named(file: &'static str, name: &str, why: &'static str) -> Case {
    let of = name.to_owned();
    let is_quick =
        matches!(name, "bloch" | "reversal" | "scipy_dae" | "locked_steering" | "free_racer" | "driven_slalom");
    let is_closed_form = matches!(file, "chaplygin_sleigh" | "knife_edge_incline");
    case(
        &format!("{file}, {name}"),
        why,
        if is_closed_form { CLOSED_FORM_TOLERANCE } else { STATE_TOLERANCE },
        if is_quick { Pace::Quick } else { Pace::Slow },
        move |how| run(file, &of, how),
    )
}

fn run(file: &'static str, name: &str, how: How) -> Findings {
    let subject = subject(file, name);
    let by = how.by(NAIVE_STEP_S);
    let table = subject.data.get("rows").map(rows).unwrap_or_default();
    match file {
        "chaplygin_sleigh" => {
            let bound = if name == "reversal" { REVERSAL } else { CLOSED_FORM };
            let a = number(&subject.data["parameters"]["a"]);
            let state = Question::at_times("v, ω, θ and the blade's place, m/s, rad/s, rad, m", bound, |i, seen| {
                let (sin, cos) = seen.q[2].sin_cos();
                let (along, row) = (seen.v[0] * cos + seen.v[1] * sin, &table[i]);
                let place = [seen.q[0] - a * cos - row[4], seen.q[1] - a * sin - row[5]];
                [along - row[1], seen.v[2] - row[2], seen.q[2] - row[3], place[0], place[1]]
                    .into_iter()
                    .fold(0.0, worse)
            });
            Trial::new(&subject, times_of_rows(&table), vec![state]).examine(by)
        }
        "knife_edge_incline" => {
            let state = Question::at_times("v, x, y, m/s, m", CLOSED_FORM, |i, seen| {
                let (sin, cos) = seen.q[2].sin_cos();
                let (along, row) = (seen.v[0] * cos + seen.v[1] * sin, &table[i]);
                [along - row[1], seen.q[0] - row[3], seen.q[1] - row[4]].into_iter().fold(0.0, worse)
            });
            Trial::new(&subject, times_of_rows(&table), vec![state]).examine(by)
        }
        _ => through_states(file, name, STATE, by, |subject| match subject.data["name"].as_str() {
            Some("free_racer") => vec![Question::energy(RACER_ENERGY, number(&subject.data["E0"]))],
            _ => vec![],
        }),
    }
}

/// Kinetic energy of a body.
fn kinetic_j(m: f64, j: f64, v: &[f64]) -> f64 {
    0.5 * (m * (v[0] * v[0] + v[1] * v[1]) + j * v[2] * v[2])
}

fn long_sleigh(how: How) -> Findings {
    let subject = subject("chaplygin_sleigh", "spin");
    let [m, j, a, v, omega] = ["m", "J", "a", "v0", "omega0"].map(|name| number(&subject.data["parameters"][name]));
    let start_j = kinetic_j(m, j, &[v, a * omega, omega]);
    let gained = Question::always("energy gained while it runs straight, relative", MILLION_ENERGY, move |seen| {
        if seen.t > 0.5 * MILLION_S { (kinetic_j(m, j, seen.v) / start_j - 1.0).max(0.0) } else { 0.0 }
    });
    let turn = Question::at_times("turn rate left, rad/s", TURN_LEFT, |_, seen| seen.v[2]);
    let questions = vec![Question::energy(MILLION_ENERGY, start_j), gained, turn];
    Trial::new(&subject, vec![MILLION_S], questions).examine(how.by(NAIVE_STEP_S))
}

/// From rest without a heading x goes to and fro between 0 and the width.
fn long_blade(how: How) -> Findings {
    let subject = subject("knife_edge_incline", "scipy_dae");
    let [m, j, downhill, omega] =
        ["m", "J", "g_sin_alpha", "Omega"].map(|name| number(&subject.data["parameters"][name]));
    let width = downhill / (2.0 * omega * omega);
    let place = Question::always("x from the cycloid, of its width", MILLION_RANGE, move |seen| {
        seen.q[0] / width - (omega * seen.t).sin().powi(2)
    });
    let questions = vec![place, Question::energy(MILLION_ENERGY, m * downhill * width + 0.5 * j * omega * omega)];
    Trial::new(&subject, vec![MILLION_S], questions).examine(how.by(NAIVE_STEP_S))
}
