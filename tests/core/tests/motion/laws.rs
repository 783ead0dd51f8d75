//! Laws that are not smooth, and works of forces.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;

model! {
    /// A ball that flies against a spring, which pushes and does not pull.
    pub model Buffer {
        param k: N/m = 16;
        body ball { mass: 1, inertia: 1 }
        effect wall { force at ball(0, 0): (-k * max(ball.x, 0), 0); }
        start near { ball at (-1, 0) angle 0 velocity (1, 0) rate 0; }
        scene bounces { start near; until 2.5 s; with wall; }
    }
}

/// To the spring in 1 s, half a swing of it, √(m/k) π s, and back.
fn exact(t: f64) -> f64 {
    let half = std::f64::consts::PI / 4.0;
    match t {
        t if t <= 1.0 => t - 1.0,
        t if t <= 1.0 + half => 0.25 * (4.0 * (t - 1.0)).sin(),
        t => 1.0 + half - t,
    }
}

fn largest_error(method: Method) -> f64 {
    let run = simulation(&buffer::Bounces::default()).method(method).every(0.05).run().unwrap();
    assert!(run.events().is_empty(), "a discontinuity is no event");
    run.samples().map(|sample| (sample.coordinates[0] - exact(sample.t)).abs()).fold(0.0, f64::max)
}

/// Steps end where the law changes, so that each method keeps its order and its tolerance.
#[test]
fn order_is_kept_across_a_discontinuity() {
    let [coarse, fine] = [0.04, 0.02].map(|h| largest_error(Method::rk4(h)));
    assert!((coarse / fine).log2() >= 3.5, "{coarse:.1e} {fine:.1e}");
    for (method, bound) in [(Method::dop853(1e-10), 1e-8), (Method::radau(1e-9), 1e-7)] {
        let error = largest_error(method);
        assert!(error <= bound, "{method:?}: {error:.1e}");
        let cost = simulation(&buffer::Bounces::default()).method(method).run().unwrap().cost;
        assert!(cost.rejected >= 2 && cost.rejected <= cost.steps, "{method:?}: each discontinuity takes back a step");
    }
    let error = simulation(&buffer::Bounces::default()).method(Method::taylor(1e-9)).run().expect_err("`max`");
    assert!(error.to_string().contains("max"), "{error}");
}

/// Errors of steps of 0.03 s at 4 rad/s: (0.12)⁵/120 of 0.25 m in each of 26.
const STEPPED: f64 = 1e-5;

/// A caller's steps end at their times, also where a discontinuity divides one.
#[test]
fn analytic_stepper_keeps_its_times_across_a_discontinuity() {
    let scene = buffer::Bounces::default();
    let mut stepper = simulation(&scene).method(Method::rk4(0.03)).stepper().unwrap();
    for n in 1..=80 {
        stepper.step(1).unwrap();
        let (t, x) = (stepper.state().t, stepper.state().q[0]);
        assert!((t - 0.03 * f64::from(n)).abs() <= 1e-14, "{t} after {n}");
        assert!((x - exact(t)).abs() <= STEPPED, "{x} at {t}");
    }
}

model! {
    /// A ball that is driven along a line by a force of the time.
    pub model Shaken {
        body ball { mass: 2, inertia: 1 }
        effect shaker { force at ball(0, 0): (4 * cos(3 * t), 0); }
        effect drag { force at ball(0, 0): (-0.5 * ball.vx, 0); }
        start rest { ball at (0, 0) angle 0 velocity (0.5, 0) rate 0; }
        scene alone { start rest; until 2 s; with shaker; }
        scene dragged { start rest; until 2 s; with shaker, drag; }
    }
}

/// v = 0.5 + (2/3) sin 3t, and the force has worked ½ m (v² − 0.25).
#[test]
fn analytic_work_of_a_force_is_the_energy_that_it_gives() {
    let alone = shaken::Alone::default();
    for (method, bound) in [
        (Method::rk4(2e-3), 1e-10),
        (Method::dop853(1e-10), 1e-8),
        (Method::taylor(1e-10), 1e-9),
        (Method::gauss(1e-10), 1e-9),
        (Method::radau(1e-9), 1e-7),
    ] {
        let run = simulation(&alone).method(method).every(0.1).work().run().unwrap();
        for sample in run.samples() {
            let v = 0.5 + 2.0 / 3.0 * (3.0 * sample.t).sin();
            let work = sample.get("work.shaker").unwrap();
            assert!((sample.velocities[0] - v).abs() <= bound, "{method:?} at {}", sample.t);
            assert!((work - (v * v - 0.25)).abs() <= bound, "{method:?} at {}: {work} {}", sample.t, v * v - 0.25);
            assert!(
                (sample.energy.work - work).abs() <= 1e-15 && sample.energy.balance.abs() <= bound,
                "{:?}",
                sample.energy
            );
        }
        // what one effect gives and another takes
        let run = simulation(&shaken::Dragged::default()).method(method).work().run().unwrap();
        let last = run.last();
        let [given, taken] = ["work.shaker", "work.drag"].map(|name| last.get(name).unwrap());
        assert!(
            taken < -0.1 && (given + taken - last.energy.kinetic + 0.25).abs() <= bound,
            "{method:?}: {given} {taken}"
        );
    }
}

model! {
    /// A ball that is pushed to a speed of 1 m/s, from rest.
    pub model Pushed {
        param f: N = 20000;
        body front { mass: 1000, inertia: 1 }
        body drone { mass: 2, inertia: 1 }
        effect drive { force at front(0, 0) along front(1, 0): f * (1 - norm(front.v) / (1 m/s)); }
        effect rotor { force at drone(0, 0): (3 - 2 * norm(drone.v) * drone.vx, 4 - 2 * norm(drone.v) * drone.vy); }
        effect brake { force at front(0, 0): -100 * front.v; }
        start rest { front at (0, 0) angle 0; drone at (0, 1) angle 0; at rest; }
        scene runs { start rest; until 1 s; with drive, rotor; }
        scene braked { start rest; until 1 s; with drive, rotor, brake; }
    }
}

/// `norm(v)` has no derivative at rest, and the motion needs none: v = 1 − exp(−f t/m), and √(5/2) tanh(√(5/2) t) along (3, 4)/5.
#[test]
fn analytic_law_without_a_derivative_at_rest() {
    let scene = pushed::Runs::default();
    for (method, bound) in [
        (Method::rk4(1e-3), 1e-8),
        (Method::dop853(1e-10), 1e-8),
        (Method::gauss(1e-9), 1e-8),
        (Method::radau(1e-9), 1e-7),
    ] {
        let run = simulation(&scene).method(method).every(0.1).run().unwrap();
        assert!(matches!(run.outcome, Outcome::ReachedEnd), "{method:?}: {:?}", run.outcome);
        for sample in run.samples() {
            let (t, speed) = (sample.t, 2.5_f64.sqrt());
            let exact = [1.0 - (-20.0 * t).exp(), 0.6 * speed * (speed * t).tanh(), 0.8 * speed * (speed * t).tanh()];
            let found = [sample.velocities[0], sample.velocities[3], sample.velocities[4]];
            let error = found.iter().zip(exact).map(|(v, exact)| (v - exact).abs()).fold(0.0, f64::max);
            assert!(error <= bound, "{method:?} at {t}: {error:.1e}");
        }
    }
}

model! {
    /// A vehicle and its trailer, driven as [`Pushed`] from rest: bound by rows, and straight ahead.
    pub model Towed {
        param f: N = 20000;
        body front { mass: 800, inertia: 900 }
        body rear { mass: 200, inertia: 50 }
        hinge hitch: front(-2, 0) ~ rear(1, 0);
        skate axle: at front(-1, 0) along front(1, 0);
        skate wheels: at rear(0, 0) along rear(1, 0);
        effect drive { force at front(0, 0) along front(1, 0): f * (1 - norm(front.v) / (1 m/s)); }
        start rest { front at (0, 0) angle 0; rear at (-3, 0) angle 0; at rest; }
        scene runs { start rest; until 1 s; with drive; }
    }
}

#[test]
fn analytic_law_without_a_derivative_at_rest_of_a_bound_vehicle() {
    let scene = towed::Runs::default();
    for (method, bound) in [(Method::dop853(1e-10), 1e-8), (Method::radau(1e-9), 1e-7)] {
        let run = simulation(&scene).method(method).every(0.1).run().unwrap();
        assert!(matches!(run.outcome, Outcome::ReachedEnd), "{method:?}: {:?}", run.outcome);
        for sample in run.samples() {
            let error = (sample.velocities[0] - 1.0 + (-20.0 * sample.t).exp()).abs();
            assert!(error <= bound, "{method:?} at {}: {error:.1e}", sample.t);
        }
    }
}

/// A Taylor series needs every derivative: the message says which law has none, and what to do.
#[test]
fn analytic_law_without_a_series_is_named() {
    let scene = pushed::Braked::default();
    let run = simulation(&scene).method(Method::taylor(1e-9)).run().unwrap();
    let Outcome::Stopped { reason, .. } = run.outcome else { panic!("{:?}", run.outcome) };
    let message = reason.to_string();
    for part in ["the force on front.x has no derivative with respect to front.v", "`sqrt(", "use dop853", "norm(v)"] {
        assert!(message.contains(part), "`{part}` is not in: {message}");
    }
    // after the start there is one
    let moving = simulation(&scene).method(Method::taylor(1e-9)).start("front.vx", 0.1).start("drone.vx", 0.1);
    assert!(matches!(moving.run().unwrap().outcome, Outcome::ReachedEnd));
}
