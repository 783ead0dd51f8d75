//! Skates that hold up to a limit and slide beyond it.

use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::{SetupError, StopReason};
use ezy_core_tests::simulation;
use ezy_models::ezy_roller;

/// Changes are located to 1e-12 s; the value that is located carries rounding of 1e-15 m/s or N at slopes around one, and where
/// a slide ends its start counts, too.
const LOCATED_S: f64 = 4e-12;

/// Every motion here is a polynomial, which every method follows but for its tolerance of 1e-12.
const FOLLOWED: f64 = 2e-11;

/// Balance against energies around 1 J at tolerances of 1e-12.
const BALANCE_J: f64 = 1e-10;

model! {
    /// A sled that is pushed across its runner by 4 t - t², up to 4 N.
    pub model Sled {
        param limit: N = 3;
        param mass: kg = 2;
        param a: N/s = 4;
        param b: N/s^2 = 1;
        input push: N = 0;
        body sled { mass: mass, inertia: 1 }
        skate runner: at sled(0, 0) along sled(1, 0) limit limit;
        effect wave { force at sled(0, 0): (0, a * t - b * t^2); }
        effect hand { force at sled(0, 0): (0, push); }
        start rest { sled at (0, 0) angle 0; at rest; }
        scene waved { start rest; until 4.5 s; with wave; }
        scene pushed { start rest; until 3 s; with hand; }
    }
}

model! {
    /// A sled that is steered into a curve and out of it.
    pub model Curve {
        param m: kg = 50;
        param mu = 0.2;
        param g: m/s^2 = 9.81;
        param u: m/s = 4;
        param a: 1/s^2 = 0.3;
        param b: 1/s^3 = 0.05;
        body sled { mass: m, inertia: 2 }
        drive steer: sled.phi = a * t^2 - b * t^3;
        skate runner: at sled(0, 0) along sled(1, 0) limit mu * m * g;
        start fast { sled at (0, 0) angle 0; sled velocity (u, 0) rate 0; }
        scene ride { start fast; until 4 s; }
    }
}

model! {
    /// A runner that wears out under a steady push.
    pub model Fading {
        param push: N = 2;
        param fresh: N = 3;
        param wear: N/s = 1;
        param worn: N = 1;
        body sled { mass: 2, inertia: 1 }
        skate runner: at sled(0, 0) along sled(1, 0) limit max(fresh - wear * t, worn);
        effect hand { force at sled(0, 0): (0, push); }
        event fast: sled.vy > 0.25;
        start rest { sled at (0, 0) angle 0; at rest; }
        scene pushed { start rest; until 3 s; with hand; }
    }
}

model! {
    /// A runner of which nothing is left in the end.
    pub model Worn {
        param push: N = 2;
        param fresh: N = 3;
        param wear: N/s = 1;
        body sled { mass: 2, inertia: 1 }
        skate runner: at sled(0, 0) along sled(1, 0) limit fresh - wear * t;
        effect hand { force at sled(0, 0): (0, push); }
        start rest { sled at (0, 0) angle 0; at rest; }
        scene pushed { start rest; until 5 s; with hand; }
        scene caught { start rest; until 5 s; until sled.vy > 0.5; with hand; }
    }
}

model! {
    /// A runner whose limit is no number after a while.
    pub model Undefined {
        param life: s = 2;
        param push: N = 1;
        param c: N^2/s = 1;
        body sled { mass: 2, inertia: 1 }
        skate runner: at sled(0, 0) along sled(1, 0) limit 3 + sqrt(c * (life - t));
        effect hand { force at sled(0, 0): (0, push); }
        start rest { sled at (0, 0) angle 0; at rest; }
        scene pushed { start rest; until 5 s; with hand; }
    }
}

model! {
    /// A sled on a runner whose limit is no number where it comes back to rest.
    pub model Slick {
        param limit: N = 3; param a: N/s = 4; param b: N/s^2 = 1;
        param unit: m/s = 1; param late: s = 2;
        body sled { mass: 2, inertia: 1 }
        let u = sled.vy / unit + max(1 - t / late, 0);
        skate runner: at sled(0, 0) along sled(1, 0) limit limit * sin(u) / u;
        effect wave { force at sled(0, 0): (0, a * t - b * t^2); }
        start rest { sled at (0, 0) angle 0; at rest; }
        scene waved { start rest; until 6 s; with wave; }
    }
}

/// Of each kind one: a fixed step with interpolation, a method with dense output, a series, an implicit method.
const METHODS: [Method; 5] =
    [Method::rk4(0.05), Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)];

/// The same with a step that leaves nothing of a motion that is no polynomial.
const FINE: [Method; 5] =
    [Method::rk4(2e-3), Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)];

fn named(run: &Run) -> Vec<(&'static str, f64)> {
    run.events().iter().map(|occurred| (occurred.event.name, occurred.state.t)).collect()
}

fn assert_changes(run: &Run, expected: &[(&str, f64)]) {
    let found = named(run);
    assert_eq!(found.len(), expected.len(), "{found:?}, {}", run.outcome);
    for ((name, t), (expected_name, expected)) in found.iter().zip(expected) {
        assert_eq!(name, expected_name);
        assert!((t - expected).abs() <= LOCATED_S, "{name}: {t} for {expected}");
    }
}

#[test]
fn analytic_sled_lets_go_and_holds_again_by_every_method() {
    // 4 t - t² - 3 = (t - 1) (3 - t): with u = t - 1, 2 v = u² - u³/3 comes back to zero at u = 3
    for method in METHODS {
        let scene = sled::Waved::default();
        let run = simulation(&scene).method(method).every(0.1).run().unwrap();
        assert_changes(&run, &[("runner slides", 1.0), ("runner stops", 4.0)]);
        let end = run.last();
        // 2 y = u³/3 - u⁴/12
        assert!((end.get("sled.y").unwrap() - 1.125).abs() <= FOLLOWED, "{}", method.name());
        assert!(end.get("sled.vy").unwrap().abs() <= FOLLOWED);
    }
}

#[test]
fn analytic_reaction_of_a_sled_is_its_limit_while_it_slides() {
    let scene = sled::Waved::default();
    let run = simulation(&scene).method(Method::dop853(1e-12)).every(0.25).run().unwrap();
    // at a change both hold
    let is_change = |t: f64| (t - 1.0).abs() <= LOCATED_S || (t - 4.0).abs() <= LOCATED_S;
    for sample in run.samples().filter(|sample| !is_change(sample.t)) {
        let push = 4.0 * sample.t - sample.t * sample.t;
        let expected = if (1.0..4.0).contains(&sample.t) { 3.0 } else { push };
        let found = sample.get("lambda.runner").unwrap();
        assert!((found - expected).abs() <= FOLLOWED, "{found} for {expected} at {}", sample.t);
    }
}

#[test]
fn analytic_sled_slides_on_to_the_other_side_where_it_cannot_hold() {
    // limit 2: it comes to rest at 2 + √8 s, where it is pushed by -4 N
    for method in METHODS {
        let scene = sled::Waved { limit: 2.0, ..sled::Waved::default() };
        let run = simulation(&scene).method(method).until(5.0).run().unwrap();
        let (begins, turns) = (2.0 - 2f64.sqrt(), 2.0 + 8f64.sqrt());
        assert_changes(&run, &[("runner slides", begins), ("runner stops", turns), ("runner slides", turns)]);
        assert!(run.last().get("sled.vy").unwrap() < 0.0, "{}", method.name());
    }
}

/// Half of the time for which the push exceeds the limit, s.
const HUMP_S: f64 = 0.005;

#[test]
fn analytic_slide_shorter_than_a_quarter_of_a_step_is_followed() {
    // with u = t - 2 + d the push exceeds the limit by 2 d u - u²; the speed d u² - u³/3 over the mass returns to zero at u = 3 d,
    // where it falls with 3 d²/m
    let d = HUMP_S;
    let scene = sled::Waved { limit: 4.0 - d * d, ..sled::Waved::default() };
    let located = LOCATED_S / d + FOLLOWED / (3.0 * d * d / scene.mass);
    for method in [Method::rk4(0.1), METHODS[1], METHODS[2], METHODS[3]] {
        let run = simulation(&scene).method(method).run().unwrap();
        let found = named(&run);
        let [("runner slides", begins), ("runner stops", ends)] = found[..] else { panic!("{found:?}") };
        let off = (begins - (2.0 - d)).abs().max((ends - (2.0 + 2.0 * d)).abs());
        assert!(off <= located, "{}: {off:.1e}", method.name());
    }
}

#[test]
fn analytic_input_that_jumps_over_the_limit_lets_the_sled_go_at_once() {
    let scene = sled::Pushed::default();
    let order = Simulation::new(&scene).method(Method::rk4(0.1));
    let run = order.control(|now, set| {
        set.push = if now.t < 0.95 {
            2.0
        } else if now.t < 1.45 {
            5.0
        } else {
            1.0
        }
    });
    let run = run.every(0.03).run().unwrap();
    // 1 m/s² from 1 s to 1.5 s, then -1 m/s²
    assert_changes(&run, &[("runner slides", 1.0), ("runner stops", 2.0)]);
    assert!((run.last().get("sled.y").unwrap() - 0.25).abs() <= FOLLOWED);
    assert!((run.last().t - 3.0).abs() <= LOCATED_S);
}

#[test]
fn invariant_energy_of_a_sliding_sled_is_work_of_its_friction() {
    for method in FINE {
        let scene = sled::Waved::default();
        let run = simulation(&scene).method(method).work().every(0.3).run().unwrap();
        for sample in run.samples() {
            assert!(sample.energy.balance.abs() <= BALANCE_J, "{} at {}", sample.energy.balance, sample.t);
        }
        // 3 N over 1.125 m
        let friction = run.last().get("work.model").unwrap();
        assert!((friction + 3.375).abs() <= BALANCE_J, "{friction} by {}", method.name());
    }
}

#[test]
fn analytic_sled_leaves_a_curve_where_the_speed_is_too_high() {
    // m u φ' = mu m g with φ' = 0.6 t - 0.15 t²
    let scene = curve::Ride::default();
    let lets_go = 2.0 - (4.0 - scene.mu * scene.g / scene.u / 0.15).sqrt();
    for method in FINE {
        let run = simulation(&scene).method(method).run().unwrap();
        let found = named(&run);
        assert_eq!(found.iter().map(|(name, _)| *name).collect::<Vec<_>>(), ["runner slides", "runner stops"]);
        assert!((found[0].1 - lets_go).abs() <= LOCATED_S, "{} for {lets_go}", found[0].1);
    }
}

#[test]
fn cross_methods_agree_where_a_sled_holds_again_in_a_curve() {
    let scene = curve::Ride::default();
    let runs = [Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)];
    let ends = runs.map(|method| named(&simulation(&scene).method(method).run().unwrap())[1].1);
    assert!(ends.iter().all(|end| (end - ends[0]).abs() <= 1e-9), "{ends:?}");
}

#[test]
fn invariant_sled_that_keeps_to_its_limit_never_slides() {
    let scene = curve::Ride { mu: 10.0, ..curve::Ride::default() };
    let run = simulation(&scene).method(Method::dop853(1e-10)).run().unwrap();
    assert!(run.events().is_empty());
    // the rows hold the whole way
    assert!(run.monitors.velocity_residual.unwrap().value <= FOLLOWED);
}

#[test]
fn invariant_steppers_refuse_a_skate_that_may_slide() {
    let scene = sled::Waved::default();
    let error = simulation(&scene).stepper().map(|_| ()).unwrap_err();
    assert!(matches!(error, SetupError::Modes { what: "skate", name: "runner", .. }), "{error}");
}

#[test]
fn analytic_limit_with_a_discontinuity_is_followed_in_every_mode() {
    // it lets go where 3 - t is 2; then 2 v = (t - 1)²/2 up to 2 s, and 1/2 + (t - 2) from there on
    for method in [Method::dop853(1e-12), Method::rk4(0.05)] {
        let run = simulation(&fading::Pushed::default()).method(method).run().unwrap();
        assert_changes(&run, &[("runner slides", 1.0), ("fast", 2.0)]);
        assert!((run.last().get("sled.vy").unwrap() - 0.75).abs() <= FOLLOWED, "{}", method.name());
    }
}

#[test]
fn invariant_energy_of_a_roller_that_drifts_is_work() {
    let scene = ezy_roller::Skid { m0: 4.0, ..ezy_roller::Skid::default() };
    for method in [Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)] {
        let run = simulation(&scene).method(method).work().until(10.0).every(0.1).run().unwrap();
        assert!(run.outcome.reached_end(), "{}", run.outcome);
        assert!(run.events().len() >= 2, "{:?}", named(&run));
        for sample in run.samples() {
            assert!(sample.energy.balance.abs() <= BALANCE_J, "{} at {}", sample.energy.balance, sample.t);
            assert!(sample.get("lambda.rear_on_ice").unwrap().abs() <= scene.hold + FOLLOWED);
        }
        assert!(run.last().get("work.ice").unwrap() < 0.0, "{}", method.name());
    }
}

fn fault(run: &Run) -> (&'static str, f64, f64) {
    match &run.outcome {
        Outcome::Stopped { reason: StopReason::Motion(MotionError::SkateLimit { t, skate, value }), .. } => {
            (skate, *t, *value)
        }
        outcome => panic!("{outcome}"),
    }
}

#[test]
fn analytic_limit_that_is_used_up_ends_the_run_where_it_is() {
    for method in METHODS {
        let run = simulation(&worn::Pushed::default()).method(method).every(0.25).run().unwrap();
        let (skate, t, value) = fault(&run);
        assert!(skate == "runner" && t >= 3.0 - LOCATED_S && value <= 0.0, "{value} N at {t} by {}", method.name());
        assert_changes(&run, &[("runner slides", 1.0)]);
        let last = run.last();
        assert!((last.t - 3.0).abs() <= LOCATED_S, "{} by {}", last.t, method.name());
        // 2 v' = 2 - (3 - t)
        assert!((last.get("sled.vy").unwrap() - 1.0).abs() <= FOLLOWED, "{}", method.name());
        assert!(run.samples().all(|sample| sample.get("lambda.runner").unwrap() >= 0.0));
    }
}

#[test]
fn analytic_limit_that_is_used_up_behind_an_end_does_not_matter() {
    for method in METHODS {
        let run = simulation(&worn::Caught::default()).method(method).run().unwrap();
        assert!(run.outcome.reached_end(), "{} by {}", run.outcome, method.name());
        // 4 v = (t - 1)²
        assert!((run.last().t - 1.0 - 2f64.sqrt()).abs() <= LOCATED_S, "{} by {}", run.last().t, method.name());
    }
}

#[test]
fn analytic_limit_that_is_no_number_ends_the_run_while_the_skate_holds() {
    for method in METHODS {
        let run = simulation(&undefined::Pushed::default()).method(method).run().unwrap();
        let (skate, t, value) = fault(&run);
        assert!(skate == "runner" && t >= 2.0 && value.is_nan(), "{value} N at {t} by {}", method.name());
        assert!((run.last().t - 2.0).abs() <= LOCATED_S, "{} by {}", run.last().t, method.name());
    }
}

#[test]
fn invariant_limit_that_is_not_above_zero_at_the_start_is_refused() {
    for fresh in [0.0, -1.0] {
        let error = simulation(&worn::Pushed { fresh, ..worn::Pushed::default() }).run().unwrap_err();
        let expected = format!(
            "the motion cannot start: the limit of skate `runner` is {fresh} at t = 0 s; it must be above zero"
        );
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn invariant_sample_behind_a_change_that_failed_belongs_to_its_mode() {
    let run = simulation(&slick::Waved::default()).method(Method::dop853(1e-12)).run().unwrap();
    let (_, t, value) = fault(&run);
    assert!(value.is_nan() && t == run.last().t, "{value} N at {t}");
    assert_eq!(named(&run).last(), Some(&("runner stops", t)));
    // it still slides, and so its multiplier is the limit: sin(u)/u is 1 next to rest
    let last = run.last().get("lambda.runner").unwrap();
    assert!((last - 3.0).abs() <= FOLLOWED, "{last}");
}
