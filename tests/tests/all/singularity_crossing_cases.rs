//! Reference cases with singular positions by the methods that choose their steps; the page of hard cases has RK4.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_tests::garage::{list, number, rows};
use ezy_tests::hard::subject::{Subject, subject};

/// Bound of the references, on the branch without a jump.
const BRANCH: f64 = 1e-6;

/// A tolerance a thousandth of the bound, and one that rounding next to singular positions used to forbid.
const TOLERANCES: [f64; 2] = [1e-9, 1e-12];

/// Far more steps than any run here takes: one whose steps become too short fails at once.
const MOST_STEPS: u64 = 100_000;

/// Of Radau, whose steps go with the fifth root.
const IMPLICIT: f64 = 1e-9;

fn methods() -> Vec<Method> {
    let explicit = TOLERANCES.into_iter().flat_map(|tolerance| [Method::dop853(tolerance), Method::taylor(tolerance)]);
    explicit.chain([Method::radau(IMPLICIT)]).collect()
}

fn run(subject: &Subject, method: Method, until_s: f64) -> Run {
    let start = simulation(&*subject.scene).method(method).until(until_s).max_steps(MOST_STEPS);
    let order = subject.given().into_iter().fold(start, |order, (name, value)| order.start(&name, value));
    let run = order.run().unwrap();
    assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
    run
}

#[test]
fn reference_slider_crank_of_equal_lengths_passes_its_bearing() {
    let subject = subject("torture", "slider_crank_equal_lengths");
    let state = list(&subject.data["states"]).last().unwrap();
    for method in methods() {
        let run = run(&subject, method, number(&state["t"]));
        let off = run.last().coordinates[2] - number(&state["bodies"]["crank"][2]);
        assert!(off.abs() <= BRANCH, "{method:?}: {off:.1e}");
    }
}

#[test]
fn reference_snakeboard_is_steered_through_a_right_angle() {
    let subject = subject("torture", "snakeboard_through_90deg");
    let state = list(&subject.data["states"]).last().unwrap();
    for method in methods() {
        let run = run(&subject, method, number(&state["t"]));
        for k in 0..3 {
            let off = run.last().coordinates[k] - number(&state["bodies"]["board"][k]);
            assert!(off.abs() <= BRANCH, "{method:?}: {off:.1e}");
        }
    }
}

#[test]
fn reference_five_cranks_pass_the_level_position() {
    let subject = subject("torture", "five_cranks_from_top");
    let row = rows(&subject.data["rows"]).into_iter().find(|row| row[0] >= 2.0).unwrap();
    for method in methods() {
        let run = run(&subject, method, row[0]);
        let off = std::f64::consts::FRAC_PI_2 - run.last().coordinates[5] - row[1];
        assert!(off.abs() <= BRANCH, "{method:?}, t = {}: {off:.1e}", row[0]);
    }
}
