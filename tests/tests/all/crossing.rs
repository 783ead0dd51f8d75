//! Mechanisms that pass positions where their rows lose rank, and go on as they came.

use ezy_core::model;
use ezy_core::model::Scene;
use ezy_core::prelude::*;
use ezy_models::{four_bar, n_four_bar};

model! {
    /// The pendulum that a parallelogram of equal rods is.
    pub model Equivalent {
        body rod { mass: 4.0, inertia: 2.0/3 }
        hinge A: ground(0, 0) ~ rod(-0.5, 0);
        gravity (0, -9.81);
        start falling { rod angle pi/2 rate -1; }
        scene turn { start falling; until 20 s; }
    }
}

model! {
    /// A crank that is driven farther than its rod reaches.
    pub model ShortRod {
        /// speed of the motor
        param omega: rad/s = 1.0;
        body crank { mass: 1.0, inertia: 0.1 }
        body rod { mass: 1.0, inertia: 0.1 }
        body block { mass: 1.0, inertia: 0.1 }
        hinge A: ground(0, 0) ~ crank(0, 0);
        hinge B: crank(1, 0) ~ rod(0, 0);
        hinge C: rod(0.5, 0) ~ block(0, 0);
        slider guide: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        drive motor: crank.phi = 0.2 + omega*t;
        start turning { rod near angle (-0.4); }
        scene turn { start turning; until 1 s; }
    }
}

/// Angle of a crank, in tolerances: how errors of 20 s of turning grow, and noise at 20 passages.
const AMPLIFICATION: f64 = 1e4;

/// A few steps of each method, s.
const STEPS: f64 = 1e-2;

/// Where rounding next to singular positions takes more than that.
const FLOOR: f64 = 1e-6;

fn crank(scene: &dyn Scene, method: Method) -> (Run, f64) {
    let run = Simulation::new(scene).method(method).work().run().unwrap();
    assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
    let phi = run.last().coordinates[2];
    (run, phi)
}

#[test]
fn cross_parallelogram_stays_one_through_its_flat_positions() {
    let (_, expected) = crank(&equivalent::Turn::default(), Method::dop853(1e-13));
    let scene = four_bar::Turning::default();
    let (usual, _) = crank(&scene, Method::rk4(1e-3));
    for tolerance in [1e-8, 1e-10] {
        for method in [Method::dop853(tolerance), Method::taylor(tolerance)] {
            let (run, phi) = crank(&scene, method);
            let bound = (AMPLIFICATION * tolerance).max(FLOOR);
            assert!((phi - expected).abs() <= bound, "{method:?}: {:.1e} of {bound:.1e}", phi - expected);
            assert!((run.last().coordinates[8] - phi).abs() <= FLOOR, "{method:?}");
            assert!(run.cost.steps <= usual.cost.steps / 10, "{method:?}: {} steps", run.cost.steps);
        }
    }
}

#[test]
fn cross_row_of_parallelograms_stays_one_through_its_flat_positions() {
    let (_, expected) = crank(&equivalent_to_two(), Method::dop853(1e-13));
    for method in [Method::rk4(1e-3), Method::dop853(1e-10), Method::taylor(1e-10)] {
        let scene = n_four_bar::Fall { n: 2, ..Default::default() };
        let run = Simulation::new(&scene).method(method).until(5.0).run().unwrap();
        assert!(run.outcome.reached_end(), "{method:?}: {}", run.outcome);
        let phi = run.last().coordinates[2];
        assert!((phi - expected).abs() <= FLOOR, "{method:?}: {:.1e}", phi - expected);
    }
}

model! {
    /// The pendulum that two parallelograms side by side are: I = 3 kg·m², m g l = 34.335 N·m.
    pub model EquivalentToTwo {
        body rod { mass: 7.0, inertia: 1.25 }
        hinge A: ground(0, 0) ~ rod(-0.5, 0);
        gravity (0, -9.81);
        start falling { rod angle pi/2 rate -1; }
        scene turn { start falling; until 5 s; }
    }
}

fn equivalent_to_two() -> equivalent_to_two::Turn {
    equivalent_to_two::Turn::default()
}

#[test]
fn analytic_motor_against_a_stretched_rod_ends_the_run_with_the_rows() {
    for method in [Method::rk4(1e-3), Method::dop853(1e-8), Method::taylor(1e-8)] {
        let run = Simulation::new(&short_rod::Turn::default()).method(method).run().unwrap();
        let outcome = run.outcome.to_string();
        // the rod is upright when sin φ = 1/2
        let end = std::f64::consts::FRAC_PI_6 - 0.2;
        assert!((run.last().t - end).abs() <= STEPS, "{method:?}: {outcome}");
        assert!(outcome.contains("motor") && outcome.contains("guide"), "{method:?}: {outcome}");
    }
}
