//! The cases, a family a file.

mod chains;
mod classical;
mod masses;
mod redundant;
mod rolling;
mod singular;
mod spinning;
mod starts;
mod stiff;

use super::case::{By, Case, Check, Family, Findings, How, Pace, Program};
use super::subject::{Subject, subject};
use super::trial::{Question, Seen, Trial};
use crate::garage::{list, number, worse};
use serde_json::Value;

/// All of them, in the order of the page.
pub fn families() -> Vec<Family> {
    vec![
        Family { name: "masses", cases: masses::cases() },
        Family { name: "redundant", cases: redundant::cases() },
        Family { name: "singular", cases: singular::cases() },
        Family { name: "stiff", cases: stiff::cases() },
        Family { name: "spinning", cases: spinning::cases() },
        Family { name: "starts", cases: starts::cases() },
        Family { name: "classical", cases: classical::cases() },
        Family { name: "rolling", cases: rolling::cases() },
        Family { name: "chains", cases: chains::cases() },
    ]
}

/// At which bounds are stated whose reference names no tolerance: most references name it.
const UNSTATED: f64 = 1e-10;

/// A case by every method, at the tolerance of its reference.
fn case(
    name: &str,
    why: &'static str,
    tolerance: f64,
    pace: Pace,
    examine: impl Fn(How) -> Findings + 'static,
) -> Case {
    Case { name: name.to_owned(), why, tolerance, by: By::Methods, pace, examine: Box::new(examine) }
}

/// Times of the `states` of a reference.
fn times_of(states: &Value) -> Vec<f64> {
    list(states).iter().map(|state| number(&state["t"])).collect()
}

/// Times of the rows of a table.
fn times_of_rows(rows: &[Vec<f64>]) -> Vec<f64> {
    rows.iter().map(|row| row[0]).collect()
}

/// Largest difference of coordinates (with `velocities`, of those too) of the listed bodies from state `i`.
fn state_error(subject: &Subject, bodies: &[&str], velocities: bool, i: usize, seen: &Seen<'_>) -> f64 {
    let state = &subject.data["states"][i]["bodies"];
    let mut error = 0.0;
    for body in bodies {
        let first = subject.first_coordinate(body);
        for k in 0..3 {
            error = worse(error, seen.q[first + k] - number(&state[body][k]));
            if velocities {
                error = worse(error, seen.v[first + k] - number(&state[body][3 + k]));
            }
        }
    }
    error
}

/// Largest difference of the angles of all bodies from state `i`.
fn angle_error(subject: &Subject, i: usize, seen: &Seen<'_>) -> f64 {
    let state = &subject.data["states"][i]["bodies"];
    let bodies = list(&subject.block["bodies"]).iter().filter_map(|body| body["name"].as_str());
    bodies.map(|body| seen.q[subject.first_coordinate(body) + 2] - number(&state[body][2])).fold(0.0, worse)
}

/// Names of the bodies of the block.
fn bodies(subject: &Subject) -> Vec<&str> {
    list(&subject.block["bodies"]).iter().filter_map(|body| body["name"].as_str()).collect()
}

/// All positions and velocities of all bodies.
fn all_states(subject: &Subject, bound: f64) -> Question<'_> {
    Question::at_times("states, m, rad, m/s, rad/s", bound, move |i, seen| {
        state_error(subject, &bodies(subject), true, i, seen)
    })
}

/// A run through the states of a case, with all of them and the gaps asked, and more.
fn through_states(
    file: &str,
    name: &str,
    bound: f64,
    by: Program,
    more: impl FnOnce(&Subject) -> Vec<Question<'_>>,
) -> Findings {
    let subject = subject(file, name);
    let mut questions = vec![all_states(&subject, bound), Question::gaps(GAP)];
    questions.extend(more(&subject));
    Trial::new(&subject, times_of(&subject.data["states"]), questions).examine(by)
}

/// Of hinges of bodies of the size of one, after every projected step, m.
const GAP: f64 = 1e-12;
