//! The tolerance of angles: rotors whose angles grow.

use ezy_core::dynamics::MotionError;
use ezy_core::prelude::*;
use ezy_core::simulate::{SetupError, StopReason};
use ezy_core_tests::{simulation, system_of};

model! {
    /// Two discs on an elastic shaft that turns at 30,000 rad/s.
    pub model Shaft {
        param k: N*m = 25;
        body left { mass: 1, inertia: 0.5 }
        body right { mass: 1, inertia: 0.5 }
        hinge first: ground(0, 0) ~ left(0, 0);
        hinge second: ground(1, 0) ~ right(0, 0);
        torsion left ~ right: stiffness k;
        output twist: rad = right.phi - left.phi;
        start turning { left angle 0 rate 30000; right angle 0.1 rate 30000; }
        scene run { start turning; until 10 s; }
    }
}

const METHODS: [fn(f64) -> Method; 4] = [Method::dop853, Method::taylor, Method::gauss, Method::radau];

/// Largest error of the twist, 0.1 cos(10 t), over the run, and the number of steps.
fn error(method: Method) -> (f64, u64) {
    let scene = shaft::Run::default();
    let run = simulation(&scene).method(method).outputs().every(0.25).run().unwrap();
    assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
    let errors = run.samples().map(|s| (s.get("output.twist").unwrap() - 0.1 * (10.0 * s.t).cos()).abs());
    (errors.fold(0.0, f64::max), run.cost.steps)
}

/// Two angles, each of which a step changes by the tolerance at most; the shaft does not multiply errors.
fn bound(steps: u64, angle: f64) -> f64 {
    2.0 * steps as f64 * angle
}

#[test]
fn analytic_twist_of_a_fast_shaft_keeps_to_the_tolerance_of_angles() {
    for method in METHODS {
        let name = method(1e-6).name();
        // a tolerance of 1e-5 φ is 3 rad at the end
        let (without, steps) = error(method(1e-5));
        let loosest = 1e-6;
        assert!(without > bound(steps, loosest), "{name}: {without:.1e} in {steps} steps");
        for angle in [loosest, 1e-8, 1e-10] {
            let (with, steps) = error(method(1e-6).angle_tolerance(angle));
            assert!(with <= bound(steps, angle), "{name} {angle:e}: {with:.1e} in {steps} steps");
            assert!(steps < 2000, "{name} {angle:e}: {steps} steps");
        }
    }
}

/// Angles of 300,000 rad are known to 6e-11 rad; a smaller tolerance is rounding. Three decades cost ten times the steps at
/// most with a method of order 3 or more, and what is below the smallest tolerance is lifted to it.
#[test]
fn cross_tolerances_below_rounding_are_not_pursued() {
    let scene = shaft::Run::default();
    for method in METHODS {
        let steps = |tolerance| {
            let run = simulation(&scene).method(method(tolerance)).max_steps(20_000).run().unwrap();
            assert!(run.outcome.reached_end(), "{}: {}", method(tolerance).name(), run.outcome);
            run.cost.steps + run.cost.rejected
        };
        let [met, below, far_below] = [1e-12, 1e-15, 1e-18].map(steps);
        let name = method(1.0).name();
        assert!(below <= 10 * met && far_below <= 10 * met, "{name}: {met}, {below} and {far_below} steps");
    }
}

#[test]
fn analytic_angle_beyond_the_resolution_of_doubles_ends_a_run() {
    let scene = shaft::Run::default();
    for method in METHODS {
        let run = simulation(&scene).method(method(1e-6).angle_tolerance(1e-11)).run().unwrap();
        let Outcome::Stopped { reason: StopReason::Motion(MotionError::AngleUnresolved { .. }), .. } = &run.outcome
        else {
            panic!("{}", run.outcome)
        };
        let text = run.outcome.to_string();
        assert!(text.contains("more than the tolerance of angles, 1.0e-11 rad"), "{text}");
        // the last state is within 1e-11/ε
        let angle = run.last().get("right.phi").unwrap();
        assert!(f64::EPSILON * angle <= 1e-11 && angle > 0.0, "{angle}");
    }
    let start = system_of(&scene, Backend::Auto).unwrap().scene_start();
    let method = Method::dop853(1e-6).angle_tolerance(1e-11);
    let mut run = Sensitivities::new(&scene, &start, ["k"], method).unwrap();
    assert!(matches!(run.advance(10.0), Err(MotionError::AngleUnresolved { .. })));
}

#[test]
fn invariant_tolerances_of_angles_that_are_none_are_refused() {
    let scene = shaft::Run::default();
    for method in METHODS {
        for rad in [0.0, -1.0, f64::NAN, 2.0] {
            let error = simulation(&scene).method(method(1e-6).angle_tolerance(rad)).run().unwrap_err();
            assert!(matches!(error, SetupError::AngleTolerance { .. }), "{error}");
        }
    }
}

#[test]
fn cross_estimate_of_the_error_follows_the_tolerance_of_angles() {
    let scene = shaft::Run::default();
    let method = Method::dop853(1e-6).angle_tolerance(1e-7);
    let run = simulation(&scene).method(method).every(0.25).estimate_error().run().unwrap();
    let estimate = run.error_estimate.as_ref().unwrap().as_ref().unwrap();
    let of_angles = estimate.errors.iter().find(|error| error.unit == "rad").unwrap();
    let exact = |t: f64| 0.5 * (0.1 + 60000.0 * t + 0.1 * (10.0 * t).cos());
    let actual = run.samples().map(|s| (s.get("right.phi").unwrap() - exact(s.t)).abs()).fold(0.0, f64::max);
    assert!((0.2..5.0).contains(&(of_angles.largest / actual)), "{:.1e} {actual:.1e}", of_angles.largest);
    assert!(actual <= bound(run.cost.steps, 1e-7), "{actual:.1e}");
}
