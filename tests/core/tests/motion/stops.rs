//! Stops: impacts, and rest on an end.

use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::StopReason;
use ezy_core_tests::simulation;

model! {
    /// A stone above a floor.
    pub model Stone {
        param e = 0.5;
        param m: kg = 2;
        param g: m/s^2 = 10;
        body stone { mass: m, inertia: 1 }
        slider rail: ground(0, 0) ~ stone(0, 0) along ground(0, 1);
        stop floor: stone.y from 0 restitution e;
        gravity (0, -g);
        start high { stone at (0, 5) angle 0; at rest; }
        scene falls { start high; until 5 s; }
    }
}

/// Landings are located to 1e-12 s, and each bounce goes on from the last one; methods keep to 1e-12.
const BOUNCED: f64 = 2e-11;

const METHODS: [Method; 4] = [Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-11)];

/// Down for 1 s, then flights of 1 s, 1/2 s, …: over after 3 s. Energy is lost in impacts alone, all 100 J.
#[test]
fn analytic_stone_bounces_and_rests() {
    for method in METHODS {
        let run = simulation(&stone::Falls::default()).method(method).work().run().unwrap();
        let events = run.events();
        let hits: Vec<f64> = events.iter().filter(|of| of.event.name == "floor hits").map(|of| of.state.t).collect();
        for (hit, expected) in hits.iter().zip([1.0, 2.0, 2.5, 2.75]) {
            assert!((hit - expected).abs() <= BOUNCED, "{method:?}: {hits:?}");
        }
        assert!(
            (events[0].state.v[1] + 10.0).abs() <= BOUNCED,
            "{method:?}: the state of `hits` is that before the impact"
        );
        let rests = &events[events.len() - 1];
        assert!(
            rests.event.name == "floor holds" && (rests.state.t - 3.0).abs() < 2e-9,
            "{method:?}: {}",
            rests.state.t
        );
        let last = run.last();
        assert!((last.get("lambda.floor").unwrap() + 20.0).abs() <= 1e-9, "{method:?}");
        assert!((last.get("work.stops").unwrap() + 100.0).abs() <= 1e-9, "{method:?}: {:?}", last.work);
    }
}

model! {
    /// A stone that is thrown upwards, and a floor that rises by 5 m at 0.5 s.
    pub model Lift {
        param e = 0.5;
        body stone { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ stone(0, 0) along ground(0, 1);
        stop floor: stone.y from 5 * (1 + sign(t - 0.5)) / 2 restitution e;
        gravity (0, -10);
        start thrown { stone at (0, 1) angle 0 velocity (0, 10); }
        scene flies { start thrown; until 0.8 s; }
    }
}

/// The floor rises through a stone that flies upwards at 5 m/s. It lifts the stone on to itself and strikes nothing: without the impact of
/// something that arrives there is no restitution, whatever its number, and the stone rests.
#[test]
fn analytic_floor_that_rises_under_a_stone_that_leaves_does_not_throw_it() {
    for e in [0.0, 0.5, 1.0] {
        let scene = lift::Flies { e };
        let run = simulation(&scene).method(Method::dop853(1e-12)).run().unwrap();
        let names: Vec<&str> = run.events().iter().map(|of| of.event.name).collect();
        assert_eq!(names, ["floor holds"], "e = {e}");
        let last = run.last();
        assert!(
            (last.get("stone.y").unwrap() - 5.0).abs() <= 1e-11 && last.get("stone.vy").unwrap().abs() <= 1e-11,
            "e = {e}"
        );
    }
}

#[test]
fn invariant_restitution_beyond_one_ends_the_run() {
    let scene = stone::Falls { e: 1.5, ..Default::default() };
    let run = simulation(&scene).run().unwrap();
    let Outcome::Stopped { reason: StopReason::Motion(MotionError::Restitution { t, value, .. }), .. } = &run.outcome
    else {
        panic!("{:?}", run.outcome)
    };
    assert!((t - 1.0).abs() <= BOUNCED && *value == 1.5);
}

model! {
    /// A stone on a floor that sinks with the acceleration `a`.
    pub model Sinking {
        param a: m/s^2 = 4;
        param h: m = 0;
        param above: m = 0;
        body stone { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ stone(0, 0) along ground(0, 1);
        stop floor: stone.y from h - a * t^2 / 2;
        gravity (0, -10);
        start resting { stone at (0, h + above) angle 0; at rest; }
        scene sinks { start resting; until 1 s; }
    }
}

/// Up to the acceleration of gravity the stone goes with the floor, which carries m (g − a); beyond that it falls freely and stays behind.
#[test]
fn analytic_floor_that_sinks_carries_what_falls_no_slower() {
    for h in [0.0, 1e3, -1e3] {
        for (a, sinks) in [(4.0, 4.0), (9.9, 9.9), (10.1, 10.0), (25.0, 10.0)] {
            let scene = sinking::Sinks { a, h, ..Default::default() };
            for method in [Method::dop853(1e-12), Method::taylor(1e-12), Method::rk4(1e-2)] {
                let run = simulation(&scene).method(method).run().unwrap();
                let last = run.last();
                let (y, v) = (last.get("stone.y").unwrap() - h, last.get("stone.vy").unwrap());
                // rounding of a height of 1 km is 1e-13 m
                assert!((y + 0.5 * sinks).abs() <= 1e-10 && (v + sinks).abs() <= 1e-10, "{method:?} {a} {h}: {y} {v}");
                let carried = if a < 10.0 { 2.0 * (10.0 - a) } else { 0.0 };
                let found = last.get("lambda.floor").unwrap();
                assert!((found + carried).abs() <= 1e-9, "{method:?} {a} {h}: {found} {carried}");
                let names: Vec<&str> = run.events().iter().map(|of| of.event.name).collect();
                assert!(!names.contains(&"floor hits"), "{method:?} {a} {h}: {names:?}");
            }
        }
    }
}

/// A tenth of what counts as zero, above the floor or in it, is on the floor.
#[test]
fn invariant_stone_within_the_tolerance_of_the_floor_rests_on_it() {
    for above in [-1e-13, 1e-13] {
        let scene = sinking::Sinks { above, h: 1.0, ..Default::default() };
        let run = simulation(&scene).method(Method::dop853(1e-12)).until(0.1).run().unwrap();
        let found = run.sample(0).unwrap().get("lambda.floor").unwrap();
        assert!((found + 12.0).abs() <= 1e-9 && run.events().is_empty(), "{above}: {found}, {:?}", run.events());
    }
}
