//! What is asked for and cannot be: steps, tolerances, times and records.

use super::runs::cart;
use super::skates::sled;
use ezy_core::dynamics::{MotionError, SystemError};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_core_tests::{simulation, system_of};

fn order(scene: &cart::Pushed) -> Simulation<'_, &dyn Scene> {
    simulation(scene).method(Method::rk4(0.1))
}

fn refused(order: Simulation<'_, &dyn Scene>) -> SetupError {
    order.run().expect_err("it is refused")
}

#[test]
fn invariant_steps_and_ends_that_are_no_times_are_refused() {
    let scene = cart::Pushed::default();
    for step_s in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let error = refused(order(&scene).method(Method::rk4(step_s)));
        assert!(matches!(error, SetupError::Step { step_s: told } if told.to_bits() == step_s.to_bits()), "{error}");
    }
    for until_s in [-0.1, f64::NAN, f64::INFINITY] {
        let error = refused(order(&scene).until(until_s));
        assert!(matches!(error, SetupError::Until { start_s: 0.0, .. }), "{error}");
    }
    for every_s in [0.0, -1.0, f64::NAN] {
        assert!(matches!(refused(order(&scene).every(every_s)), SetupError::Every { .. }), "{every_s}");
    }
    // no step to the start
    let run = order(&scene).until(0.0).run().unwrap();
    assert!(
        run.outcome.reached_end() && run.cost.steps == 0 && run.samples().len() == 1 && run.monitors.steps_s.is_none()
    );
}

/// Ten thousand million steps are allowed, and 1e9 numbers, of which a sample has three for each of the 3 coordinates and one for each of the 3 rows
/// of the cart and its rail.
#[test]
fn analytic_runs_that_would_not_end_or_not_fit_are_refused() {
    let scene = cart::Pushed::default();
    let error = refused(order(&scene).method(Method::rk4(0.9e-10)).until(1.0));
    let SetupError::TooManySteps { steps, step_s, limit } = error else { panic!("{error}") };
    assert!((steps * step_s - 1.0).abs() <= 1e-12 && limit == 1e10, "{steps} {limit}");
    let n_numbers = (3 * scene.info().n_coordinates() + scene.info().n_rows()) as f64;
    let error = refused(order(&scene).until(2.0).every(1.9 * n_numbers / 1e9));
    let SetupError::TooManySamples { samples, limit, .. } = error else { panic!("{error}") };
    assert!(
        (limit * n_numbers / 1e9 - 1.0).abs() <= 1e-12 && (samples / limit - 2.0 / 1.9).abs() <= 1e-12,
        "{samples}"
    );
}

#[test]
fn invariant_tolerances_beyond_what_numbers_tell_are_refused() {
    let scene = cart::Pushed::default();
    for tolerance in [0.0, 1.1, -1e-6, f64::NAN, f64::INFINITY] {
        for method in
            [Method::dop853(tolerance), Method::taylor(tolerance), Method::gauss(tolerance), Method::radau(tolerance)]
        {
            let error = refused(order(&scene).method(method));
            assert!(matches!(error, SetupError::Tolerance { largest: 1.0, .. }), "{method:?}: {error}");
        }
    }
    assert!(order(&scene).method(Method::dop853(1.0)).run().is_ok());
    // below rounding the smallest one is kept
    let steps = |relative| {
        let method = Method::taylor(relative).with_tolerance(Tolerance::new(relative, 1e-9));
        order(&scene).method(method).run().unwrap().cost
    };
    let kept = steps(Tolerance::SMALLEST_RELATIVE);
    for relative in [1e-16, 1e-300] {
        let cost = steps(relative);
        assert_eq!((cost.steps, cost.rejected, cost.evaluations), (kept.steps, kept.rejected, kept.evaluations));
    }
}

/// Inputs that change are held over steps of fixed length; one that stays does not matter. Of two settings of an input the later one counts.
#[test]
fn analytic_changing_inputs_need_steps_of_fixed_length() {
    let scene = cart::Pushed::default();
    let ramp = || InputTable::new(vec![0.0, 2.0], vec![0.0, 4.0]).unwrap();
    let error = refused(order(&scene).method(Method::dop853(1e-9)).input("push", ramp()));
    assert!(matches!(error, SetupError::NeedsFixedStep { method: "dop853" }), "{error}");
    // 2 N, or 3 N, on 2 kg for 2 s
    let last = |order: Simulation<'_, &dyn Scene>| order.run().unwrap().last().velocities[0];
    for method in [Method::dop853(1e-9), Method::rk4(0.1)] {
        let found = last(order(&scene).method(method).input("push", ramp()).input("push", 2.0));
        assert!((found - 2.0).abs() <= 1e-12, "{method:?}: {found}");
    }
    let found = last(order(&scene).input("push", 9.0).input("push", ramp()));
    assert!((found - 2.0).abs() <= 1e-12, "{found}");
    assert!(order(&scene).input("pull", 1.0).run().is_err());
    let error = order(&scene).input("push", f64::NAN).run().unwrap_err();
    assert!(matches!(error, SetupError::Motion(MotionError::InputNotFinite { name: "push", .. })), "{error}");
    let error = order(&scene).method(Method::taylor(1e-9)).stepper().err().unwrap();
    assert!(matches!(error, SetupError::NeedsFixedStep { method: "taylor" }), "{error}");
}

/// Runs of other numbers than doubles: of rk4 and dop853, on scenes without modes, from starts with one time and one length.
#[test]
fn invariant_runs_side_by_side_refuse_what_they_cannot_do() {
    let scenes = [cart::Pushed::default(); 2];
    let start = State::zero(3, 0);
    let make = |starts: [&State; 2], method| Ensemble::new(&scenes, starts, method).map(|_| ()).unwrap_err();
    let later = State { t: 1.0, ..start.clone() };
    let error = make([&start, &later], Method::rk4(0.1));
    assert!(matches!(error, SetupError::DifferentTimes { first: 0.0, other: 1.0 }), "{error}");
    let error = make([&start, &State::zero(6, 0)], Method::rk4(0.1));
    assert!(matches!(error, SetupError::StartLength { expected: 3, found: 6 }), "{error}");
    for step_s in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(make([&start; 2], Method::rk4(step_s)), SetupError::Step { .. }), "{step_s}");
    }
    assert!(matches!(make([&start; 2], Method::dop853(2.0)), SetupError::Tolerance { .. }));
    for method in [Method::taylor(1e-9), Method::gauss(1e-9), Method::radau(1e-9)] {
        assert!(matches!(make([&start; 2], method), SetupError::SingleNumbers { .. }), "{method:?}");
    }
    let mut ensemble = Ensemble::new(&scenes, [&start; 2], Method::rk4(0.3)).unwrap();
    assert!(matches!(ensemble.advance(f64::NAN), Err(MotionError::NotFinite { .. })));
    ensemble.advance(1.0).unwrap();
    // 3 N on 2 kg; a time that is past changes nothing
    ensemble.advance(0.5).unwrap();
    assert!(ensemble.time() == 1.0 && (ensemble.state(1).v[0] - 1.5).abs() <= 1e-14, "{:?}", ensemble.state(1));
}

#[test]
fn invariant_scenes_with_modes_are_not_stepped_by_callers() {
    let scene = sled::Pulled::default();
    let error = simulation(&scene).method(Method::rk4(0.1)).stepper().err().unwrap();
    assert!(error.to_string().contains("limit"), "{error}");
    let error = simulation(&cart::Pushed::default()).backend(Backend::Generated).start("cart.nope", 1.0).run();
    assert!(error.is_err());
    assert!(system_of(&scene, Backend::Auto).map(|_| ()) != Err(SystemError::NoElimination { scene: "pulled" }));
}
