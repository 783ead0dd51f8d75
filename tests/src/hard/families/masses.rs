//! Ratios of masses to 1e10, and bodies without mass.

use super::*;
use crate::fuzz::{Oracle, exact_equations};
use crate::garage::rows;
use crate::hard::case::Purpose;
use crate::hard::naive::Naive;
use ezy_core::prelude::Backend;
use ezy_core_tests::system_of;

/// Of the reference: what elimination with one step of refinement keeps.
const ANGLE: f64 = 1e-8;
/// Of the reference, relative.
const ACCELERATION: f64 = 1e-12;
/// Of the reference, of the potential energy that is turned over.
const ENERGY: f64 = 1e-11;
/// Of the reference.
const MASSLESS_STATE: f64 = 1e-9;
/// Of the reference.
const PENDULUM_TOLERANCE: f64 = 1e-12;
/// Steps of the naive program, s.
const NAIVE_STEP_S: f64 = 1e-3;

pub fn cases() -> Vec<Case> {
    vec![
        case(
            "mass_ratio_heavy_below",
            "1 kg carries 1e10 kg: the force in the upper pin is 1e11 times the weight of the light rod, and its acceleration the difference of such forces",
            UNSTATED,
            Pace::Quick,
            |how| ratio("mass_ratio_heavy_below", how),
        ),
        case("mass_ratio_heavy_above", "1 kg hangs from 1e10 kg", UNSTATED, Pace::Quick, |how| {
            ratio("mass_ratio_heavy_above", how)
        }),
        case("mass_ratio_sandwich", "10 mg between two rods of 100 t", UNSTATED, Pace::Quick, |how| {
            ratio("mass_ratio_sandwich", how)
        }),
        case(
            "heavy_tractor_tractrix",
            "1e10 kg pulls 1 kg on two skates; the light trailer must follow its tractrix",
            UNSTATED,
            Pace::Quick,
            |how| {
                let by = how.by(NAIVE_STEP_S);
                through_states("car_trailers", "heavy_tractor_tractrix", ANGLE, by, |_| vec![])
            },
        ),
        case(
            "massless_coupler",
            "the coupler has neither mass nor inertia: M has no inverse, K has one",
            UNSTATED,
            Pace::Quick,
            |how| {
                let subject = subject("torture", "massless_coupler");
                let links = Question::at_times("crank and rocker, m, rad, m/s, rad/s", MASSLESS_STATE, |i, seen| {
                    state_error(&subject, &["crank", "rocker"], true, i, seen)
                });
                let coupler = Question::at_times("coupler's angle, rad", MASSLESS_STATE, |i, seen| {
                    seen.q[5] - number(&subject.data["states"][i]["bodies"]["coupler"][2])
                });
                let questions = vec![links, coupler, Question::gaps(GAP)];
                let trial = Trial::new(&subject, times_of(&subject.data["states"]), questions);
                trial.examine(how.by(NAIVE_STEP_S))
            },
        ),
        case("massless_middle_link", "a link without mass between two with", UNSTATED, Pace::Quick, |how| {
            let by = how.by(NAIVE_STEP_S);
            through_states("torture", "massless_middle_link", MASSLESS_STATE, by, |_| vec![])
        }),
        case(
            "a01_simple_pendulum",
            "a point mass has no inertia: M has no inverse",
            PENDULUM_TOLERANCE,
            Pace::Quick,
            |how| pendulum(10.0, 1e-9, how),
        ),
        case(
            "a01_simple_pendulum to 2,000 s",
            "845 periods: errors of the energy shift the phase",
            PENDULUM_TOLERANCE,
            Pace::Slow,
            |how| pendulum(2000.0, 1e-3, how),
        ),
    ]
}

/// A chain of rods of very different masses.
fn ratio(name: &str, how: How) -> Findings {
    let subject = subject("torture", name);
    let bodies = list(&subject.block["bodies"]);
    // every rod is a metre long
    let scale_j: f64 = bodies.iter().enumerate().map(|(i, body)| 9.81 * number(&body["mass"]) * (i as f64 + 0.5)).sum();
    let angles = Question::at_times("angles, rad", ANGLE, |i, seen| angle_error(&subject, i, seen));
    let questions = vec![angles, Question::gaps(GAP), Question::energy(ENERGY, scale_j)];
    let trial = Trial::new(&subject, times_of(&subject.data["states"]), questions);
    let mut findings = trial.examine(how.by(NAIVE_STEP_S));
    findings.checks.push(accelerations_at_start(&subject, how));
    findings
}

/// Accelerations at the start against the same equations in numbers of twice the length, solved with complete pivoting.
fn accelerations_at_start(subject: &Subject, how: How) -> Check {
    let scene = &*subject.scene;
    let mut system = system_of(scene, Backend::Auto).expect("a scene that can be set up");
    let (n_q, n_c) = (system.info().n_coordinates(), system.info().n_rows());
    let (mut q, mut v) = (vec![0.0; n_q], vec![0.0; n_q]);
    for (i, (_, value)) in subject.given().iter().enumerate() {
        if i % 6 < 3 { q[i / 6 * 3 + i % 3] = *value } else { v[i / 6 * 3 + i % 3] = *value }
    }
    let (matrix, right) = exact_equations(&system, 0.0, &q, &v).expect("a scene with a Taylor series");
    let mut exact = Oracle::new(&matrix).expect("numbers").solve(&right);
    exact.truncate(n_q);
    let largest = exact.iter().copied().fold(0.0, worse);
    let error = |a: &[f64]| a.iter().zip(&exact).map(|(a, x)| (a - x) / largest).fold(0.0, worse);
    let (mut a, mut lambda) = (vec![0.0; n_q], vec![0.0; n_c]);
    let reached = match system.accelerations(0.0, &q, &v, &mut a, &mut lambda) {
        Ok(_) => error(&a),
        Err(_) => f64::NAN,
    };
    let mut check = Check::for_all("accelerations at the start, relative", ACCELERATION, reached);
    if how.purpose == Purpose::PageWithNaive {
        let mut naive = Naive::new(scene, &q, &v);
        let state = naive.state.clone();
        check.naive = Some(naive.accelerations(0.0, &state).map_or(f64::NAN, |a| error(&a)));
    }
    check
}

/// A01 against elliptic functions.
fn pendulum(until_s: f64, bound: f64, how: How) -> Findings {
    let subject = subject("a01_simple_pendulum", "");
    let table: Vec<_> = rows(&subject.data["exact"]["rows"]).into_iter().filter(|row| row[0] <= until_s).collect();
    let place = Question::at_times("x and y, m", bound, |i, seen| {
        worse((seen.q[0] - table[i][1]).abs(), seen.q[1] - table[i][2])
    });
    // turned over from rest: the speed of a fall by the length
    let questions = vec![place, Question::gaps(GAP), Question::energy(1e-9, 9.81)];
    let trial = Trial::new(&subject, times_of_rows(&table), questions);
    trial.examine(how.by(NAIVE_STEP_S))
}
