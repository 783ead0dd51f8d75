//! Fast turns and a million steps.

use super::*;
use crate::garage::rows;
use ezy_core::model::Scene;
use ezy_models::{n_four_bar, pendulum, roller_racer};

/// Of the reference, rad, after 1e4 rad.
const ANGLE: f64 = 1e-6;
/// The same part of the angle after 1e6 rad.
const FAR_ANGLE: f64 = 1e-4;
/// Of the reference, relative.
const ENERGY: f64 = 1e-11;
/// Of the reference, relative.
const RATE: f64 = 1e-9;
/// Of the reference, m.
const PARABOLA: f64 = 1e-9;
/// Of the reference, relative, over a million steps.
const LONG_ENERGY: f64 = 1e-9;
/// Of the reference, m, after 2,000 s.
const LONG_PLACE: f64 = 1e-3;
/// Of the references.
const ROTOR_TOLERANCE: f64 = 1e-12;
const LONG_TOLERANCE: f64 = 1e-10;
/// 1e4 rad/s at this step are a tenth of a radian.
const NAIVE_STEP_S: f64 = 1e-5;

pub fn cases() -> Vec<Case> {
    vec![
        case(
            "fast_rotor_off_centre",
            "10,000 rad/s 5 cm off the bearing: the convective term is 5e6 m/s²",
            ROTOR_TOLERANCE,
            Pace::Quick,
            |how| rotor(1.0, ANGLE, how),
        ),
        case(
            "fast_rotor_off_centre, 1e6 rad",
            "the same for 100 s: an angle of 1e6 rad has ten digits left for the turn that it is in",
            ROTOR_TOLERANCE,
            Pace::Slow,
            |how| rotor(100.0, FAR_ANGLE, how),
        ),
        case(
            "fast_counter_rotating_pair",
            "two hinged bodies thrown while they spin at ±10,000 rad/s: momenta leak where a projection does not weigh with masses",
            UNSTATED,
            Pace::Quick,
            pair,
        ),
        case("long_run_1e6_steps, A01", "2,000 s", LONG_TOLERANCE, Pace::Slow, long_pendulum),
        case(
            "long_run_1e6_steps, A02",
            "2,000 s of the linkage of two loops: 1,029 turns through 2,059 level positions",
            LONG_TOLERANCE,
            Pace::Long,
            |how| {
                let scene = n_four_bar::Fall::default();
                long(&scene, 2000.0, 5e-4, 1.5 + 34.335, how)
            },
        ),
        case("long_run_1e6_steps, free racer", "10,000 s, 12 km away in the end", LONG_TOLERANCE, Pace::Slow, |how| {
            let scene = roller_racer::Coast::default();
            long(&scene, 1e4, 4e-3, 1.2, how)
        }),
        case("long_run_1e6_steps, knife edge", "10,000 s at 100 rad/s", LONG_TOLERANCE, Pace::Slow, |how| {
            let subject = subject("knife_edge_incline", "fast_turn");
            long(&*subject.scene, 1e4, 2e-3, 50.0, how)
        }),
    ]
}

fn rotor(until_s: f64, bound: f64, how: How) -> Findings {
    let subject = subject("torture", "fast_rotor_off_centre");
    let table: Vec<_> = rows(&subject.data["rows"]).into_iter().filter(|row| row[0] <= until_s).collect();
    let angle = Question::at_times("angle, rad", bound, |i, seen| seen.q[2] - table[i][1]);
    let energy = Question::energy(ENERGY, number(&subject.data["E0"]));
    let trial = Trial::new(&subject, times_of_rows(&table), vec![angle, Question::gaps(GAP), energy]);
    trial.examine(how.by(NAIVE_STEP_S))
}

fn pair(how: How) -> Findings {
    let subject = subject("torture", "fast_counter_rotating_pair");
    let rates = Question::always("turn rates, relative", RATE, |seen| {
        worse((seen.v[2] / 1e4 - 1.0).abs(), seen.v[5] / 1e4 + 1.0)
    });
    // the common centre starts at a third of the way, with the first's velocity and a third of what the second has more
    let centre = Question::always("common centre, m", PARABOLA, |seen| {
        let [x, y] = [0, 1].map(|k| (2.0 * seen.q[k] + seen.q[3 + k]) / 3.0);
        let velocity = 4.0 + 4000.0 / 3.0;
        worse((x - (0.4 / 3.0 + 1.5 * seen.t)).abs(), y - (velocity * seen.t - 4.905 * seen.t * seen.t))
    });
    let trial = Trial::new(&subject, vec![1.0], vec![rates, centre]);
    trial.examine(how.by(NAIVE_STEP_S))
}

fn long_pendulum(how: How) -> Findings {
    let subject = subject("a01_simple_pendulum", "");
    let table: Vec<_> = rows(&subject.data["exact"]["rows"]).into_iter().filter(|row| row[0] >= 1000.0).collect();
    let scene = pendulum::Swing::default();
    let place = Question::at_times("x and y, m", LONG_PLACE, |i, seen| {
        worse((seen.q[0] - table[i][1]).abs(), seen.q[1] - table[i][2])
    });
    let questions = vec![place, Question::gaps(GAP), Question::energy(LONG_ENERGY, 9.81)];
    let trial = Trial { scene: &scene, given: Vec::new(), times: times_of_rows(&table), questions };
    trial.examine(how.by(1e-3))
}

/// Energy and gaps alone, over the whole run; far away a gap drowns in the rounding of coordinates.
fn long(scene: &dyn Scene, until_s: f64, step_s: f64, scale_j: f64, how: How) -> Findings {
    let gaps = Question::always("gaps, m, over coordinates beyond 1 m", GAP, |seen| {
        seen.gap / seen.q.iter().copied().fold(1.0, worse)
    })
    .for_all();
    let questions = vec![gaps, Question::energy(LONG_ENERGY, scale_j)];
    let trial = Trial { scene, given: Vec::new(), times: vec![until_s], questions };
    trial.examine(how.by(step_s))
}
