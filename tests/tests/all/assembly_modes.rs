//! Near values that give way: what moved is told, and another assembly mode than the one asked for is refused.

use ezy_core::dynamics::{MovedValue, StartError};
use ezy_core::model::Start;
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_core_tests::{simulation, system_of};
use ezy_models::mechanisms::{four_bar::four_bar, pendulum::pendulum};
use ezy_models::registry::MODELS;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI, TAU};

ezy_core::model! {
    /// Two long bars, and two short ones that make a parallelogram with parts of them; folded, the short bars cross.
    model Pantograph {
        body arm { mass: 2, inertia: 2*4/12 }
        body pen { mass: 2, inertia: 2*4/12 }
        body inner { mass: 0.5, inertia: 0.125/12 }
        body outer { mass: 1, inertia: 1/12 }
        hinge O: ground(0, 0) ~ arm(-1, 0);
        hinge C: arm(1, 0) ~ pen(-1, 0);
        hinge B: arm(0, 0) ~ inner(-0.25, 0);
        hinge D: pen(-0.5, 0) ~ outer(0.5, 0);
        hinge Q: inner(0.25, 0) ~ outer(-0.5, 0);
        gravity (0, -9.81);
        start open {
            arm near angle pi/3;
            pen near angle -pi/3;
            inner near angle -pi/3;
            outer near angle pi/3;
            at rest;
        }
        scene drawing { start open; until 1 s; }
    }
}

/// Of a loop of bars of length one.
const ROUNDING: f64 = 1e-12;

/// Sine of the angle from body `a` to body `b`: its sign says to which side the second bar turns off.
fn elbow(q: &[f64], [a, b]: [usize; 2]) -> f64 {
    (q[3 * b + 2] - q[3 * a + 2]).sin()
}

/// Guesses of two angles all around.
fn guesses() -> impl Iterator<Item = [f64; 2]> {
    const N: usize = 12;
    let angle = |i: usize| (i as f64 + 0.25) * TAU / N as f64 - PI;
    (0..N * N).map(move |i| [angle(i / N), angle(i % N)])
}

/// A start with the angles of some bodies held, and those of two others near.
fn start_from(n_bodies: usize, held: &[(usize, f64)], bodies: [usize; 2], near: [f64; 2]) -> Start {
    let mut start = Start::free(3 * n_bodies);
    held.iter().for_each(|&(body, angle)| start.give_position(3 * body + 2, angle));
    bodies.iter().zip(near).for_each(|(body, angle)| start.near_position(3 * body + 2, angle));
    start
}

/// Assembles two bars that close a loop, from guesses all around. A start that is accepted bends as its guess does, unless one of
/// both is nearly stretched; one that is refused tells the guess, and angles that bend the other way. Returns how many of these there are.
fn assert_elbow_is_kept_or_refused(
    scene: &dyn Scene,
    held: &[(usize, f64)],
    bars: [usize; 2],
    modes: [[f64; 2]; 2],
) -> usize {
    let mut system = system_of(scene, Backend::Auto).unwrap();
    let mut n_refused = 0;
    for near in guesses() {
        let start = start_from(system.info().bodies.len(), held, bars, near);
        let asked = elbow(&start.q, bars);
        match system.consistent_start(&start) {
            Ok(state) => {
                let found = elbow(&state.q, bars);
                assert!(found * asked > 0.0 || found.abs().min(asked.abs()) < 0.5, "{near:?}: {asked} became {found}");
            }
            Err(StartError::OtherAssemblyMode { values }) => {
                n_refused += 1;
                let of = |body: usize| {
                    values.iter().find(|value| value.name == system.info().coordinates[3 * body + 2].name)
                };
                let told = bars.map(|body| of(body).unwrap());
                assert_eq!(told.map(|value| value.given), near);
                let [first, second] = told.map(|value| value.got);
                assert!(asked * (second - first).sin() < 0.0, "{near:?}: {values:?}");
                // one of the two solutions of the triangle
                let is_mode = |mode: &[f64; 2]| {
                    told.iter().zip(mode).all(|(value, angle)| (value.got - angle).sin().abs() <= ROUNDING)
                };
                assert!(modes.iter().any(is_mode), "{near:?}: {values:?}");
            }
            // the search is stuck, and says so
            Err(StartError::Contradiction { .. }) => {}
            Err(error) => panic!("{near:?}: {error}"),
        }
    }
    n_refused
}

/// Angles of two bars of these lengths, the first from `from`, the second to `to`, that meet: bent to one side and to the other.
fn two_bars(from: [f64; 2], to: [f64; 2], [first, second]: [f64; 2]) -> [[f64; 2]; 2] {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let (distance, along) = (dx.hypot(dy), dy.atan2(dx));
    let angle = |a: f64, b: f64| ((a * a + distance * distance - b * b) / (2.0 * a * distance)).acos();
    let (at_first, at_second) = (angle(first, second), angle(second, first));
    [1.0, -1.0].map(|side| [along + side * at_first, along - side * at_second])
}

fn uneven_four_bar() -> four_bar::Turning {
    four_bar::Turning { base: 1.3, l2: 1.4, l3: 1.2, ..Default::default() }
}

#[test]
fn analytic_four_bar_keeps_its_elbow_or_is_refused() {
    // the rocker points from its bearing to the coupler
    let modes = two_bars([0.0, 1.0], [1.3, 0.0], [1.4, 1.2]).map(|[coupler, rocker]| [coupler, rocker + PI]);
    let n_refused = assert_elbow_is_kept_or_refused(&uneven_four_bar(), &[(0, FRAC_PI_2)], [1, 2], modes);
    assert!((1..72).contains(&n_refused), "{n_refused} of 144");
}

#[test]
fn analytic_pantograph_is_not_folded_in_silence() {
    let held = [(0, FRAC_PI_3), (1, -FRAC_PI_3)];
    // from the middle of the arm to a point of the pen, which is beyond its end
    let (x, y) = (FRAC_PI_3.cos(), FRAC_PI_3.sin());
    let modes = two_bars([x, y], [2.5 * x, 1.5 * y], [0.5, 1.0]);
    assert!(
        (modes[0][0] - FRAC_PI_3).abs().min((modes[1][0] + FRAC_PI_3).abs()) <= ROUNDING,
        "a parallelogram: {modes:?}"
    );
    let n_refused = assert_elbow_is_kept_or_refused(&pantograph::Drawing::default(), &held, [2, 3], modes);
    assert!((1..72).contains(&n_refused), "{n_refused} of 144");
}

/// A near value may lead into the other mode, too, when no angle is held: the one that moved least is taken for the driver.
#[test]
fn invariant_folded_pantograph_is_refused_with_both_modes_when_all_give_way() {
    let scene = pantograph::Drawing::default();
    let order = |inner: f64, outer: f64| {
        let order = simulation(&scene).until(0.0).project_start().start("arm.phi", FRAC_PI_3);
        order.start("pen.phi", -FRAC_PI_3).start("inner.phi", inner).start("outer.phi", outer).run()
    };
    let mut n_refused = 0;
    for [inner, outer] in guesses() {
        let Err(SetupError::Start(error)) = order(inner, outer) else { continue };
        n_refused += 1;
        let StartError::OtherAssemblyMode { values } = &error else { panic!("{inner}, {outer}: {error}") };
        let message = error.to_string();
        for MovedValue { name, .. } in values {
            assert!(message.contains(&format!("{name} near ")) && message.contains(&format!("{name} = ")), "{message}");
        }
        assert!(message.ends_with("or hold one of them"), "{message}");
    }
    assert!(n_refused > 0);
}

#[test]
fn invariant_mode_that_was_reached_runs_when_it_is_asked_for() {
    let scene = uneven_four_bar();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let start = |near| start_from(3, &[(0, FRAC_PI_2)], [1, 2], near);
    let refused = guesses().find_map(|near| match system.consistent_start(&start(near)) {
        Err(StartError::OtherAssemblyMode { values }) => Some(values),
        _ => None,
    });
    let values = refused.unwrap();
    let of = |name: &str| values.iter().find(|value| value.name == name).unwrap().got;
    let [coupler, rocker] = [of("coupler.phi"), of("rocker.phi")];
    let state = system.consistent_start(&start([coupler, rocker])).unwrap();
    assert!((state.q[5] - coupler).hypot(state.q[8] - rocker) <= ROUNDING);
}

/// Guesses are for a crank that is upright; it is held a right angle and a radian away.
#[test]
fn analytic_near_values_that_move_by_radians_are_told() {
    let run =
        simulation(&uneven_four_bar()).until(0.0).start("crank.phi", -1.0).start("crank.omega", 0.0).run().unwrap();
    let [[coupler, rocker], _] = two_bars([(-1.0_f64).cos(), (-1.0_f64).sin()], [1.3, 0.0], [1.4, 1.2]);
    let told: Vec<(&str, &str, f64)> = run.moved.iter().map(|value| (&*value.name, value.unit, value.given)).collect();
    assert_eq!(told, [("coupler.phi", "rad", 0.0), ("rocker.phi", "rad", FRAC_PI_2)]);
    // the rocker points from its bearing to the coupler
    for (value, angle) in run.moved.iter().zip([coupler, rocker + PI]) {
        assert!((value.got - angle).sin().abs() <= ROUNDING && (value.got - angle).cos() > 0.0, "{value}: {angle}");
    }
    assert!(run.moved[0].got > 1.5, "{:?}", run.moved);
}

#[test]
fn analytic_projected_velocities_are_told() {
    let scene = four_bar::Turning::default();
    let order = simulation(&scene).until(0.0).start("crank.omega", -1.0).start("rocker.omega", -0.5);
    let run = order.project_start().run().unwrap();
    let told: Vec<(&str, &str, f64)> = run.moved.iter().map(|value| (&*value.name, value.unit, value.given)).collect();
    assert_eq!(told, [("crank.omega", "rad/s", -1.0), ("rocker.omega", "rad/s", -0.5)]);
    run.moved.iter().for_each(|value| assert_eq!(run.first().get(&value.name), Ok(value.got)));
}

/// A pendulum's height that is held decides its angle.
#[test]
fn analytic_last_digits_of_a_guess_are_not_told() {
    let scene = pendulum::Swing::default();
    for (off, n_told) in [(2e-7, 0), (-2e-7, 0), (1e-5, 1), (-1e-5, 1)] {
        let mut system = system_of(&scene, Backend::Auto).unwrap();
        let mut start = Start::free(3);
        start.give_position(0, FRAC_PI_3.cos());
        start.near_position(2, FRAC_PI_3 + off);
        let state = system.consistent_start(&start).unwrap();
        assert!((state.q[2] - FRAC_PI_3).abs() <= ROUNDING, "{off}");
        assert_eq!(system.moved_values(&start, &state).len(), n_told, "{off}");
    }
}

/// What turns every angle of a consistent start, rad: less than leads to the other side of an elbow.
const TURNED: f64 = 0.1;

#[test]
fn invariant_no_scene_is_told_anything_of_its_own_start_nor_refused_nearby() {
    let mut n = 0;
    for entry in MODELS.iter().flat_map(|model| model.scenes) {
        let scene = (entry.new)();
        let mut system = system_of(&*scene, Backend::Auto).unwrap();
        let given = system.scene_start();
        let state = system.consistent_start(&given).unwrap();
        assert_eq!(system.moved_values(&given, &state), [], "{}/{}", scene.info().model, entry.name);
        for sign in [1.0, -1.0] {
            let mut start = given.clone();
            for (i, q) in state.q.iter().enumerate().skip(2).step_by(3) {
                start.near_position(i, q + if i % 2 == 0 { sign * TURNED } else { -sign * TURNED });
            }
            if let Err(error) = system.consistent_start(&start) {
                assert!(!matches!(error, StartError::OtherAssemblyMode { .. }), "{}: {error}", entry.name);
            }
        }
        n += 1;
    }
    assert!(n >= 40, "{n} scenes");
}
