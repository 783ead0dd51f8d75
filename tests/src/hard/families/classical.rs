//! Loops that the literature compares codes with.

use super::*;
use crate::garage::rows;

/// Of the reference.
const ANDREWS_ANGLE: f64 = 1e-9;
/// Of the reference.
const ANDREWS_TOLERANCE: f64 = 1e-10;
/// Of the reference, rad/s: 1e-7 of 1,000 rad/s.
const ANDREWS_RATE: f64 = 1e-4;
/// Of the reference, of 2 J.
const ANDREWS_ENERGY: f64 = 5e-10;
/// Of the reference.
const IDA_STATE: f64 = 1e-8;
const IDA_TOLERANCE: f64 = 1e-10;
const DRIVEN_ANGLE: f64 = 1e-11;
const DRIVE_TORQUE: f64 = 1e-9;

pub fn cases() -> Vec<Case> {
    vec![
        case(
            "a03_andrews, to 0.05 s",
            "seven bodies in three loops, masses of grams, accelerations of 6e5 rad/s²",
            ANDREWS_TOLERANCE,
            Pace::Quick,
            andrews,
        ),
        case(
            "slider_crank_ida",
            "a spring with a damper across a closed loop, 10 s",
            IDA_TOLERANCE,
            Pace::Quick,
            slider_crank,
        ),
        case(
            "driven_four_bar",
            "the crank turns at exactly 10 rad/s: its row moves with time, and no degree of freedom is left",
            UNSTATED,
            Pace::Quick,
            driven,
        ),
    ]
}

/// β, Θ, γ, Φ, δ, Ω, ε of the literature, from the angles of K1 … K7 or their rates.
fn andrews_angles(of: &[f64]) -> [f64; 7] {
    let [k1, k2, k3, k4, k5, k6, k7] = std::array::from_fn(|i| of[3 * i + 2]);
    [k1, k2 - k1, k3, k4 - k5, k5, k6 - k7, k7]
}

fn andrews(how: How) -> Findings {
    let subject = subject("a03_andrews", "");
    let table = rows(&subject.data["trajectory"]["rows"]);
    let difference = |of: &[f64], i: usize, from: usize| {
        andrews_angles(of).iter().enumerate().map(|(k, x)| x - table[i][from + k]).fold(0.0, worse)
    };
    let angles = Question::at_times("the seven angles, rad", ANDREWS_ANGLE, |i, seen| difference(seen.q, i, 1));
    let rates = Question::at_times("their rates, rad/s", ANDREWS_RATE, |i, seen| difference(seen.v, i, 8));
    let questions = vec![angles, rates, Question::gaps(GAP), Question::energy(ANDREWS_ENERGY, 2.0)];
    // assembled from the angles that the scene gives
    let trial = Trial { scene: &*subject.scene, given: Vec::new(), times: times_of_rows(&table), questions };
    trial.examine(how.by(5e-6))
}

fn slider_crank(how: How) -> Findings {
    let subject = subject("slider_crank_ida", "");
    let table = rows(&subject.data["rows"]);
    let state = Question::at_times("q, x, p, rad, m", IDA_STATE, |i, seen| {
        let differences = [seen.q[2] - table[i][1], seen.q[3] - table[i][2], seen.q[5] - table[i][3]];
        differences.into_iter().fold(0.0, worse)
    });
    let trial = Trial {
        scene: &*subject.scene,
        given: Vec::new(),
        times: times_of_rows(&table),
        questions: vec![state, Question::gaps(GAP)],
    };
    trial.examine(how.by(1e-3))
}

fn driven(how: How) -> Findings {
    let subject = subject("torture", "driven_four_bar");
    let table = rows(&subject.data["rows"]);
    let after: Vec<_> = table.iter().filter(|row| row[0] > 0.0).cloned().collect();
    let drive = subject.scene.info().rows.iter().position(|row| row.name == "motor").expect("the row of the drive");
    let angles = Question::at_times("angles, rad", DRIVEN_ANGLE, |i, seen| angle_error(&subject, i, seen));
    let torque = Question::at_times("driver's torque, relative", DRIVE_TORQUE, |i, seen| {
        -seen.lambda[drive] / after[i][8] - 1.0
    });
    let questions = vec![angles, torque, Question::gaps(GAP)];
    let trial = Trial::new(&subject, times_of_rows(&after), questions);
    trial.examine(how.by(1e-3))
}
