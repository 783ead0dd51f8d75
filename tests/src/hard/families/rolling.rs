//! Vehicles on wheels that do not slip.

use super::*;
use crate::garage::{load, rows};

/// Of the references.
const STATE: f64 = 1e-8;
const CLOSED_FORM: f64 = 1e-9;
const REVERSAL: f64 = 1e-6;
const RACER_ENERGY: f64 = 1e-10;

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
    Case {
        name: format!("{file}, {name}"),
        why,
        is_quick: matches!(
            name,
            "bloch" | "reversal" | "scipy_dae" | "locked_steering" | "free_racer" | "driven_slalom"
        ),
        examine: Box::new(move |how| run(file, &of, how)),
    }
}

fn run(file: &'static str, name: &str, how: How) -> Findings {
    let subject = subject(file, name);
    let by = how.by(Method::taylor(1e-12), 1e-3);
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
