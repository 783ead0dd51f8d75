//! Scenes in which several rows are switched: skates with limits, and a stop.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;

/// Changes are located to 1e-12 s; the value that is located carries rounding of 1e-15 m/s or N at slopes around one, and where
/// a slide ends its start counts, too.
const LOCATED_S: f64 = 4e-12;

/// A spring's motion is followed to a tolerance of 1e-12 a step, over a hundred steps.
const FOLLOWED: f64 = 1e-10;

/// Newton's law at a sample, as a share of the largest force of 10 N: the solution of K is refined.
const NEWTON_N: f64 = 1e-11;

/// Velocity across a skate that holds, after projection, m/s.
const HELD: f64 = 1e-12;

model! {
    /// Two sleds that nothing joins, each on a runner of its own.
    pub model Pair {
        param first_limit: N = 3; param second_limit: N = 3.5;
        body one { mass: 2, inertia: 1 }
        body two { mass: 2, inertia: 1 }
        skate first: at one(0, 0) along one(1, 0) limit first_limit;
        skate second: at two(0, 0) along two(1, 0) limit second_limit;
        let push = 4 N/s * t - 1 N/s^2 * t^2;
        force at one(0, 0): (0, push);
        force at two(0, 0): (0, push);
        start rest { one at (0, 0) angle 0; two at (3, 0) angle 0; at rest; }
        scene waved { start rest; until 6 s; }
    }
}

model! {
    /// A motor draws a block on a spring, which draws another one on a second spring.
    pub model Drawn {
        param k: N/m = 40; param k2: N/m = 10; param u: m/s = 0.5; param m: kg = 1;
        param near_limit: N = 6; param far_limit: N = 2;
        body hand { mass: 1, inertia: 1 }
        body near { mass: m, inertia: 1 }
        body far { mass: 3, inertia: 1 }
        slider hand_rail: ground(0, 0) ~ hand(0, 0) along ground(1, 0);
        slider near_rail: ground(0, 0) ~ near(0, 0) along ground(1, 0);
        slider far_rail: ground(0, 0) ~ far(0, 0) along ground(1, 0);
        drive motor: hand.x = u * t;
        skate near_runner: at near(0, 0) along near(0, 1) limit near_limit;
        skate far_runner: at far(0, 0) along far(0, 1) limit far_limit;
        force at near(0, 0): (k * (hand.x - near.x) + k2 * (far.x - near.x), 0);
        force at far(0, 0): (k2 * (near.x - far.x), 0);
        start rest { hand at (0, 0) angle 0; near at (0, 0) angle 0; far at (0, 0) angle 0;
                     hand velocity (u, 0) rate 0; near velocity (0, 0) rate 0; far velocity (0, 0) rate 0; }
        scene drawn { start rest; until 3 s; }
    }
}

model! {
    /// A sled on two runners in line, which is pushed across them out of its middle.
    pub model Runners {
        param rear_limit: N = 2; param front_limit: N = 4; param phase: rad = 0;
        body sled { mass: 2, inertia: 0.5 }
        skate rear: at sled(-0.5, 0) along sled(1, 0) limit rear_limit;
        skate front: at sled(0.5, 0) along sled(1, 0) limit front_limit;
        force at sled(0.2, 0) along sled(0, 1): 10 N * sin(2 rad/s * t + phase);
        drag at sled(0, 0): linear 0.5;
        start rest { sled at (0, 0) angle 0; sled velocity (1, 0) rate 0; }
        scene pushed { start rest; until 4 s; }
    }
}

model! {
    /// A sled that slides along its runner into a wall, at an angle of 45°.
    pub model Walled {
        param limit: N = 2; param e = 0.5; param v: m/s = 1;
        body sled { mass: 1, inertia: 1 }
        skate runner: at sled(0, 0) along sled(1, 1) limit limit;
        stop wall: sled.x to 1 restitution e;
        start away { sled at (0, 0) angle 0; sled velocity (v, v) rate 0; }
        scene hits { start away; until 3 s; }
    }
}

model! {
    /// A sled that a force presses onto a wall, while another one pushes it along the wall.
    pub model Pressed {
        body sled { mass: 2, inertia: 1 }
        skate runner: at sled(0, 0) along sled(1, 0) limit 3;
        stop wall: sled.x to 0;
        force at sled(0, 0): (2 N - 1 N/s * t, 4 N/s * t - 1 N/s^2 * t^2);
        start rest { sled at (0, 0) angle 0; at rest; }
        scene leaves { start rest; until 3.5 s; }
    }
}

const METHODS: [Method; 5] =
    [Method::rk4(0.05), Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)];

/// The same with a step that leaves nothing of a motion that is no polynomial.
const FINE: [Method; 5] =
    [Method::rk4(1e-3), Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)];

fn named(run: &Run) -> Vec<(&'static str, f64)> {
    run.events().iter().map(|occurred| (occurred.event.name, occurred.state.t)).collect()
}

fn assert_changes(run: &Run, expected: &[(&str, f64)], tolerance: f64) {
    let found = named(run);
    assert_eq!(found.len(), expected.len(), "{found:?}, {}", run.outcome);
    for ((name, t), (expected_name, expected)) in found.iter().zip(expected) {
        assert_eq!(name, expected_name, "{found:?}");
        assert!((t - expected).abs() <= tolerance, "{name}: {t} for {expected}");
    }
}

/// The root of a function that rises between two places.
fn root(mut from: f64, mut to: f64, f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..80 {
        let middle = 0.5 * (from + to);
        if f(middle) < 0.0 { from = middle } else { to = middle }
    }
    0.5 * (from + to)
}

/// From `a`, where push 4 t − t² passes the limit, 2 v = ∫ (4 t − t² − limit) dt comes back to zero with u = t − a at
/// (2 − a) u² − u³/3 = 0.
fn slide(limit: f64) -> [f64; 2] {
    let a = 2.0 - (4.0 - limit).sqrt();
    [a, a + 3.0 * (2.0 - a)]
}

#[test]
fn analytic_skates_of_bodies_apart_slide_each_for_itself() {
    let ([a, b], [c, d]) = (slide(3.0), slide(3.5));
    for method in METHODS {
        let run = simulation(&pair::Waved::default()).method(method).until(4.5).run().unwrap();
        let expected = [("first slides", a), ("second slides", c), ("second stops", d), ("first stops", b)];
        assert_changes(&run, &expected, LOCATED_S);
    }
}

#[test]
fn analytic_skates_that_let_go_at_once_are_both_told() {
    let [a, b] = slide(3.0);
    let scene = pair::Waved { second_limit: 3.0, ..Default::default() };
    for method in METHODS {
        let run = simulation(&scene).method(method).until(4.5).run().unwrap();
        let expected = [("first slides", a), ("second slides", a), ("first stops", b), ("second stops", b)];
        assert_changes(&run, &expected, LOCATED_S);
    }
}

#[test]
fn analytic_block_that_slides_draws_the_next_one_over_its_limit() {
    let scene = drawn::Drawn::default();
    let drawn::Drawn { k, k2, u, m, near_limit, far_limit, .. } = scene;
    let begins = near_limit / (k * u);
    // m x'' = k u τ − (k + k2) x from rest: x = s (τ − sin(ω τ)/ω) with s = k u/(k + k2)
    let (omega, s) = (((k + k2) / m).sqrt(), k * u / (k + k2));
    let x = |tau: f64| s * (tau - (omega * tau).sin() / omega);
    let follows = begins + root(0.0, 2.0, |tau| k2 * x(tau) - far_limit);
    // the near block must not have stopped before
    assert!(follows < begins + std::f64::consts::TAU / omega, "{follows}");
    for method in FINE {
        let run = simulation(&scene).method(method).until(follows + 0.01).run().unwrap();
        assert_changes(&run, &[("near_runner slides", begins), ("far_runner slides", follows)], FOLLOWED);
    }
}

/// Newton's law with the forces of the runners and Coulomb's law of each of them, at every sample, without the equations of the scene.
#[test]
fn invariant_forces_of_two_runners_are_those_of_their_laws() {
    // pushed over both limits at the start, too
    for (phase, method) in [0.0, 1.5].into_iter().flat_map(|phase| FINE.map(|method| (phase, method))) {
        let scene = runners::Pushed { phase, ..Default::default() };
        let limits = [scene.rear_limit, scene.front_limit];
        let run = simulation(&scene).method(method).every(0.01).work().run().unwrap();
        assert!(run.outcome.reached_end(), "{}", run.outcome);
        let names: std::collections::BTreeSet<&str> = run.events().iter().map(|e| e.event.name).collect();
        assert_eq!(
            names.into_iter().collect::<Vec<_>>(),
            ["front slides", "front stops", "rear slides", "rear stops"],
            "by {}",
            method.name()
        );
        let (mut n_held, mut n_slid) = ([0; 2], [0; 2]);
        for sample in run.samples() {
            let get = |name: &str| sample.get(name).unwrap();
            let (sin, cos) = get("sled.phi").sin_cos();
            let across = |x: f64, y: f64| -sin * x + cos * y;
            let omega = get("sled.omega");
            let lambda = [get("lambda.rear"), get("lambda.front")];
            let speed = [-0.5, 0.5].map(|x| across(get("sled.vx"), get("sled.vy")) + x * omega);
            for i in 0..2 {
                if speed[i].abs() <= HELD {
                    n_held[i] += 1;
                    assert!(lambda[i].abs() <= limits[i] + NEWTON_N, "{} at {}", lambda[i], sample.t);
                } else {
                    n_slid[i] += 1;
                    assert!((lambda[i] - limits[i].copysign(speed[i])).abs() <= NEWTON_N, "at {}", sample.t);
                }
            }
            let push = 10.0 * (2.0 * sample.t + phase).sin();
            let force = push - lambda[0] - lambda[1];
            let a = |i: usize| sample.accelerations[i];
            let newton = [
                2.0 * a(0) + sin * force + 0.5 * get("sled.vx"),
                2.0 * a(1) - cos * force + 0.5 * get("sled.vy"),
                0.5 * a(2) - 0.2 * push - 0.5 * lambda[0] + 0.5 * lambda[1],
            ];
            assert!(newton.iter().all(|r| r.abs() <= NEWTON_N), "{newton:?} at {} by {}", sample.t, method.name());
        }
        assert!(n_held.iter().chain(&n_slid).all(|n| *n > 50), "{n_held:?} {n_slid:?}");
        let work = run.last().energy.balance;
        assert!(work.abs() <= FOLLOWED, "{work} by {}", method.name());
    }
}

#[test]
fn analytic_limit_gives_no_impulse_to_an_impact() {
    let scene = walled::Hits::default();
    let walled::Hits { limit, e, v, .. } = scene;
    // across the runner, to its left, from (1 + e) v/√2 after the impact to zero, under the limit
    let hit = 1.0 / v;
    let slides_s = (1.0 + e) * v / 2f64.sqrt() / limit;
    for method in METHODS {
        let run = simulation(&scene).method(method).until(hit + slides_s + 0.1).run().unwrap();
        let expected = [("wall hits", hit), ("runner slides", hit), ("runner stops", hit + slides_s)];
        assert_changes(&run, &expected, LOCATED_S);
        let last = run.last();
        // what is left is the velocity along the runner, (1 − e) v/√2
        for name in ["sled.vx", "sled.vy"] {
            assert!((last.get(name).unwrap() - 0.5 * (1.0 - e) * v).abs() <= LOCATED_S, "{name} by {}", method.name());
        }
    }
}

#[test]
fn analytic_skate_slides_along_a_wall_that_holds() {
    let [a, b] = slide(3.0);
    for method in METHODS {
        let run = simulation(&pressed::Leaves::default()).method(method).run().unwrap();
        assert_changes(&run, &[("runner slides", a), ("wall lets go", 2.0)], LOCATED_S);
        let last = run.last();
        let (tau, u) = (1.5, 3.5 - a);
        // 2 x'' = −(t − 2); 2 v_y = (2 − a) u² − u³/3
        let expected = [("sled.x", -tau * tau * tau / 12.0), ("sled.vy", 0.5 * ((2.0 - a) * u * u - u * u * u / 3.0))];
        for (name, value) in expected {
            assert!((last.get(name).unwrap() - value).abs() <= 1e-11, "{name} by {}", method.name());
        }
        assert!(b > 3.5, "it slides to the end");
        assert_eq!(last.get("lambda.runner").unwrap(), 3.0);
    }
}
