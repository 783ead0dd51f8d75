//! Rows that repeat others.

use super::*;
use crate::garage::{load, rows};
use crate::hard::case::Ended;
use crate::parallel_cranks::judge::{Verdict, judge};
use crate::parallel_cranks::members::{Member, members};
use ezy_core_tests::simulation;
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
            UNSTATED,
            Pace::Quick,
            coaxial,
        ),
        case(
            "three_skates_concurrent",
            "the axles of three skates meet in one point: two rows determine the third, and the body turns about it",
            UNSTATED,
            Pace::Quick,
            concurrent,
        ),
        case(
            "three_skates_locked",
            "one of the axles turned by 0.05 rad: the body is held",
            UNSTATED,
            Pace::Quick,
            locked,
        ),
        case(
            "five_cranks_hanging",
            "five cranks carry one coupler: 20 rows of rank 17 on 18 coordinates",
            UNSTATED,
            Pace::Slow,
            |how| five_cranks("five_cranks_hanging", 1e-8, how),
        ),
        case(
            "five_cranks_from_top",
            "the same from above, through the level position where the rank falls to 16",
            UNSTATED,
            Pace::Slow,
            |how| five_cranks("five_cranks_from_top", 1e-6, how),
        ),
    ]
    .into_iter()
    .chain(members().into_iter().step_by(OF_FAMILY).map(of_family))
    .collect()
}

/// Every eleventh member of the family of `parallel_cranks`, which `tests/examples/measure` runs as a whole: each number of cranks,
/// written out and with a count.
const OF_FAMILY: usize = 11;

fn of_family(member: Member) -> Case {
    Case {
        name: format!("parallel_cranks, {}", member.name),
        why: "uneven cranks through their level position; the pendulum that they are is the reference",
        tolerance: UNSTATED,
        by: By::Methods,
        pace: Pace::Slow,
        examine: Box::new(move |how| cranks(&member, how)),
    }
}

/// Step of RK4 as a part of the time scale of the motion.
const OF_PACE: f64 = 0.02;

fn cranks(member: &Member, how: How) -> Findings {
    let course = member.course();
    let by = how.by(OF_PACE / course.pace);
    let judged = judge(member, &course, by.method);
    let (ended, stopped) = match judged.verdict {
        Verdict::Right | Verdict::Off => (Ended::Reached, None),
        Verdict::Stuck => (Ended::Cut, Some("its steps became too short".to_owned())),
        Verdict::Refused(message) => (Ended::Refused("next to the level position"), Some(message)),
        Verdict::Untrue(message) => (Ended::Refused("for an untrue reason"), Some(message)),
    };
    // what the errors of its steps may grow to
    let checks = vec![Check::new("angles, and rates over the pace, rad", judged.allowed, judged.error)];
    Findings { checks, steps: judged.steps, ended: Some(ended), stopped, ..Findings::default() }
}

fn coaxial(how: How) -> Findings {
    let subject = subject("torture", "coaxial_wheels");
    let sleigh = crate::garage::case(&load("chaplygin_sleigh"), "spin").clone();
    let table = rows(&sleigh["rows"]);
    let times = times_of(&subject.data["states"]);
    let knife = |t: f64| table.iter().find(|row| row[0] == t).map(|row| row[6]);
    let force = Question::at_times("sum of the wheel forces, N", KNIFE, |i, seen| {
        knife(times[i]).map_or(0.0, |knife| -seen.lambda.iter().sum::<f64>() - knife)
    });
    let questions = vec![all_states(&subject, ONE_SKATE), force];
    let trial = Trial::new(&subject, times.clone(), questions);
    let mut findings = trial.examine(how.by(NAIVE_STEP_S));
    findings.checks.push(redundant_rows(&subject, 1.0));
    findings
}

fn concurrent(how: How) -> Findings {
    let subject = subject("torture", "three_skates_concurrent");
    let pose = Question::at_times("pose, m, rad", POSE, |i, seen| state_error(&subject, &["B"], false, i, seen));
    let turn = Question::always("turn rate, rad/s", TURN, |seen| seen.v[2] - 0.7);
    let trial = Trial::new(&subject, times_of(&subject.data["states"]), vec![pose, turn]);
    trial.examine(how.by(NAIVE_STEP_S))
}

fn locked(how: How) -> Findings {
    let subject = subject("torture", "three_skates_locked");
    let speed = Question::always("any velocity, m/s, rad/s", AT_REST, |seen| seen.v.iter().copied().fold(0.0, worse));
    let trial = Trial::new(&subject, vec![10.0], vec![speed]);
    trial.examine(how.by(1e-2))
}

/// All cranks are one pendulum; the angle in the reference is from the upward vertical.
fn five_cranks(name: &str, bound: f64, how: How) -> Findings {
    let subject = subject("torture", name);
    let table = rows(&subject.data["rows"]);
    let crank = |seen: &Seen<'_>, k: usize| seen.q[3 * (k + 1) + 2];
    let angle =
        Question::at_times("angle of the cranks, rad", bound, |i, seen| FRAC_PI_2 - crank(seen, 0) - table[i][1]);
    let equal = Question::always("cranks apart, rad", CRANKS_EQUAL, |seen| {
        (1..5).map(|k| crank(seen, k) - crank(seen, 0)).fold(0.0, worse)
    });
    let questions = vec![angle, equal, Question::gaps(GAP)];
    let trial = Trial::new(&subject, times_of_rows(&table), questions);
    let mut findings = trial.examine(how.by(NAIVE_STEP_S));
    findings
        .checks
        .push(redundant_rows(&subject, number(&subject.data["rows_count"]) - number(&subject.data["rank_regular"])));
    findings
}

/// How far the redundant rows that a run reports at its start are from the true ones.
fn redundant_rows(subject: &Subject, expected: f64) -> Check {
    let run = simulation(&*subject.scene).until(0.0).run();
    let reported =
        run.ok().map(|run| run.rank.intervals.first().and_then(|interval| interval.loss.n_redundant).unwrap_or(0));
    let away = reported.map_or(f64::NAN, |n| (n as f64 - expected).abs());
    Check::for_all("redundant rows, reported against true", 0.0, away)
}
