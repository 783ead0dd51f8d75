//! The error that a run says it has.

use ezy_core::model::Name;
use ezy_core::prelude::*;
use ezy_core::simulate::{ErrorEstimate, SetupError};
use ezy_core_tests::simulation;
use ezy_models::{
    chain, double_pendulum, ezy_roller, pendulum, single_track_car, skateboard, tractor_trailers, wheeled_snake,
};
use ezy_tests::estimates::{Question, Reference};
use ezy_tests::shapes::tethered;
use std::sync::atomic::AtomicBool;

model! {
    /// A cart that a force drives away from its place: x'' = k² x.
    pub model Balance {
        param k: s^-1 = 4.0;
        param m: kg = 1.0;
        body cart { mass: m, inertia: 1 }
        force at cart(0, 0): (m*k^2*cart.x, 0);
        start still { cart at (0, 0) angle 0; at rest; }
        scene lost { start still; until 3 s; }
    }
}

/// An estimate is within this factor of the error.
const FACTOR: f64 = 5.0;

/// Errors of a few steps that are rounding: of numbers up to 10.
const ROUNDING: f64 = 1e-14;

fn estimate(run: &Run) -> &ErrorEstimate {
    run.error_estimate.as_ref().expect("asked for").as_ref().expect("an estimate")
}

#[test]
fn cross_estimates_are_within_a_factor_of_five_of_the_error() {
    let scenes: [(&str, Box<dyn Scene>, &[Method]); 5] = [
        (
            "ezyroller/drift",
            Box::new(ezy_roller::Drift::default()),
            &[Method::dop853(1e-6), Method::taylor(1e-9), Method::gauss(1e-9), Method::radau(1e-7), Method::rk4(1e-2)],
        ),
        (
            "doublependulum/swing",
            Box::new(double_pendulum::Swing::default()),
            &[Method::taylor(1e-6), Method::dop853(1e-8)],
        ),
        ("skateboard/carved", Box::new(skateboard::Carved::default()), &[Method::taylor(1e-14), Method::dop853(1e-12)]),
        ("tractortrailers/towed", Box::new(tractor_trailers::Towed::default()), &[Method::radau(1e-12)]),
        ("wheeledsnake/floating", Box::new(wheeled_snake::Floating::default()), &[Method::taylor(1e-6)]),
    ];
    for (name, scene, methods) in scenes {
        let question = Question::of(&*scene);
        let reference = Reference::of(&question).expect("a reference");
        for &method in methods {
            let (judged, amplification) = reference.judge(&question, method).expect("a run");
            assert!(!judged.is_empty() && amplification.is_some(), "{name} {method:?}");
            for judged in judged {
                let ratio = judged.ratio();
                // at the level of rounding it may be larger: the second run rounds, too
                let most = if method.tolerance().is_some_and(|t| t.relative < 1e-13) { f64::INFINITY } else { FACTOR };
                assert!((1.0 / FACTOR..=most).contains(&ratio), "{name} {method:?}: {ratio} {judged:?}");
            }
        }
    }
}

/// Over a few steps a thousandth of the tolerance may be reached by the same steps: another method then tells the error, which is not 0.
#[test]
fn cross_estimates_of_runs_of_a_few_steps_are_not_zero() {
    let scene = pendulum::Quarter::default();
    let mut n_same = 0;
    for until_s in [0.05, 0.1, 0.2, 0.3, 0.4] {
        let order = |method| simulation(&scene).method(method).until(until_s);
        let exact = order(Method::dop853(1e-14)).run().unwrap();
        let off = |run: &Run, level: fn(&Sample<'_>) -> Vec<f64>| {
            let pairs = level(&run.last()).into_iter().zip(level(&exact.last()));
            pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()))
        };
        for method in [Method::dop853(1e-3), Method::dop853(1e-5), Method::taylor(1e-4), Method::radau(1e-3)] {
            let run = order(method).estimate_error().run().unwrap();
            let estimate = estimate(&run);
            n_same += u32::from(estimate.second.name() != method.name());
            for (quantity, error) in [
                ("positions", off(&run, |sample| sample.coordinates.to_vec())),
                ("velocities", off(&run, |sample| sample.velocities.to_vec())),
            ] {
                let told = estimate.errors.iter().filter(|told| told.quantity == quantity);
                let told = told.fold(0.0, |most: f64, told| most.max(told.at_end));
                let is_rounding = error <= ROUNDING;
                assert!(is_rounding || told >= error / FACTOR, "{method:?} to {until_s} s: {told:e} of {error:e}");
            }
        }
    }
    assert!(n_same >= 2, "{n_same} runs of the same steps");
}

/// First steps hardly depend on a tolerance: of three steps and of four, with a smaller one, the first two are as long, and with them the error.
#[test]
fn cross_estimates_of_runs_with_steps_as_long_are_not_too_small() {
    let scene = chain::Swing { n: 6, m: 2.0921071681612773, g: 13.718224817986986, ..Default::default() };
    let given = [("link[3].y", 3.1319393763740626), ("link[4].omega", 2.242763693175838)];
    let given = given.map(|(name, value)| (name.into(), value));
    let until_s = 0.17759191702680352;
    assert_told(&scene, &given, until_s, Method::dop853(4.1483465036629727e-4), 4);
}

/// Of three steps of an implicit method and of four: none of the explicit ones near rounding is asked, since it may be slow.
#[test]
fn cross_estimates_of_implicit_runs_with_steps_as_long_are_not_too_small() {
    let scene = single_track_car::Thrust {
        lr: 3.2433732588722974,
        m: 1.556364148132999e3,
        delta: 7.703491585863009e-1,
        cr: 6.80088249292767e4,
        ff: 4.124012263696918e5,
        f: 4e2,
        ..Default::default()
    };
    let given = [("car.x", 8.77519625320891e-1), ("car.vx", 1.123239847478455)];
    let given = given.map(|(name, value)| (name.into(), value));
    let (until_s, method) = (0.0022399822840725283, Method::radau(1.7357742320532432e-5));
    assert_told(&scene, &given, until_s, method, 4);
    let order = simulation(&scene).method(method).until(until_s).project_start().estimate_error();
    let run = given.iter().fold(order, |order, (name, value)| order.start(&**name, *value)).run().unwrap();
    assert_eq!(estimate(&run).second.name(), "radau");
}

/// At the end the errors of four steps and of six happen to be alike, a fifth of those before it.
#[test]
fn cross_estimates_where_errors_of_both_runs_are_alike_are_not_too_small() {
    let scene = tethered::Circle::default();
    assert_told(&scene, &[], 0.7154224131259377, Method::radau(1.4651924156278827e-5), 4);
}

/// A tyre lets the car go within a tenth of the first step, and only that step is limited by the tolerance.
#[test]
fn cross_estimates_of_two_steps_and_of_three_are_not_too_small() {
    let scene = single_track_car::Thrust {
        lf: 2.7070001378859314,
        j: 1.0234048411112165e3,
        delta: 5.713134673226763e-6,
        cr: 1.926394943456055e8,
        ff: 5.939783534096464e3,
        f: 4.054906776036846e1,
        drag: 0.5,
        ..Default::default()
    };
    let given = [("car.x".into(), 1.0)];
    assert_told(&scene, &given, 0.0037895416133374034, Method::radau(7.209913076572496e-6), 2);
}

/// A run that is off by a fiftieth of what its tolerance lets expect, and at the end by as much as one with a hundredth of its tolerance.
#[test]
fn cross_estimates_of_a_first_run_that_is_lucky_are_not_too_small() {
    let scene =
        double_pendulum::Swing { l1: 1.7412131166858185, m1: 1.1303772172565618, g: 9.81, ..Default::default() };
    let given = [("lower.y", 6.882252518062537e-1), ("lower.vy", -5.586849728085332e-1)];
    let given = given.map(|(name, value)| (name.into(), value));
    assert_told(&scene, &given, 5.147493568147084, Method::dop853(1.6756387502785654e-8), 4);
}

model! {
    /// A speed that dies out within a microsecond, on a body that goes on.
    pub model Decay {
        param k: N*s/m = 1e6;
        body cart { mass: 1, inertia: 1 }
        force at cart(0, 0): (-k*cart.vx, 0);
        start pushed { cart at (0, 0) angle 0 velocity (1, 0) rate 0; }
        scene dies_out { start pushed; until 1 s; }
    }
}

/// Steps of `radau` grow as far as they may there, and explicit ones near rounding would take millions.
#[test]
fn invariant_estimates_of_decays_are_by_the_implicit_method() {
    let scene = decay::DiesOut::default();
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-9] {
        let run = simulation(&scene).method(Method::radau(tolerance)).estimate_error().run().unwrap();
        assert_eq!(estimate(&run).second.name(), "radau", "{tolerance:e}");
    }
}

/// No error is told by less than a fifth of it, of at least so many above rounding.
fn assert_told(scene: &dyn Scene, given: &[(Name, f64)], until_s: f64, method: Method, n_errors: usize) {
    let question = Question { scene, given, until_s, most_steps: 1_000, counts_rounding: false };
    let reference = Reference::of(&question).expect("a reference");
    let (judged, _) = reference.judge(&question, method).expect("a run");
    assert!(judged.len() >= n_errors, "{judged:?}");
    assert!(judged.iter().all(|judged| judged.ratio() >= 1.0 / FACTOR), "{judged:?}");
}

/// A thousandth of the tolerance takes DOP853 2.4 times the steps: it tells the error by itself.
#[test]
fn invariant_estimate_of_a_run_of_many_steps_is_by_its_own_method() {
    let scene = ezy_roller::Driven::default();
    let run = simulation(&scene).method(Method::dop853(1e-6)).until(10.0).estimate_error().run().unwrap();
    assert_eq!(estimate(&run).second.name(), "dop853");
}

model! {
    /// A cart that shakes too fast for the samples of fixed steps.
    pub model Shaken {
        param omega: rad/s = 100;
        body cart { mass: 1, inertia: 1 }
        force at cart(0, 0): (cos(omega*t), 0);
        start still { cart at (0, 0) angle 0; at rest; }
        scene shakes { start still; until 1 s; }
    }
}

/// A force of eight periods in a step is the same at all its nodes and at those of half the step: both push all the time, and only a method that
/// sees the force tells the error, nearly 0.5 m.
#[test]
fn analytic_estimate_of_fixed_steps_sees_what_they_sample_too_seldom() {
    let step_s = 0.1;
    let scene = shaken::Shakes { omega: 16.0 * std::f64::consts::PI / step_s };
    let run = simulation(&scene).method(Method::rk4(step_s)).estimate_error().run().unwrap();
    let exact = (1.0 - scene.omega.cos()) / scene.omega.powi(2);
    let error = (run.last().coordinates[0] - exact).abs();
    assert!(error > 0.4, "{error}");
    let told = estimate(&run).errors.iter().find(|told| told.quantity == "positions" && told.unit == "m").unwrap();
    // and what the second run may be off by, a thousandth
    assert!((told.at_end / error - 1.001).abs() <= 1e-9, "{} for {error}", told.at_end);
}

/// The user's bound on steps is one of the runs beside, too: with ten thousand steps of a tolerance that needs more, there is no estimate.
#[test]
fn invariant_bound_on_steps_holds_for_the_runs_beside() {
    let scene = ezy_roller::Driven::default();
    let run = |most| simulation(&scene).method(Method::dop853(1e-6)).max_steps(most).estimate_error().run().unwrap();
    let enough = run(10_000);
    assert!(enough.error_estimate.as_ref().unwrap().is_ok());
    // as many as the run itself takes: a thousandth of the tolerance takes more
    let scarce = run(enough.cost.steps + enough.cost.rejected);
    assert!(scarce.outcome.reached_end());
    let second = &scarce.error_estimate.as_ref().unwrap().as_ref().map(|estimate| estimate.second.tolerance());
    assert!(second.is_err() || second.unwrap().is_some_and(|looser| looser.relative > 1e-6), "{second:?}");
}

#[test]
fn analytic_amplification_is_that_of_the_linear_motion() {
    for method in
        [Method::rk4(1e-3), Method::dop853(1e-6), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-8)]
    {
        let scene = balance::Lost::default();
        let run = simulation(&scene).method(method).every(0.1).estimate_error().run().unwrap();
        let found = estimate(&run).amplification.unwrap();
        // x and x' grow by k cosh(kt) at most; the start is moved in both, by up to the same amount
        let (k, t) = (scene.k, 3.0);
        let most = f64::cosh(k * t) * (k + 1.0);
        assert!((0.05 * most..=most).contains(&found), "{method:?}: {found:e} of {most:e}");
        // the cart itself stays where it is
        assert_eq!(run.last().get("cart.x").unwrap(), 0.0);
    }
    let tame = pendulum::Swing::default();
    let run = simulation(&tame).method(Method::dop853(1e-9)).every(0.1).estimate_error().run().unwrap();
    assert!(estimate(&run).amplification.unwrap() < 100.0);
}

/// The same growth, from other directions of the move and by runs with errors of their own.
const SAME_GROWTH: f64 = 3.0;

#[test]
fn cross_amplification_is_that_of_the_motion_with_every_method() {
    let scene = double_pendulum::Swing::default();
    let of = |method: Method| {
        let run = simulation(&scene).method(method).until(8.0).every(0.02).estimate_error().run().unwrap();
        estimate(&run).amplification.unwrap()
    };
    let exact = of(Method::taylor(1e-11));
    assert!(exact > 1e3, "{exact:e}");
    for method in [Method::dop853(1e-5), Method::radau(1e-5), Method::dop853(1e-12), Method::rk4(1e-3)] {
        let found = of(method);
        assert!((exact / SAME_GROWTH..=exact * SAME_GROWTH).contains(&found), "{method:?}: {found:e} for {exact:e}");
    }
}

#[test]
fn invariant_estimate_without_a_tighter_run_is_too_large() {
    // not analytic, so that no other method takes over at the level of rounding
    let scene = skateboard::Ridden::default();
    let order = || simulation(&scene).method(Method::dop853(2e-14)).until(0.5).every(0.1);
    let run = order().estimate_error().run().unwrap();
    assert_eq!(estimate(&run).second, Method::dop853(2e-13));
    let looser = order().method(Method::dop853(2e-13)).run().unwrap();
    let apart = run
        .samples()
        .zip(looser.samples())
        .map(|(a, b)| a.coordinates.iter().zip(b.coordinates).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())));
    let apart = apart.fold(0.0, f64::max);
    let said = estimate(&run).errors.iter().filter(|error| error.quantity == "positions");
    assert_eq!(said.map(|error| error.largest).fold(0.0, f64::max), apart);
}

#[test]
fn invariant_estimate_leaves_the_run_as_it_is() {
    let scene = ezy_roller::Driven::default();
    for method in
        [Method::rk4(1e-2), Method::dop853(1e-6), Method::taylor(1e-8), Method::gauss(1e-8), Method::radau(1e-6)]
    {
        let order = || simulation(&scene).method(method).until(2.0).every(0.25).work();
        let (alone, estimated) = (order().run().unwrap(), order().estimate_error().run().unwrap());
        assert_eq!((alone.cost.steps, alone.cost.evaluations), (estimated.cost.steps, estimated.cost.evaluations));
        assert_eq!(alone.samples().len(), estimated.samples().len());
        for (a, b) in alone.samples().zip(estimated.samples()) {
            assert!(a.numbers().zip(b.numbers()).all(|(a, b)| a.to_bits() == b.to_bits()));
        }
        assert!(alone.error_estimate.is_none());
    }
}

#[test]
fn invariant_end_by_an_event_has_an_error_of_its_time() {
    let scene = pendulum::Quarter::default();
    let run = simulation(&scene).method(Method::dop853(1e-6)).every(0.1).estimate_error().run().unwrap();
    let Outcome::ReachedEvent { t, .. } = run.outcome else { panic!("{}", run.outcome) };
    let exact = simulation(&scene).method(Method::dop853(1e-13)).run().unwrap();
    let error = (t - exact.last().t).abs();
    let end = estimate(&run).errors.last().unwrap();
    assert_eq!((end.quantity, end.unit.as_str()), ("end", "s"));
    assert!((error / FACTOR..=error * FACTOR).contains(&end.at_end), "{} for {error}", end.at_end);
}

#[test]
fn invariant_run_whose_error_is_not_known_says_why() {
    let scene = ezy_roller::Driven::default();
    let order = || simulation(&scene).method(Method::dop853(1e-9)).until(5.0).every(0.5).estimate_error();
    let law = Simulation::new(&scene).method(Method::rk4(1e-3)).until(5.0).estimate_error().control(|_, _| {});
    assert!(matches!(law.run(), Err(SetupError::ControlledOnce)));
    let short = order().max_steps(3).run().unwrap();
    assert_eq!(short.error_estimate.unwrap().unwrap_err().to_string(), "the run did not come to its end");
    let flag = AtomicBool::new(true);
    let interrupted = order().interrupted_by(&flag).run().unwrap();
    assert!(matches!(interrupted.outcome, Outcome::Interrupted { .. }) && interrupted.error_estimate.unwrap().is_err());
}
