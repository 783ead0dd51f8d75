//! The belt: it stays closed and symmetrical, keeps its energy, and its pins hold what a turning ring needs.

use crate::examples::belt::belt::{Fall, Spin};
use ezy_core::prelude::*;

/// Of the energy turned over, with a tolerance of 1e-10 a step.
const ENERGY: f64 = 1e-8;
/// What the projection leaves in the closing of a loop of 16 links, m.
const CLOSED: f64 = 1e-10;

#[test]
fn invariant_belt_stays_closed_and_keeps_its_energy() {
    for h in [3, 8] {
        let scene = Fall { h, ..Default::default() };
        let run = Simulation::new(&scene).method(Method::dop853(1e-10)).every(0.1).work().run().unwrap();
        for s in run.samples() {
            let get = |name: &str, i: usize| s.get(&format!("link[{i}].{name}")).unwrap();
            let end = |i: usize, side: f64| {
                let (sin, cos) = get("phi", i).sin_cos();
                [get("x", i) + side * scene.l / 2.0 * cos, get("y", i) + side * scene.l / 2.0 * sin]
            };
            let (last, first) = (end(2 * h - 1, 1.0), end(0, -1.0));
            let gap = (last[0] - first[0]).hypot(last[1] - first[1]);
            assert!(gap <= CLOSED, "{h} {}: {gap:.1e} m", s.t);
            let turned_over = s.get("kinetic").unwrap().max(scene.m * 9.81 * scene.l);
            let balance = s.get("balance").unwrap() / turned_over;
            assert!(balance.abs() <= ENERGY, "{h} {}: {balance:.1e}", s.t);
        }
    }
}

/// Rounding, as much as a second of falling multiplies it, m.
const MIRRORED: f64 = 1e-7;

#[test]
fn invariant_belt_falls_symmetrically() {
    let run = Simulation::new(&Fall::default()).method(Method::dop853(1e-10)).every(0.1).run().unwrap();
    for s in run.samples() {
        let place = |i: usize, axis: &str| s.get(&format!("link[{i}].{axis}")).unwrap();
        for i in 0..6 {
            let (x, y) = (place(i, "x") + place(11 - i, "x"), place(i, "y") - place(11 - i, "y"));
            assert!(x.abs().max(y.abs()) <= MIRRORED, "{i} {}: {x:.1e} {y:.1e}", s.t);
        }
    }
}

/// Of a tension, by the solution of the equations of motion.
const TENSION: f64 = 1e-9;

/// A link at the distance ρ from the centre needs m ω² ρ, from two pins that pull along their neighbours' bisector.
#[test]
fn analytic_pins_of_a_turning_polygon_hold_the_centrifugal_force() {
    for h in [3, 6, 12] {
        let scene = Spin { h, ..Default::default() };
        let run = Simulation::new(&scene).until(0.0).run().unwrap();
        let half = std::f64::consts::PI / (2 * h) as f64;
        let radius = scene.l / 2.0 / half.tan();
        let expected = scene.m * scene.w * scene.w * radius / (2.0 * half.sin());
        let pin = |i: usize| {
            let [x, y] = ["x", "y"].map(|axis| run.last().get(&format!("lambda.pin[{i}].{axis}")).unwrap());
            x.hypot(y)
        };
        for i in 1..2 * h {
            assert!((pin(i) / expected - 1.0).abs() <= TENSION, "{h} {i}: {} {expected}", pin(i));
        }
    }
}
