//! The energy balance of a run.

use ezy_core::prelude::*;
use ezy_core_tests::simulation;

model! {
    /// A puck that is driven by one force and held back by another: nearly all the work of one is taken out by the other.
    pub model Puck {
        body puck { mass: 1, inertia: 1 }
        effect motor { force at puck(0, 0): (10 + 4 * sin(9 * t), 0); }
        effect brake { force at puck(0, 0): (-10, 0); }
        start moving { puck at (0, 0) angle 0 velocity (2, 0) rate 0; }
        scene pushed { start moving; until 2 s; with motor, brake; }
    }
}

/// ½ v² stays near 2 J while each force works some 40 J: errors are compared with what was turned over, works without their signs.
#[test]
fn analytic_energy_turned_over_counts_each_work_without_its_sign() {
    let h = 0.05;
    let run = simulation(&puck::Pushed::default()).method(Method::rk4(h)).every(h).work().run().unwrap();
    let energy = run.monitors.energy.expect("works are integrated");
    assert!(energy.joules.abs() >= 1e-7, "coarse steps err: {energy:?}");
    let until = run.samples().filter(|sample| sample.t <= energy.t * (1.0 + 1e-12));
    let turned_over = until.fold(0.0, |largest: f64, sample| {
        let kinetic = 0.5 * sample.velocities.iter().map(|v| v * v).sum::<f64>();
        largest.max(kinetic + sample.work.iter().map(|work| work.abs()).sum::<f64>())
    });
    let expected = energy.joules.abs() / turned_over;
    assert!((energy.relative / expected - 1.0).abs() <= 1e-6, "{energy:?}, expected {expected}");
    let last = run.last();
    let works = ["work.motor", "work.brake"].map(|name| last.get(name).unwrap());
    assert!(works[0] > 30.0 && works[1] < -30.0, "{works:?}");
}

model! {
    /// A mass on a spring.
    pub model Spring {
        param k: N/m = 50;
        body block { mass: 2, inertia: 1 }
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        spring ground(0, 0) ~ block(0, 0): stiffness k;
        start out { block at (0.3, 0) angle 0; at rest; }
        scene swings { start out; until 2 s; }
    }
}

/// x = 0.3 m cos(5 t); kinetic and potential energy add up to ½ k x₀² = 2.25 J, and the samples say so.
#[test]
fn analytic_spring_swings_with_the_energy_of_its_start() {
    for method in
        [Method::rk4(1e-3), Method::dop853(1e-11), Method::taylor(1e-11), Method::gauss(1e-11), Method::radau(1e-11)]
    {
        let run = simulation(&spring::Swings::default()).method(method).every(0.1).run().unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {:?}", run.outcome);
        for sample in run.samples() {
            let (x, v) = (sample.get("block.x").unwrap(), sample.get("block.vx").unwrap());
            let (cos, sin) = ((5.0 * sample.t).cos(), (5.0 * sample.t).sin());
            assert!(
                (x - 0.3 * cos).abs() <= 1e-9 && (v + 1.5 * sin).abs() <= 1e-8,
                "{method:?} at {}: {x} {v}",
                sample.t
            );
            let total = v * v + 25.0 * x * x;
            assert!((total - 2.25).abs() <= 1e-8 && (sample.energy.kinetic - v * v).abs() <= 1e-12, "{method:?}");
            assert!((sample.energy.potential - 25.0 * x * x).abs() <= 1e-12, "{method:?}: {:?}", sample.energy);
        }
        assert!(run.monitors.energy.expect("no force works").relative <= 1e-9, "{method:?}");
    }
}

/// A run with fixed steps too long for its spring is not to be trusted, and says by how much.
#[test]
fn invariant_steps_too_long_are_not_trusted() {
    let scene = spring::Swings { k: 5000.0 };
    let run = simulation(&scene).method(Method::rk4(0.02)).run().unwrap();
    let Outcome::Untrusted { step_s, energy, .. } = run.outcome else { panic!("{:?}", run.outcome) };
    assert!((step_s - 0.02).abs() <= 1e-15 && energy.relative > 1e-3, "{step_s} {energy:?}");
    let limited = simulation(&scene).method(Method::rk4(0.02)).max_energy_error(1e-6).run().unwrap();
    assert!(matches!(limited.outcome, Outcome::Stopped { .. }), "{:?}", limited.outcome);
}
