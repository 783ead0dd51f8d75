//! Positions in which the rows lose rank on the way.

use super::*;
use crate::garage::rows;
use crate::hard::case::Ended;
use ezy_core::dynamics::MotionError;
use ezy_core::model::Scene;
use ezy_core::simulate::SetupError;
use ezy_core_tests::simulation;
use ezy_models::n_four_bar;
use std::f64::consts::FRAC_PI_2;

/// Of the references, on the branch without a jump.
const BRANCH: f64 = 1e-6;
/// Of the reference, relative.
const LINKAGE_ENERGY: f64 = 1e-8;
const SLIDER_ENERGY: f64 = 1e-7;
/// Loops beyond which dense LU takes minutes.
const LARGEST_FOR_LU: usize = 3;
/// Loops beyond which radau takes a minute to its limit of steps.
const LARGEST_FOR_CHECK: usize = 10;
/// Of the reference: sideways speed of the board.
const SIDEWAYS: f64 = 1e-8;

pub fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = [1, 2, 3, 10, 40].into_iter().map(linkage).collect();
    cases.push(case(
        "slider_crank_equal_lengths",
        "with crank and rod of one length the slider reaches the crank's bearing, where the rod could begin to turn with the crank",
        UNSTATED,
        Pace::Slow,
        slider,
    ));
    cases.push(case(
        "snakeboard_through_90deg",
        "both trucks are steered through a right angle, where their rows say the same and the board could slide sideways",
        UNSTATED,
        Pace::Quick,
        snakeboard,
    ));
    cases.push(case(
        "linkage_stretched_at_the_start",
        "the given angles cannot be met, and the nearest place stretches a crank and its coupler between two fixed points: to first order they may move, but they cannot, and no finite force holds them",
        UNSTATED,
        Pace::Quick,
        stretched,
    ));
    cases
}

/// A02 with `n` loops.
fn linkage(n: usize) -> Case {
    Case {
        name: format!("a02_n_four_bar, N = {n}"),
        why: "twice a turn all rods lie level: the rank falls by N, and every loop could fold",
        tolerance: UNSTATED,
        by: By::Methods,
        pace: if n > LARGEST_FOR_CHECK { Pace::Long } else { Pace::Slow },
        examine: Box::new(move |how| turning(n, how)),
    }
}

fn turning(n: usize, how: How) -> Findings {
    let subject = subject("a02_n_four_bar", "");
    let scene = n_four_bar::Fall { n, ..Default::default() };
    let case = list(&subject.data["cases"]).iter().find(|case| case["N"] == n).expect("a reference");
    let table = rows(&case["rows"]);
    let angle = |seen: &Seen<'_>, crank: usize| FRAC_PI_2 - seen.q[3 * crank + 2];
    let turned = Question::at_times("angle of a crank, rad", BRANCH, |i, seen| angle(seen, 0) - table[i][1]);
    let parallel = Question::always("cranks apart, rad", BRANCH, |seen| {
        (1..=n).map(|crank| angle(seen, crank) - angle(seen, 0)).fold(0.0, worse)
    });
    let energy = Question::energy(LINKAGE_ENERGY, number(&case["kinetic0"]) + number(&case["mgl"]));
    let questions = vec![turned, parallel, Question::gaps(GAP), energy];
    let scene: &dyn Scene = &scene;
    let trial = Trial { scene, given: Vec::new(), times: times_of_rows(&table), questions };
    let by = how.by(1e-3);
    trial.examine(if n <= LARGEST_FOR_LU { by } else { by.without_naive() })
}

fn slider(how: How) -> Findings {
    let subject = subject("torture", "slider_crank_equal_lengths");
    let of = |i: usize, body: &str, k: usize| number(&subject.data["states"][i]["bodies"][body][k]);
    let place = Question::at_times("crank's angle and slider's x, rad, m", BRANCH, |i, seen| {
        worse((seen.q[2] - of(i, "crank", 2)).abs(), seen.q[6] - of(i, "slider", 0))
    });
    let energy = Question::energy(SLIDER_ENERGY, number(&subject.data["E0"]));
    let questions = vec![place, Question::gaps(GAP), energy];
    let trial = Trial::new(&subject, times_of(&subject.data["states"]), questions);
    trial.examine(how.by(1e-4))
}

fn snakeboard(how: How) -> Findings {
    let subject = subject("torture", "snakeboard_through_90deg");
    let pose = Question::at_times("pose of the board, m, rad", BRANCH, |i, seen| {
        state_error(&subject, &["board"], false, i, seen)
    });
    let sideways = Question::always("sideways speed, m/s", SIDEWAYS, |seen| {
        let (sin, cos) = seen.q[2].sin_cos();
        -sin * seen.v[0] + cos * seen.v[1]
    });
    let questions = vec![pose, sideways, Question::gaps(GAP)];
    let trial = Trial::new(&subject, times_of(&subject.data["states"]), questions);
    trial.examine(how.by(5e-4))
}

/// A02 with three loops, one crank of which points down: every method has to refuse the start.
fn stretched(how: How) -> Findings {
    let scene = n_four_bar::Fall { n: 3, ..Default::default() };
    let by = how.by(1e-4);
    let order = simulation(&scene).method(by.method).until(0.05).project_start();
    let begun = match order.start("crank[1].phi", -1.6).run() {
        Err(SetupError::Motion(MotionError::SingularPosition { .. })) => 0.0,
        _ => 1.0,
    };
    let checks = vec![Check::for_all("runs that begin", 0.0, begun)];
    let ended = Some(Ended::Refused("singular position"));
    Findings { checks, ended, ..Findings::default() }
}
