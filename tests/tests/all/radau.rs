//! Radau IIA: its order, stiff and not, its dense output, and the steps that stiffness does not hold.

use crate::scenes::{distance, stepped};
use ezy_core::prelude::*;
use ezy_core::simulate::{Cost, SetupError};
use ezy_core::testing::StepsBy;
use ezy_core_tests::simulation;
use ezy_models::{chain, double_pendulum, ezy_roller, four_bar, road_train, roller_racer, single_track_car};
use ezy_tests::garage::{case, load, rows, worse};
use ezy_tests::hand_roller::HandRoller;

model! {
    /// A mass on a spring that is nearly a rod.
    pub model Stiff {
        param k: N/m = 1e9;
        param c: N*s/m = 0;
        body bob { mass: 1, inertia: 1 }
        spring ground(0, 0) ~ bob(0, 0): stiffness k, length 1, damping c;
        gravity (0, -9.81);
        start level { bob at (1, 0) angle 0; at rest; }
        scene swing { start level; until 1 s; }
    }
}

model! {
    /// A cart with a caster whose wheel trails its hinge.
    pub model Cart {
        param trail: m = 0.01;
        body cart { mass: 5, inertia: 0.3 }
        body caster { mass: 0.2, inertia: 1e-6 }
        hinge pin: cart(0.5, 0) ~ caster(0, 0);
        skate rear: at cart(-0.4, 0) along cart(1, 0);
        skate wheel: at caster(-trail, 0) along caster(1, 0);
        start askew { cart at (0.4, 0) angle 0 velocity (1, _) rate 0.4; caster angle 1.2; }
        param halt: s = 0.2345;
        event half: t > halt/2;
        event halted: t > halt;
        scene coast { start askew; until 2 s; }
        scene halted_coast { start askew; until 2 s; until halted; }
    }
}

/// Lengths of steps for orders: the coarsest resolves the motion, the finest leaves more than rounding.
const STEPS: [f64; 3] = [0.05, 0.025, 0.0125];
/// Slopes between steps that are not infinitely small.
const ORDER_TOLERANCE: f64 = 0.4;
/// The state at `end_s` after equal steps, and the one in the middle of the last step.
fn equal_steps(scene: &dyn Scene, end_s: f64, h: f64) -> [State; 2] {
    stepped(scene, StepsBy::Method(MethodKind::Radau), std::iter::repeat_n(h, (end_s / h).round() as usize))
}

fn order(errors: [f64; 3]) -> f64 {
    (errors[0] / errors[2]).ln() / (STEPS[0] / STEPS[2]).ln()
}

/// Where DOP853 gets to, with room for two digits.
fn truth(scene: &dyn Scene, t: f64) -> Vec<f64> {
    let run = simulation(scene).method(Method::dop853(1e-14)).until(t).work().run().unwrap();
    let last = run.last();
    [last.coordinates, last.velocities, last.work].concat()
}

fn numbers(state: &State) -> Vec<f64> {
    [&state.q[..], &state.v, &state.work].concat()
}

#[test]
fn order_radau_is_five_with_works() {
    let scene = ezy_roller::Driven::default();
    let end = truth(&scene, 1.0);
    let errors = STEPS.map(|h| distance(&numbers(&equal_steps(&scene, 1.0, h)[0]), &end));
    assert!((order(errors) - 5.0).abs() <= ORDER_TOLERANCE, "order {:.2}: {errors:?}", order(errors));
}

#[test]
fn order_radau_dense_output_is_four_with_works() {
    let scene = ezy_roller::Driven::default();
    let errors = STEPS.map(|h| {
        let [_, middle] = equal_steps(&scene, 1.0, h);
        distance(&numbers(&middle), &truth(&scene, middle.t))
    });
    // one step of order 4 has an error of order 5
    assert!((order(errors) - 5.0).abs() <= ORDER_TOLERANCE, "order {:.2}: {errors:?}", order(errors));
}

model! {
    /// A cart held by a stiff spring and damper to a mark that moves as sin t, and by nothing else.
    pub model Led {
        param k: N/m = 1e10;
        param c: N*s/m = 2e5;
        body cart { mass: 1, inertia: 1 }
        force at cart(0, 0): (-k*(cart.x - sin(t)) - c*(cart.vx - cos(t)) - sin(t), 0);
        start on_mark { cart at (0, 0) angle 0 velocity (1, 0) rate 0; }
        scene lead { start on_mark; until 1 s; }
    }
}

/// Where the cart settles in 1e-5 s and steps are a thousand times as long, the order is that of the stages.
#[test]
fn order_radau_is_three_at_least_where_a_force_is_stiff() {
    let scene = led::Lead::default();
    let errors = STEPS.map(|h| (equal_steps(&scene, 1.0, h)[0].v[0] - 1.0_f64.cos()).abs());
    assert!(order(errors) >= 3.0 - ORDER_TOLERANCE, "order {:.2}: {errors:?}", order(errors));
}

/// The rigid limit: extensions of N/k come to 3e-8 m, and the swing with them to 4e-8 m.
#[test]
fn reference_radau_swings_on_a_stiff_spring() {
    let file = load("torture");
    // bounds of the reference
    let (position, extension) = (1e-6, 1e-10);
    for (name, c) in [("stiff_spring_undamped", 0.0), ("stiff_spring_damped", 2e3)] {
        let scene = stiff::Swing { c, ..Default::default() };
        let case = case(&file, name);
        let states = case["states"].as_array().unwrap();
        for (row, state) in rows(&case["rows"]).iter().zip(states) {
            let run = simulation(&scene).method(Method::radau(1e-9)).until(row[0]).run().unwrap();
            assert!(run.outcome.reached_end(), "{name}: {}", run.outcome);
            let [x, y] = [0, 1].map(|i| run.last().coordinates[i]);
            let [ref_x, ref_y] = [0, 1].map(|i| state["bodies"]["M"][i].as_f64().unwrap());
            let error = worse((x - ref_x).abs(), y - ref_y);
            assert!(error <= position, "{name}: {error:.1e} at {} s", row[0]);
            let error = (x.hypot(y) - 1.0 - row[1]).abs();
            assert!(error <= extension, "{name}: extension off by {error:.1e} at {} s", row[0]);
        }
    }
}

#[test]
fn analytic_radau_steps_are_not_held_by_a_damped_stiff_spring() {
    let scene = stiff::Swing { c: 2e3, ..Default::default() };
    let run = simulation(&scene).method(Method::radau(1e-6)).until(3.0).run().unwrap();
    // a hundredth of a second each; the spring holds DOP853 to 1e-4 s and less
    assert!(run.outcome.reached_end() && run.cost.steps <= 300, "{} steps", run.cost.steps);
}

#[test]
fn invariant_radau_keeps_the_energy_of_an_undamped_swing() {
    let scene = stiff::Swing::default();
    let run = simulation(&scene).method(Method::radau(1e-9)).until(5.0).every(0.1).run().unwrap();
    let energy = |s: Sample<'_>| s.energy.kinetic + s.energy.potential;
    let worst = run.samples().fold(0.0, |m: f64, s| worse(m, energy(s) - energy(run.first())));
    // two swings turn 9.81 J over
    assert!(worst <= 1e-6, "{worst:.1e} J");
}

#[test]
fn reference_radau_follows_a_caster_on_a_short_trail() {
    let file = load("torture");
    // bound of the reference at a tolerance of 1e-9
    let bound = 1e-7;
    for (name, trail) in [("caster_trail_1e-2", 0.01), ("caster_trail_1e-3", 0.001)] {
        let scene = cart::Coast { trail, ..Default::default() };
        for state in case(&file, name)["states"].as_array().unwrap() {
            let t = state["t"].as_f64().unwrap();
            let run = simulation(&scene).method(Method::radau(1e-9)).until(t).run().unwrap();
            let expected = ["cart", "caster"].map(|body| {
                let numbers = state["bodies"][body].as_array().unwrap();
                numbers.iter().map(|x| x.as_f64().unwrap()).collect::<Vec<_>>()
            });
            let expected = expected.concat();
            let (q, v) = (run.last().coordinates, run.last().velocities);
            let found = [&q[..3], &v[..3], &q[3..], &v[3..]].concat();
            let error = distance(&found, &expected);
            assert!(error <= bound, "{name}: {error:.1e} at {t} s");
        }
    }
}

/// A start from which an error of the caster's angle by a tolerance is one of its rate by 40,000.
fn fast(scene: &dyn Scene, method: Method) -> Simulation<'_, &dyn Scene> {
    let start = [("cart.vx", 20.0), ("cart.omega", 8.0), ("caster.phi", 1.2)];
    let order = simulation(scene).method(method).until(0.5).project_start();
    start.iter().fold(order, |order, (name, value)| order.start(*name, *value))
}

/// Samples in a step, and ends of steps.
#[test]
fn cross_radau_follows_a_caster_on_a_trail_of_half_a_millimetre() {
    let scene = cart::Coast { trail: 5e-4, ..Default::default() };
    let samples = |method: Method| fast(&scene, method).every(0.5 / 64.0).without_events().run().unwrap();
    let reference = samples(Method::dop853(1e-11));
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
        let run = samples(Method::radau(tolerance));
        let of = |sample: Sample<'_>| [sample.coordinates, sample.velocities].concat();
        let pairs = run.samples().zip(reference.samples());
        let error = pairs.fold(0.0, |m: f64, (a, b)| worse(m, distance(&of(a), &of(b))));
        println!("{tolerance:.0e}: {} steps, {:.1e} tolerances", run.cost.steps, error / tolerance);
        assert!(error <= OVER_TURNS * tolerance, "{error:.1e} at {tolerance:.0e}");
    }
}

/// States of events, and the end at an event, are as good as samples.
#[test]
fn cross_radau_events_of_a_caster_keep_to_the_tolerance() {
    // one event time in a step for each tolerance would be chance
    for halt in (1..=8).map(|i| 0.05 * f64::from(i) + 0.0123) {
        let scene = cart::HaltedCoast { trail: 5e-4, halt };
        let states = |method: Method| {
            let run = fast(&scene, method).run().unwrap();
            assert_eq!(run.events().len(), 2, "{}", run.outcome);
            run.events()
                .iter()
                .map(|event| [&event.state.q[..], &event.state.v].concat())
                .chain([numbers_at_end(&run)])
                .collect::<Vec<_>>()
                .concat()
        };
        let reference = states(Method::dop853(1e-11));
        for tolerance in [1e-4, 1e-6, 1e-8] {
            let found = states(Method::radau(tolerance));
            let pairs = found.iter().zip(&reference);
            let error = pairs.fold(0.0, |m: f64, (x, truth)| worse(m, (x - truth).abs() / (1.0 + truth.abs())));
            println!("{halt} s, {tolerance:.0e}: {:.1e} tolerances", error / tolerance);
            assert!(error <= OVER_TURNS * tolerance, "{halt} s: {error:.1e} at {tolerance:.0e}");
        }
    }
}

/// A step that the projection rejects is not tried again and again.
#[test]
fn invariant_radau_seldom_repeats_steps_in_a_steady_circle() {
    let scene = road_train::Circling { l: 7e-4, n: 1, ..Default::default() };
    let cost = simulation(&scene).method(Method::radau(1e-8)).until(5.0).run().unwrap().cost;
    // one in four, and those of the beginning
    assert!(cost.rejected <= cost.steps / 3, "{} of {} steps", cost.rejected, cost.steps);
}

/// Next to a singular position, rounding of positions is more of a velocity than the tolerance allows.
#[test]
fn invariant_radau_takes_no_rounding_for_an_error() {
    let run = simulation(&four_bar::Turning::default()).method(Method::radau(1e-14)).until(1.3).run().unwrap();
    assert!(run.outcome.reached_end(), "{}", run.outcome);
}

/// Once the caster has aligned, steps are those of the cart.
#[test]
fn analytic_radau_steps_are_not_held_by_a_caster() {
    let trail = 1e-3;
    let scene = cart::Coast { trail, ..Default::default() };
    let steps = |until_s: f64| simulation(&scene).method(Method::radau(1e-6)).until(until_s).run().unwrap().cost.steps;
    // the caster aligns in a few trail/v, 1 ms each
    let (aligned, until) = (steps(0.2), steps(2.2));
    let mean = 2.0 / (until - aligned) as f64;
    assert!(mean >= 100.0 * trail, "{mean} s a step");
}

#[test]
fn cross_radau_and_dop853_on_scenes_without_stiffness() {
    let scenes: [&dyn Scene; 2] = [&ezy_roller::Driven::default(), &double_pendulum::Swing::default()];
    for scene in scenes {
        let end = |method| {
            let run = simulation(scene).method(method).until(2.0).work().run().unwrap();
            [run.last().coordinates, run.last().velocities, run.last().work].concat()
        };
        let difference = distance(&end(Method::radau(1e-10)), &end(Method::dop853(1e-13)));
        // a tolerance is kept per step, and the motion multiplies errors a hundred times at most
        assert!(difference <= 1e-8, "{}: {difference:.1e}", scene.info().model);
    }
}

/// Masses of the upper and the lower rod: a heavy one that a light one carries, a light one that a heavy one carries, each in
/// units of the light, of the heavy and of neither.
const APART: [[f64; 2]; 10] = [
    [1.0, 1e8],
    [1.0, 1e10],
    [1.0, 1e12],
    [1e-10, 1.0],
    [1e-5, 1e5],
    [1e9, 1e19],
    [1e12, 1.0],
    [1e10, 1.0],
    [1.0, 1e-10],
    [1e-19, 1e-9],
];

/// Whatever the masses, the rods swing as fast, and steps are as long.
#[test]
fn invariant_radau_steps_do_not_depend_on_ratios_of_masses() {
    for tolerance in [1e-9, 1e-11] {
        let run = |[m1, m2]: [f64; 2], method| {
            let scene = double_pendulum::Swing { m1, m2, ..Default::default() };
            simulation(&scene).method(method).until(1.0).run().unwrap()
        };
        let equal = run([1.0, 1.0], Method::radau(tolerance)).cost;
        for masses in APART {
            let (found, exact) = (run(masses, Method::radau(tolerance)), run(masses, Method::taylor(1e-14)));
            let Cost { steps, rejected, evaluations, .. } = found.cost;
            // a tenth for a motion that is not the same
            let held = steps <= equal.steps * 11 / 10 && evaluations <= equal.evaluations * 11 / 10 && rejected <= 5;
            assert!(found.outcome.reached_end() && held, "{masses:?}: {steps} steps, {rejected} rejected");
            let error = distance(found.last().coordinates, exact.last().coordinates);
            // steps keep to the tolerance, which the motion multiplies ten times at most
            assert!(error <= 10.0 * tolerance, "{masses:?}: {error:.1e} at {tolerance:.0e}");
        }
    }
}

/// Steps are as many, to the last one, in any unit of mass.
#[test]
fn invariant_radau_steps_do_not_depend_on_the_unit_of_mass() {
    for [m1, m2] in [[1.0, 1.0], [1.0, 1e10], [1e10, 1.0]] {
        let run = |unit: f64| {
            let scene = double_pendulum::Swing { m1: unit * m1, m2: unit * m2, ..Default::default() };
            simulation(&scene).method(Method::radau(1e-10)).until(1.0).run().unwrap()
        };
        let plain = run(1.0);
        for unit in [1e-9, 1e9] {
            let other = run(unit);
            let counts = |run: &Run| (run.cost.steps, run.cost.rejected);
            assert_eq!(counts(&other), counts(&plain), "{m1} kg and {m2} kg times {unit:.0e}");
            let difference = distance(other.last().coordinates, plain.last().coordinates);
            // rounding of 320 steps, and lengths of steps that go with the rounded estimates
            assert!(difference <= 1e-12, "{m1} kg and {m2} kg times {unit:.0e}: {difference:.1e}");
        }
    }
}

/// 30 rods are 150 equations, which are factored by their pattern.
#[test]
fn cross_radau_and_dop853_on_a_chain_with_friction() {
    let n = 30;
    let scene = chain::Settle { n, l: 1.0 / n as f64, m: 1.0 / n as f64, d: 1e-3, ..Default::default() };
    let run = |method| simulation(&scene).method(method).until(0.05).run().unwrap();
    let (found, expected) = (run(Method::radau(1e-8)), run(Method::dop853(1e-10)));
    let difference = distance(found.last().coordinates, expected.last().coordinates);
    // a tolerance is kept per step
    assert!(difference <= 1e-7, "{difference:.1e}");
}

#[test]
fn invariant_radau_samples_keep_to_the_tolerance_and_meet_the_rows() {
    let scene = ezy_roller::Driven::default();
    let order = |method| simulation(&scene).method(method).until(2.0).every(0.01).run().unwrap();
    let (coarse, fine) = (order(Method::radau(1e-6)), order(Method::dop853(1e-12)));
    for (sample, exact) in coarse.samples().zip(fine.samples()) {
        let error = distance(sample.coordinates, exact.coordinates);
        // errors of steps add up over the steps
        assert!(error <= 1e-5, "{error:.1e} at {} s", sample.t);
        assert!(sample.position_residual <= 1e-12 && sample.velocity_residual <= 1e-12, "at {} s", sample.t);
    }
}

#[test]
fn analytic_radau_refuses_a_scene_without_jacobians() {
    let outcome = simulation(&HandRoller::driven()).method(Method::radau(1e-9)).run();
    assert!(matches!(outcome, Err(SetupError::NoJacobians { scene: "driven" })));
}

/// DOP853 counts slopes at the edge of its stability and says so.
#[test]
fn analytic_dop853_says_that_stiffness_holds_it() {
    let scene = cart::Coast { trail: 1e-3, ..Default::default() };
    let run = simulation(&scene).method(Method::dop853(1e-6)).run().unwrap();
    let since = run.stiff_since_s.expect("a remark");
    // the caster aligns in a few milliseconds; fifty steps pass until one is looked at, and fifteen more
    assert!((0.01..1.0).contains(&since), "since {since} s");
    assert_eq!(simulation(&scene).method(Method::radau(1e-6)).run().unwrap().stiff_since_s, None);
}

/// Rubber turns its trucks back at c/j = 270 per second, while the rider takes a second for a turn.
const STIFF: (&str, &str) = ("Skateboard", "ridden");

#[test]
fn invariant_no_scene_without_stiffness_is_called_stiff() {
    for entry in ezy_models::registry::MODELS.iter().flat_map(|model| model.scenes) {
        let scene = (entry.new)();
        if (scene.info().model, scene.info().name) == STIFF {
            continue;
        }
        let until_s = scene.info().until_s.min(2.0);
        let Ok(run) = simulation(&*scene).method(Method::dop853(1e-9)).until(until_s).run() else { continue };
        assert_eq!(run.stiff_since_s, None, "{}/{}", scene.info().model, scene.info().name);
    }
}

/// Angle of the handle after a second of rowing against friction with this knee, from DOP853 at 1e-12 in 10,507 and 1,043,158 steps.
const OVER_KNEES: [(f64, f64); 2] = [(1e-8, 2.356_228_683_73), (1e-10, 2.356_228_045_84)];

/// Steps at most: DOP853 takes ten thousand and a million.
const FEW_STEPS: u64 = 200;

/// What a tolerance per step may become in this motion, which doubles errors.
const ADDED_UP: f64 = 100.0;

/// Within the knee the force is stiff, beyond it is constant, and wheels that stand begin to roll within a step. The iteration must not
/// take small changes for a solution, nor the estimate hide what is stiff at the start of the step alone.
#[test]
fn reference_radau_over_a_steep_knee_of_friction() {
    for (knee, expected) in OVER_KNEES {
        let scene = roller_racer::RowedOnTarmac { knee, ..Default::default() };
        for tolerance in [1e-6, 1e-7, 1e-8, 1e-9] {
            let run = simulation(&scene).method(Method::radau(tolerance)).until(1.0).run().unwrap();
            let error = (run.last().get("handle.phi").unwrap() - expected).abs();
            let steps = run.cost.steps;
            assert!(error <= ADDED_UP * tolerance, "{knee:.0e} at {tolerance:.0e}: off by {error:.1e}, {steps} steps");
            assert!(steps <= FEW_STEPS, "{knee:.0e} at {tolerance:.0e}: {steps} steps");
        }
    }
}

/// Wheels that creep within the knee of their friction make the motion stiff: the polynomial of a step of 0.05 s, in which they begin to, is off by 160
/// tolerances at 0.083 s.
#[test]
fn cross_radau_samples_keep_to_the_tolerance_where_friction_is_stiff() {
    let scene = roller_racer::RowedOnTarmac { h: 0.62, m1: 0.104, omega: -0.38, knee: 1.5e-6, ..Default::default() };
    let samples = |method| simulation(&scene).method(method).until(0.38).every(0.38 / 32.0).run().unwrap();
    let of = |sample: Sample<'_>| [sample.coordinates, sample.velocities].concat();
    const TOLERANCE: f64 = 1e-9;
    let (run, reference) = (samples(Method::radau(TOLERANCE)), samples(Method::dop853(1e-12)));
    assert!(run.cost.steps <= FEW_STEPS, "{} steps", run.cost.steps);
    assert_eq!((run.samples().len(), reference.samples().len()), (33, 33), "{}", run.outcome);
    for (sample, expected) in run.samples().zip(reference.samples()) {
        // no number is much larger than one
        let error = distance(&of(sample), &of(expected));
        assert!(error <= ADDED_UP * TOLERANCE, "{error:.1e} at {} s", sample.t);
    }
}

/// Tyres that follow their slip swing a car whose rear axle is far behind by 1e-8 rad/s at thousands of rad/s, which steps damp that are as long as the tolerance
/// of their estimate allows: it was off by 260 tolerances without a word.
#[test]
fn cross_radau_follows_fast_oscillations_above_the_tolerance() {
    let scene = single_track_car::Relaxing {
        lr: 245.186_750_5,
        delta: 2.567_220_168e-2,
        sigma: 0.769_973_408,
        ..Default::default()
    };
    const UNTIL_S: f64 = 1.326_752_35;
    const TOLERANCE: f64 = 1.057_557e-10;
    let samples = |method| simulation(&scene).method(method).until(UNTIL_S).every(UNTIL_S / 32.0).run().unwrap();
    let (run, reference) = (samples(Method::radau(TOLERANCE)), samples(Method::dop853(1e-13)));
    assert_eq!((run.samples().len(), reference.samples().len()), (33, 33), "{}", run.outcome);
    let of = |sample: Sample<'_>| sample.get("car.omega").unwrap();
    let error = run.samples().zip(reference.samples()).fold(0.0, |m: f64, (a, b)| worse(m, of(a) - of(b)));
    println!("{} steps, {:.1} tolerances", run.cost.steps, error / TOLERANCE);
    // its turning is far below 1 rad/s
    assert!(error <= OVER_TURNS * TOLERANCE, "{error:.1e}");
}

fn numbers_at_end(run: &Run) -> Vec<f64> {
    [run.last().coordinates, run.last().velocities].concat()
}

/// What errors of steps add up to.
const OVER_TURNS: f64 = 100.0;

/// A torque that turns round 1,100 times a second, in steps of several turns: the estimate of a step vanishes now and then.
#[test]
fn cross_radau_steps_do_not_pass_over_turns_of_a_torque() {
    let fast =
        ezy_roller::Driven { d: 3.944_153_374_243_181e-2, omega: 1.589_030_602_584_880_4e4, ..Default::default() };
    let rowed = roller_racer::RowedOnTarmac {
        h: 2.812_688_966_078_293_4,
        omega: 6.893_255_039_213_796e3,
        ..Default::default()
    };
    let cases: [(&dyn Scene, _, _); 2] = [
        (&fast, 0.682_019_185_596_350_4, vec![("bar.omega", -0.454_981_766_130_069_7)]),
        (&rowed, 1.265_869_791_561_476_3, vec![]),
    ];
    for (scene, until_s, given) in cases {
        let samples = |method: Method| {
            let order = simulation(scene).method(method).until(until_s).every(until_s / 32.0).project_start();
            given.iter().fold(order, |order, given: &(&str, f64)| order.start(given.0, given.1)).run().unwrap()
        };
        let reference = samples(Method::dop853(1e-11));
        let of = |sample: Sample<'_>| [sample.coordinates, sample.velocities].concat();
        let size = reference.samples().flat_map(of).fold(1.0, |size: f64, x| size.max(x.abs()));
        for tolerance in [1e-4, 1e-6] {
            let run = samples(Method::radau(tolerance));
            let pairs = run.samples().zip(reference.samples());
            let error = pairs.fold(0.0, |m: f64, (a, b)| worse(m, distance(&of(a), &of(b)) / size));
            assert!(error <= OVER_TURNS * tolerance, "{error:.1e} at {tolerance:.0e}");
        }
    }
}
