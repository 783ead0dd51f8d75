//! Taylor's method: its order, its dense output, its steps, and what it cannot run.

use crate::scenes::{distance, set, stepped};
use ezy_core::prelude::*;
use ezy_core::simulate::SetupError;
use ezy_core::testing::StepsBy;
use ezy_core_tests::simulation;
use ezy_models::registry::MODELS;
use ezy_models::{andrews, differential_robot, double_pendulum, ezy_roller, roller_racer};
use ezy_tests::crank::Crank;
use ezy_tests::hand_roller::HandRoller;
use ezy_tests::reference::load;

/// Energies of 10 J over 6e2 steps, with rounding of each.
const BALANCE: f64 = 1e-12;
/// Solvers of K differ in rounding alone, which 5 s make ten times as large.
const SOLVERS: f64 = 1e-12;
/// Tolerances of 1e-12 a step, over the tens of steps that a second takes at most, made larger by the motion.
const EVERY_SCENE: f64 = 1e-10;
/// Orders are slopes over steps that are not infinitely small.
const ORDER_TOLERANCE: f64 = 0.5;

/// The coasting roller after `n` steps of a fixed order to `t`, and in the middle of the last step.
fn fixed_steps(order: usize, n: usize, t: f64) -> [State; 2] {
    stepped(&HandRoller::coast(), StepsBy::Taylor(order), std::iter::repeat_n(t / n as f64, n))
}

#[test]
fn order_taylor_is_the_one_that_is_asked_for() {
    let end = load("ezyroller_coast").pop().expect("a reference at the end");
    for order in [6, 9, 12] {
        let [coarse, fine] = [10, 20].map(|n| distance(&fixed_steps(order, n, 1.0)[0].v, &end.v));
        let slope = (coarse / fine).log2();
        assert!(slope >= order as f64 - ORDER_TOLERANCE, "order {order}: {slope:.2}");
    }
}

#[test]
fn order_values_between_are_as_good_as_a_step() {
    let reference = load("ezyroller_coast");
    let at = |t: f64| reference.iter().find(|r| (r.t - t).abs() < 1e-9).expect("a reference at this time");
    for order in [6, 9] {
        // in the middle of the first step
        let [late, early] = [0.2, 0.1].map(|t| distance(&fixed_steps(order, 1, 2.0 * t)[1].v, &at(t).v));
        let slope = (late / early).log2();
        assert!(slope >= order as f64 + 1.0 - ORDER_TOLERANCE, "order {order}: {slope:.2}");
    }
}

#[test]
fn order_error_follows_the_tolerance() {
    let end = load("ezyroller_driven").pop().expect("a reference at the end");
    let error = |tolerance: f64| {
        let run = simulation(&HandRoller::driven()).method(Method::taylor(tolerance)).run().unwrap();
        distance(run.last().coordinates, &end.q)
    };
    for tolerance in [1e-6, 1e-8, 1e-10, 1e-12] {
        // the sensitivity of the motion to a disturbance, of which every step makes one
        let error = error(tolerance);
        assert!(error <= 2e3 * tolerance, "{error:.1e} at {tolerance:.0e}");
    }
}

#[test]
fn analytic_series_without_odd_orders_does_not_fool_the_step() {
    // from rest every second coefficient vanishes; the first steps are as long as the others
    let run = simulation(&HandRoller::driven()).method(Method::taylor(1e-12)).until(1.0).run().unwrap();
    assert!((4..=12).contains(&run.cost.steps), "{} steps", run.cost.steps);
    assert_eq!((run.last().t, run.cost.rejected), (1.0, 0));
}

#[test]
fn analytic_rest_takes_one_step() {
    let mut still = HandRoller::driven();
    set(&mut still, &[("m0", 0.0)]);
    let run = simulation(&still).method(Method::taylor(1e-9)).until(1e6).run().unwrap();
    assert_eq!((run.cost.steps, run.last().t), (1, 1e6));
    assert_eq!(run.last().coordinates, run.first().coordinates);
}

#[test]
fn invariant_works_along_the_polynomials_balance_the_energy() {
    let scene = HandRoller::driven();
    let order = || simulation(&scene).method(Method::taylor(1e-14)).until(20.0).every(0.37);
    let [without, with] = [order().run().unwrap(), order().work().run().unwrap()];
    assert_eq!(without.last().coordinates, with.last().coordinates);
    for s in with.samples() {
        assert!(s.energy.balance.abs() <= BALANCE, "{:.1e} J at {} s", s.energy.balance, s.t);
    }
}

#[test]
fn cross_taylor_solves_by_every_backend() {
    let scene = HandRoller::driven();
    let end = |backend| {
        let order = simulation(&scene).method(Method::taylor(1e-13)).backend(backend).until(5.0);
        order.run().unwrap().last().coordinates.to_vec()
    };
    let generated = end(Backend::Generated);
    for backend in [Backend::Dense, Backend::Sparse] {
        assert!(distance(&end(backend), &generated) <= SOLVERS, "{backend:?}");
    }
}

#[test]
fn cross_emitted_series_is_the_one_by_hand() {
    let (hand, generated) = (HandRoller::driven(), ezy_roller::Driven::default());
    let ends = [
        simulation(&hand).method(Method::taylor(1e-13)).until(5.0).run().unwrap(),
        simulation(&generated).method(Method::taylor(1e-13)).until(5.0).run().unwrap(),
    ];
    let [hand, generated] = ends.each_ref().map(|run| run.last().coordinates);
    assert!(distance(hand, generated) <= SOLVERS);
    assert_eq!(ends[0].cost.steps, ends[1].cost.steps);
}

#[test]
fn cross_taylor_and_dop853_on_every_scene() {
    let mut n_compared = 0;
    for (model, entry) in MODELS.iter().flat_map(|model| model.scenes.iter().map(move |entry| (model, entry))) {
        let scene = (entry.new)();
        if scene.series().is_none() {
            continue;
        }
        let until_s = scene.info().until_s.min(1.0);
        let order = |method| simulation(&*scene).method(method).until(until_s).run().unwrap();
        let [one, other] = [Method::taylor(1e-12), Method::dop853(1e-12)].map(order);
        let size = one.last().coordinates.iter().fold(1.0, |m: f64, x| m.max(x.abs()));
        let error = distance(one.last().coordinates, other.last().coordinates) / size;
        assert!(one.outcome.reached_end() && error <= EVERY_SCENE, "{}/{}: {error:.1e}", model.name, entry.name);
        n_compared += 1;
    }
    // all but those with a saturation or a rectified force
    assert!(n_compared >= 38, "{n_compared} scenes");
}

model! {
    /// A stone that is thrown: all orders beyond the second vanish.
    pub model Stone {
        body stone { mass: 2, inertia: 0.1 }
        gravity (0, -9.81);
        start thrown { stone at (0, 0) angle 0; stone velocity (3, 4) rate 5; }
        scene flight { start thrown; until 100 s; }
    }
}

#[test]
fn analytic_free_flight_takes_one_step() {
    let scene = stone::Flight::default();
    let run = simulation(&scene).method(Method::taylor(1e-12)).run().unwrap();
    assert_eq!((run.cost.steps, run.last().t), (1, 100.0));
    let expected = [300.0, 400.0 - 0.5 * 9.81 * 1e4, 500.0];
    assert!(distance(run.last().coordinates, &expected) <= 1e-15 * expected[1].abs());
}

#[test]
fn cross_massless_bodies_are_solved_by_the_pivoted_solver() {
    let scene = ezy_roller::Driven { i2: 0.0, ..Default::default() };
    let order = |method| simulation(&scene).method(method).until(2.0).run().unwrap();
    let [one, other] = [Method::taylor(1e-12), Method::dop853(1e-12)].map(order);
    assert!(distance(one.last().coordinates, other.last().coordinates) <= EVERY_SCENE);
}

#[test]
fn analytic_law_without_a_series_is_named() {
    let scene = ezy_models::skateboard::Ridden::default();
    let error = simulation(&scene).method(Method::taylor(1e-9)).run().unwrap_err();
    assert!(error.to_string().contains("`max`"), "{error}");
}

#[test]
fn analytic_scene_without_a_series_is_refused() {
    let outcome = simulation(&Crank::default()).method(Method::taylor(1e-9)).run();
    assert!(matches!(outcome, Err(SetupError::NoSeries { scene: "turn", .. })));
}

/// A force that turns round within 0.1 mm/s adds two steps of the tolerance to an error that the motion makes up to ten times as large.
const OVER_A_LAYER: f64 = 100.0;

#[test]
fn cross_taylor_steps_do_not_pass_over_a_friction_layer() {
    let scene = roller_racer::RowedOnTarmac {
        a: 0.126,
        h: 0.774,
        i1: 8.71e-3,
        m0: -2.568,
        knee: 5.44e-5,
        ..roller_racer::RowedOnTarmac::default()
    };
    let run = |method: Method| simulation(&scene).method(method).until(4.3).run().unwrap();
    let reference = run(Method::dop853(1e-12));
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
        let taylor = run(Method::taylor(tolerance));
        let error = distance(taylor.last().coordinates, reference.last().coordinates);
        assert!(error <= OVER_A_LAYER * tolerance, "{error:.1e} at {tolerance:.0e}");
        assert!(taylor.cost.rejected < 20, "{:?}", taylor.cost);
    }
}

#[test]
fn invariant_taylor_takes_few_steps_again_where_forces_are_smooth() {
    let cost = |scene: &dyn Scene, tolerance: f64| {
        let run = simulation(scene).method(Method::taylor(tolerance)).run().unwrap();
        assert!(run.outcome.reached_end());
        run.cost
    };
    for tolerance in [1e-4, 1e-8, 1e-12, 1e-15] {
        for scene in [&ezy_roller::Driven::default() as &dyn Scene, &double_pendulum::Swing::default()] {
            let cost = cost(scene, tolerance);
            assert!(20 * cost.rejected <= cost.steps, "{cost:?} at {tolerance:.0e}");
        }
    }
    // accelerations of 1e6 rad/s², whose rounding is many tolerances
    assert_eq!(cost(&andrews::Squeeze::default(), 1e-15).rejected, 0);
}

/// What some hundred steps may add up to, in tolerances; the rates of wheels that nothing brakes stay off by what they are off, so that
/// angles and directions grow with the time.
const ADDED_UP: f64 = 100.0;

/// Wheels of 5 cm that reach 300 rad/s make rates of 20 times the errors of the axle, with one sign step after step: 1,441 tolerances of a velocity
/// without looking at what the projection changes. Where no lever is short steps stay as long as they are.
#[test]
fn cross_taylor_keeps_to_the_tolerance_over_short_levers() {
    let scene = differential_robot::Cruise { left_torque: 1.4, ..Default::default() };
    let until_s = 6.0;
    let run = |method| simulation(&scene).method(method).until(until_s).run().unwrap();
    let numbers = |run: &Run| [run.last().coordinates, run.last().velocities].concat();
    let expected = numbers(&run(Method::dop853(1e-13)));
    for tolerance in [1e-4, 1e-6, 1e-7, 1e-8, 1e-10] {
        let run = run(Method::taylor(tolerance));
        let of = |(found, expected): (&f64, &f64)| (found - expected).abs() / (1.0 + expected.abs());
        let off = numbers(&run).iter().zip(&expected).map(of).fold(0.0, f64::max);
        assert!(off <= ADDED_UP * until_s * tolerance, "{:.0} tolerances at {tolerance:e}", off / tolerance);
        assert!(run.cost.steps <= 260, "{} steps at {tolerance:e}", run.cost.steps);
    }
}
