//! Rows that move with time, from the language: they are followed, and their work is counted.

use crate::scenes::{assert_checks, distance};
use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use ezy_tests::crank::{self, Crank};

model! {
    /// A crank whose angle is prescribed, in a field of gravity or without.
    pub model Motor {
        param r: m = 0.3;
        body arm { mass: 2, inertia: 0.4 }
        hinge pin: arm(-r, 0) ~ ground(0, 0);
        drive angle: arm.phi = 2*t + 0.3*sin(3*t);
        output height: m = arm.y;
        effect weight { gravity (0, -9.81); }
        start here { arm angle 0; }
        scene level { start here; until 2 s; }
        scene upright { start here; until 2 s; with weight; }
    }
}

model! {
    /// A sledge that is pulled along its own axis with a prescribed speed.
    pub model Sledge {
        param speed: m/s = 0.7;
        body sledge { mass: 3, inertia: 0.2 }
        point P = sledge(-0.3, 0.1);
        skate runner: at P along sledge(1, 0);
        velocity constraint pulled: P.vx*cos(sledge.phi) + P.vy*sin(sledge.phi) = speed * sin(t)^2;
        torque sledge: 0.3 * cos(2*t);
        start here { sledge at (0, 0) angle 0; }
        scene run { start here; until 3 s; }
    }
}

model! {
    /// A motor, a pair of gears, a crank, a coupler and a block on a rail.
    pub model Press {
        param ratio = -2;
        body motor { mass: 1, inertia: 0.01 }
        body crank { mass: 1, inertia: 0.1 }
        body block { mass: 3, inertia: 1 }
        body plate { mass: 1, inertia: 1 }
        hinge shaft: ground(-0.5, 0) ~ motor(0, 0);
        hinge bearing: ground(0, 0) ~ crank(0, 0);
        gear teeth: motor ~ crank ratio ratio;
        slider rail: ground(0, 0) ~ block(0, 0) along ground(1, 0);
        rod coupler: crank(0.3, 0) ~ block(0, 0) length 1;
        weld glue: block(0, 0.2) ~ plate(0, 0);
        drive speed: motor.phi = 3 * t;
        start home { crank angle 0; block near x 1.3; }
        scene turning { start home; until 2 s; }
    }
}

/// RK4 at 1 ms over a few seconds, or the default method.
const METHOD: f64 = 1e-9;
/// Two derivations of the same numbers, of the size of ten.
const ROUNDING: f64 = 1e-12;

#[test]
fn fd_driven_scenes_pass_their_checks() {
    let scenes: [&dyn Scene; 4] =
        [&motor::Level::default(), &motor::Upright::default(), &sledge::Run::default(), &press::Turning::default()];
    for scene in scenes {
        assert_checks(scene);
    }
}

/// The crank turns at −1.5 rad/s.
#[test]
fn analytic_geared_slider_crank_has_its_block_where_the_rod_puts_it() {
    let run = simulation(&press::Turning::default()).run().unwrap();
    let angle = -1.5 * 2.0_f64;
    let x = 0.3 * angle.cos() + (1.0 - (0.3 * angle.sin()).powi(2)).sqrt();
    assert!((run.last().get("block.x").unwrap() - x).abs() < METHOD);
}

#[test]
fn invariant_driven_rows_are_one_group() {
    let names = |scene: &dyn Scene| scene.info().effects.iter().map(|effect| effect.name).collect::<Vec<_>>();
    assert_eq!(names(&motor::Level::default()), ["drives"]);
    assert_eq!(names(&motor::Upright::default()), ["weight", "drives"]);
    assert_eq!(names(&sledge::Run::default()), ["model", "drives"]);
}

#[test]
fn cross_generated_drive_and_the_one_by_hand() {
    let (generated, hand) = (motor::Level::default(), Crank::default());
    let run = |scene: &dyn Scene| simulation(scene).method(Method::rk4(1e-3)).work().every(0.1).run().unwrap();
    let (generated, hand) = (run(&generated), run(&hand));
    for (a, b) in generated.samples().zip(hand.samples()) {
        assert!(distance(a.coordinates, b.coordinates) <= ROUNDING, "at {} s", a.t);
        assert!((a.energy.work - b.energy.work).abs() <= ROUNDING, "at {} s", a.t);
        assert!((-a.get("lambda.angle").unwrap() - crank::drive_torque(a.t)).abs() <= 1e1 * ROUNDING, "at {} s", a.t);
    }
}

#[test]
fn analytic_work_of_a_drive_is_the_energy_it_gives() {
    let scene = motor::Upright::default();
    let run = simulation(&scene).method(Method::rk4(1e-3)).work().outputs().every(0.1).run().unwrap();
    // about the pin
    let inertia = 0.4 + 2.0 * 0.3 * 0.3;
    let kinetic = |t: f64| 0.5 * inertia * crank::rate(t) * crank::rate(t);
    for s in run.samples() {
        let height = 0.3 * crank::angle(s.t).sin();
        assert!((s.get("output.height").unwrap() - height).abs() <= METHOD, "at {} s", s.t);
        let energy = kinetic(s.t) - kinetic(0.0) + 2.0 * 9.81 * height;
        let error = (s.get("work.drives").unwrap() - energy).abs();
        assert!(error <= METHOD, "{error:.1e} J at {} s", s.t);
        assert!(s.energy.balance.abs() <= METHOD, "{:.1e} J at {} s", s.energy.balance, s.t);
    }
}

#[test]
fn invariant_energy_balances_with_driven_velocity_rows() {
    let scene = sledge::Run::default();
    let run = simulation(&scene).method(Method::rk4(1e-3)).work().every(0.1).run().unwrap();
    let most = run.samples().map(|s| s.work[1].abs()).fold(0.0, f64::max);
    assert!(most > 0.5, "pulling does work: {most} J");
    for s in run.samples() {
        assert!(s.energy.balance.abs() <= METHOD, "{:.1e} J at {} s", s.energy.balance, s.t);
    }
}
