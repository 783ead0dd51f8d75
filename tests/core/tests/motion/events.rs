//! Events.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;

model! {
    /// A pendulum that passes its lowest position.
    pub model Pendulum {
        param l: m = 1.5;
        body bob { mass: 2, inertia: 0.375 }
        hinge pivot: ground(0, 0) ~ bob(-l/2, 0);
        gravity (0, -9.81);
        event lowest: bob.phi = -pi/2;
        event slow: bob.omega = -0.5;
        start level { bob angle 0; at rest; }
        scene swing { start level; until 1 s; }
        scene down { start level; until 5 s; until lowest; }
    }
}

/// The tolerance of projections.
const PROJECTED: f64 = 1e-12;

/// Errors of the motion, which is compared with itself by its energy.
const MOTION: f64 = 1e-8;

/// Residuals of the hinge, positions and velocities.
fn residuals(l: f64, q: &[f64], v: &[f64]) -> [f64; 4] {
    let (sin, cos) = q[2].sin_cos();
    [q[0] - l / 2.0 * cos, q[1] - l / 2.0 * sin, v[0] + l / 2.0 * sin * v[2], v[1] - l / 2.0 * cos * v[2]]
}

/// Interpolation leaves a step of 0.05 s by 1e-6: what an event reports is projected, as the ends of steps are.
#[test]
fn invariant_states_of_events_fulfil_the_constraints() {
    let scene = pendulum::Swing::default();
    for method in
        [Method::rk4(0.05), Method::dop853(1e-6), Method::taylor(1e-6), Method::gauss(1e-6), Method::radau(1e-6)]
    {
        let run = simulation(&scene).method(method).run().unwrap();
        let names: Vec<&str> = run.events().iter().map(|of| of.event.name).collect();
        assert_eq!(names, ["slow", "lowest"], "{method:?}");
        for of in run.events() {
            let found = residuals(scene.l, &of.state.q, &of.state.v);
            assert!(found.iter().all(|x| x.abs() <= PROJECTED), "{method:?} {}: {found:?}", of.event.name);
        }
        // an event is in no step but the one that it divides
        let without = simulation(&scene).method(method).without_events().run().unwrap();
        assert_eq!(run.last().coordinates, without.last().coordinates, "{method:?}");
    }
}

/// ½ I φ'² = m g l/2 at the lowest position, with I = 0.375 kg m² + m (l/2)².
#[test]
fn analytic_a_run_ends_at_the_lowest_position() {
    let scene = pendulum::Down::default();
    for method in
        [Method::rk4(1e-3), Method::dop853(1e-11), Method::taylor(1e-11), Method::gauss(1e-11), Method::radau(1e-11)]
    {
        let run = simulation(&scene).method(method).run().unwrap();
        assert!(matches!(run.outcome, Outcome::ReachedEvent { name: "lowest", .. }), "{method:?}: {:?}", run.outcome);
        let last = run.last();
        if method == Method::rk4(1e-3) {
            assert_eq!(run.cost.steps, (last.t / 1e-3).ceil() as u64, "the last step counts, though it ends before");
        }
        assert!((last.get("bob.phi").unwrap() + std::f64::consts::FRAC_PI_2).abs() <= 1e-11, "{method:?}");
        let rate = (2.0 * 9.81 * 0.75 * 2.0_f64 / (0.375 + 2.0 * 0.75 * 0.75)).sqrt();
        assert!((last.get("bob.omega").unwrap() + rate).abs() <= MOTION, "{method:?}: {} {rate}", last.velocities[2]);
    }
}

/// φ'' = −g m l/2 / (I + m (l/2)²) = −9.81 rad/s² where it is level, and less below: 0.5 rad/s is passed 51 ms after the start, before the first step is
/// sampled inside.
#[test]
fn analytic_an_event_soon_after_the_start_is_found() {
    let run = simulation(&pendulum::Swing::default()).method(Method::rk4(0.25)).until(0.25).run().unwrap();
    let [slow] = run.events() else { panic!("{:?}", run.events()) };
    assert!(slow.event.name == "slow" && (slow.state.t - 0.5 / 9.81).abs() < 1e-3, "{}", slow.state.t);
}

model! {
    /// A puck that passes two places, the farther one declared first.
    pub model Passing {
        body puck { mass: 1, inertia: 1 }
        event far: puck.x = 0.6;
        event near: puck.x = 0.3;
        start here { puck at (0, 0) angle 0 velocity (1, 0) rate 0; }
        scene glides { start here; until 1 s; }
    }
}

/// Both in one step: they are told in the order of their times.
#[test]
fn analytic_events_of_a_step_are_told_in_the_order_of_time() {
    let run = simulation(&passing::Glides::default()).method(Method::rk4(1.0)).run().unwrap();
    let names: Vec<&str> = run.events().iter().map(|of| of.event.name).collect();
    assert_eq!((names, run.cost.steps), (vec!["near", "far"], 1));
}
