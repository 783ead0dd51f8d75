//! What runs watch on their way, and the limits that end them.

use crate::scenes::{Case, coast, driven, set};
use ezy_core::dynamics::{MotionError, StrainSource};
use ezy_core::prelude::*;
use ezy_core::simulate::{ExceededLimit, StopReason};
use ezy_core_tests::simulation;
use ezy_models::{double_pendulum, four_bar, knife_edge, pendulum, wheeled_snake};
use ezy_tests::hard::subject::subject;

model! {
    /// A cart that a belt carries to and fro at 1 Hz.
    pub model Belt {
        param speed: m/s = 1.0;
        param omega: rad/s = 2*pi;
        body cart { mass: 1, inertia: 1 }
        velocity constraint pace: cart.vx*cos(cart.phi) + cart.vy*sin(cart.phi) = speed * sin(omega*t);
        start resting { cart at (0, 0) angle 0; at rest; }
        scene ride { start resting; until 1 s; }
    }
}

model! {
    /// A crank that a motor turns, and a rod to a slide, which is little longer: upright they nearly fall into one line.
    pub model Motor {
        param omega: rad/s = 1.0;
        body crank { mass: 1, inertia: 1/12 }
        body rod { mass: 1, inertia: 1/12 }
        hinge A: ground(0, 0) ~ crank(-0.5, 0);
        hinge B: crank(0.5, 0) ~ rod(-0.51, 0);
        constraint slide: rod.y + 0.51*sin(rod.phi) = 0;
        drive motor: crank.phi = omega*t;
        start stretched { rod near angle 0; }
        scene turn { start stretched; until 1 s; }
    }
}

model! {
    /// A bob that hardly swings, a thousand kilometres up: 5e-8 J beside ten million, whose rounding is 2e-9 J.
    pub model Tower {
        body bob { mass: 1, inertia: 1 }
        hinge top: ground(0, 1e6) ~ bob(0, 1);
        gravity (0, -9.81);
        start aside { bob angle 1e-4; at rest; }
        scene swing { start aside; until 1 s; }
    }
}

/// Where both are projected, positions of bodies of size one keep this.
const POSITION_RESIDUAL: f64 = 1e-12;
/// Velocities below 10 m/s and rad/s keep this: rounding of sums of products.
const VELOCITY_RESIDUAL: f64 = 1e-13;

fn reason(run: &Run) -> &StopReason {
    let Outcome::Stopped { reason, .. } = &run.outcome else { panic!("{}", run.outcome) };
    reason
}

#[test]
fn invariant_monitors_of_a_projected_run_bound_every_sample() {
    for Case { route, scene } in driven() {
        let run = simulation(&*scene).method(Method::rk4(1e-3)).until(5.0).every(1e-3).work().run().unwrap();
        let monitors = &run.monitors;
        let [positions, velocities] =
            [&monitors.position_residual, &monitors.velocity_residual].map(|peak| peak.as_ref().unwrap());
        let energy = monitors.energy.unwrap();
        assert!(positions.value <= POSITION_RESIDUAL && velocities.value <= VELOCITY_RESIDUAL, "{route}: {monitors:?}");
        for sample in run.samples() {
            assert!(sample.position_residual <= positions.value, "{route} at t = {}", sample.t);
            assert!(sample.energy.balance.abs() <= energy.joules.abs(), "{route} at t = {}", sample.t);
        }
        let drift = monitors.position_drift.as_ref().unwrap();
        assert!(drift.value > 0.0 && ["B.x", "B.y"].contains(&&*drift.row), "{route}: {drift:?}");
        assert!(drift.t > 0.0 && drift.t <= 5.0, "{route}: {drift:?}");
    }
}

#[test]
fn cross_drift_without_projection_is_the_residual_of_the_samples() {
    for Case { route, scene } in driven() {
        let order = simulation(&*scene).method(Method::rk4(0.01)).project(Projection::None).max_drift(1.0);
        let run = order.until(5.0).every(0.01).run().unwrap();
        let monitors = &run.monitors;
        let largest = |pick: fn(&Sample<'_>) -> f64| run.samples().map(|s| pick(&s)).fold(0.0, f64::max);
        assert_eq!(monitors.position_residual.as_ref().unwrap().value, largest(|s| s.position_residual), "{route}");
        assert_eq!(monitors.velocity_residual.as_ref().unwrap().value, largest(|s| s.velocity_residual), "{route}");
        assert_eq!((&monitors.position_drift, &monitors.velocity_drift), (&None, &None), "{route}");
    }
}

#[test]
fn invariant_energy_is_told_where_it_can_be() {
    for Case { route, scene } in driven() {
        assert_eq!(
            simulation(&*scene).method(Method::rk4(1e-3)).until(0.1).run().unwrap().monitors.energy,
            None,
            "{route}"
        );
    }
    for Case { route, scene } in coast() {
        assert!(
            simulation(&*scene).method(Method::rk4(1e-3)).until(0.1).run().unwrap().monitors.energy.is_some(),
            "{route}"
        );
    }
}

#[test]
fn invariant_steps_are_told_from_the_shortest_to_the_longest() {
    let scene = pendulum::Swing::default();
    let run = simulation(&scene).method(Method::rk4(0.25)).until(0.6).run().unwrap();
    let [shortest, longest] = run.monitors.steps_s.unwrap();
    assert!((shortest - 0.1).abs() < 1e-15 && longest == 0.25, "{shortest} {longest}");
    assert_eq!(simulation(&scene).until(0.0).run().unwrap().monitors.steps_s, None);
}

#[test]
fn invariant_condition_rises_where_rows_come_near_each_other() {
    let scene = four_bar::Turning::default();
    let run = simulation(&scene).method(Method::rk4(1e-3)).run().unwrap();
    let condition = run.monitors.condition.unwrap();
    assert!(condition.at_start >= 1.0 && condition.largest >= condition.at_start, "{condition:?}");
    assert!(condition.pivot > 0.0 && condition.pivot <= 1.0 && condition.unknown.is_some(), "{condition:?}");
}

/// Steps between two looks at the condition.
const N_STEPS: f64 = 4096.0;

#[test]
fn analytic_condition_is_worst_on_the_way_where_crank_and_rod_are_upright() {
    let (h, upright) = (1e-3, std::f64::consts::FRAC_PI_2);
    let scene = motor::Turn { omega: upright / (N_STEPS * h) };
    let run = simulation(&scene).method(Method::rk4(h)).until(2.0 * N_STEPS * h).run().unwrap();
    let condition = run.monitors.condition.unwrap();
    assert!((condition.t - N_STEPS * h).abs() <= 1e-9 && condition.largest > 2.0 * condition.at_start, "{condition:?}");
}

/// Looks after steps 17 and 49 of 64 see 0.995 of the amplitude of a sine over all of them.
const SEEN: f64 = 0.99;

#[test]
fn analytic_velocity_residual_is_seen_between_the_ends_of_a_run() {
    // Simpson's rule on a cosine leaves a sine, which is zero at the end
    let scene = belt::Ride::default();
    let order = || simulation(&scene).method(Method::rk4(1.0 / 64.0)).project(Projection::None);
    let value = |order: Simulation<'_, &dyn Scene>| order.run().unwrap().monitors.velocity_residual.unwrap().value;
    let (seldom, always) = (value(order()), value(order().max_drift(1.0)));
    assert!(seldom >= SEEN * always && always > 1e-9, "{seldom:.3e} of {always:.3e}");
}

#[test]
fn invariant_rounding_of_a_large_potential_energy_is_no_error() {
    let run = simulation(&tower::Swing::default()).method(Method::rk4(0.01)).run().unwrap();
    let energy = run.monitors.energy.unwrap();
    assert!(energy.joules != 0.0 && energy.relative == 0.0, "{energy:?}");
}

#[test]
fn invariant_monitors_do_not_change_the_motion() {
    for Case { route, scene } in driven() {
        let order = || simulation(&*scene).method(Method::rk4(1e-3)).until(2.0).work();
        let limited = order().max_drift(1.0).max_energy_error(1.0).max_steps(5000).run().unwrap();
        let plain = order().run().unwrap();
        assert!(limited.last().numbers().eq(plain.last().numbers()), "{route}");
    }
}

#[test]
fn invariant_drift_beyond_its_limit_ends_the_run_before_it() {
    for Case { route, scene } in driven() {
        let order = simulation(&*scene).method(Method::rk4(0.01)).project(Projection::Velocities);
        let run = order.max_drift(1e-9).run().unwrap();
        let StopReason::Limit(ExceededLimit::Drift { t, level, row, value, limit }) = reason(&run) else {
            panic!("{route}: {}", run.outcome)
        };
        assert_eq!((*level, *limit), ("position", 1e-9), "{route}");
        assert!(["B.x", "B.y"].contains(&&**row) && value > limit && *t > run.last().t, "{route}: {row} {value:e} {t}");
        assert!(run.last().position_residual <= *limit, "{route}");
        assert!(run.outcome.to_string().contains("(max-drift)"), "{}", run.outcome);
    }
}

#[test]
fn invariant_skate_that_slips_beyond_the_limit_ends_the_run() {
    let scene = knife_edge::Cycloid::default();
    let run = simulation(&scene).method(Method::rk4(0.05)).project(Projection::None).max_drift(1e-9).run().unwrap();
    assert!(
        matches!(reason(&run), StopReason::Limit(ExceededLimit::Drift { level: "velocity", .. })),
        "{}",
        run.outcome
    );
}

#[test]
fn invariant_energy_beyond_its_limit_ends_the_run_before_it() {
    for Case { route, scene } in driven() {
        let run = simulation(&*scene).method(Method::rk4(0.05)).max_energy_error(1e-9).run().unwrap();
        let &StopReason::Limit(ExceededLimit::EnergyError { t, relative, limit, .. }) = reason(&run) else {
            panic!("{route}: {}", run.outcome)
        };
        assert!(relative > limit && limit == 1e-9 && t > run.last().t, "{route}: {relative:e} at t = {t}");
        let largest = run.monitors.energy.unwrap();
        assert!(largest.relative <= limit && largest.t <= run.last().t, "{route}: {largest:?}");
    }
}

#[test]
fn invariant_fixed_steps_that_lose_energy_are_not_trusted() {
    let scene = double_pendulum::Swing::default();
    let order = |step_s: f64| simulation(&scene).method(Method::rk4(step_s)).until(10.0).every(0.5);
    let run = order(0.1).run().unwrap();
    let Outcome::Untrusted { t, step_s, energy } = run.outcome else { panic!("{}", run.outcome) };
    assert_eq!((t, run.last().t, run.samples().len()), (10.0, 10.0, 21));
    assert!((step_s - 0.1).abs() < 1e-12 && Some(energy) == run.monitors.energy, "{step_s} {energy:?}");
    let told = [format!("{:.1e} of the energy turned over", energy.relative), "the fixed step of 0.1 s".to_owned()];
    assert!(told.iter().all(|told| run.outcome.to_string().contains(told)), "{}", run.outcome);
    assert!(!run.outcome.reached_end());
    // less than three digits are asked for
    let allowed = order(0.1).max_energy_error(1.0).run().unwrap();
    assert!(allowed.outcome.reached_end(), "{}", allowed.outcome);
    for step_s in [0.02, 0.01] {
        let run = order(step_s).run().unwrap();
        let relative = run.monitors.energy.unwrap().relative;
        assert!(run.outcome.reached_end() && relative > 1e-5, "{}: {relative:e}", run.outcome);
    }
}

#[test]
fn invariant_rounding_of_a_body_that_cannot_move_is_no_loss_of_energy() {
    let subject = subject("torture", "three_skates_locked");
    for step_s in [0.056, 0.01, 0.002] {
        let order = simulation(&*subject.scene).method(Method::rk4(step_s)).until(10.0).work();
        let run =
            subject.given().into_iter().fold(order, |order, (name, value)| order.start(name, value)).run().unwrap();
        assert!(run.outcome.reached_end(), "{step_s}: {}", run.outcome);
        let energy = run.monitors.energy.unwrap();
        assert!(energy.relative == 0.0 && energy.joules != 0.0, "{step_s}: {energy:?}");
    }
}

#[test]
fn invariant_heavy_body_below_a_light_one_keeps_its_energy_at_every_step() {
    /// Of 1e10 J, from a step of 10 ms on: the error of RK4 there.
    const ENERGY: f64 = 1e-6;
    let scene = double_pendulum::Swing { m1: 1.0, m2: 1e10, ..Default::default() };
    for step_s in [1e-2, 1e-3, 5e-4, 2e-4, 1e-4] {
        let run = simulation(&scene).method(Method::rk4(step_s)).until(2.0).run().unwrap();
        let relative = run.monitors.energy.unwrap().relative;
        assert!(run.outcome.reached_end() && relative <= ENERGY, "{step_s}: {}, {relative:e}", run.outcome);
    }
}

#[test]
fn invariant_steps_beyond_their_limit_end_the_run_and_are_kept() {
    let scene = pendulum::Swing::default();
    for method in [Method::rk4(1e-3), Method::dop853(1e-9), Method::taylor(1e-9)] {
        let run = simulation(&scene).method(method).max_steps(7).run().unwrap();
        let reason = reason(&run);
        assert!(matches!(reason, StopReason::Limit(ExceededLimit::Steps { limit: 7, .. })), "{reason}");
        assert!(run.cost.steps <= 7 && run.cost.steps + run.cost.rejected >= 7, "{:?}", run.cost);
        assert!(run.last().t > 0.0);
    }
}

#[test]
fn invariant_limits_that_are_none_are_refused() {
    let scene = pendulum::Swing::default();
    for (value, told) in [(f64::NAN, "NaN"), (-1e-9, "-1e-9")] {
        let drift = simulation(&scene).max_drift(value).run().unwrap_err();
        assert!(drift.to_string().starts_with(&format!("the limit max-drift is {told}; give")), "{drift}");
        let energy = simulation(&scene).max_energy_error(value).run().unwrap_err();
        assert!(energy.to_string().starts_with("the limit max-energy-error is"), "{energy}");
    }
}

#[test]
fn invariant_runaway_names_coordinate_and_force() {
    for Case { route, mut scene } in driven() {
        set(&mut *scene, &[("m0", 1e200)]);
        let run = simulation(&*scene).method(Method::rk4(1e-3)).run().unwrap();
        let Outcome::Stopped { reason: StopReason::Motion(MotionError::NotFinite { .. }), strain, .. } = &run.outcome
        else {
            panic!("{route}: {}", run.outcome)
        };
        let StrainSource::Applied { coordinate, force, .. } = &strain.as_ref().unwrap().source else {
            panic!("{route}: {}", run.outcome)
        };
        assert!(coordinate.ends_with(".phi") && force.abs() > 1e199, "{route}: {}", run.outcome);
    }
}

#[test]
fn invariant_runaway_by_speed_names_a_reaction() {
    let scene = knife_edge::Cycloid::default();
    let run = simulation(&scene).method(Method::rk4(0.1)).start("blade.omega", 1e3).start("blade.vx", 1e3).max_steps(1);
    let run = run.run().unwrap();
    let Outcome::Stopped { strain: Some(strain), .. } = &run.outcome else { panic!("{}", run.outcome) };
    assert!(matches!(&strain.source, StrainSource::Reaction { row, .. } if row == "edge"), "{strain}");
}

#[test]
fn invariant_what_a_step_does_behind_an_end_is_not_watched() {
    let scene = pendulum::Quarter::default();
    let order = || simulation(&scene).method(Method::rk4(0.7));
    // a step over half of the motion
    let run = order().max_energy_error(1.0).run().unwrap();
    let (end, monitors) = (run.last().t, &run.monitors);
    assert!(matches!(run.outcome, Outcome::ReachedEvent { .. }) && end < 0.6, "{}", run.outcome);
    let [_, longest] = monitors.steps_s.unwrap();
    assert_eq!(longest, end);
    let energy = monitors.energy.unwrap();
    assert_eq!(energy.t, end);
    assert_eq!(energy.joules, run.last().energy.balance);
    let limited = order().max_energy_error(energy.relative).run().unwrap();
    assert!(limited.outcome.reached_end(), "{}", limited.outcome);
}

/// Links of 814 kg whose mass is at their middles: the elimination divides by inertias that are 5e5 times smaller, and multipliers lose some of their digits,
/// which the condition of the equations does not tell. Of links as they are it tells all.
#[test]
fn cross_digits_that_the_elimination_loses_are_seen() {
    let rounding = |m: f64| {
        let mut scene = wheeled_snake::Crawling::default();
        set(&mut scene, &[("m", m)]);
        let run = simulation(&scene).method(Method::dop853(1e-9)).until(0.1).run().unwrap();
        let condition = run.monitors.condition.unwrap();
        (condition.rounding, condition.largest * f64::EPSILON)
    };
    let (seen, told) = rounding(1.0);
    assert!(seen < 10.0 * told, "{seen:e} {told:e}");
    let (seen, told) = rounding(814.0);
    assert!(seen > 1e3 * told, "{seen:e} {told:e}");
}
