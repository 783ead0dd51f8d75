//! Changes of frame, sign, scale and direction of time that leave the motion as it is.

use crate::scenes::{Case, coast, distance, driven, set};
use ezy_core::prelude::*;
use ezy_core_tests::simulation;
use std::f64::consts::PI;

/// Both runs do the same steps; only rounding differs, amplified by at most 20 within five seconds.
const SAME_STEPS: f64 = 1e-12;
/// There and back: the method's error of 3e-12 each way, at 1 ms.
const THERE_AND_BACK: f64 = 1e-11;

const STEP: f64 = 1e-3;

/// A coasting run from a placed and turned start.
fn placed(scene: &dyn Scene, x: f64, y: f64, phi: f64) -> Run {
    simulation(scene)
        .method(Method::rk4(STEP))
        .start("seat.x", x)
        .start("seat.y", y)
        .start("seat.phi", phi)
        .start("bar.phi", phi + 0.5 * PI)
        .start("seat.vx", phi.cos())
        .start("seat.vy", phi.sin())
        .run()
        .unwrap()
}

#[test]
fn invariant_coast_under_rigid_motions() {
    let (x, y, phi) = (3.0_f64, -2.0_f64, 1.1_f64);
    for Case { route, scene } in coast() {
        let (plain, moved) = (placed(&*scene, 0.0, 0.0, 0.0), placed(&*scene, x, y, phi));
        let q = plain.last().coordinates;
        let (s, c) = phi.sin_cos();
        let turn = |i: usize| [x + c * q[i] - s * q[i + 1], y + s * q[i] + c * q[i + 1], q[i + 2] + phi];
        let error = distance(&[turn(0), turn(3)].concat(), moved.last().coordinates);
        assert!(error <= SAME_STEPS, "{route}: {error:.1e}");
    }
}

#[test]
fn invariant_driven_under_reflection() {
    for (Case { route, scene }, Case { scene: mut mirrored, .. }) in driven().into_iter().zip(driven()) {
        set(&mut *mirrored, &[("m0", -2.0)]);
        let plain = simulation(&*scene).method(Method::rk4(1e-3)).until(5.0).run().unwrap();
        let mirror = simulation(&*mirrored).method(Method::rk4(1e-3)).until(5.0).start("bar.phi", -PI).run().unwrap();
        let q = plain.last().coordinates;
        let expected = [q[0], -q[1], -q[2], q[3], -q[4], -q[5]];
        let error = distance(&expected, mirror.last().coordinates);
        assert!(error <= SAME_STEPS, "{route}: {error:.1e}");
    }
}

#[test]
fn invariant_driven_under_scaling_of_masses() {
    for (Case { route, scene }, Case { scene: mut heavy, .. }) in driven().into_iter().zip(driven()) {
        let k = 7.0;
        set(&mut *heavy, &[("m1", 46.0 * k), ("i1", 10.0 * k), ("m2", k), ("i2", 0.005 * k), ("m0", 2.0 * k)]);
        let run = |scene: &dyn Scene| simulation(scene).method(Method::rk4(1e-3)).until(5.0).run().unwrap();
        let error = distance(run(&*scene).last().coordinates, run(&*heavy).last().coordinates);
        assert!(error <= SAME_STEPS, "{route}: {error:.1e}");
    }
}

#[test]
fn invariant_coast_under_scaling_of_time() {
    for Case { route, scene } in coast() {
        let k = 4.0;
        let slow = simulation(&*scene).method(Method::rk4(STEP)).run().unwrap();
        let fast = simulation(&*scene).method(Method::rk4(STEP / k)).until(1.0 / k).start("seat.vx", k);
        let error = distance(slow.last().coordinates, fast.run().unwrap().last().coordinates);
        assert!(error <= SAME_STEPS, "{route}: {error:.1e}");
    }
}

#[test]
fn invariant_coast_under_reversal_of_time() {
    for Case { route, scene } in coast() {
        let there = simulation(&*scene).method(Method::rk4(STEP)).run().unwrap();
        let mut back = simulation(&*scene).method(Method::rk4(STEP));
        let info = scene.info();
        for (i, (c, v)) in info.coordinates.iter().zip(&*info.velocities).enumerate() {
            back = back.start(&*c.name, there.last().coordinates[i]).start(&*v.name, -there.last().velocities[i]);
        }
        let back = back.run().unwrap();
        let error = distance(there.first().coordinates, back.last().coordinates);
        assert!(error <= THERE_AND_BACK, "{route}: {error:.1e}");
    }
}

#[test]
fn invariant_coast_under_turning_the_axes_of_the_bar() {
    for (Case { route, scene }, Case { scene: mut turned, .. }) in coast().into_iter().zip(coast()) {
        set(&mut *turned, &[("c", -0.1), ("d", -0.1)]);
        let plain = simulation(&*scene).method(Method::rk4(1e-3)).run().unwrap();
        let turned = simulation(&*turned).method(Method::rk4(1e-3)).start("bar.phi", 1.5 * PI).run().unwrap();
        let mut expected = plain.last().coordinates.to_vec();
        expected[5] += PI;
        let error = distance(&expected, turned.last().coordinates);
        assert!(error <= SAME_STEPS, "{route}: {error:.1e}");
    }
}
