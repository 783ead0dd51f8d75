//! Near values that lead into another assembly mode: refused, with what was asked for and what was reached.

use super::starts::{four_bar, two_bars};
use ezy_core::dynamics::{MovedValue, StartError};
use ezy_core::model::Start;
use ezy_core::prelude::*;
use ezy_core_tests::system_of;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};

model! {
    /// Two long bars, and two short ones that make a parallelogram with parts of them; folded, the short bars cross.
    pub model Pantograph {
        body arm { mass: 2, inertia: 2*4/12 }
        body pen { mass: 2, inertia: 2*4/12 }
        body inner { mass: 0.5, inertia: 0.125/12 }
        body outer { mass: 1, inertia: 1/12 }
        hinge O: ground(0, 0) ~ arm(-1, 0);
        hinge C: arm(1, 0) ~ pen(-1, 0);
        hinge B: arm(0, 0) ~ inner(-0.25, 0);
        hinge D: pen(-0.5, 0) ~ outer(0.5, 0);
        hinge Q: inner(0.25, 0) ~ outer(-0.5, 0);
        start open { arm near angle pi/3; pen near angle -pi/3; inner near angle -pi/3; outer near angle pi/3; at rest; }
        scene drawing { start open; until 1 s; }
    }
}

/// Of a loop of bars of length one.
const ROUNDING: f64 = 1e-12;

/// Sine of the angle from the first bar to the second: its sign says to which side the second turns off.
fn elbow([first, second]: [f64; 2]) -> f64 {
    (second - first).sin()
}

/// Guesses of two angles all around.
fn guesses(n: usize) -> impl Iterator<Item = [f64; 2]> {
    let angle = move |i: usize| (i as f64 + 0.25) * TAU / n as f64 - PI;
    (0..n * n).map(move |i| [angle(i / n), angle(i % n)])
}

/// A four-bar whose crank is held upright.
fn upright(near: [f64; 2]) -> Start {
    let mut start = Start::free(9);
    start.give_position(2, FRAC_PI_2);
    start.near_position(5, near[0]);
    start.near_position(8, near[1]);
    start
}

/// The two closed loops of the four-bar; the rocker points from its bearing to the coupler.
fn modes() -> [[f64; 2]; 2] {
    two_bars([0.0, 1.0], [1.3, 0.0], [1.4, 1.2]).map(|[coupler, rocker]| [coupler, rocker - PI])
}

fn is_mode(found: [f64; 2], mode: [f64; 2]) -> bool {
    found.iter().zip(mode).all(|(x, y)| (x - y).sin().abs() <= ROUNDING && (x - y).cos() > 0.0)
}

/// A start that is accepted bends as its guess does, unless one of both is nearly stretched; one that is refused tells the guess and
/// the loop that bends the other way.
#[test]
fn analytic_four_bar_keeps_its_elbow_or_is_refused() {
    let scene = four_bar::Turning::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let (mut n_refused, mut n_kept) = (0, 0);
    for near in guesses(8) {
        match system.consistent_start(&upright(near)) {
            Ok(state) => {
                let found = [state.q[5], state.q[8]];
                assert!(modes().iter().any(|mode| is_mode(found, *mode)), "{near:?}: {found:?}");
                let (asked, found) = (elbow(near), elbow(found));
                assert!(found * asked > 0.0 || found.abs().min(asked.abs()) < 0.5, "{near:?}: {asked} became {found}");
                n_kept += 1;
            }
            Err(StartError::OtherAssemblyMode { values }) => {
                n_refused += 1;
                let of = |name: &str| values.iter().find(|value| value.name == name).unwrap();
                let told = [of("coupler.phi"), of("rocker.phi")];
                assert_eq!((values.len(), told.map(|value| value.given)), (2, near));
                let [first, second] = &values[..] else { panic!("{values:?}") };
                let moved = |value: &MovedValue| (value.got - value.given).abs();
                assert!(moved(first) >= moved(second), "the one that moved farthest comes first: {values:?}");
                let got = told.map(|value| value.got);
                assert!(elbow(near) * elbow(got) < 0.0, "{near:?}: {values:?}");
                assert!(modes().iter().any(|mode| is_mode(got, *mode)), "{near:?}: {values:?}");
            }
            // the search is stuck, and says so
            Err(StartError::Contradiction { .. }) => {}
            Err(error) => panic!("{near:?}: {error}"),
        }
    }
    assert!((1..16).contains(&n_refused) && n_kept >= 40, "{n_refused} refused and {n_kept} kept of 64");
}

/// The first guess that is refused.
fn refused(system: &mut System<&(dyn Scene + '_)>) -> ([f64; 2], StartError) {
    let found = guesses(8).find_map(|near| match system.consistent_start(&upright(near)) {
        Err(error @ StartError::OtherAssemblyMode { .. }) => Some((near, error)),
        _ => None,
    });
    found.expect("some guesses are refused")
}

/// Bars that are bent by 0.1 rad are nearly stretched, where the two modes meet: a guess to either side asks for none of them.
#[test]
fn analytic_nearly_stretched_bars_are_in_no_mode() {
    let (distance, to_bearing) = (1.3_f64.hypot(1.0), (-1.0_f64).atan2(1.3));
    let length = 0.5 * distance / 0.05_f64.cos();
    let scene = four_bar::Turning { coupler_length: length, rocker_length: length, ..Default::default() };
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    for guessed in [-0.6, 0.6] {
        let near = [to_bearing - 0.5 * guessed, to_bearing + 0.5 * guessed - PI];
        let state = system.consistent_start(&upright(near)).unwrap_or_else(|error| panic!("{guessed}: {error}"));
        let bent = elbow([state.q[5], state.q[8]]).abs();
        assert!((bent - 0.1_f64.sin()).abs() <= ROUNDING, "{guessed}: {bent}");
    }
}

/// What is told as reached is accepted when it is asked for; the same guess of places, with free angles, asks for no mode.
#[test]
fn invariant_mode_that_was_reached_is_accepted_and_what_is_not_guessed_is_in_no_mode() {
    let scene = four_bar::Turning::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let (near, error) = refused(&mut system);
    let message = error.to_string();
    let StartError::OtherAssemblyMode { values } = error else { panic!() };
    let of = |name: &str| values.iter().find(|value| value.name == name).unwrap();
    let got = [of("coupler.phi").got, of("rocker.phi").got];
    let state = system.consistent_start(&upright(got)).unwrap();
    assert!((state.q[5] - got[0]).hypot(state.q[8] - got[1]) <= ROUNDING);
    // eight digits of each, the guess and what was reached
    for value in &values {
        let digits = |text: &str| -> f64 { text.split(' ').next().unwrap().parse().unwrap() };
        let asked = message.split_once(&format!("{} near ", value.name)).unwrap().1;
        let reached = message.split_once(&format!("{} = ", value.name)).unwrap().1;
        assert!(
            (digits(asked) - value.given).abs() <= 1e-7 && (digits(reached) - value.got).abs() <= 1e-7,
            "{message}"
        );
    }
    assert!(message.contains(" rad, ") && message.ends_with("or hold one of them"), "{message}");
    let mut start = upright(near);
    (start.q_given[8], start.q_near[8]) = (false, false);
    let state = system.consistent_start(&start).unwrap();
    assert!(modes().iter().any(|mode| is_mode([state.q[5], state.q[8]], *mode)), "{:?}", state.q);
}

/// The short bars of a pantograph, from guesses all around, with the long ones held and with the long ones near: those of the short bars
/// that come out crossed are told, and never the long ones, which are as guessed.
#[test]
fn analytic_pantograph_is_not_folded_in_silence() {
    let (x, y) = (FRAC_PI_3.cos(), FRAC_PI_3.sin());
    let modes = two_bars([x, y], [2.5 * x, 1.5 * y], [0.5, 1.0]);
    let scene = pantograph::Drawing::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let mut n_refused = 0;
    for near in guesses(4) {
        let mut start = Start::free(12);
        start.give_position(2, FRAC_PI_3);
        start.give_position(5, -FRAC_PI_3);
        start.near_position(8, near[0]);
        start.near_position(11, near[1]);
        match system.consistent_start(&start) {
            Ok(state) => {
                let (asked, found) = (elbow(near), elbow([state.q[8], state.q[11]]));
                assert!(found * asked > 0.0 || found.abs().min(asked.abs()) < 0.5, "{near:?}: {asked} became {found}");
            }
            Err(StartError::OtherAssemblyMode { values }) => {
                n_refused += 1;
                let mut names: Vec<&str> = values.iter().map(|value| &*value.name).collect();
                names.sort();
                assert_eq!(names, ["inner.phi", "outer.phi"], "{near:?}");
                let moved: Vec<f64> = values.iter().map(|value| (value.got - value.given).abs()).collect();
                assert!(moved[0] >= moved[1], "the one that moved farthest comes first: {values:?}");
                let got = |name: &str| values.iter().find(|value| value.name == name).unwrap().got;
                let got = [got("inner.phi"), got("outer.phi")];
                assert!(modes.iter().any(|mode| is_mode(got, *mode)), "{near:?}: {values:?}");
            }
            Err(StartError::Contradiction { .. }) => {}
            Err(error) => panic!("{near:?}: {error}"),
        }
    }
    assert!((1..8).contains(&n_refused), "{n_refused} of 16");
    let mut n_refused = 0;
    for near in guesses(4) {
        let mut start = Start::free(12);
        for (i, angle) in [(2, FRAC_PI_3), (5, -FRAC_PI_3), (8, near[0]), (11, near[1])] {
            start.near_position(i, angle);
        }
        if let Err(StartError::OtherAssemblyMode { values }) = system.consistent_start(&start) {
            n_refused += 1;
            assert!(values.iter().any(|value| ["inner.phi", "outer.phi"].contains(&&*value.name)), "{values:?}");
        }
    }
    assert!(n_refused >= 1, "none of 16");
}
