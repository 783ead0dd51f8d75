//! Stops: impacts, bounces without end, rest on an end.

use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::{Cost, Monitors, SetupError, SoftestImpact, StopReason};
use ezy_core_tests::simulation;
use nalgebra::{DMatrix, DVector};

/// Landings are located to 1e-12 s, and each bounce goes on from the last one; methods keep to 1e-12.
const BOUNCED: f64 = 2e-11;

/// A change is located to 1e-12 s on a motion that methods follow to 1e-12.
const LOCATED_S: f64 = 1e-11;

/// Flights shorter than 1e-9 s are not flown; what is left of the bounces under e = 0.5 is twice as long at most.
const UNFLOWN_S: f64 = 2e-9;

/// Balance against energies of 100 J at most at tolerances of 1e-12.
const BALANCE_J: f64 = 1e-10;

/// A landing that is 1e-12 s early or late moves the stone by 1e-11 m, 2e-12 of its energy; over a thousand of both signs.
const THOUSAND_IMPACTS: f64 = 1e-10;

model! {
    /// A stone that falls on the floor.
    pub model Stone {
        param e = 0.5;
        param m: kg = 2;
        param g: m/s^2 = 10;
        param floor: m = 0;
        body stone { mass: m, inertia: 1 }
        slider rail: ground(0, 0) ~ stone(0, 0) along ground(0, 1);
        stop ground_below: stone.y from floor restitution e;
        gravity (0, -g);
        start high { stone at (0, 5) angle 0; at rest; }
        start thrown { stone at (0, 0) angle 0 velocity (0, -6); }
        scene falls { start high; until 5 s; }
        scene thrown_down { start thrown; until 0.5 s; }
    }
}

model! {
    /// Two bars whose elbow bends so far and no farther.
    pub model Elbow {
        param e = 0.5;
        param l: m = 0.5;
        param m1: kg = 3; param j1: kg*m^2 = 0.2;
        param m2: kg = 1; param j2: kg*m^2 = 0.05;
        body upper { mass: m1, inertia: j1 }
        body lower { mass: m2, inertia: j2 }
        hinge shoulder: ground(0, 0) ~ upper(-l, 0);
        hinge elbow: upper(l, 0) ~ lower(-l, 0);
        stop reach: elbow.angle from -0.4 to 0.5 restitution e;
        gravity (0, -9.81);
        start bent { upper angle 0.3 rate 1; lower angle 0.3 rate 6; }
        scene swing { start bent; until 1 s; }
    }
}

model! {
    /// An arm that a torque presses against a stop, until it turns.
    pub model Arm {
        param m0: N*m = 3; param w: rad/s = 2; param j: kg*m^2 = 0.5;
        input push: N*m = 0;
        body arm { mass: 1, inertia: j }
        hinge P: ground(0, 0) ~ arm(0, 0);
        stop rest: arm.phi to 0;
        effect wave { torque arm: m0 * cos(w * t); }
        effect hand { torque arm: push; }
        start there { arm angle 0; at rest; }
        scene pressed { start there; until 2 s; with wave; }
        scene held { start there; until 2 s; with hand; }
    }
}

model! {
    /// A puck between two walls.
    pub model Puck {
        param e = 0.8;
        body puck { mass: 1, inertia: 1 }
        stop walls: puck.x from -1 to 1 restitution e;
        start middle { puck at (0, 0) angle 0 velocity (1, 0) rate 0; }
        scene slides { start middle; until 8 s; }
    }
}

model! {
    /// A ball on a table that shakes.
    pub model Table {
        param a: m = 0.1; param w: rad/s = 12; param g: m/s^2 = 9.81; param e = 0;
        body ball { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ ball(0, 0) along ground(0, 1);
        stop top: ball.y from a * sin(w * t) restitution e;
        gravity (0, -g);
        start with_it { ball at (0, 0) angle 0 velocity (0, a * w); }
        scene shakes { start with_it; until 1 s; }
    }
}

model! {
    /// A sled that is pushed across its runner and slides against a wall.
    pub model Sled {
        body sled { mass: 2, inertia: 1 }
        skate runner: at sled(0, 0) along sled(1, 0);
        stop wall: sled.x to 1;
        force at sled(0, 0): (4, 3);
        start here { sled at (0, 0) angle 0; at rest; }
        scene slides { start here; until 2 s; }
    }
}

model! {
    /// A stone that falls on a plate below it that has no mass.
    pub model Plated {
        body stone { mass: 2, inertia: 1 }
        body plate { mass: 0, inertia: 0 }
        weld on: stone(0, -1) ~ plate(0, 0);
        slider rail: ground(0, 0) ~ stone(0, 0) along ground(0, 1);
        stop floor: plate.y from -1 restitution 0.5;
        gravity (0, -10);
        start high { stone at (0, 5) angle 0; at rest; }
        scene falls { start high; until 2.2 s; }
    }
}

model! {
    /// A stone that falls below a lid that is nowhere after a while.
    pub model Lidded {
        param life: s = 0.5;
        param c: m^2/s = 1;
        body stone { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ stone(0, 0) along ground(0, 1);
        stop shaft: stone.y from 0 to 9 + sqrt(c * (life - t));
        gravity (0, -10);
        start high { stone at (0, 5) angle 0; at rest; }
        scene falls { start high; until 5 s; }
    }
}

/// Of each kind one; the fixed step leaves less than 1e-10 of motions that are no polynomials.
const METHODS: [Method; 5] =
    [Method::rk4(5e-4), Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)];

fn times(run: &Run, name: &str) -> Vec<f64> {
    run.events().iter().filter(|occurred| occurred.event.name == name).map(|occurred| occurred.state.t).collect()
}

fn names(run: &Run) -> Vec<&'static str> {
    run.events().iter().map(|occurred| occurred.event.name).collect()
}

#[test]
fn analytic_stone_bounces_until_it_rests_by_every_method() {
    for method in
        [Method::rk4(0.05), Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)]
    {
        let run = simulation(&stone::Falls::default()).method(method).run().unwrap();
        assert!(run.outcome.reached_end(), "{}", run.outcome);
        // 1 s down, then flights of 1 s, 1/2 s, …: landing n is at 3 s - 2^(1 - n)
        let hits = times(&run, "ground_below hits");
        assert!(hits.len() > 25, "{}", hits.len());
        for (n, t) in hits.iter().enumerate() {
            let expected = 3.0 - 2f64.powi(1 - n as i32);
            assert!((t - expected).abs() <= BOUNCED, "landing {n} by {}: {t} for {expected}", method.name());
        }
        let holds = times(&run, "ground_below holds");
        assert_eq!(holds.len(), 1);
        assert!((holds[0] - 3.0).abs() <= UNFLOWN_S, "{}", holds[0]);
        let end = run.last();
        // M a + Gᵀ λ = F with C = y
        assert!((end.get("lambda.ground_below").unwrap() + 20.0).abs() <= BALANCE_J);
        assert!(end.get("stone.y").unwrap().abs() <= BOUNCED && end.get("stone.vy").unwrap() == 0.0);
    }
}

#[test]
fn analytic_heights_of_a_bouncing_stone_are_squares() {
    let run = simulation(&stone::Falls::default()).method(Method::dop853(1e-12)).every(0.125).run().unwrap();
    let heights = [(1.5, 1.25), (2.25, 0.3125), (2.625, 0.078125)];
    for (t, height) in heights {
        let found = run.samples().find(|sample| sample.t == t).unwrap().get("stone.y").unwrap();
        assert!((found - height).abs() <= BOUNCED, "{found} for {height} at {t}");
    }
}

#[test]
fn analytic_stone_rests_on_a_floor_away_from_the_origin() {
    // rounding of 3 m hides flights below 1e-14 m
    let scene = stone::Falls { floor: 3.0, ..stone::Falls::default() };
    let run = simulation(&scene).method(Method::taylor(1e-12)).run().unwrap();
    let holds = times(&run, "ground_below holds");
    let expected = 3.0 * 0.4f64.sqrt();
    assert!(holds.len() == 1 && (holds[0] - expected).abs() <= 1e-6, "{holds:?} for {expected}");
    assert!((run.last().get("lambda.ground_below").unwrap() + 20.0).abs() <= BALANCE_J);
}

#[test]
fn invariant_works_balance_the_energy_of_impacts() {
    for method in METHODS {
        let run = simulation(&stone::Falls::default()).method(method).work().every(0.3).run().unwrap();
        for sample in run.samples() {
            assert!(sample.energy.balance.abs() <= BALANCE_J, "{} by {}", sample.energy.balance, method.name());
        }
        assert!((run.last().get("work.stops").unwrap() + 100.0).abs() <= BALANCE_J);
        assert!(run.monitors.energy.unwrap().joules.abs() <= BALANCE_J);
    }
}

#[test]
fn invariant_thousand_elastic_impacts_keep_the_energy() {
    let scene = stone::Falls { e: 1.0, ..stone::Falls::default() };
    let run = simulation(&scene).method(Method::taylor(1e-12)).until(2000.0).run().unwrap();
    assert_eq!(times(&run, "ground_below hits").len(), 1000);
    let (first, last) = (run.first().energy, run.last().energy);
    let change = (last.kinetic + last.potential) / (first.kinetic + first.potential) - 1.0;
    assert!(change.abs() <= THOUSAND_IMPACTS, "{change:e}");
}

/// The velocities after an impact by K [dv; p] = [0; jump] with the rows of the elbow written by hand.
fn after_impact(scene: &elbow::Swing, q: &[f64], v: &[f64]) -> DVector<f64> {
    let elbow::Swing { e, l, m1, j1, m2, j2 } = *scene;
    let ((s1, c1), (s2, c2)) = (q[2].sin_cos(), q[5].sin_cos());
    let rows = [
        [1.0, 0.0, l * s1, 0.0, 0.0, 0.0],
        [0.0, 1.0, -l * c1, 0.0, 0.0, 0.0],
        [1.0, 0.0, -l * s1, -1.0, 0.0, -l * s2],
        [0.0, 1.0, l * c1, 0.0, -1.0, l * c2],
        [0.0, 0.0, -1.0, 0.0, 0.0, 1.0],
    ];
    let mut k = DMatrix::zeros(11, 11);
    for (i, m) in [m1, m1, j1, m2, m2, j2].into_iter().enumerate() {
        k[(i, i)] = m;
    }
    for (i, row) in rows.iter().enumerate() {
        for (j, g) in row.iter().enumerate() {
            (k[(6 + i, j)], k[(j, 6 + i)]) = (*g, *g);
        }
    }
    let mut right = DVector::zeros(11);
    right[10] = -(1.0 + e) * (v[5] - v[2]);
    let jump = k.lu().solve(&right).unwrap();
    DVector::from_iterator(6, v.iter().zip(jump.iter()).map(|(v, jump)| v + jump))
}

#[test]
fn cross_impact_in_a_linkage_is_the_dense_solution() {
    let scene = elbow::Swing::default();
    let order = |until: f64| simulation(&scene).method(Method::dop853(1e-12)).until(until).run().unwrap();
    let run = order(0.4);
    let hit = &run.events()[0];
    assert_eq!(hit.event.name, "reach hits");
    let expected = after_impact(&scene, &hit.state.q, &hit.state.v);
    // a little later, and back along the accelerations
    let later = 1e-6;
    let run = order(hit.state.t + later);
    let last = run.last();
    for i in 0..6 {
        let found = last.velocities[i] - later * last.accelerations[i];
        assert!((found - expected[i]).abs() <= 1e-9, "{found} for {} of {i}", expected[i]);
    }
    assert!(run.last().velocity_residual <= 1e-12);
}

#[test]
fn cross_linkage_between_two_ends_moves_alike_by_every_method() {
    let scene = elbow::Swing::default();
    let runs = METHODS.map(|method| simulation(&scene).method(method).work().run().unwrap());
    let expected = times(&runs[1], "reach hits");
    assert!(expected.len() > 2, "{:?}", names(&runs[1]));
    for (run, method) in runs.iter().zip(METHODS) {
        let found = times(run, "reach hits");
        assert_eq!(found.len(), expected.len(), "{}", method.name());
        let apart = found.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart <= 1e-9, "{apart:e} by {}", method.name());
        assert!(run.last().energy.balance.abs() <= BALANCE_J, "{} by {}", run.last().energy.balance, method.name());
    }
}

#[test]
fn analytic_arm_leaves_its_stop_where_the_torque_turns() {
    for method in METHODS {
        let scene = arm::Pressed::default();
        let run = simulation(&scene).method(method).every(0.1).run().unwrap();
        assert_eq!(names(&run), ["rest lets go"], "{}", run.outcome);
        let (begins, arm::Pressed { m0, w, j }) = (run.events()[0].state.t, scene);
        let expected = std::f64::consts::FRAC_PI_2 / w;
        assert!((begins - expected).abs() <= LOCATED_S, "{begins} for {expected} by {}", method.name());
        for sample in run.samples() {
            let t = sample.t;
            let (angle, push) = if t < expected {
                (0.0, m0 * (w * t).cos())
            } else {
                (-m0 / (j * w) * ((t - expected) + (w * t).cos() / w), 0.0)
            };
            assert!((sample.get("arm.phi").unwrap() - angle).abs() <= BOUNCED, "at {t} by {}", method.name());
            assert!((sample.get("lambda.rest").unwrap() - push).abs() <= BOUNCED, "at {t} by {}", method.name());
        }
    }
}

#[test]
fn analytic_input_that_turns_between_steps_frees_the_arm() {
    let scene = arm::Held::default();
    let order = Simulation::new(&scene).method(Method::rk4(0.1));
    let run = order.control(|now, set| set.push = if now.t < 0.95 { 2.0 } else { -1.0 }).run().unwrap();
    assert_eq!(names(&run), ["rest lets go"]);
    assert!((run.events()[0].state.t - 1.0).abs() <= LOCATED_S);
    // -1 N·m on 0.5 kg·m² for 1 s
    assert!((run.last().get("arm.phi").unwrap() + 1.0).abs() <= LOCATED_S);
}

#[test]
fn analytic_puck_goes_to_and_fro_between_two_ends() {
    for method in METHODS {
        let run = simulation(&puck::Slides::default()).method(method).run().unwrap();
        let hits = times(&run, "walls hits");
        let expected = [1.0, 1.0 + 2.0 / 0.8, 1.0 + 2.0 / 0.8 + 2.0 / 0.64];
        assert_eq!(hits.len(), expected.len(), "{}", run.outcome);
        assert!(hits.iter().zip(expected).all(|(t, expected)| (t - expected).abs() <= LOCATED_S), "{hits:?}");
        assert!((run.last().get("puck.vx").unwrap() + 0.512).abs() <= LOCATED_S);
        // each leaves eight tenths
        let softest = run.monitors.softest_impact.unwrap();
        assert!(
            (softest.speed - 0.64).abs() <= LOCATED_S && (softest.t - expected[2]).abs() <= LOCATED_S,
            "{softest:?}"
        );
    }
}

#[test]
fn analytic_puck_that_nothing_presses_stays_at_a_wall_without_restitution() {
    for method in METHODS {
        let scene = puck::Slides { e: 0.0 };
        let run = simulation(&scene).method(method).run().unwrap();
        assert_eq!(names(&run), ["walls hits", "walls holds"], "{}", run.outcome);
        assert_eq!(run.last().get("puck.vx").unwrap(), 0.0);
    }
}

#[test]
fn analytic_ball_leaves_a_shaking_table_where_it_falls_faster() {
    for method in METHODS {
        let scene = table::Shakes::default();
        let run = simulation(&scene).method(method).work().every(0.05).run().unwrap();
        assert!(run.outcome.reached_end(), "{}", run.outcome);
        assert_eq!(names(&run)[..3], ["top lets go", "top hits", "top holds"]);
        let expected = (scene.g / (scene.a * scene.w * scene.w)).asin() / scene.w;
        let found = run.events()[0].state.t;
        assert!((found - expected).abs() <= LOCATED_S, "{found} for {expected} by {}", method.name());
        for sample in run.samples() {
            let balance = sample.energy.balance;
            assert!(balance.abs() <= BALANCE_J, "{balance} at {} by {}", sample.t, method.name());
        }
    }
}

#[test]
fn analytic_multipliers_of_other_rows_keep_their_names() {
    let run = simulation(&sled::Slides::default()).method(Method::dop853(1e-12)).every(0.3).run().unwrap();
    // 2 m/s²: at the wall after 1 s, where 4 N press on
    assert_eq!(names(&run), ["wall hits", "wall holds"]);
    for sample in run.samples() {
        let wall = if sample.t < 1.0 { 0.0 } else { 4.0 };
        assert!((sample.get("lambda.wall").unwrap() - wall).abs() <= BOUNCED, "at {}", sample.t);
        assert!((sample.get("lambda.runner").unwrap() - 3.0).abs() <= BOUNCED, "at {}", sample.t);
    }
}

#[test]
fn analytic_plate_without_mass_bounces_with_its_stone() {
    let run = simulation(&plated::Falls::default()).method(Method::dop853(1e-12)).run().unwrap();
    let hits = times(&run, "floor hits");
    assert_eq!(hits.len(), 2, "{}", run.outcome);
    assert!((hits[0] - 1.0).abs() <= LOCATED_S && (hits[1] - 2.0).abs() <= LOCATED_S, "{hits:?}");
}

#[test]
fn invariant_ball_that_bounces_on_a_shaking_table_stays_above_it() {
    let scene = table::Shakes { e: 0.7, ..table::Shakes::default() };
    let run = simulation(&scene).method(Method::dop853(1e-12)).work().until(3.0).every(0.01).run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
    for sample in run.samples() {
        let above = sample.get("ball.y").unwrap() - scene.a * (scene.w * sample.t).sin();
        assert!(above >= -LOCATED_S, "{above:e} at {}", sample.t);
        assert!(sample.energy.balance.abs() <= BALANCE_J, "{} at {}", sample.energy.balance, sample.t);
    }
}

#[test]
fn analytic_start_that_moves_into_a_stop_begins_with_an_impact() {
    let run = simulation(&stone::ThrownDown::default()).method(Method::dop853(1e-12)).work().run().unwrap();
    assert_eq!(times(&run, "ground_below hits"), [0.0]);
    assert_eq!(run.monitors.softest_impact, Some(SoftestImpact { speed: 6.0, t: 0.0 }));
    // a speed that is rounding is none
    let stands = simulation(&stone::ThrownDown::default()).start("stone.vy", -1e-15).run().unwrap();
    assert_eq!(stands.monitors.softest_impact, None);
    // 3 m/s upwards for 0.5 s
    assert!((run.last().get("stone.y").unwrap() - 0.25).abs() <= LOCATED_S);
    assert!((run.first().energy.kinetic - 36.0).abs() <= BALANCE_J && run.last().energy.balance.abs() <= BALANCE_J);
}

#[test]
fn invariant_start_beyond_a_stop_is_refused() {
    let scene = stone::Falls { floor: 5.5, ..stone::Falls::default() };
    let error = simulation(&scene).run().unwrap_err();
    assert!(matches!(error, SetupError::BeyondStop { stop: "ground_below", end: "lower", .. }), "{error}");
    assert_eq!(
        error.to_string(),
        "the start of scene `falls` is beyond the lower end of stop `ground_below`, by 5.000e-1; start on the other side, \
         or move the stop"
    );
}

#[test]
fn invariant_restitution_that_gains_energy_ends_the_run_at_the_impact() {
    let scene = stone::Falls { e: 1.5, ..stone::Falls::default() };
    let run = simulation(&scene).method(Method::dop853(1e-12)).run().unwrap();
    let outcome = run.outcome.to_string();
    assert!(!run.outcome.reached_end() && outcome.contains("`ground_below` is 1.5"), "{outcome}");
    assert!((run.last().t - 1.0).abs() <= LOCATED_S);
}

#[test]
fn invariant_steppers_refuse_a_stop() {
    let error = simulation(&stone::Falls::default()).stepper().map(|_| ()).unwrap_err();
    assert!(matches!(error, SetupError::Modes { what: "stop", name: "ground_below", .. }), "{error}");
}

#[test]
fn analytic_bound_that_is_no_number_ends_the_run_where_it_is() {
    for method in METHODS {
        let run = simulation(&lidded::Falls::default()).method(method).run().unwrap();
        let Outcome::Stopped { reason: StopReason::Motion(MotionError::StopNotFinite { stop, end, t, .. }), .. } =
            run.outcome
        else {
            panic!("{}", run.outcome)
        };
        assert!((stop, end) == ("shaft", "upper") && t >= 0.5, "{t} by {}", method.name());
        assert!((run.last().t - 0.5).abs() <= LOCATED_S, "{} by {}", run.last().t, method.name());
        assert!((run.last().get("stone.y").unwrap() - 3.75).abs() <= BOUNCED);
    }
}

#[test]
fn invariant_bound_that_is_no_number_at_the_start_is_refused() {
    let error = simulation(&lidded::Falls { life: -1.0, ..lidded::Falls::default() }).run().unwrap_err();
    assert_eq!(
        error.to_string(),
        "the motion cannot start: the distance of stop `shaft` from its upper end is NaN at t = 0 s; its quantity and its \
         bounds must be finite"
    );
}

#[test]
fn invariant_steps_cut_at_impacts_count_as_rejected() {
    let scene = stone::Falls::default();
    let order = || simulation(&scene).method(Method::rk4(0.05));
    let run = order().run().unwrap();
    let n_hits = times(&run, "ground_below hits").len() as u64;
    assert!(run.cost.rejected >= n_hits, "{} for {n_hits} hits", run.cost.rejected);
    let limit = (run.cost.steps + run.cost.rejected) / 2;
    let limited = order().max_steps(limit).run().unwrap();
    assert!(!limited.outcome.reached_end());
    let Cost { steps, rejected, .. } = limited.cost;
    assert!(steps + rejected >= limit && steps < limit && rejected > 0, "{steps} and {rejected} for {limit}");
}

model! {
    /// A slide that a motor drives against a stop, whatever it takes.
    pub model Rammed {
        body slide { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ slide(0, 0) along ground(1, 0);
        drive motor: slide.x = 2 m/s * t;
        stop wall: slide.x to 1;
        start home { slide at (0, 0) angle 0; slide velocity (2, 0) rate 0; }
        scene runs { start home; until 1 s; }
    }
}

/// The motor and the wall contradict each other: the run ends with the state before the impact, not with one that is half changed.
#[test]
fn invariant_impact_that_rows_forbid_ends_the_run_with_the_state_before_it() {
    for method in METHODS {
        let run = simulation(&rammed::Runs::default()).method(method).run().unwrap();
        let last = run.last();
        assert!(
            !run.outcome.reached_end() && (last.t - 0.5).abs() <= LOCATED_S,
            "{} by {}",
            run.outcome,
            method.name()
        );
        assert!((last.get("slide.x").unwrap() - 2.0 * last.t).abs() <= 1e-12, "{} by {}", run.outcome, method.name());
        assert!((last.get("slide.vx").unwrap() - 2.0).abs() <= 1e-12, "{} by {}", run.outcome, method.name());
        assert_eq!(last.get("lambda.wall").unwrap(), 0.0, "{}", method.name());
    }
}

#[test]
fn invariant_row_of_a_stop_that_holds_is_watched() {
    // without it there is no row
    let run = simulation(&puck::Slides { e: 0.0 }).method(Method::dop853(1e-12)).run().unwrap();
    let Monitors { position_residual, velocity_residual, position_drift, velocity_drift, pivot, .. } = run.monitors;
    for peak in [position_residual, velocity_residual, position_drift, velocity_drift] {
        assert_eq!(peak.unwrap().row, "walls");
    }
    assert!(pivot.unwrap().t > 1.0);
    let bounces = simulation(&puck::Slides::default()).method(Method::dop853(1e-12)).run().unwrap();
    assert!(bounces.monitors.position_residual.is_none() && bounces.monitors.pivot.is_none());
}
