//! Rows that repeat others.

use super::*;
use crate::garage::{load, rows};
use std::f64::consts::FRAC_PI_2;

/// Of the reference.
const ONE_SKATE: f64 = 1e-10;
const KNIFE: f64 = 1e-9;
const POSE: f64 = 1e-9;
const TURN: f64 = 1e-10;
const AT_REST: f64 = 1e-13;
const CRANKS_EQUAL: f64 = 1e-9;
/// Steps of the naive program, s.
const NAIVE_STEP_S: f64 = 1e-3;

pub fn cases() -> Vec<Case> {
    vec![
        case(
            "coaxial_wheels",
            "both wheels of an axle state the same row: only the sum of their forces is determined",
            false,
            coaxial,
        ),
        case(
            "three_skates_concurrent",
            "the axles of three skates meet in one point: two rows determine the third, and the body turns about it",
            false,
            concurrent,
        ),
        case("three_skates_locked", "one of the axles turned by 0.05 rad: the body is held", true, locked),
        case(
            "five_cranks_hanging",
            "five cranks carry one coupler: 20 rows of rank 17 on 18 coordinates",
            false,
            |naive| five_cranks("five_cranks_hanging", 1e-8, naive),
        ),
        case(
            "five_cranks_from_top",
            "the same from above, through the level position where the rank falls to 13",
            false,
            |naive| five_cranks("five_cranks_from_top", 1e-6, naive),
        ),
    ]
}

fn coaxial(naive: bool) -> Findings {
    let subject = subject("torture", "coaxial_wheels");
    let sleigh = crate::garage::case(&load("chaplygin_sleigh"), "spin").clone();
    let table = rows(&sleigh["rows"]);
    let times = times_of(&subject.data["states"]);
    let knife = |t: f64| table.iter().find(|row| row[0] == t).map(|row| row[6]);
    let force = Question::at_times("sum of the wheel forces, N", KNIFE, |i, seen| {
        knife(times[i]).map_or(0.0, |knife| -seen.lambda.iter().sum::<f64>() - knife)
    });
    let questions = vec![all_states(&subject, ONE_SKATE), force];
    Trial::new(&subject, times.clone(), questions).examine(Method::taylor(1e-13), naive.then_some(NAIVE_STEP_S))
}

fn concurrent(naive: bool) -> Findings {
    let subject = subject("torture", "three_skates_concurrent");
    let pose = Question::at_times("pose, m, rad", POSE, |i, seen| state_error(&subject, &["B"], false, i, seen));
    let turn = Question::always("turn rate, rad/s", TURN, |seen| seen.v[2] - 0.7);
    let trial = Trial::new(&subject, times_of(&subject.data["states"]), vec![pose, turn]);
    trial.examine(Method::taylor(1e-13), naive.then_some(NAIVE_STEP_S))
}

fn locked(naive: bool) -> Findings {
    let subject = subject("torture", "three_skates_locked");
    let speed = Question::always("any velocity, m/s, rad/s", AT_REST, |seen| seen.v.iter().copied().fold(0.0, worse));
    let trial = Trial::new(&subject, vec![10.0], vec![speed]);
    trial.examine(Method::rk4(1e-2), naive.then_some(1e-2))
}

/// Cranks of equal masses with the same sum: one pendulum. The angle in the reference is from the upward vertical.
fn five_cranks(name: &str, bound: f64, naive: bool) -> Findings {
    let subject = subject("torture", name);
    let table = rows(&subject.data["rows"]);
    let start = number(&list(&subject.block["bodies"])[1]["angle"]);
    let crank = |seen: &Seen<'_>, k: usize| seen.q[3 * (k + 1) + 2];
    let angle =
        Question::at_times("angle of the cranks, rad", bound, |i, seen| FRAC_PI_2 - crank(seen, 0) - table[i][1]);
    let equal = Question::always("cranks apart, rad", CRANKS_EQUAL, |seen| {
        (1..5).map(|k| crank(seen, k) - crank(seen, 0)).fold(0.0, worse)
    });
    let given = (0..5).map(|k| (format!("crank[{k}].phi"), start)).collect();
    let questions = vec![angle, equal, Question::gaps(GAP)];
    let trial = Trial { scene: &*subject.scene, given, times: times_of_rows(&table), questions };
    trial.examine(Method::rk4(1e-3), naive.then_some(NAIVE_STEP_S))
}
