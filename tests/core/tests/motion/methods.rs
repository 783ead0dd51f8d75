//! Every method against a motion that is known: its order, its tolerance, its number of steps.

use ezy_core::integrate::PreciseMotion;
use ezy_core::prelude::*;
use ezy_core::scalar::Scalar as _;
use ezy_core::testing::{GivenSteps, StepsBy};
use ezy_core_tests::{simulation, system_of};

model! {
    /// A body that swings on a spring while a force drives it and a damper holds it back; in `held` a stiff one.
    pub model Driven {
        param k: N/m = 9;
        param c: N*s/m = 0.6;
        body block { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        spring ground(0, 0) ~ block(0, 0): stiffness k, damping c;
        effect shaker { force at block(0, 0): (2 * cos(2 * t), 0); }
        start steady { block at (x0, 0) angle 0 velocity (v0, 0); }
        let x0 = 2 * (k - 4) / ((k - 4)^2 + 4 * c^2);
        let v0 = 8 * c / ((k - 4)^2 + 4 * c^2);
        scene shaken { start steady; until 5 s; with shaker; }
    }
}

/// The steady motion x = a cos 2t + b sin 2t of m x'' + c x' + k x = 2 cos 2t.
fn exact(scene: &driven::Shaken, t: f64) -> [f64; 2] {
    let (k, c) = (scene.k - 4.0, 2.0 * scene.c);
    let (a, b) = (2.0 * k / (k * k + c * c), 2.0 * c / (k * k + c * c));
    let (sin, cos) = (2.0 * t).sin_cos();
    [a * cos + b * sin, 2.0 * (b * cos - a * sin)]
}

fn error(scene: &driven::Shaken, state: &State) -> f64 {
    let [x, v] = exact(scene, state.t);
    (state.q[0] - x).abs().max((state.v[0] - v).abs())
}

fn start(scene: &driven::Shaken) -> State {
    let mut system = system_of(scene, Backend::Auto).unwrap();
    let start = system.scene_start();
    system.consistent_start(&start).unwrap()
}

/// Error after `n` steps over `s` seconds, and the largest error in the middle of them.
fn errors(scene: &driven::Shaken, by: StepsBy, s: f64, n: u32) -> [f64; 2] {
    let system = system_of(scene, Backend::Auto).unwrap();
    let mut steps = GivenSteps::new(system, start(scene), by).unwrap();
    let (mut last, mut middle) = (0.0, 0.0_f64);
    for _ in 0..n {
        let end = steps.step(s / f64::from(n)).unwrap().expect("the iteration converges");
        last = error(scene, end);
        middle = middle.max(error(scene, &steps.middle().unwrap()));
    }
    [last, middle]
}

/// Steps, half as long: errors fall by 2 to the order, of steps and of the interpolation between their ends. Errors of Gauss that are no rounding
/// need steps of 9 rad of the fastest product, cos 5t: there the next term, θ² of some 140, takes up to two orders off.
#[test]
fn order_of_each_method_and_of_its_interpolation() {
    let scene = driven::Shaken::default();
    for (by, s, n, order, less, between) in [
        (StepsBy::Method(MethodKind::Midpoint), 1.0, 200, 2.0, 0.0, 2.0),
        (StepsBy::Method(MethodKind::Rk4), 1.0, 20, 4.0, 0.0, 3.0),
        (StepsBy::Method(MethodKind::Dop853), 1.0, 4, 8.0, 0.0, 7.0),
        (StepsBy::Method(MethodKind::Gauss), 7.2, 4, 16.0, 2.0, 8.0),
        (StepsBy::Method(MethodKind::Radau), 1.0, 8, 5.0, 0.0, 3.0),
        (StepsBy::Taylor(6), 1.0, 8, 6.0, 0.0, 6.0),
        (StepsBy::Taylor(10), 1.0, 3, 10.0, 0.0, 10.0),
    ] {
        let (coarse, fine) = (errors(&scene, by, s, n), errors(&scene, by, s, 2 * n));
        let [found, found_between] = [0, 1].map(|i| (coarse[i] / fine[i]).log2());
        assert!((order - less - 0.5..=order + 0.5).contains(&found), "{by:?}: order {found:.2}, {coarse:?} {fine:?}");
        assert!(found_between >= between - 0.5, "{by:?}: order {found_between:.2} between, {coarse:?} {fine:?}");
        assert!(coarse[0] <= 1e-4 && coarse[1] <= 1e-3, "{by:?}: {coarse:?}");
    }
}

/// Errors at the end over the tolerance: each of some ten steps adds one at most, and the damper lets them fade.
const AT_THE_END: f64 = 10.0;

/// Errors of samples over the tolerance: between the ends of a step DOP853 interpolates by order 7, and controls order 8 at the ends alone.
const BETWEEN: [(&str, f64); 4] = [("dop853", 100.0), ("taylor", 10.0), ("gauss", 10.0), ("radau", 10.0)];

/// Numbers of steps are those of today, within a half of them.
#[test]
fn analytic_tolerances_are_kept_with_steps_of_the_length_that_they_allow() {
    let scene = driven::Shaken::default();
    for (method, steps) in [
        (Method::dop853(1e-6), 11.0),
        (Method::dop853(1e-9), 24.0),
        (Method::dop853(1e-12), 52.0),
        (Method::taylor(1e-6), 7.0),
        (Method::taylor(1e-9), 7.0),
        (Method::taylor(1e-12), 6.0),
        (Method::gauss(1e-6), 7.0),
        (Method::gauss(1e-9), 7.0),
        (Method::gauss(1e-12), 7.0),
        (Method::radau(1e-5), 24.0),
        (Method::radau(1e-8), 82.0),
    ] {
        let run = simulation(&scene).method(method).every(0.05).run().unwrap();
        let tolerance = method.tolerance().unwrap().relative;
        let between = BETWEEN.iter().find(|(name, _)| *name == method.name()).unwrap().1;
        for sample in run.samples() {
            let [x, v] = exact(&scene, sample.t);
            let error = (sample.coordinates[0] - x).abs().max((sample.velocities[0] - v).abs());
            let bound = if sample.t == scene.info().until_s { AT_THE_END } else { between };
            assert!(error <= bound * tolerance, "{method:?}: {error:.1e} at {}", sample.t);
        }
        let found = run.cost.steps as f64;
        assert!(found >= steps / 1.5 && found <= 1.5 * steps, "{method:?}: {found} steps, {steps} before");
        assert!(run.cost.rejected <= 2, "{method:?}: {} rejected", run.cost.rejected);
    }
}

/// A damper of 1e4 N s/m: the motion is slow, and an implicit method follows it in steps of its own length, from a start that is on it.
#[test]
fn analytic_stiff_damper_costs_radau_nothing() {
    let scene = driven::Shaken { k: 1e4, c: 1e4 };
    let run = simulation(&scene).method(Method::radau(1e-8)).run().unwrap();
    let last = run.last();
    let [x, v] = exact(&scene, last.t);
    assert!(
        (last.coordinates[0] - x).abs() <= 1e-8 && (last.velocities[0] - v).abs() <= 1e-7,
        "{} {x}, {} {v}",
        last.coordinates[0],
        last.velocities[0]
    );
    assert!(run.cost.steps <= 200, "{} steps", run.cost.steps);
}

model! {
    /// Water below a hull that drives it to 1 m/s, however little it moves: v' = k (v − v³).
    pub model Surfing {
        param k: s^-1 = 1e4;
        body hull { mass: 1, inertia: 1 }
        slider rail: ground(0, 0) ~ hull(0, 0) along ground(1, 0);
        let v = hull.vx / (1.0 m/s);
        force at hull(0, 0): (1.0 kg*m/s * k * (v - v^3), 0);
        start still { hull at (0, 0) velocity (1e-9, 0); }
        scene surf { start still; until 1 s; }
    }
}

/// A mode that grows from a ten-thousandth of the tolerance within 2 ms: a step that is longer than its time would damp it, and end at rest.
#[test]
fn analytic_radau_does_not_damp_what_grows() {
    let scene = surfing::Surf::default();
    for method in [Method::dop853(1e-5), Method::radau(1e-5)] {
        let run = simulation(&scene).method(method).run().unwrap();
        let v = run.last().velocities[0];
        assert!((v - 1.0).abs() <= 1e-4, "{method:?}: {v} m/s after {} steps", run.cost.steps);
    }
}

/// Stability limits steps of an explicit method beside a damper of 1e3 N s/m: it says since when. An implicit one does not, nor does a motion
/// that is not stiff.
#[test]
fn invariant_stiffness_is_told_by_the_method_that_suffers_from_it() {
    let stiff_since = |scene: &driven::Shaken, method| {
        let run = simulation(scene).method(method).until(3.0).run().unwrap();
        (run.stiff_since_s, run.last().t)
    };
    let stiff = driven::Shaken { k: 1e3, c: 1e3 };
    let (since, end) = stiff_since(&stiff, Method::dop853(1e-6));
    assert!(since.is_some_and(|since| since > 0.0 && since < 0.5 * end), "{since:?}");
    assert_eq!(stiff_since(&stiff, Method::radau(1e-6)).0, None);
    for method in [Method::dop853(1e-6), Method::rk4(1e-2), Method::taylor(1e-6)] {
        assert_eq!(stiff_since(&driven::Shaken::default(), method).0, None, "{method:?}");
    }
}

/// A start beside the slow motion is drawn on to it within microseconds: steps begin short and become long.
#[test]
fn analytic_radau_leaves_a_layer_behind() {
    let scene = driven::Shaken { k: 1e4, c: 1e3 };
    let run = simulation(&scene).method(Method::radau(1e-8)).start("block.vx", 1.0).run().unwrap();
    let last = run.last();
    let [x, v] = exact(&scene, last.t);
    assert!(
        (last.coordinates[0] - x).abs() <= 1e-7 && (last.velocities[0] - v).abs() <= 1e-6,
        "{:?}",
        last.coordinates
    );
    let [shortest, longest] = run.monitors.steps_s.unwrap();
    assert!(shortest <= 1e-3 && longest >= 1e-2, "steps from {shortest} s to {longest} s");
}

/// A pendulum in double-double keeps its energy to 28 digits and its hinge to 30.
#[test]
fn invariant_precise_motion_keeps_energy_and_hinge() {
    let scene = pendulum::Swing::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let begin = system.scene_start();
    let begin = system.consistent_start(&begin).unwrap();
    let mut motion = PreciseMotion::new(&scene, &begin).unwrap();
    motion.advance_to(2.0).unwrap();
    let (q, v) = (motion.q(), motion.v());
    let half = ezy_core::scalar::DoubleDouble::from(0.5);
    let hinge = [q[0] - half * q[2].cos(), q[1] - half * q[2].sin()];
    assert!(hinge.iter().all(|c| c.magnitude() <= 1e-30), "{hinge:?}");
    // ½ (1/12 + 1/4) ω² + 9.81/2 sin φ = 0 for 1 kg and 1 m
    let twelfth = ezy_core::scalar::DoubleDouble::from(1.0) / ezy_core::scalar::DoubleDouble::from(3.0);
    let gravity = ezy_core::scalar::DoubleDouble::from(9.81);
    let balance = half * twelfth * v[2] * v[2] + gravity * half * q[2].sin();
    assert!(balance.magnitude() <= 1e-26, "{:.1e}", balance.magnitude());
}

/// Rods that are counted have no elimination of their own: factors of sixteen digits are refined, and energies and hinges kept to as many as
/// with one.
#[test]
fn invariant_precise_motion_by_refined_factors_keeps_energies_and_hinges() {
    let scene = pendulums::Swing::default();
    let mut system = system_of(&scene, Backend::Auto).unwrap();
    let begin = system.scene_start();
    let begin = system.consistent_start(&begin).unwrap();
    let mut motion = PreciseMotion::new(&scene, &begin).unwrap();
    motion.advance_to(0.6).unwrap();
    let (half, gravity) = (ezy_core::scalar::DoubleDouble::from(0.5), ezy_core::scalar::DoubleDouble::from(9.81));
    for (q, v) in motion.q().chunks(3).zip(motion.v().chunks(3)) {
        let hinge = [q[0] - half * q[2].cos(), q[1] - half * q[2].sin()];
        assert!(hinge.iter().all(|c| c.magnitude() <= 1e-30), "{hinge:?}");
        // ½ (1/8 + 1/4) ω² + 9.81/2 sin φ = 0
        let inertia = ezy_core::scalar::DoubleDouble::from(0.375);
        let balance = half * inertia * v[2] * v[2] + gravity * half * q[2].sin();
        assert!(balance.magnitude() <= 1e-26 && v[2].magnitude() > 1.0, "{:.1e}", balance.magnitude());
    }
}

model! {
    /// Two rods of 1/8 kg m² side by side.
    pub model Pendulums {
        count n = 2;
        body rod[n] { mass: 1, inertia: 0.125 }
        for i in 0..n { hinge pivot[i]: ground(0, 0) ~ rod[i](-0.5, 0); }
        gravity (0, -9.81);
        start level { for i in 0..n { rod[i] angle 0; } at rest; }
        scene swing { start level; until 2 s; }
    }
}

model! {
    /// A rod of 1 kg and 1 m that falls from level.
    pub model Pendulum {
        body rod { mass: 1, inertia: 1/12 }
        hinge pivot: ground(0, 0) ~ rod(-1/2, 0);
        gravity (0, -9.81);
        start level { rod angle 0; at rest; }
        scene swing { start level; until 2 s; }
    }
}

/// Time from level to the lowest position: √(2 l/(3 g)) K(1/√2), with K(1/√2) = 1.854 074 677 301 371 9; four of them are a period.
#[test]
fn analytic_pendulum_returns_after_its_period() {
    let period = 4.0 * (2.0_f64 / (3.0 * 9.81)).sqrt() * 1.854_074_677_301_371_9;
    for (method, bound) in [
        (Method::rk4(1e-3), 1e-9),
        (Method::dop853(1e-11), 1e-9),
        (Method::taylor(1e-11), 1e-9),
        (Method::gauss(1e-11), 1e-9),
        (Method::radau(1e-10), 1e-8),
    ] {
        for projection in [Projection::Both, Projection::Velocities, Projection::None] {
            let scene = pendulum::Swing::default();
            let run = simulation(&scene).method(method).project(projection).until(period).run().unwrap();
            let last = run.last();
            let angle = last.get("rod.phi").unwrap();
            // at the turning point the angle moves with the square of an error of time
            let rate = last.get("rod.omega").unwrap();
            assert!(angle.abs() <= bound && rate.abs() <= 100.0 * bound, "{method:?} {projection:?}: {angle} {rate}");
        }
    }
}
