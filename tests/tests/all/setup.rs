//! Orders that cannot be carried out, each with its message; runs that stop on the way.

use crate::scenes::{Case, driven, set};
use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::{SetupError, StopReason};
use ezy_core_tests::simulation;

fn message(change: impl for<'s> Fn(Simulation<'s, &'s dyn Scene>) -> Simulation<'s, &'s dyn Scene>) -> String {
    let case = driven().remove(0);
    change(simulation(&*case.scene).method(Method::rk4(1e-3))).run().unwrap_err().to_string()
}

fn message_with(parameter: &str, value: f64) -> String {
    let mut case = driven().remove(0);
    set(&mut *case.scene, &[(parameter, value)]);
    simulation(&*case.scene).run().unwrap_err().to_string()
}

#[test]
fn invariant_bad_steps_are_refused() {
    for (step, text) in [(-1.0, "-1 s"), (0.0, "0 s"), (f64::NAN, "NaN s"), (f64::INFINITY, "inf s")] {
        let error = message(|s| s.method(Method::rk4(step)));
        assert_eq!(error, format!("the step is {text}; give a positive step"));
    }
    let error = message(|s| s.method(Method::rk4(1e-12)));
    assert!(error.starts_with("6.0e13 steps of 1e-12 s") && error.contains("larger step"), "{error}");
}

#[test]
fn invariant_bad_ends_and_intervals_are_refused() {
    for end in [f64::NAN, f64::INFINITY, -1.0] {
        let error = message(|s| s.until(end));
        assert!(error.starts_with(&format!("the run is to end at {end} s but starts at 0 s")), "{error}");
    }
    for every in [f64::NAN, 0.0, -0.1] {
        let error = message(|s| s.every(every));
        assert!(error.starts_with(&format!("the recording interval is {every} s")), "{error}");
    }
    assert!(message(|s| s.every(1e-9)).contains("give a longer interval"));
}

/// What is accepted fails later, by a limit that is none.
fn is_accepted(order: impl for<'s> FnOnce(Simulation<'s, &'s dyn Scene>) -> Simulation<'s, &'s dyn Scene>) -> bool {
    let case = driven().remove(0);
    let error =
        order(simulation(&*case.scene).method(Method::rk4(1e-3))).until(60.0).max_drift(-1.0).run().unwrap_err();
    matches!(error, SetupError::Limit { .. })
}

#[test]
fn invariant_orders_out_of_proportion_are_refused_and_large_ones_accepted() {
    for (n, accepted) in [(1e9, true), (1e11, false)] {
        assert_eq!(is_accepted(|s| s.method(Method::rk4(60.0 / n))), accepted, "{n:e} steps");
    }
    for (tolerance, accepted) in [(0.5, true), (50.0, false)] {
        assert_eq!(is_accepted(|s| s.method(Method::dop853(tolerance))), accepted, "a tolerance of {tolerance}");
    }
    // 18 numbers of coordinates, velocities and accelerations, and four multipliers, make a sample
    for (numbers, accepted) in [(1e8, true), (1e10, false)] {
        assert_eq!(is_accepted(|s| s.every(60.0 * 22.0 / numbers)), accepted, "{numbers:e} numbers");
    }
}

#[test]
fn invariant_bad_parameters_and_masses_are_named() {
    assert_eq!(message_with("b", f64::NAN), "parameter `b` is NaN; give it a finite value");
    assert_eq!(message_with("omega", f64::INFINITY), "parameter `omega` is inf; give it a finite value");
    assert_eq!(message_with("m1", -1.0), "the mass of body `seat` is -1; it must be finite and not negative");
    assert_eq!(message_with("i2", -0.5), "the inertia of body `bar` is -0.5; it must be finite and not negative");
}

#[test]
fn invariant_infinite_inertia_is_named() {
    let mut scene = ezy_tests::shapes::double_pendulum::Swing::default();
    set(&mut scene, &[("l", 1e200)]);
    let error = simulation(&scene).run().unwrap_err().to_string();
    assert_eq!(error, "the inertia of body `upper` is inf; it must be finite and not negative");
}

#[test]
fn invariant_unknown_start_names_come_with_the_nearest() {
    let error = message(|s| s.start("seat.fi", 1.0));
    assert!(error.starts_with("start value `seat.fi` is not known (did you mean `seat."), "{error}");
    assert!(error.contains("known: seat.x, seat.y, seat.phi") && error.contains("bar.omega"), "{error}");
}

#[test]
fn invariant_overflow_stops_with_the_last_good_state() {
    for Case { route, mut scene } in driven() {
        set(&mut *scene, &[("m0", 1e200)]);
        let run = simulation(&*scene).method(Method::rk4(1e-3)).every(1e-3).run().unwrap();
        let Outcome::Stopped { t, reason: StopReason::Motion(reason), .. } = &run.outcome else {
            panic!("{route}: {}", run.outcome)
        };
        assert!(matches!(reason, MotionError::NotFinite { .. }), "{route}: {reason}");
        assert_eq!(run.last().t, *t, "{route}");
        assert!(run.last().numbers().take(13).all(f64::is_finite), "{route}");
    }
}

#[test]
fn invariant_run_stops_before_its_kinetic_energy_overflows() {
    let mut scene = ezy_models::vehicles::single_track_car::single_track_car::Limit::default();
    set(&mut scene, &[("lr", 1.4e6)]);
    let run = simulation(&scene).method(Method::rk4(1e-3)).until(1.0).run().unwrap();
    assert!(run.outcome.to_string().contains("is not finite after"), "{}", run.outcome);
    assert!(run.last().energy.kinetic.is_finite());
}

#[test]
fn invariant_progress_rises_to_one() {
    for Case { route, scene } in driven() {
        let mut told = Vec::new();
        simulation(&*scene).method(Method::rk4(1e-3)).until(1.0).on_progress(|p| told.push(p)).run().unwrap();
        assert!(told.is_sorted() && told.last() == Some(&1.0) && told.len() == 100, "{route}: {told:?}");
    }
}

#[test]
fn invariant_order_of_a_run_can_be_handed_to_another_thread() {
    fn assert_send<T: Send>() {}
    assert_send::<Simulation<'_, &dyn Scene>>();
    assert_send::<Stepper<'_, &dyn Scene>>();
    assert_send::<Run>();
    for Case { route, scene } in driven() {
        let mut told = 0;
        let here = simulation(&*scene).method(Method::rk4(1e-3)).until(0.1).run().unwrap();
        let order = simulation(&*scene).method(Method::rk4(1e-3)).until(0.1).on_progress(|_| told += 1);
        let there = std::thread::scope(|threads| threads.spawn(move || order.run()).join()).unwrap().unwrap();
        assert_eq!(here.last().coordinates, there.last().coordinates, "{route}");
        assert!(told > 0, "{route}");
    }
}
