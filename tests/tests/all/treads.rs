//! Friction and tyres on surfaces that move: belts, tracks, driven wheels.

use crate::scenes::{assert_checks, distance};
use ezy_core::prelude::*;
use ezy_core_tests::simulation;

model! {
    /// A block that is put onto a belt.
    pub model Belt {
        param m: kg = 2;
        param mu = 0.3;
        param v: m/s = 1.5;
        param u: m/s = 0.01;
        body block { mass: m, inertia: 0.1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        friction at block(0, 0) along ground(1, 0): force mu * m * 10, speed u, tread v;
        start standing { block x 0; at rest; }
        scene carried { start standing; until 1 s; }
    }
}

model! {
    /// A spinning wheel that drives a cart: with dry friction, or as a tyre.
    pub model Launch {
        param r: m = 0.4;
        body cart { mass: 3, inertia: 0.5 }
        body wheel { mass: 0, inertia: 0.2 }
        hinge axle: cart(0, 0) ~ wheel(0, 0);
        slider rail: ground(0, 0) ~ cart(0, 0) along ground(1, 0);
        effect dry { friction at cart(0.1, 0) along cart(1, 0): force 6, speed 0.02, tread r * wheel.omega; }
        effect rubber { tyre at cart(0.1, 0) along cart(1, 0): stiffness 50, limit 6, speed 0.1, tread r * wheel.omega; }
        effect motor { torque wheel ~ cart: 1; }
        start spinning { cart x 0 vx 0; wheel angle 0 rate 20; }
        start standing { cart x 0; wheel angle 0; at rest; }
        scene starting { start standing; until 2 s; with rubber, motor; }
        scene sliding { start spinning; until 2 s; with dry; }
        scene rolling { start spinning; until 2 s; with rubber; }
    }
}

model! {
    /// A robot on four wheels that steers by their speeds.
    pub model SkidSteer {
        param a: m = 0.3;
        param b: m = 0.2;
        param grip: N = 8;
        param left: m/s = -0.5;
        param right: m/s = 0.5;
        body robot { mass: 4, inertia: 0.2 }
        tyre at robot(a, b) along robot(1, 0): stiffness 40, limit grip, speed 0.01, tread left;
        tyre at robot(-a, b) along robot(1, 0): stiffness 40, limit grip, speed 0.01, tread left;
        tyre at robot(a, -b) along robot(1, 0): stiffness 40, limit grip, speed 0.01, tread right;
        tyre at robot(-a, -b) along robot(1, 0): stiffness 40, limit grip, speed 0.01, tread right;
        start standing { robot at (0, 0) angle 0.3; at rest; }
        scene turns { start standing; until 4 s; }
    }
}

model! {
    /// A body on a wheel that slips sidewards.
    pub model Drift {
        body car { mass: 4, inertia: 0.2 }
        effect free { tyre at car(-0.2, 0.1) along car(1, 0.1): stiffness 30, limit 9, speed 0.3; }
        effect free_unlimited { tyre at car(-0.2, 0.1) along car(1, 0.1): stiffness 30; }
        point P = car(-0.2, 0.1);
        let forward = (P.vx * cos(car.phi + atan2(0.1, 1)) + P.vy * sin(car.phi + atan2(0.1, 1)));
        effect rolling { tyre at P along car(1, 0.1): stiffness 30, limit 9, speed 0.3, tread forward; }
        effect rolling_unlimited { tyre at P along car(1, 0.1): stiffness 30, tread forward; }
        start aside { car at (0, 0) angle 0.3 velocity (2, 1.5) rate 0.7; }
        scene limited { start aside; until 1 s; with free; }
        scene limited_tread { start aside; until 1 s; with rolling; }
        scene linear { start aside; until 1 s; with free_unlimited; }
        scene linear_tread { start aside; until 1 s; with rolling_unlimited; }
    }
}

model! {
    /// Wheels of a cart, as many as wanted.
    pub model Train {
        count n = 2;
        param r: m = 0.4;
        body cart { mass: 3, inertia: 0.5 }
        body wheel[n] { mass: 0.1, inertia: 0.2 }
        for i in 0..n { hinge axle[i]: cart(0.2*i, 0.1) ~ wheel[i](0, 0); }
        for i in 0..n {
            tyre at cart(0.2*i, 0.1) along cart(1, 0): stiffness 50, limit 6, speed 0.1, tread r * wheel[i].omega;
        }
        for i in 0..n { friction at cart(0.2*i, 0) along cart(0, 1): force 2, speed 0.1, tread r * wheel[i].omega; }
        start spinning { cart at (0, 0) angle 0 velocity (0.3, 0.1); for i in 0..n { wheel[i] angle 0 rate 5 + 3*i; } }
        scene rolls { start spinning; until 1 s; }
    }
}

model! {
    /// The same two wheels one by one.
    pub model Pair {
        param r: m = 0.4;
        body cart { mass: 3, inertia: 0.5 }
        body first { mass: 0.1, inertia: 0.2 }
        body second { mass: 0.1, inertia: 0.2 }
        hinge first_axle: cart(0, 0.1) ~ first(0, 0);
        hinge second_axle: cart(0.2, 0.1) ~ second(0, 0);
        tyre at cart(0, 0.1) along cart(1, 0): stiffness 50, limit 6, speed 0.1, tread r * first.omega;
        tyre at cart(0.2, 0.1) along cart(1, 0): stiffness 50, limit 6, speed 0.1, tread r * second.omega;
        friction at cart(0, 0) along cart(0, 1): force 2, speed 0.1, tread r * first.omega;
        friction at cart(0.2, 0) along cart(0, 1): force 2, speed 0.1, tread r * second.omega;
        start spinning { cart at (0, 0) angle 0 velocity (0.3, 0.1); first angle 0 rate 5; second angle 0 rate 8; }
        scene rolls { start spinning; until 1 s; }
    }
}

/// DOP853 at 1e-12 over some seconds.
const METHOD: f64 = 1e-10;
/// The same number by two routes, of the size of one, through a run at 1e-12.
const ALIKE: f64 = 1e-9;
const PRECISE: Method = Method::dop853(1e-12);

#[test]
fn fd_scenes_with_treads_pass_their_checks() {
    let (mut sliding, mut rolling) = (launch::Sliding::default(), launch::Rolling::default());
    (sliding.r, rolling.r) = (0.3, 0.3);
    let skid = skid_steer::Turns { left: 0.2, ..Default::default() };
    let scenes: [&dyn Scene; 7] = [
        &belt::Carried::default(),
        &sliding,
        &rolling,
        &skid,
        &drift::LimitedTread::default(),
        &drift::LinearTread::default(),
        &train::Rolls::default(),
    ];
    for scene in scenes {
        assert_checks(scene);
    }
}

/// With s' = −k s/√(s² + u²), √(s² + u²) − u asinh(u/s) decreases by k t.
fn slip_function(s: f64, u: f64) -> f64 {
    s.hypot(u) - u * (u / s).asinh()
}

#[test]
fn analytic_block_is_carried_along_by_a_belt() {
    for u in [0.01, 0.1] {
        let scene = belt::Carried { u, ..Default::default() };
        let (v, deceleration) = (scene.v, scene.mu * 10.0);
        let run = simulation(&scene).work().method(PRECISE).every(0.05).run().unwrap();
        for s in run.samples() {
            let slip = v - s.get("block.vx").unwrap();
            if slip > 1e-3 * u {
                let error = slip_function(slip, u) - slip_function(v, u) + deceleration * s.t;
                assert!(error.abs() <= METHOD * (1.0 + u / slip), "u = {u}, {} s: {error:.1e}", s.t);
            }
            assert!(s.energy.balance.abs() <= METHOD, "{:.1e} J at {} s", s.energy.balance, s.t);
        }
    }
    // v/(μ g) = 0.5 s, if the law is sharp; there remains a slip of 0.66 u, the root of s² + 1 = asinh(1/s)²
    let scene = belt::Carried { u: 1e-6, ..Default::default() };
    let run = simulation(&scene).method(PRECISE).every(0.5).run().unwrap();
    let reached = run.samples().find(|s| (s.t - 0.5).abs() < 1e-9).unwrap();
    assert!((1.5 - reached.get("block.vx").unwrap()).abs() <= scene.u);
}

#[test]
fn invariant_wheel_and_cart_exchange_momentum_through_the_tread() {
    for scene in [&launch::Sliding::default() as &dyn Scene, &launch::Rolling::default()] {
        let run = simulation(scene).work().method(PRECISE).every(0.1).run().unwrap();
        let mut lost: f64 = 0.0;
        for s in run.samples() {
            let [v, omega] = ["cart.vx", "wheel.omega"].map(|name| s.get(name).unwrap());
            // m v' = F and I ω' = −r F
            let momentum = 3.0 * v * 0.4 + 0.2 * omega;
            assert!((momentum - 0.2 * 20.0).abs() <= METHOD, "{momentum} at {} s", s.t);
            assert!(s.energy.balance.abs() <= METHOD, "{:.1e} J at {} s", s.energy.balance, s.t);
            // what slips loses energy at every time
            assert!(s.energy.work <= lost + METHOD, "{} J at {} s", s.energy.work, s.t);
            lost = s.energy.work;
        }
        assert!(lost < -10.0, "{lost} J");
    }
}

#[test]
fn analytic_wheel_spins_down_by_the_law_of_friction() {
    let scene = launch::Sliding::default();
    let run = simulation(&scene).method(PRECISE).every(0.05).run().unwrap();
    let slips = run.samples().map(|s| (s.t, 0.4 * s.get("wheel.omega").unwrap() - s.get("cart.vx").unwrap()));
    for (t, slip) in slips.take_while(|(t, _)| *t < 1.0) {
        let decrease = 6.0 * (1.0 / 3.0 + 0.4 * 0.4 / 0.2) * t;
        let error = slip_function(slip, 0.02) - slip_function(8.0, 0.02) + decrease;
        assert!(error.abs() <= METHOD * (1.0 + 0.02 / slip), "{error:.1e} at {t} s");
    }
}

#[test]
fn analytic_skid_steered_robot_turns_in_place() {
    let scene = skid_steer::Turns::default();
    let run = simulation(&scene).work().method(PRECISE).run().unwrap();
    // every wheel has the same slip, and moves against it: b (w − b Ω) = a² Ω
    let expected = scene.b * 0.5 / (scene.a.powi(2) + scene.b.powi(2));
    let end = run.last();
    assert!((end.get("robot.omega").unwrap() - expected).abs() <= METHOD);
    assert!(end.get("robot.x").unwrap().hypot(end.get("robot.y").unwrap()) <= METHOD);
    assert!(end.energy.balance.abs() <= METHOD, "{:.1e} J", end.energy.balance);
}

#[test]
fn analytic_skid_steered_robot_turns_on_a_circle() {
    // slow, so that the forces of the wheels are in balance
    let scene = skid_steer::Turns { left: 0.02, right: 0.05, ..Default::default() };
    let run = simulation(&scene).method(PRECISE).until(20.0).run().unwrap();
    let end = run.last();
    let [vx, vy, angle, rate] = ["robot.vx", "robot.vy", "robot.phi", "robot.omega"].map(|name| end.get(name).unwrap());
    let (along, across) = (vx * angle.cos() + vy * angle.sin(), vy * angle.cos() - vx * angle.sin());
    // forces of the tyres at this motion, from the law as the manual states it
    let mut sum = [0.0; 3];
    for (x, y, w) in [(0.3, 0.2, 0.02), (-0.3, 0.2, 0.02), (0.3, -0.2, 0.05), (-0.3, -0.2, 0.05_f64)] {
        let slip = [along - rate * y - w, across + rate * x];
        let speed = slip[0].hypot(slip[1]);
        let force = 8.0 * (40.0 * (speed / w.hypot(0.01)).atan() / 8.0).tanh();
        let [fx, fy] = slip.map(|s| -force * s / speed);
        sum = [sum[0] + fx, sum[1] + fy, sum[2] + x * fy - y * fx];
    }
    // uniform motion on a circle: m Ω × v
    let inertia = [-4.0 * rate * across, 4.0 * rate * along, 0.0];
    assert!(distance(&sum, &inertia) <= ALIKE, "{sum:?} {inertia:?}");
    assert!(rate > 0.01 && along > 0.02, "{rate} {along}");
}

#[test]
fn cross_tyre_on_a_wheel_that_rolls_freely_is_the_tyre_without_tread() {
    let end = |scene: &dyn Scene| {
        let run = simulation(scene).method(PRECISE).run().unwrap();
        run.last().coordinates.to_vec()
    };
    let limited = distance(&end(&drift::Limited::default()), &end(&drift::LimitedTread::default()));
    let linear = distance(&end(&drift::Linear::default()), &end(&drift::LinearTread::default()));
    assert!(limited <= ALIKE && linear <= ALIKE, "{limited:.1e}, {linear:.1e}");
}

#[test]
fn cross_wheels_of_an_array_and_wheels_one_by_one() {
    let end = |scene: &dyn Scene, method| {
        let run = simulation(scene).work().method(method).run().unwrap();
        assert!(run.last().energy.balance.abs() <= ALIKE, "{:.1e} J", run.last().energy.balance);
        run.last().coordinates.to_vec()
    };
    let expected = end(&pair::Rolls::default(), PRECISE);
    let error = distance(&end(&train::Rolls::default(), PRECISE), &expected);
    assert!(error <= ALIKE, "{error:.1e}");
    for method in [Method::taylor(1e-12), Method::gauss(1e-12), Method::radau(1e-12), Method::rk4(1e-4)] {
        let error = distance(&end(&pair::Rolls::default(), method), &expected);
        assert!(error <= ALIKE, "{method:?}: {error:.1e}");
    }
}

#[test]
fn analytic_tyre_at_rest_gives_no_force_and_its_slope() {
    // no wheel slips: the force is zero, and its slope that of small slips, c/u
    let scene = skid_steer::Turns { left: 0.0, right: 0.0, ..Default::default() };
    for method in [PRECISE, Method::radau(1e-9), Method::rk4(1e-3)] {
        let run = simulation(&scene).method(method).run().unwrap();
        assert!(run.last().velocities.iter().all(|v| *v == 0.0), "{method:?}");
    }
    assert_checks(&scene);
}

#[test]
fn cross_methods_agree_on_a_start_without_slip() {
    let scene = launch::Starting::default();
    let run = |method| simulation(&scene).method(method).run().unwrap();
    let end = |method| {
        let run = run(method);
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        run.last().coordinates.to_vec()
    };
    // the size of a slip is not analytic at zero, though the force is
    assert!(!run(Method::taylor(1e-12)).outcome.reached_end());
    let expected = end(PRECISE);
    for method in [Method::radau(1e-12), Method::rk4(1e-4)] {
        let error = distance(&end(method), &expected);
        assert!(error <= ALIKE, "{method:?}: {error:.1e}");
    }
}
