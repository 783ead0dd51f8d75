//! Events: found, located, and harmless.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_models::pendulum;

/// Events are located to 1e-12 s; the value that is located carries rounding of 1e-15 m or rad at speeds around one.
const LOCATED_S: f64 = 2e-12;

model! {
    /// A ball that is thrown up: everything about it is a polynomial, which every method follows.
    pub model Throw {
        param g: m/s^2 = 10;
        param height: m = 5;
        param slit: m = 7.1;
        body ball { mass: 1, inertia: 1 }
        gravity (0, -g);
        input gate: m = 100;
        event landing: ball.y < 0;
        event top: ball.vy = 0;
        event level: ball.y = height;
        event noon: t > 1.5;
        event through: ball.y > slit;
        event gone: ball.x > gate;
        effect wind { event far: ball.x > 6.5; }
        start up { ball at (0, 0) angle 0; ball velocity (3, 12) rate 0; }
        scene fly { start up; until 2.9 s; }
        scene windy { start up; until 2.9 s; with wind; }
        scene land { start up; until 5 s; until landing; }
        scene range { start up; until 5 s; until landing; until ball.x > 6; }
        scene short { start up; until 1 s; until landing; }
    }
}

/// Of each kind one: a fixed step with interpolation, a method with dense output, a series, an implicit method.
const METHODS: [Method; 5] =
    [Method::rk4(0.05), Method::dop853(1e-12), Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12)];

fn run(scene: &dyn Scene, method: Method) -> Run {
    simulation(scene).method(method).run().unwrap()
}

/// A value below 1e-10 of the largest in the first step is rounding: 5e-12 where the wheel turns by 0.05 rad.
#[test]
fn analytic_start_just_before_an_event_is_told_from_rounding() {
    for (before, expected) in [(1e-12, 1), (4e-10, 2)] {
        let scene = wheel::Turn::default();
        let order = simulation(&scene).method(Method::rk4(0.05)).start("wheel.phi", std::f64::consts::PI - before);
        let found = named(&order.run().unwrap());
        assert_eq!(found.len(), expected, "{before:e} rad: {found:?}");
    }
}

fn named(run: &Run) -> Vec<(&'static str, f64)> {
    run.events().iter().map(|occurred| (occurred.event.name, occurred.state.t)).collect()
}

#[test]
fn analytic_events_of_a_throw_are_located_by_every_method() {
    // y = 12 t - 5 t²
    let (level, slit) = (0.44f64.sqrt(), (0.1f64 / 5.0).sqrt());
    let expected = [
        ("level", 1.2 - level),
        ("through", 1.2 - slit),
        ("top", 1.2),
        ("noon", 1.5),
        ("level", 1.2 + level),
        ("landing", 2.4),
    ];
    for method in METHODS {
        let run = run(&throw::Fly::default(), method);
        let found = named(&run);
        assert_eq!(found.len(), expected.len(), "{}: {found:?}", method.name());
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(found.0, expected.0, "{}", method.name());
            assert!((found.1 - expected.1).abs() <= LOCATED_S, "{}: {found:?} for {expected:?}", method.name());
        }
        let top = &run.events()[2].state;
        // twelve metres a second over the located time
        assert!((top.q[1] - 7.2).abs() <= 1e-10 && top.v[1].abs() <= 1e-10, "{top:?}");
    }
}

#[test]
fn analytic_two_passages_within_one_step_are_both_found() {
    let scene = throw::Fly { slit: 1e3, ..Default::default() };
    // one step holds the whole flight, and the ball passes 5 m twice
    let run = simulation(&scene).method(Method::rk4(2.9)).run().unwrap();
    let found = named(&run);
    assert_eq!(run.cost.steps, 1);
    assert_eq!(found.iter().filter(|(name, _)| *name == "level").count(), 2, "{found:?}");
}

#[test]
fn analytic_run_ends_at_the_first_of_its_conditions() {
    for method in METHODS {
        for (scene, end, name) in
            [(&throw::Land::default() as &dyn Scene, 2.4, "landing"), (&throw::Range::default(), 2.0, "ball.x > 6")]
        {
            let run = run(scene, method);
            let Outcome::ReachedEvent { t, name: found } = run.outcome else { panic!("{}", run.outcome) };
            assert_eq!(found, name);
            assert!(run.outcome.reached_end());
            assert!((t - end).abs() <= LOCATED_S && run.last().t == t, "{}: {t}", method.name());
            assert_eq!(named(&run).last(), Some(&(name, t)));
            // the state of the end, and its accelerations
            assert!((run.last().get("ball.x").unwrap() - 3.0 * end).abs() <= 1e-10);
            assert_eq!(run.last().accelerations[1], -10.0);
        }
    }
}

#[test]
fn analytic_run_that_is_over_before_its_condition_reaches_its_time() {
    let run = run(&throw::Short::default(), Method::default());
    assert!(matches!(run.outcome, Outcome::ReachedEnd), "{}", run.outcome);
    assert_eq!(run.last().t, 1.0);
}

#[test]
fn analytic_samples_go_up_to_the_end_that_an_event_makes() {
    for method in METHODS {
        let scene = throw::Land::default();
        let run = simulation(&scene).method(method).every(0.25).run().unwrap();
        let times: Vec<f64> = run.samples().map(|sample| sample.t).collect();
        assert_eq!(times.len(), 11, "{}: {times:?}", method.name());
        assert!(times[..10].iter().enumerate().all(|(i, t)| (t - 0.25 * i as f64).abs() <= 1e-15), "{times:?}");
        for sample in run.samples() {
            let y = 12.0 * sample.t - 5.0 * sample.t * sample.t;
            assert!((sample.get("ball.y").unwrap() - y).abs() <= 1e-11, "{} at {}", method.name(), sample.t);
        }
    }
}

#[test]
fn invariant_motion_with_events_has_the_bits_of_the_motion_without() {
    for method in METHODS {
        let scene = pendulum::Swing::default();
        let order = || simulation(&scene).method(method).every(0.3);
        let (with, without) = (order().run().unwrap(), order().without_events().run().unwrap());
        assert!(!with.events().is_empty() && without.events().is_empty());
        for (a, b) in with.samples().zip(without.samples()) {
            assert_eq!((a.coordinates, a.velocities), (b.coordinates, b.velocities), "{} at {}", method.name(), a.t);
        }
    }
}

#[test]
fn analytic_pendulum_turns_back_every_half_period() {
    // T = 2π √(l/g) / agm(1, cos(θ₀/2)) (Gauss), released level
    let (mut a, mut b) = (1.0f64, std::f64::consts::FRAC_PI_4.cos());
    for _ in 0..6 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    let half = std::f64::consts::PI / (9.81f64.sqrt() * a);
    for (method, tolerance) in [(Method::dop853(1e-13), 1e-10), (Method::taylor(1e-14), 1e-11)] {
        let run = run(&pendulum::Swing::default(), method);
        let found = named(&run);
        // at rest where it begins: this is no event
        assert_eq!(found.len(), (10.0 / half) as usize, "{found:?}");
        for (i, (_, t)) in found.iter().enumerate() {
            // the error of the motion, which grows with each swing
            let error = (t - half * (i + 1) as f64).abs();
            assert!(error <= tolerance, "{} turn {i}: {error:.1e}", method.name());
        }
    }
}

#[test]
fn invariant_events_of_an_effect_come_with_it() {
    let names = |scene: &dyn Scene| scene.info().events.iter().map(|event| event.name).collect::<Vec<_>>();
    assert!(!names(&throw::Fly::default()).contains(&"far"));
    assert_eq!(names(&throw::Windy::default()).last(), Some(&"far"));
    let found = named(&run(&throw::Windy::default(), Method::taylor(1e-10)));
    assert!(
        found.iter().any(|(name, t)| *name == throw::events::far && (t - 6.5 / 3.0).abs() <= LOCATED_S),
        "{found:?}"
    );
}

#[test]
fn analytic_input_that_jumps_over_a_value_is_an_event_of_its_step() {
    let scene = throw::Fly::default();
    let order = Simulation::new(&scene).method(Method::rk4(0.1));
    let run = order.control(|now, set| set.gate = if now.t < 0.95 { 100.0 } else { 1.0 }).run().unwrap();
    let gone: Vec<f64> = named(&run).iter().filter(|(name, _)| *name == "gone").map(|(_, t)| *t).collect();
    // 3 m are passed, and the gate comes down to 1 m at 1 s
    assert_eq!(gone, [1.0]);
}

model! {
    pub model Rope {
        count n = 4;
        body bead[n] { mass: 1, inertia: 1 }
        gravity (0, -10);
        event last: bead[n-1].y < -5;
        start level { for i in 0..n { bead[i] at (i, -i) angle 0; } at rest; }
        scene drop { start level; until 1 s; until bead[0].y < -1.25; }
    }
}

#[test]
fn analytic_events_of_a_scene_with_counts_follow_the_count() {
    let end = ("bead[0].y < -1.25", 0.5);
    for (n, expected) in [(5, vec![("last", 0.2f64.sqrt()), end]), (4, vec![end])] {
        let run = run(&rope::Drop { n }, Method::rk4(0.01));
        let found = named(&run);
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for ((name, t), (expected_name, expected)) in found.into_iter().zip(expected) {
            assert_eq!(name, expected_name);
            assert!((t - expected).abs() <= LOCATED_S, "{name}: {t} for {expected}");
        }
    }
}

model! {
    /// A wheel that turns at 1 rad/s, from half a turn on.
    pub model Wheel {
        body wheel { mass: 1, inertia: 1 }
        event level: sin(wheel.phi) = 0;
        start turning { wheel at (0, 0) angle pi rate 1; wheel velocity (0, 0); }
        scene turn { start turning; until 4 s; }
    }
}

#[test]
fn analytic_start_on_an_event_within_rounding_is_no_event() {
    // the sine of π is 1e-16 in doubles, on the wrong side
    for method in METHODS {
        let found = named(&run(&wheel::Turn::default(), method));
        assert!(matches!(found[..], [("level", t)] if (t - std::f64::consts::PI).abs() <= LOCATED_S), "{found:?}");
    }
}
